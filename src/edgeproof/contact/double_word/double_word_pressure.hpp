// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/double_word/double_word_power_law.hpp"
#include "edgeproof/contact/double_word/double_word_slope.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"

#include <optional>
#include <variant>

namespace edgeproof::contact {

/// p in closed form, correctly rounded to binary64: the formulas of a piecewise linear slope
/// (double_word_slope.hpp) and of power laws with integer and half-integer exponents
/// (double_word_power_law.hpp) in double words, which carry bounds (docs/double-words.md). Balls
/// decide the rest.
///
/// The object is immutable: many threads may use it.
class DoubleWordPressure {
public:
    /// The precision that a contact should have, so that places near knots keep their accuracy.
    static constexpr long contact_bits = 192;

    /// For a contact with such a slope. If a number of the contact is not 0 and its size is not
    /// between 2^-100 and 2^100, then every place is undecided.
    /// @param profile g'(x)
    /// @param contact the contact in balls
    DoubleWordPressure(const Profile& profile, const BallContact& contact)
        : DoubleWordPressure(profile, contact, contact) {}
    /// The same with the distances of the knots measured from the edges of another zone `whole` of
    /// the profile: formula() then takes a place of `contact` and the distance from an edge of
    /// `whole`.
    DoubleWordPressure(const Profile& profile, const BallContact& contact,
                       const BallContact& whole);

    /// True if there is a formula in double words.
    [[nodiscard]] static bool has_form(const Profile& profile);

    /// Returns p (stress) at the distance `u` from an edge (length), for every u within its radius.
    /// Unknown (a radius that is not finite) for u outside the contact, for u that its radius does
    /// not separate from a corner, for u below 2^-300 or not finite, and in a thread that does not
    /// round to nearest. Infinite, without a radius, exactly on a corner.
    [[nodiscard]] DoubleWord at(Edge edge, const DoubleWord& u) const {
        return in_range_ && in_double_words(u) ? kernel_(*this, edge, u) : double_word::unknown();
    }
    /// Returns the binary64 nearest to p (ties to even) at exactly the distance `u`: proved.
    /// Nothing where that is undecided.
    [[nodiscard]] std::optional<double> nearest(Edge edge, double u) const {
        return nearest_binary64(at(edge, {u, 0, 0}));
    }

    /// `at` without its checks.
    [[nodiscard]] DoubleWord formula(Edge edge, const DoubleWord& u) const {
        return formula({length_, edge, u}, edge, u);
    }
    /// The same at a place `x` of the contact, which is at the distance `u` from an edge of
    /// `whole`.
    [[nodiscard]] DoubleWord formula(const DoubleWordPlace& x, Edge edge,
                                     const DoubleWord& u) const {
        return slope() != nullptr ? slope()->pressure(x, edge, u)
                                  : std::get_if<DoubleWordPowerLaw>(&form_)->pressure(x, edge, u);
    }
    /// Null for a power law.
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
