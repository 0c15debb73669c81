// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/double_word/double_word_power_law.hpp"
#include "edgeproof/contact/double_word/double_word_slope.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"

#include <optional>
#include <variant>

namespace edgeproof::contact {

/// p in closed form, correctly rounded to binary64: the formulas of a piecewise linear slope
/// (double_word_slope.hpp) and of power laws of whole and half exponents
/// (double_word_power_law.hpp) in double words, which carry their bounds. What they do not decide
/// (docs/pressure.md) is left to balls.
///
/// Immutable: many threads may use one object.
class DoubleWordPressure {
public:
    /// The precision that a contact should have, so that places beside knots keep their digits.
    static constexpr long contact_bits = 192;

    /// Of a contact of such a slope. Numbers of the contact that are not 0 and not between 2^-100
    /// and 2^100 in size leave every place undecided.
    DoubleWordPressure(const Profile& profile, const BallContact& contact)
        : DoubleWordPressure(profile, contact, contact) {}
    /// The same with the knots counted from the edges of another zone of the profile, for formula()
    /// with a place of this contact and the distance from an edge of that zone.
    DoubleWordPressure(const Profile& profile, const BallContact& contact,
                       const BallContact& whole);

    /// Whether there is a formula in double words.
    [[nodiscard]] static bool has_form(const Profile& profile);

    /// p at the distance u from an edge, for every u within its radius; unknown (a radius that is
    /// not finite) for u outside the contact, beside a corner and closer than the radius tells,
    /// below 2^-300 or not finite, and in a thread that does not round to nearest. Infinite, and no
    /// radius, exactly on a corner.
    [[nodiscard]] DoubleWord at(Edge edge, const DoubleWord& u) const {
        return in_range_ && in_double_words(u) ? kernel_(*this, edge, u) : double_word::unknown();
    }
    /// The binary64 nearest to p (ties to even) at the distance u, exactly that binary64: proved.
    /// Nothing where that is not decided.
    [[nodiscard]] std::optional<double> nearest(Edge edge, double u) const {
        return nearest_binary64(at(edge, {u, 0, 0}));
    }

    /// `at` without its checks.
    [[nodiscard]] DoubleWord formula(Edge edge, const DoubleWord& u) const {
        return formula({length_, edge, u}, edge, u);
    }
    /// At a place of the contact.
    [[nodiscard]] DoubleWord formula(const DoubleWordPlace& x, Edge edge,
                                     const DoubleWord& u) const {
        return slope() != nullptr ? slope()->pressure(x, edge, u)
                                  : std::get_if<DoubleWordPowerLaw>(&form_)->pressure(x, edge, u);
    }
    /// Nothing of a power law.
    [[nodiscard]] const DoubleWordSlope* slope() const {
        return std::get_if<DoubleWordSlope>(&form_);
    }
    /// a + b.
    [[nodiscard]] const PreciseWord& length() const { return length_; }
    [[nodiscard]] bool in_range() const { return in_range_; }

private:
    PreciseWord length_;
    std::variant<DoubleWordSlope, DoubleWordPowerLaw> form_;
    bool in_range_ = true;
    DoubleWordKernel<DoubleWordPressure>::Function kernel_;
};

} // namespace edgeproof::contact
