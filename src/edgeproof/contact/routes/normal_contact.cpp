// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/routes/normal_contact.hpp"

#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/contact/routes/pressure_routes.hpp"
#include "edgeproof/contact/routes/solved_contact.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::contact {

std::string route_name(Route route) {
    switch (route) {
    case Route::barber_mossakovskii:
        return "barber-mossakovskii";
    case Route::singular_integral:
        return "singular-integral";
    case Route::closed_form:
        return "closed-form";
    case Route::automatic:
        break;
    }
    return "automatic";
}

NormalContact::~NormalContact() = default;
NormalContact::NormalContact(NormalContact&&) noexcept = default;
NormalContact& NormalContact::operator=(NormalContact&&) noexcept = default;

const Profile& NormalContact::profile() const noexcept { return profile_; }
unsigned NormalContact::digits() const noexcept { return digits_; }
const formula::Exact& NormalContact::contact_modulus() const noexcept { return modulus_; }
const Load& NormalContact::load() const noexcept { return load_; }

Real NormalContact::a() const { return at(base_working_).extent.a; }
Real NormalContact::b() const { return at(base_working_).extent.b; }
Real NormalContact::force() const {
    if (work_ != nullptr) {
        ++work_->counts.resultants;
    }
    const PrecisionScope scope(base_working_);
    const Solved& s = at(base_working_);
    return s.law.force(s.extent);
}
Real NormalContact::moment() const {
    if (work_ != nullptr) {
        ++work_->counts.resultants;
    }
    const PrecisionScope scope(base_working_);
    const Solved& s = at(base_working_);
    return s.law.moment(s.extent);
}

/// P^(k)(a), a multiple of a coefficient of the law's series.
Real NormalContact::force_derivative(unsigned k) const {
    if (k == 0) {
        return force();
    }
    const PrecisionScope scope(base_working_);
    const Solved& s = at(base_working_);
    Real d = s.law.series(s.extent, k).force_rate[k - 1];
    for (unsigned j = 2; j < k; ++j) {
        d *= j;
    }
    return d;
}

Real NormalContact::left_edge_derivative(unsigned k) const {
    if (k == 0) {
        return b();
    }
    const PrecisionScope scope(base_working_);
    const Solved& s = at(base_working_);
    Real d = s.law.series(s.extent, k + 1).b[k];
    for (unsigned j = 2; j <= k; ++j) {
        d *= j;
    }
    return d;
}

Route NormalContact::chosen(Route route) const {
    if (route != Route::automatic) {
        return route;
    }
    return profile_.has_closed_form() ? Route::closed_form : Route::singular_integral;
}

Estimated NormalContact::pressure(Edge edge, const formula::Exact& u, Route route) const {
    const auto read = [&](unsigned working) {
        const PrecisionScope scope(working);
        return u.to<Real>();
    };
    route = chosen(route);
    Look found = look(read(base_working_), edge, base_working_, route);
    if (found.on_knot) {
        const unsigned closer = base_working_ + knot_decades;
        found = look(read(closer), edge, closer, route);
    }
    return pressure_at(edge, read(found.working), route, found);
}

Estimated NormalContact::pressure(Edge edge, const Real& u, Route route) const {
    route = chosen(route);
    return pressure_at(edge, u, route, look(u, edge, base_working_, route));
}

Estimated NormalContact::pressure_at(Edge edge, const Real& u, Route route,
                                     const Look& found) const {
    const unsigned working = found.working;
    Solved& s = at(working);
    const PrecisionScope scope(working);
    Point<Real> point = point_at(s.extent, edge, u);
    if (found.on_knot) {
        if (profile_.has_corner(*found.on_knot)) {
            throw DomainError("the pressure is infinite at a corner of the profile");
        }
        const Real& knot = s.law.slope().knots()[*found.on_knot];
        point = {Real(s.extent.a - knot), Real(s.extent.b + knot), knot};
    }
    RoutedPressure<Real> p{};
    const unsigned target = digits_ + guard_digits / 2;
    switch (route) {
    case Route::barber_mossakovskii:
        if (point.x < 0) {
            // moore-hills EQ21, second branch: the first branch of the mirrored problem.
            const auto& mirror = s.mirrored(profile_, modulus_);
            const Extent<Real> e{s.extent.b, s.extent.a};
            p = barber_mossakovskii(mirror, e, Point<Real>{point.left, point.right, Real(-point.x)},
                                    target);
        } else {
            p = barber_mossakovskii(s.law, s.extent, point, target);
        }
        break;
    case Route::singular_integral:
        p = singular_integral(s.law, s.extent, point, target);
        break;
    default:
        if (!profile_.has_closed_form()) {
            throw DomainError("only a piecewise linear slope or a power law has a closed form");
        }
        p = profile_.piecewise_linear() ? logarithmic_closed_form(s.law, s.marks(), point)
                                        : s.power_law(profile_.parameters().at("m"))(point);
        break;
    }
    if (!p.converged) {
        throw BudgetError("the quadrature of " + route_name(route) +
                          " did not converge within its levels");
    }
    if (work_ != nullptr) {
        ++(route == Route::closed_form ? work_->counts.closed_forms : work_->counts.quadratures);
        work_->evaluations += p.evaluations;
    }
    // The roundoff of the whole computation; the working precision has made up for the digits lost
    // in gaps.
    return {p.value, std::max(p.estimate, s.roundoff), route, p.evaluations, working};
}

std::vector<Real> NormalContact::expansion(Edge edge, std::size_t terms) const {
    if (work_ != nullptr) {
        ++work_->counts.expansions;
    }
    // High coefficients are sums in which terms of the size of binomial coefficients cancel.
    const unsigned working = base_working_ + static_cast<unsigned>(terms);
    const Solved& s = at(working);
    const PrecisionScope scope(working);
    return edge_expansion(s.law, s.extent, edge, terms);
}

Real NormalContact::convergence_radius(Edge edge) const {
    const Solved& s = at(base_working_);
    const PrecisionScope scope(base_working_);
    Real radius = s.extent.length();
    for (const Real& knot : s.law.slope().knots()) {
        const Real d = edge == Edge::right ? Real(s.extent.a - knot) : Real(s.extent.b + knot);
        if (d > 0 && d < radius) {
            radius = d;
        }
    }
    return radius;
}

} // namespace edgeproof::contact
