// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/cost/cost_route.hpp"

#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/witness/witness.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/route/plan.hpp"
#include "edgeproof/scene/route/value_route.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace edgeproof::cost {
namespace {

long bits_of(unsigned digits) {
    return static_cast<long>(static_cast<double>(digits) * 3.3219281) + 64;
}

/// A route of the witness, at the digits asked for.
ReadyContact in_real(const CostCase& c, unsigned digits, contact::Route route) {
    const auto contact = std::make_shared<contact::Witness>(
        *c.scene.profile, c.scene.contact_modulus, c.scene.load, digits);
    return [&c, contact, route](std::size_t i) -> CostValue {
        const auto p = contact->pressure(c.edge, c.u[i], route);
        return {p.value, p.evaluations};
    };
}

/// An enclosure with as many bits as the digits need if nothing cancels.
template <class Contact> ReadyContact in_balls(const CostCase& c, unsigned digits) {
    const auto contact = std::make_shared<Contact>(*c.scene.profile, c.scene.contact_modulus,
                                                   c.scene.load, bits_of(digits));
    return [&c, contact](std::size_t i) -> CostValue {
        const Ball p = contact->pressure(c.edge, c.u[i]);
        return {p.midpoint(), {}, p};
    };
}

/// The method of `edgeproof pressure`: more and more bits until the value rounds as asked.
ReadyContact as_printed(const CostCase& c, unsigned digits) {
    struct Prepared {
        scene::Scene scene;
        scene::Plan plan = {};
        scene::Work work = {};
        std::unique_ptr<scene::ValueRoute> route = nullptr;
    };
    const auto ready = std::make_shared<Prepared>(Prepared{c.scene});
    scene::Scene& scene = ready->scene;
    scene.shear.reset();
    scene.ask = {};
    scene.ask.quantities = {scene::QuantityGroup::pressure};
    scene.ask.edges = {c.edge};
    scene.ask.digits.count = digits;
    for (const formula::Exact& u : c.u) {
        scene.ask.u.push_back({u, 0});
    }
    ready->plan = make_plan(scene);
    ready->route = make_route(scene, ready->plan, ready->work);
    return [&c, ready](std::size_t i) -> CostValue {
        const Ball p =
            ready->route->value({.quantity = scene::Quantity::p, .edge = c.edge, .u = c.u[i]})
                .value;
        return {p.midpoint(), {}, p};
    };
}

bool any(const scene::Scene&) { return true; }
bool closed(const scene::Scene& scene) {
    return contact::BallContact::has_closed_form(*scene.profile);
}
bool curved(const scene::Scene& scene) { return !closed(scene); }

/// For a curved g', the integrand of Barber-Mossakovskii is itself an integral: minutes for each
/// point.
CostRoute in_mpfr(const char* name, contact::Route route,
                  const std::function<bool(const scene::Scene&)>& takes) {
    return {
        name,  "MPFR",
        false, true,
        takes, [route](const CostCase& c, unsigned digits) {
                return in_real(c, digits, route); }};
}

} // namespace

const std::vector<CostRoute>& cost_routes() {
    static const std::vector<CostRoute> routes = [] {
        std::vector<CostRoute> list;
        list.push_back(in_mpfr("Barber-Mossakovskii", contact::Route::barber_mossakovskii, closed));
        list.push_back(in_mpfr("singular integral", contact::Route::singular_integral, any));
        list.push_back({"enclosure", "balls", true, false, closed, in_balls<contact::BallContact>});
        list.push_back(
            {"enclosure", "balls", true, false, curved, in_balls<contact::IntegratedContact>});
        list.push_back({"rounded", "balls", true, false, any, as_printed});
        return list;
    }();
    return routes;
}

} // namespace edgeproof::cost
