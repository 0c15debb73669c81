// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/law/linear_measure.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// Both edges of a contact -b < x < a as exact numbers (lengths).
struct ExactEdges {
    Exact a;
    Exact b;
};

/// The exact edges of the contact, where one of them lies on a knot, or where g' is odd in the
/// whole contact; no number of bits can prove either. `near_a` and `near_b`, which are known to
/// most of their bits, suggest candidates, and exact algebra (algebra/identity.hpp) proves
/// that they satisfy the consistency condition (moore-hills EQ20) and carry the load (moore-hills
/// EQ22). Returns nothing if no edge is near a knot, or if there is no such proof: then it is not
/// known whether an edge lies on a knot. Lengths in one unit; forces in the unit of contact_modulus
/// times length.
[[nodiscard]] std::optional<ExactEdges> exact_edges(const Profile& profile,
                                                    const Exact& contact_modulus, const Load& load,
                                                    const Ball& near_a, const Ball& near_b);

/// True if g'(-x) = -g'(x) for 0 < x < a is proved.
[[nodiscard]] bool odd_within(const Profile& profile, const Expr& a);

/// The rational number with the smallest denominator in a ball; nothing for a ball that is not
/// finite.
[[nodiscard]] std::optional<Rational> simplest_rational(const Ball& x);

/// The form of a constant. Throws Error if it is too large for the algebra.
[[nodiscard]] Form exact_form(const Expr& constant);

/// A normal contact in exact algebra: power laws, and piecewise linear slopes where the angles of
/// the knots are multiples of pi/12. Members throw NoExactForm, or an Error of the algebra, where a
/// value has no exact form. It decides whether a value is equal to a number of few digits, or lies
/// half-way between two of them, which no enclosure can. The formulas are those of contact/law/, as
/// in BallContact. Lengths in one unit, pressures in the unit of contact_modulus.
/// A pressure with a logarithm needs no such decision: by `baker1966`, logarithms of algebraic
/// numbers, pi and 1 are linearly independent over the algebraic numbers unless trivially
/// dependent, so that the pressure is not a rational number.
class AlgebraicContact {
public:
    /// `near_a` and `near_b` enclose the edges (lengths). An edge that is not given is guessed from
    /// its ball, and accepted only if the exact equations hold for the guess; their solution is
    /// unique.
    AlgebraicContact(const Profile& profile, const Exact& contact_modulus, const Load& load,
                     const Ball& near_a, const Ball& near_b);

    [[nodiscard]] const Form& a() const { return known(a_); }
    [[nodiscard]] const Form& b() const { return known(b_); }
    [[nodiscard]] Form length() const { return a() + b(); }
    [[nodiscard]] Form force() const;
    [[nodiscard]] Form moment() const;
    [[nodiscard]] Form pressure(Edge edge, const Form& u) const;
    /// c_0 ... c_{terms-1} of a symmetric profile, at most 40.
    [[nodiscard]] std::vector<Form> expansion(Edge edge, std::size_t terms) const;

private:
    [[nodiscard]] static const Form& known(const std::optional<Form>& x);
    /// The marks of the knots, if it is known for all whether they are inside.
    [[nodiscard]] const std::vector<Mark<Form>>& marks() const;
    void find_edges(const Load& load, const Ball& near_a, const Ball& near_b);
    /// True if a and b satisfy the exact equations.
    [[nodiscard]] bool holds(const Load& load);
    [[nodiscard]] bool bends(std::size_t knot) const;
    template <class Kernel> [[nodiscard]] Form over_measure() const;

    Profile profile_;
    Form modulus_;
    std::optional<Rational> exponent_; ///< of a power law
    Form power_factor_;                ///< P = power_factor a^(m+1)
    LinearSlope<Form> slope_;
    std::vector<Mark<Form>> marks_;
    std::optional<Form> a_;
    std::optional<Form> b_;
};

} // namespace edgeproof::contact
