// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"
#include "edgeproof/contact/routes/pressure_routes.hpp"

#include <memory>

namespace edgeproof::contact {

/// Many pressures of one contact, each at the least cost of a quadrature: everything that does not
/// depend on the point (nodes, weights, g' at the nodes) is computed once for each contact and
/// number of nodes, when it is first needed. A further point then costs one division for each node.
///
/// The integral is eqn:SIEPressure on -b < x < a with its principal value regularised
/// (docs/pressure.md, "Many points of one contact"), over s = c + d cos(theta); in a symmetric
/// contact, whose two halves are folded onto each other, over s^2 = a^2 (1 + cos(phi))/2. A power
/// law has its own nodes (batch_power_law.hpp). Corners of g' contribute logarithms.
///
/// The two rules have only the integrand in common. Routes that are independent of both are in
/// pressure_routes.hpp. No rule proves a bound.
class BatchPressure {
public:
    enum class Rule {
        /// The number of nodes follows from a Bernstein ellipse in which the integrand is proved to
        /// be holomorphic and bounded (trefethen2013, theorem 19.3), so that `estimate` is a bound
        /// of the error of the rule; it does not include roundoff. A pole near the piece (x close
        /// to a knot) is subtracted and integrated as a logarithm. Tanh-sinh is used for a piece of
        /// g' that is singular at an end, and for one that begins at the apex of a symmetric
        /// contact and is not proved to be odd there.
        gauss_legendre,
        /// Levels are added until two agree; `estimate` is their difference. This rule is the
        /// reference.
        tanh_sinh
    };

    /// Throws DomainError where a route in Real would.
    /// @param contact the contact; needed only during the call
    /// @param digits relative accuracy wanted, in decimal digits
    /// @param rule quadrature rule
    BatchPressure(const NormalContact& contact, unsigned digits, Rule rule = Rule::gauss_legendre);
    /// The same contact from its parts.
    /// @param profile g'(x)
    /// @param contact_modulus E* (stress)
    /// @param e distances of both edges from the origin (length), with about 20 digits more than
    /// `digits`, and as many more as there are decades between the length of the contact and its
    /// smallest gap between edges and knots
    /// @param digits relative accuracy wanted, in decimal digits
    /// @param rule quadrature rule
    BatchPressure(const Profile& profile, const Real& contact_modulus, const Extent<Real>& e,
                  unsigned digits, Rule rule = Rule::gauss_legendre);
    ~BatchPressure();
    BatchPressure(BatchPressure&&) noexcept;
    BatchPressure& operator=(BatchPressure&&) noexcept;

    /// Returns p (stress); `evaluations` is the number of nodes used. Throws DomainError on a
    /// corner, where p is infinite. One object belongs to one thread; several objects may have
    /// different precisions.
    /// @param at point whose distances (length) have the precision of `e`; near a corner or the
    /// apex of a power law also its distance from there must have `digits` digits
    [[nodiscard]] RoutedPressure<Real> operator()(const Point<Real>& at) const;
    /// The same at the distance `u` inwards from `edge` (length).
    [[nodiscard]] RoutedPressure<Real> operator()(Edge edge, const Real& u) const;

private:
    struct Contact;
    std::unique_ptr<Contact> contact_;
};

} // namespace edgeproof::contact
