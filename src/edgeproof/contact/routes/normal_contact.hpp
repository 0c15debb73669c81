// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/contact_law.hpp"
#include "edgeproof/contact/law/load.hpp"
#include "edgeproof/contact/law/work.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/contact/routes/pressure_routes.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::contact {

/// How a pressure was computed.
enum class Route {
    barber_mossakovskii, ///< flat punches laid over each other, tanh-sinh
    singular_integral,   ///< regularised principal value, tanh-sinh
    closed_form,         ///< logarithms, or Gauss's 2F1 for a power law
    automatic            ///< the closed form where there is one, else the singular integral
};
[[nodiscard]] std::string route_name(Route route);

/// A value at the digits asked for, with the relative error that its route estimates (quadrature
/// and roundoff; an estimate, never a bound) and what it cost.
struct Estimated {
    Real value;
    Real estimate;
    Route route = Route::automatic;
    std::size_t evaluations = 0;
    unsigned working_digits = 0;
};

/// A normal contact given exactly, computed to `digits` digits. The working precision is found
/// here: digits asked, plus a guard, plus twice the decades between the contact's length and the
/// smallest gap among edges, knots and the point. One object belongs to one thread.
class NormalContact {
public:
    /// Throws InputError when the load is not positive, DomainError when no contact carries it.
    /// What is done is counted in `work`, which must outlive the contact, where one is given.
    NormalContact(Profile profile, formula::Exact contact_modulus, Load load, unsigned digits,
                  Work* work = nullptr);
    ~NormalContact();
    NormalContact(NormalContact&&) noexcept;
    NormalContact& operator=(NormalContact&&) noexcept;

    [[nodiscard]] const Profile& profile() const noexcept;
    [[nodiscard]] unsigned digits() const noexcept;
    [[nodiscard]] const formula::Exact& contact_modulus() const noexcept;
    [[nodiscard]] const Load& load() const noexcept;

    [[nodiscard]] Real a() const;
    [[nodiscard]] Real b() const;
    /// Whether an edge that is solved for lies within 1e-300 of a knot (1e-60 where g' is curved)
    /// and as near as the digits tell: then it is taken to be on the knot, which nothing proves.
    [[nodiscard]] bool edge_taken_on_knot() const noexcept {
        return a_on_knot_.has_value() || b_on_knot_.has_value();
    }
    [[nodiscard]] Real force() const;  ///< P per unit length
    [[nodiscard]] Real moment() const; ///< M about the origin, per unit length
    /// P'(a), P''(a), ... (k = 1, 2, ...): one-sided, from inside, where an edge is on a knot.
    [[nodiscard]] Real force_derivative(unsigned k) const;
    /// b(a), b'(a), ... (k = 0, 1, ...).
    [[nodiscard]] Real left_edge_derivative(unsigned k) const;

    /// p at the distance u inwards from `edge`. Throws DomainError for u outside (0, a + b), or on
    /// a corner of the profile, where p is infinite; for a route that the profile does not have.
    /// An exact u is told from a knot down to 1e-400 of the contact, a Real down to its roundoff;
    /// nearer than that it counts as on the knot.
    [[nodiscard]] Estimated pressure(Edge edge, const Real& u,
                                     Route route = Route::automatic) const;
    [[nodiscard]] Estimated pressure(Edge edge, const formula::Exact& u,
                                     Route route = Route::automatic) const;
    /// c_0 ... c_{terms-1} at an edge (eqn:LocalPressureI to any order).
    [[nodiscard]] std::vector<Real> expansion(Edge edge, std::size_t terms) const;
    /// Distance from `edge` to the nearest place where p is not analytic (a knot, the mirror edge):
    /// the radius in u within which the expansion converges.
    [[nodiscard]] Real convergence_radius(Edge edge) const;

private:
    struct Solved;
    /// What a first look at a point tells: the precision that it needs, and the knot it stands on.
    struct Look {
        unsigned working;
        std::optional<std::size_t> on_knot;
    };
    [[nodiscard]] Solved& at(unsigned working) const;
    /// An edge that is not given came out as a knot, to all of its digits.
    [[nodiscard]] bool solved_edge_on_knot(const Solved& s) const;
    /// Takes edges that no digits tell from a knot to be on it; false where there is none.
    bool take_edges_on_knots(unsigned working);
    [[nodiscard]] Look look(const Real& u, Edge edge, unsigned working, Route route) const;
    [[nodiscard]] Route chosen(Route route) const;
    [[nodiscard]] Estimated pressure_at(Edge edge, const Real& u, Route route,
                                        const Look& found) const;
    Profile profile_;
    formula::Exact modulus_;
    Load load_;
    unsigned digits_;
    unsigned base_working_ = 0;
    std::optional<std::size_t> a_on_knot_; ///< the knot that an edge is taken to be on
    std::optional<std::size_t> b_on_knot_;
    Work* work_;
    mutable bool counted_ = false; ///< the first solution, in work_
    mutable std::map<unsigned, std::unique_ptr<Solved>> solved_;
};

} // namespace edgeproof::contact
