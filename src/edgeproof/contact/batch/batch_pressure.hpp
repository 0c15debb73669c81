// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"
#include "edgeproof/contact/routes/pressure_routes.hpp"

#include <memory>

namespace edgeproof::contact {

/// Many pressures of one contact, each at the least cost that a quadrature has: whatever does not
/// depend on the point (nodes, weights, g' at the nodes) is computed once a contact and number of
/// nodes, by whichever point asks for it first; a point then costs a division a node.
///
/// The integral is eqn:SIEPressure on -b < x < a, its principal value made regular, over
/// s = c + d cos(theta) (a symmetric contact: its halves laid on each other, so that
/// s^2 = a^2 (1 + cos(phi))/2 takes the place of s). A power law has nodes of its own
/// (batch_power_law.hpp). Corners of g' are logarithms.
///
/// The two rules share the integrand and nothing else; routes that share nothing with either are in
/// pressure_routes.hpp. Neither proves a bound.
class BatchPressure {
public:
    enum class Rule {
        /// The number of nodes follows from Bernstein's ellipse, inside which the integrand is
        /// proved to be holomorphic (and how large it is there), so that `estimate` is a bound of
        /// the rule's own error; roundoff is not in it. A pole that comes near (x beside a knot) is
        /// taken out with a logarithm. A piece of g' that is singular at an end, or begins at the
        /// apex of a symmetric contact and is not proved to be odd there, is left to the other
        /// rule.
        gauss_legendre,
        /// Levels until two agree; `estimate` is their difference. The reference.
        tanh_sinh
    };

    /// To `digits` digits, relative. `contact` is needed only during the call. Throws DomainError
    /// where a route in Real would.
    BatchPressure(const NormalContact& contact, unsigned digits, Rule rule = Rule::gauss_legendre);
    /// The same contact from its parts; `e` at some 20 digits more than `digits`, and as many more
    /// as the decades between the contact's length and its smallest gap between edges and knots.
    BatchPressure(const Profile& profile, const Real& contact_modulus, const Extent<Real>& e,
                  unsigned digits, Rule rule = Rule::gauss_legendre);
    ~BatchPressure();
    BatchPressure(BatchPressure&&) noexcept;
    BatchPressure& operator=(BatchPressure&&) noexcept;

    /// p at a point whose distances carry the precision of `e` (more, beside a corner or the apex
    /// of a power law: its distance from there to `digits` digits). Units of the contact modulus.
    /// `evaluations` are nodes used. Throws DomainError on a corner, where p is infinite. One
    /// object belongs to one thread; several live side by side at any precisions.
    [[nodiscard]] RoutedPressure<Real> operator()(const Point<Real>& at) const;
    /// The same at the distance u inwards from an edge.
    [[nodiscard]] RoutedPressure<Real> operator()(Edge edge, const Real& u) const;

private:
    struct Contact;
    std::unique_ptr<Contact> contact_;
};

} // namespace edgeproof::contact
