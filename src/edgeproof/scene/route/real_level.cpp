// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/route/real_level.hpp"

#include "edgeproof/contact/routes/partial_slip.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/roots/bracketed_root.hpp"
#include "edgeproof/scene/route/plan.hpp"
#include "edgeproof/scene/route/value_route.hpp"

#include <algorithm>

namespace edgeproof::scene {
namespace {

constexpr const char* slip_route = "pressures in the slip zones";

} // namespace

RealLevel::RealLevel(const Profile& profile, const std::optional<Exact>& alpha, const Scene& scene,
                     const Plan& plan, unsigned digits, Work* work)
    : scene_(scene), plan_(plan), digits_(digits), alpha_(alpha),
      contact_(profile, scene.contact_modulus, scene.load, digits, work) {
    if (scene.shear) {
        shear_.emplace(contact_, *scene.shear, work);
    }
}

Real RealLevel::unit() const { return pow(Real(10), -static_cast<int>(digits_ + kept_digits)); }

BoundedValue RealLevel::sound(const Real& x, const char* route) const {
    const PrecisionScope scope(x.precision());
    return estimated(x, Real(abs(x) * unit()), route);
}

BoundedValue RealLevel::given(const Exact& x) const {
    return {ball_of(x, bits()), true, "given", rational_of(x)};
}

BoundedValue RealLevel::a() const {
    return scene_.load.kind == Load::Kind::force ? sound(contact_.a(), "from P")
                                                 : given(scene_.load.value);
}

BoundedValue RealLevel::b() const {
    return scene_.symmetric() ? a() : sound(contact_.b(), "consistency");
}

BoundedValue RealLevel::distance(Edge edge) const {
    return sound(edge == Edge::right ? contact_.a() : contact_.b(), "");
}

BoundedValue RealLevel::force() const {
    const Real P = contact_.force(); // counted in any case
    if (scene_.round) {
        return given(*scene_.round->force);
    }
    return scene_.load.kind == Load::Kind::force ? given(scene_.load.value)
                                                 : sound(P, "contact-law");
}

BoundedValue RealLevel::moment() const {
    const Real M = contact_.moment();
    return scene_.moment ? given(*scene_.moment) : sound(M, "contact-law");
}

BoundedValue RealLevel::alpha() const {
    const PrecisionScope scope(digits_ + tilt_digits);
    return sound(alpha_->to<Real>(), "tilt");
}

RealLevel::Last& RealLevel::at(Edge edge, const Exact& u) {
    const auto is_here = [&](const std::optional<Last>& last) {
        return last && last->edge == edge && last->u == u;
    };
    if (!is_here(last_[0])) {
        std::swap(last_[0], last_[1]);
    }
    if (!is_here(last_[0])) {
        last_[0] = Last{edge, u};
    }
    return *last_[0];
}

/// If the closed form of a power law has no value in balls, its value in Real is not used either.
Route RealLevel::route() const {
    return plan_.proved && !contact_.profile().piecewise_linear() ? Route::singular_integral
                                                                  : plan_.route;
}

const contact::Estimated& RealLevel::pressure(Edge edge, const Exact& u) {
    Last& last = at(edge, u);
    if (!last.p) {
        last.p = contact_.pressure(edge, u, route());
    }
    return *last.p;
}

BoundedValue RealLevel::p(Edge edge, const Exact& u) {
    const contact::Estimated& p = pressure(edge, u);
    const PrecisionScope scope(p.working_digits);
    return estimated(p.value, Real(abs(p.value) * p.estimate), route_name(p.route));
}

BoundedValue RealLevel::q(Edge edge, const Exact& u) {
    if (scene_.slips()) {
        const Real q = slip().traction(edge, u);
        const PrecisionScope scope(q.precision());
        return estimated(q, Real(abs(q) * slip().estimate()), slip_route);
    }
    Last& last = at(edge, u);
    const bool similar = scene_.together();
    if (!last.q) {
        last.q = similar ? shear_->similar_to(pressure(edge, u)) : shear_->traction(edge, u);
    }
    return estimated(last.q->value, last.q->error, similar ? "similar" : "full-stick");
}

BoundedValue RealLevel::peak() {
    const Profile& profile = contact_.profile();
    const PrecisionScope scope(contact_.a().precision());
    for (std::size_t i = 0; i < profile.knots().size(); ++i) {
        const Real x = profile.knots()[i].to<Real>();
        if (profile.has_corner(i) && -contact_.b() < x && x < contact_.a()) {
            refuse_infinite_peak(x);
        }
    }
    const Real length = contact_.a() + contact_.b();
    const auto at = [&](const Real& u) { return contact_.pressure(Edge::right, u, route()).value; };
    constexpr unsigned places = 64;
    unsigned best = 1;
    Real most = 0;
    for (unsigned k = 1; k < places; ++k) {
        check_interruption();
        const Real p = at(Real(length * k / places));
        if (p > most) {
            most = p;
            best = k;
        }
    }
    // Half of the digits of the place give all digits of the pressure, whose slope is zero there.
    const int steps = static_cast<int>(digits_ * 5 / 2) + 20;
    const Real u = roots::place_of_minimum(
        [&](const Real& v) {
            check_interruption();
            return Real(-at(v));
        },
        Real(length * (best - 1) / places + length * unit()),
        Real(length * (best + 1) / places - length * unit()), steps,
        [](const Real& /*value*/) { return false; });
    const Real p = std::max(most, at(u));
    return estimated(p, Real(p * unit() * 100), "scan");
}

const contact::PartialSlip& RealLevel::slip() {
    if (!slip_) {
        try {
            uncounted_.emplace(Profile(contact_.profile()), contact_.contact_modulus(),
                               contact_.load(), digits_);
            slip_.emplace(*uncounted_, *scene_.shear);
        } catch (const InputError& error) {
            throw error.at(scene_.file, scene_.friction_line);
        } catch (const BudgetError& error) {
            throw InputError(error.what(),
                             "give a smaller Q or bulk_tension, or leave friction out")
                .at(scene_.file, scene_.friction_line);
        }
    }
    return *slip_;
}

BoundedValue RealLevel::load_ratio() {
    const contact::PartialSlip& zones = slip();
    const PrecisionScope scope(contact_.a().precision());
    return sound(zones.load_ratio(), "contact-law");
}

BoundedValue RealLevel::slip_size(Edge edge) {
    const PrecisionScope scope(contact_.a().precision());
    const Real d = slip().size(edge);
    return estimated(d, Real(d * slip().estimate()), slip_route);
}

BoundedValue RealLevel::stick_edge(Edge edge) {
    const PrecisionScope scope(contact_.a().precision());
    const Real d = slip().size(edge);
    const Real from = edge == Edge::right ? contact_.a() : contact_.b();
    return estimated(Real(from - d), Real(d * slip().estimate()), slip_route);
}

BoundedValue RealLevel::cycle_energy() {
    const contact::PartialSlip& zones = slip();
    const Real W = contact::cycle_energy(*uncounted_, zones, *scene_.shear->friction);
    const PrecisionScope scope(W.precision());
    return estimated(W, Real(W * zones.estimate()), "Mindlin's loop");
}

const std::vector<BoundedValue>& RealLevel::c(Edge edge) {
    auto& c = c_[edge];
    if (c.empty()) {
        raw_c_[edge] = contact_.expansion(edge, plan_.terms);
        const auto& raw = raw_c_[edge];
        const PrecisionScope scope(raw.front().precision());
        // The error of a coefficient that cancels is relative to the scale of its neighbours.
        const Real radius = contact_.convergence_radius(edge);
        Real scale = abs(raw.front());
        for (const Real& x : raw) {
            c.push_back(estimated(x, Real(std::max(Real(abs(x)), scale) * unit()), series_name()));
            scale /= radius;
        }
    }
    return c;
}

const std::vector<BoundedValue>& RealLevel::s(Edge edge) {
    auto& s = s_[edge];
    const bool similar = scene_.together();
    if (s.empty()) {
        if (similar) {
            (void)c(edge);
        }
        for (const auto& x :
             similar ? shear_->similar_to(raw_c_[edge]) : shear_->expansion(edge, plan_.terms)) {
            s.push_back(estimated(x.value, x.error, similar ? "similar" : "series"));
        }
    }
    return s;
}

BoundedValue RealLevel::sum(Edge edge, const Exact& u, std::size_t n, bool shear) {
    return {sum_of_terms(shear ? s(edge) : c(edge), n, ball_of(u, bits()),
                         shear && !scene_.together(), &BoundedValue::value),
            false, series_name()};
}

BoundedValue RealLevel::relative_error(Edge edge, const Exact& u, std::size_t n, bool shear) {
    const Ball value = (shear ? q(edge, u) : p(edge, u)).value;
    return {1 - sum(edge, u, n, shear).value / value, false, series_name()};
}

std::string RealLevel::series_name() const {
    return contact_.edge_taken_on_knot() ? "series, an edge taken to be on a knot" : "series";
}

} // namespace edgeproof::scene
