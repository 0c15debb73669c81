// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/validation/asked_value.hpp"

#include "edgeproof/formula/exact/exact_ball.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/value_route.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace edgeproof::validation {
namespace {

using Kind = AskedValue::Kind;

constexpr std::array<std::pair<Kind, std::string_view>, 9> names{{
    {Kind::pressure, "pressure"},
    {Kind::coefficient, "coefficient"},
    {Kind::residual, "residual"},
    {Kind::shear, "shear"},
    {Kind::shear_coefficient, "shear-coefficient"},
    {Kind::load, "load"},
    {Kind::left_edge, "left-edge"},
    {Kind::tilt_difference, "tilt-difference"},
    {Kind::extent, "extent"},
}};

/// Bits of a difference are raised until it has its digits, this far.
constexpr unsigned most_cancelled = 4000;

/// A route and all that it keeps references to.
class Routed {
public:
    explicit Routed(scene::Scene scene) : scene_(std::move(scene)), plan_(make_plan(scene_)) {
        route_ = plan_.proved ? make_ball_route(scene_, plan_, work_)
                              : make_real_route(scene_, plan_, work_);
    }
    Routed(const Routed&) = delete;
    Routed& operator=(const Routed&) = delete;
    [[nodiscard]] scene::ValueRoute& operator*() { return *route_; }
    [[nodiscard]] scene::ValueRoute* operator->() { return route_.get(); }

private:
    scene::Scene scene_;
    scene::Plan plan_;
    contact::Work work_;
    std::unique_ptr<scene::ValueRoute> route_;
};

scene::BoundedValue pressure_of(const scene::Scene& scene, const AskedValue& asked,
                                unsigned digits) {
    AskedValue plain = asked;
    plain.kind = Kind::pressure;
    Routed route(asking(scene, plain, digits));
    return *route->at(asked.edge, *asked.u, true, false).p;
}

/// x - y, of balls that grow narrower until the difference has its digits.
scene::BoundedValue tilt_difference(const scene::Scene& scene, const AskedValue& asked,
                                    unsigned digits) {
    const scene::Scene other = upright(scene);
    for (unsigned extra = 32;; extra *= 2) {
        const scene::BoundedValue p = pressure_of(scene, asked, digits + extra);
        const scene::BoundedValue q = pressure_of(other, asked, digits + extra);
        scene::BoundedValue d{p.value - q.value, p.proved && q.proved, p.route};
        if (scene::settles(d.value, {digits, Rounding::nearest, false}) ||
            extra >= most_cancelled) {
            return d;
        }
    }
}

/// 1 - (the first n terms)/p, with its sign.
scene::BoundedValue residual(const scene::Scene& scene, const AskedValue& asked, unsigned digits) {
    for (unsigned extra = 32;; extra *= 2) {
        scene::Scene raised = asking(scene, asked, digits + extra);
        raised.ask.terms = {asked.n};
        Routed route(std::move(raised));
        const scene::PointValues at = route->at(asked.edge, *asked.u, true, false);
        const scene::EdgeValues edge = route->expansion(asked.edge, true, false);
        const Ball u = ball_of(*asked.u, formula::bits_for(digits + extra) + 64);
        Ball sum = edge.c[asked.n - 1].value;
        bool proved = at.p->proved;
        for (std::size_t k = asked.n; k-- > 0;) {
            proved = proved && edge.c[k].proved;
            sum = k + 1 < asked.n ? sum * u + edge.c[k].value : sum;
        }
        scene::BoundedValue d{1 - sum * sqrt(u) / at.p->value, proved, "series"};
        if (scene::settles(d.value, {digits, Rounding::nearest, false}) ||
            extra >= most_cancelled) {
            return d;
        }
    }
}

} // namespace

std::string kind_name(Kind kind) {
    const auto* const found = std::find_if(names.begin(), names.end(),
                                           [&](const auto& entry) { return entry.first == kind; });
    return std::string(found->second);
}

std::optional<Kind> asked_kind(std::string_view name) {
    for (const auto& [kind, text] : names) {
        if (text == name) {
            return kind;
        }
    }
    return {};
}

std::string asked_text(const AskedValue& asked) {
    const std::string n = std::to_string(asked.n);
    const std::string edge = scene::edge_name(asked.edge) + " edge";
    const std::string at = asked.u ? " at u = " + asked.u->text() + " from the " + edge : "";
    switch (asked.kind) {
    case Kind::pressure:
        return "p" + at;
    case Kind::coefficient:
        return "c_" + n + " at the " + edge;
    case Kind::residual:
        return "residual of " + n + " terms" + at;
    case Kind::shear:
        return "q" + at;
    case Kind::shear_coefficient:
        return "s_" + n + " at the " + edge;
    case Kind::load:
        return "P";
    case Kind::left_edge:
        return "b";
    case Kind::tilt_difference:
        return "p less that without tilt" + at;
    case Kind::extent:
        break;
    }
    return "extent of " + n + " terms at the " + edge;
}

scene::Scene asking(const scene::Scene& scene, const AskedValue& asked, unsigned digits) {
    scene::Scene s = scene;
    s.ask = scene::Ask{};
    s.ask.edges = {asked.edge};
    s.ask.digits.count = digits;
    if (asked.u) {
        s.ask.u = {{*asked.u, 0}};
    }
    switch (asked.kind) {
    case Kind::pressure:
    case Kind::tilt_difference:
        s.ask.quantities = {scene::Quantity::pressure};
        break;
    case Kind::residual:
        s.ask.quantities = {scene::Quantity::pressure, scene::Quantity::coefficients};
        s.ask.terms = {asked.n};
        break;
    case Kind::coefficient:
    case Kind::shear_coefficient:
        s.ask.quantities = {scene::Quantity::coefficients};
        s.ask.terms = {asked.n + 1};
        break;
    case Kind::shear:
        s.ask.quantities = {scene::Quantity::shear};
        break;
    case Kind::load:
    case Kind::left_edge:
        s.ask.quantities = {scene::Quantity::contact};
        break;
    case Kind::extent:
        s.ask.quantities = {scene::Quantity::extent};
        s.ask.terms = {asked.n};
        s.ask.tolerance = asked.tolerance;
        break;
    }
    if (asked.kind != Kind::shear && asked.kind != Kind::shear_coefficient) {
        s.shear.reset();
    }
    return s;
}

scene::Scene upright(const scene::Scene& scene) {
    const formula::Exact none = formula::Exact::of(Rational(0));
    const auto& parameters = scene.profile->parameters();
    scene::Scene s = scene;
    switch (scene.profile->kind()) {
    case contact::Profile::Kind::tilted_wedge:
        s.profile = contact::Profile::tilted_wedge(parameters.at("phi"), none);
        return s;
    case contact::Profile::Kind::tilted_flat_and_rounded:
        s.profile =
            contact::Profile::tilted_flat_and_rounded(none, parameters.at("t"), parameters.at("R"));
        return s;
    default:
        throw InputError("a " + scene.profile->kind_name() + " profile has no tilt",
                         "take a tilted-wedge or tilted-flat-and-rounded profile");
    }
}

scene::BoundedValue enclosed_value(const scene::Scene& scene, const AskedValue& asked,
                                   unsigned digits) {
    if (asked.kind == Kind::tilt_difference) {
        return tilt_difference(scene, asked, digits);
    }
    if (asked.kind == Kind::residual) {
        return residual(scene, asked, digits);
    }
    Routed route(asking(scene, asked, digits));
    switch (asked.kind) {
    case Kind::pressure:
        return *route->at(asked.edge, *asked.u, true, false).p;
    case Kind::shear:
        return *route->at(asked.edge, *asked.u, false, true).q;
    case Kind::coefficient:
        return route->expansion(asked.edge, true, false).c.at(asked.n);
    case Kind::shear_coefficient:
        return route->expansion(asked.edge, false, true).s.at(asked.n);
    case Kind::load:
        return *route->contact().force;
    case Kind::left_edge:
        return route->contact().b;
    default:
        break;
    }
    const scene::ExtentValues extent = route->extent(asked.edge, asked.n);
    if (!extent.leaves) {
        throw DomainError("there is no first exit: the terms stay within the tolerance");
    }
    return extent.first_exit;
}

} // namespace edgeproof::validation
