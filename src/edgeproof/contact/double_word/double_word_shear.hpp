// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/double_word/double_word_pressure.hpp"
#include "edgeproof/contact/double_word/double_word_slip.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/contact/slip/ball_slip.hpp"

#include <cmath>
#include <optional>
#include <variant>

namespace edgeproof::contact {

/// q, correctly rounded to binary64, in double words like the pressure: under full stick
/// (law/shear.hpp), similar to p (Q and P increase together), or in partial slip, f (p - p*)
/// (slip/ball_slip.hpp). On a corner of the stick zone, where p and p* are infinite, it is the
/// limit. Undecided values are left to balls. The object is immutable: many threads may
/// use it.
class DoubleWordShear {
public:
    /// `load`: Q (force/length) and the bulk tension (stress).
    [[nodiscard]] static DoubleWordShear full_stick(const BallContact& contact,
                                                    const ShearLoad<Ball>& load);
    /// `ratio`: Q/P.
    [[nodiscard]] static DoubleWordShear similar(DoubleWordPressure pressure, const Ball& ratio);
    /// `stick`: the stick zone (length); `traction`: f in the direction of Q.
    [[nodiscard]] static DoubleWordShear partial_slip(const Profile& profile,
                                                      const BallContact& contact,
                                                      const BallZone& stick, const Ball& traction);

    /// Returns q (stress) at the distance `u` from an edge (length); see DoubleWordPressure::at.
    [[nodiscard]] DoubleWord at(Edge edge, const DoubleWord& u) const {
        return in_range_ && in_double_words(u) ? kernel_(*this, edge, u) : double_word::unknown();
    }
    /// Returns the binary64 nearest to q at `u`; nothing where that is undecided.
    [[nodiscard]] std::optional<double> nearest(Edge edge, double u) const {
        return nearest_binary64(at(edge, {u, 0, 0}));
    }

    /// `at` without its checks.
    [[nodiscard]] DoubleWord formula(Edge edge, const DoubleWord& u) const;

private:
    /// Returns factor times a p that may be infinite (on a corner).
    static DoubleWord times(const DoubleWord& factor, const DoubleWord& p) {
        return std::isinf(p.high) && double_word::well_known(factor)
                   ? DoubleWord{factor.high * p.high, 0, p.radius}
                   : factor * p;
    }
    struct FullStick {
        PreciseWord length;
        DoubleWord Q_over_pi;
        DoubleWord tension; ///< sigma_0/8

        /// eqn:Shear_Adhered, where 2x + b - a is the difference of the distances from the edges.
        [[nodiscard]] DoubleWord at(Edge edge, const DoubleWord& u) const {
            const DoubleWordPlace x(length, edge, u);
            return x.inside() ? (Q_over_pi + tension * (x.left - x.right)) / sqrt(x.right * x.left)
                              : double_word::unknown();
        }
    };
    struct Similar {
        DoubleWordPressure pressure;
        DoubleWord ratio;

        /// q = (Q/P) p (docs/shear.md, "P and Q in proportion").
        [[nodiscard]] DoubleWord at(Edge edge, const DoubleWord& u) const {
            return times(ratio, pressure.formula(edge, u));
        }
    };
    struct Slip {
        DoubleWordPressure pressure;
        DoubleWordPressure stick; ///< p*
        DoubleWord friction;
        DoubleWordMark right; ///< of the edge of the stick zone
        DoubleWordMark left;
        DoubleWordSlip zones;

        /// q = f (p - p*) (docs/partial-slip.md; docs/double-words.md, lemmas 9 to 11).
        [[nodiscard]] DoubleWord at(Edge edge, const DoubleWord& u) const {
            DoubleWordPlace x(right, left, edge, u);
            if (!x.known()) { // on the edge of the stick zone, or too close to it to be separated
                x.move_inside();
                const DoubleWord inner =
                    x.inside() ? double_word::about_zero(stick.formula(x, edge, u)) : DoubleWord{};
                return friction * (pressure.formula(edge, u) - inner);
            }
            if (!x.inside()) {
                return times(friction, pressure.formula(edge, u));
            }
            if (pressure.slope() == nullptr) {
                return friction * (pressure.formula(edge, u) - stick.formula(x, edge, u));
            }
            return friction * zones.difference(*pressure.slope(), *stick.slope(),
                                               {pressure.length(), edge, u}, x, edge, u);
        }
    };
    using Form = std::variant<FullStick, Similar, Slip>;

    /// `in_range`: the numbers of the contact are in the range of the bounds.
    DoubleWordShear(Form form, bool in_range);

    Form form_;
    bool in_range_;
    DoubleWordKernel<DoubleWordShear>::Function kernel_;
};

} // namespace edgeproof::contact
