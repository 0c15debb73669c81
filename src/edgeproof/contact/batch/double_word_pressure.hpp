// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/precision/double_word/logarithm.hpp"

#include <optional>
#include <vector>

namespace edgeproof::contact {

/// p of a piecewise linear slope, correctly rounded to binary64: the formula of
/// law/logarithmic_pressure.hpp in double words, which carry their bounds. What they do not decide
/// (some 1 in 10^6 places, those beside corners and beyond a contact's range) is left to balls.
///
/// Immutable: many threads may use one object.
class DoubleWordPressure {
public:
    /// Of a contact whose slope is piecewise linear. Numbers of the contact that are not 0 and not
    /// between 2^-100 and 2^100 in size leave every place undecided.
    explicit DoubleWordPressure(const BallContact& contact);

    /// The binary64 nearest to p (ties to even) at the distance u, exactly that binary64, from an
    /// edge: proved. Nothing where that is not decided, nor for u outside the contact, on a corner,
    /// below 2^-300 or not finite, nor in a thread that does not round to nearest.
    [[nodiscard]] std::optional<double> nearest(Edge edge, double u) const;

    struct Knot {
        DoubleWord inset;  ///< a - knot
        DoubleWord outset; ///< b + knot
        Mark<DoubleWord> mark;
        bool corner;
        DoubleWord jump; ///< of g'
        DoubleWord drop; ///< of g''
    };

private:
    friend struct DoubleWordKernel;
    std::vector<Knot> knots_; ///< those that count
    DoubleWord length_;
    DoubleWord arc_;
    DoubleWord factor_;
    bool in_range_ = true;
    DoubleWord (*kernel_)(const DoubleWordPressure&, Edge, double);
    const LogarithmTable* table_;
};

} // namespace edgeproof::contact
