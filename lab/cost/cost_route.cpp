// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/cost/cost_route.hpp"

#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"
#include "edgeproof/contact/routes/pressure_routes.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/route/plan.hpp"
#include "edgeproof/scene/route/value_route.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace edgeproof::cost {
namespace {

constexpr unsigned most_machine_digits = 40;

long bits_of(unsigned digits) {
    return static_cast<long>(static_cast<double>(digits) * 3.3219281) + 64;
}

/// A route that is a template, in a hardware arithmetic.
template <Arithmetic T> ReadyContact in_machine(const CostCase& c, contact::Route route) {
    using contact::Point;
    const contact::ContactLaw<T> law(*c.scene.profile, c.scene.contact_modulus.to<T>());
    const contact::ContactLaw<T> mirrored(c.scene.profile->reflected(),
                                          c.scene.contact_modulus.to<T>());
    const T load = c.scene.load.value.to<T>();
    const contact::Extent<T> extent = law.extent(
        c.scene.load.kind == contact::Load::Kind::right_edge ? load
                                                             : law.right_edge_for_force(load));
    std::vector<Point<T>> points;
    for (const formula::Exact& u : c.u) {
        points.push_back(point_at(extent, c.edge, u.to<T>()));
    }
    const auto by = [=](const Point<T>& at) {
        if (route == contact::Route::closed_form) {
            return logarithmic_closed_form(law, extent, at);
        }
        if (route == contact::Route::singular_integral) {
            return singular_integral(law, extent, at);
        }
        return at.x < T(0) ? barber_mossakovskii(mirrored, contact::Extent<T>{extent.b, extent.a},
                                                 Point<T>{at.left, at.right, T(-at.x)})
                           : barber_mossakovskii(law, extent, at);
    };
    return [by, points = std::move(points)](std::size_t i) -> CostValue {
        const contact::RoutedPressure<T> p = by(points[i]);
        const PrecisionScope scope(most_machine_digits);
        return {Real(p.value), p.evaluations, {}};
    };
}

/// A route of NormalContact, at the digits asked for.
ReadyContact in_real(const CostCase& c, unsigned digits, contact::Route route) {
    const auto contact = std::make_shared<contact::NormalContact>(
        *c.scene.profile, c.scene.contact_modulus, c.scene.load, digits);
    return [&c, contact, route](std::size_t i) -> CostValue {
        const contact::Estimated p = contact->pressure(c.edge, c.u[i], route);
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
        contact::Work work = {};
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
bool piecewise_linear(const scene::Scene& scene) { return scene.profile->piecewise_linear(); }
bool closed(const scene::Scene& scene) {
    return contact::BallContact::has_closed_form(*scene.profile);
}
bool curved(const scene::Scene& scene) {
    return !closed(scene) && contact::IntegratedContact::handles(*scene.profile);
}

/// For a curved g', the integrand of Barber-Mossakovskii is itself an integral: minutes for each
/// point.
std::function<bool(const scene::Scene&)> taken_by(contact::Route route, bool machine) {
    return route == contact::Route::barber_mossakovskii ? closed
           : route != contact::Route::closed_form       ? any
           : machine                                    ? piecewise_linear
                                                        : closed;
}

template <Arithmetic T>
CostRoute machine_route(const std::string& name, const char* arithmetic, unsigned digits,
                        contact::Route route) {
    return {name,
            arithmetic,
            digits,
            false,
            false,
            taken_by(route, true),
            [route](const CostCase& c, unsigned) { return in_machine<T>(c, route); }};
}

void add_all_arithmetics(std::vector<CostRoute>& routes, const std::string& name,
                         contact::Route route) {
    routes.push_back(machine_route<double>(name, "double", 16, route));
    routes.push_back(machine_route<long double>(name, "long double", 19, route));
    routes.push_back(machine_route<Float128>(name, "__float128", 34, route));
    routes.push_back(
        {name, "MPFR", 0, false, route != contact::Route::closed_form, taken_by(route, false),
         [route](const CostCase& c, unsigned digits) { return in_real(c, digits, route); }});
}

} // namespace

const std::vector<CostRoute>& cost_routes() {
    static const std::vector<CostRoute> routes = [] {
        std::vector<CostRoute> list;
        add_all_arithmetics(list, "Barber-Mossakovskii", contact::Route::barber_mossakovskii);
        add_all_arithmetics(list, "singular integral", contact::Route::singular_integral);
        add_all_arithmetics(list, "closed form", contact::Route::closed_form);
        list.push_back(
            {"enclosure", "balls", 0, true, false, closed, in_balls<contact::BallContact>});
        list.push_back(
            {"enclosure", "balls", 0, true, false, curved, in_balls<contact::IntegratedContact>});
        list.push_back({"rounded", "balls", 0, true, false,
                        [](const scene::Scene& scene) { return closed(scene) || curved(scene); },
                        as_printed});
        return list;
    }();
    return routes;
}

} // namespace edgeproof::cost
