// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/contact_law.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/contact/routes/pressure_routes.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::contact {

/// The method by which a pressure was computed.
enum class Route {
    barber_mossakovskii, ///< a sequence of flat punches, tanh-sinh
    singular_integral,   ///< regularised principal value, tanh-sinh
    closed_form,         ///< logarithms, or Gauss's 2F1 for a power law
    automatic            ///< the closed form where there is one, else the singular integral
};
[[nodiscard]] std::string route_name(Route route);

/// A value to the required digits, with the relative error that its route estimates (quadrature and
/// roundoff; not a bound) and its cost.
struct Estimated {
    Real value;
    Real estimate;
    Route route = Route::automatic;
    std::size_t evaluations = 0;
    unsigned working_digits = 0;
};

/// A normal contact given by exact numbers, computed to `digits` digits. Lengths in one unit,
/// pressures in the unit of contact_modulus, forces per unit length.
/// The working precision is the required digits, plus guard digits, plus twice the decades between
/// the contact's length and the smallest gap between edges, knots and the point. One object belongs
/// to one thread.
class NormalContact {
public:
    /// Throws InputError if the load is not positive, DomainError if no contact carries it.
    NormalContact(Profile profile, Exact contact_modulus, Load load, unsigned digits);
    ~NormalContact();
    NormalContact(NormalContact&&) noexcept;
    NormalContact& operator=(NormalContact&&) noexcept;

    [[nodiscard]] const Profile& profile() const noexcept { return profile_; }
    [[nodiscard]] unsigned digits() const noexcept { return digits_; }
    [[nodiscard]] const Exact& contact_modulus() const noexcept { return modulus_; }
    [[nodiscard]] const Load& load() const noexcept { return load_; }

    [[nodiscard]] Real a() const; ///< right edge, a length
    [[nodiscard]] Real b() const; ///< distance of the left edge from the origin
    /// True if an edge that is solved for lies within 1e-300 of a knot (1e-60 where g' is curved)
    /// and the digits do not separate them. It is then taken to be on the knot, without a proof.
    [[nodiscard]] bool edge_taken_on_knot() const noexcept {
        return a_on_knot_.has_value() || b_on_knot_.has_value();
    }
    [[nodiscard]] Real force() const;  ///< P per unit length
    [[nodiscard]] Real moment() const; ///< M about the origin, per unit length
    /// P'(a), P''(a), ... (k = 1, 2, ...); one-sided, from inside the contact, if an edge is on a
    /// knot.
    [[nodiscard]] Real force_derivative(unsigned k) const;
    /// b(a), b'(a), ... (k = 0, 1, ...).
    [[nodiscard]] Real left_edge_derivative(unsigned k) const;

    /// p at the distance u inwards from `edge`. Throws DomainError for u outside (0, a + b), on a
    /// corner of the profile, where p is infinite, and for a route that the profile does not have.
    /// An exact u is separated from a knot down to 1e-400 of the contact, a Real down to its
    /// roundoff; a nearer point counts as on the knot.
    [[nodiscard]] Estimated pressure(Edge edge, const Real& u,
                                     Route route = Route::automatic) const;
    [[nodiscard]] Estimated pressure(Edge edge, const Exact& u,
                                     Route route = Route::automatic) const;
    /// c_0 ... c_{terms-1} at an edge (moore-hills EQ04, to any order), in pressure/length^(k+1/2).
    [[nodiscard]] std::vector<Real> expansion(Edge edge, std::size_t terms) const;
    /// The distance from `edge` to the nearest place where p is not analytic (a knot, the other
    /// edge): the radius in u within which the expansion converges.
    [[nodiscard]] Real convergence_radius(Edge edge) const;

private:
    struct Solved;
    /// The precision that a point needs, and the knot on which it lies, if any.
    struct Look {
        unsigned working;
        std::optional<std::size_t> on_knot;
    };
    [[nodiscard]] Solved& at(unsigned working) const;
    /// True if an edge that is not given is equal to a knot in all its digits.
    [[nodiscard]] bool solved_edge_on_knot(const Solved& s) const;
    /// Takes edges that the digits do not separate from a knot to be on it; returns false if there
    /// is none.
    bool take_edges_on_knots(unsigned working);
    [[nodiscard]] Look look(const Real& u, Edge edge, unsigned working, Route route) const;
    [[nodiscard]] Route chosen(Route route) const;
    [[nodiscard]] Estimated pressure_at(Edge edge, const Real& u, Route route,
                                        const Look& found) const;
    Profile profile_;
    Exact modulus_;
    Load load_;
    unsigned digits_;
    unsigned base_working_ = 0;
    std::optional<std::size_t> a_on_knot_; ///< the knots that the edges are taken to be on
    std::optional<std::size_t> b_on_knot_;
    mutable std::map<unsigned, std::unique_ptr<Solved>> solved_;
};

} // namespace edgeproof::contact
