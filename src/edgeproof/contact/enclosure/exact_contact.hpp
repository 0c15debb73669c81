// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/law/linear_measure.hpp"
#include "edgeproof/contact/law/load.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/formula/exact/exact_number.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// The rational number with the smallest denominator in a ball; nothing for a ball that is not
/// finite.
[[nodiscard]] std::optional<Rational> simplest_rational(const Ball& x);

/// A normal contact in exact arithmetic, as far as its values have an exact form (ExactNumber):
/// power laws with an integer exponent, and piecewise linear slopes where the angles of the knots
/// are multiples of pi/12. It decides whether a value is equal to a number of few digits, or lies
/// half-way between two of them, which no enclosure can. The formulas are those of contact/law/, as
/// in BallContact. Lengths in one unit, pressures in the unit of contact_modulus.
/// A pressure with a logarithm needs no such decision: by `baker1966`, logarithms of algebraic
/// numbers, pi and 1 are linearly independent over the algebraic numbers unless trivially
/// dependent, so that the pressure is not a rational number.
class ExactContact {
public:
    /// `near_a` and `near_b` enclose the edges (lengths). An edge that is not given is guessed from
    /// its ball, and accepted only if the exact equations hold for the guess; their solution is
    /// unique.
    ExactContact(const Profile& profile, const formula::Exact& contact_modulus, const Load& load,
                 const Ball& near_a, const Ball& near_b);

    [[nodiscard]] const formula::ExactNumber& a() const { return a_; }
    [[nodiscard]] const formula::ExactNumber& b() const { return b_; }
    [[nodiscard]] formula::ExactNumber length() const { return a_ + b_; }
    [[nodiscard]] formula::ExactNumber force() const;
    [[nodiscard]] formula::ExactNumber moment() const;
    [[nodiscard]] formula::ExactNumber pressure(Edge edge, const formula::ExactNumber& u) const;
    /// c_0 ... c_{terms-1} of a symmetric profile; unknown for other profiles and for more than 40
    /// terms.
    [[nodiscard]] std::vector<formula::ExactNumber> expansion(Edge edge, std::size_t terms) const;

private:
    /// For a power law of a rational exponent: 0 if c_k vanishes, else unknown.
    [[nodiscard]] std::vector<formula::ExactNumber> vanishing_coefficients(std::size_t terms) const;
    void read_power_law();
    void place_knots();
    void find_edges(const Load& load, const Ball& near_a, const Ball& near_b);
    [[nodiscard]] bool balanced() const;
    [[nodiscard]] bool bends(std::size_t knot) const;
    template <class Kernel> [[nodiscard]] formula::ExactNumber over_measure() const;

    Profile profile_;
    formula::ExactNumber modulus_;
    bool power_law_ = false;
    std::optional<Rational> exponent_; ///< of the power law
    std::optional<unsigned> whole_exponent_;
    formula::ExactNumber power_factor_; ///< P = power_factor a^(m+1)
    LinearSlope<formula::ExactNumber> slope_;
    std::vector<Mark<formula::ExactNumber>> marks_; ///< the marks of the knots
    bool placed_ = false; ///< true if it is decided for all knots whether they are inside
    formula::ExactNumber a_;
    formula::ExactNumber b_;
};

} // namespace edgeproof::contact
