// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/algebra/identity.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/route/ball_level.hpp"
#include "edgeproof/scene/route/exact_values.hpp"
#include "edgeproof/scene/route/rows.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>
#include <type_traits>

namespace edgeproof::scene {

namespace {

using Group = QuantityGroup;
using Needs = QuantityRow::Needs;
using Index = QuantityRow::Index;
using Place = QuantityRow::Place;
using Asked = const AskedValue&;
using State = const contact::StressState&;
using Slip = const BallSlip&;

/// Force per length to the first power, times length to the second.
struct Unit {
    int force_power;
    double length_power;
};
namespace units {
constexpr Unit number{0, 0};
constexpr Unit length{0, 1};
constexpr Unit force{1, 0};
constexpr Unit moment{1, 1};
constexpr Unit stress{1, -1};
} // namespace units

/// The evaluators of a row; `f` takes a level of either kind, or only that of balls.
struct Evaluators {
    Ball (*ball)(BallLevel&, Asked);
    Form (*exact)(ExactValues&, Asked);
};
template <class F> constexpr Evaluators both(F f) { return {f, f}; }
template <class F> constexpr Evaluators balls(F f) { return {f, nullptr}; }

/// The name of a route, or the function of the scene that returns it.
struct RouteName {
    constexpr RouteName(const char* name) : fixed(name) {}               // NOLINT: as text
    constexpr RouteName(const char* (*name)(const Scene&)) : by(name) {} // NOLINT: as a function
    const char* fixed = "";
    const char* (*by)(const Scene&) = nullptr;
};

constexpr QuantityRow row(Quantity quantity, std::string_view symbol, std::string_view name,
                          Group group, Place place, Unit unit, Evaluators f, RouteName route,
                          const QuantityOptions& options = {}) {
    return {options,          quantity,          symbol, name,    group,       place,
            unit.force_power, unit.length_power, f.ball, f.exact, route.fixed, route.by};
}

const char* size_given(const Scene& s) {
    const Load::Kind given = s.given_load().kind;
    return given == Load::Kind::force      ? "from P"
           : given == Load::Kind::approach ? "from delta"
                                           : "given";
}
const char* left_edge(const Scene& s) { return s.symmetric() ? size_given(s) : "consistency"; }
/// The route of P and delta of an axisymmetric contact.
const char* integral(const Scene& s) {
    return s.curved_body() ? "rigorous integration" : "closed-form";
}
const char* force(const Scene& s) {
    const Load::Kind given = s.given_load().kind;
    return given == Load::Kind::force ? "given" : s.round ? integral(s) : "contact-law";
}
const char* moment(const Scene& s) { return s.moment ? "given" : "contact-law"; }
const char* pressure(const Scene& s) {
    return s.closed()                               ? "closed-form"
           : s.profile && s.profile->axisymmetric() ? "Abel integral"
                                                    : "rigorous integration";
}
const char* peak(const Scene& s) {
    return peaks_in_the_middle(s) ? "at the origin" : "branch and bound";
}
const char* stuck(const Scene& s) { return s.proportional() ? "similar" : "full-stick"; }
const char* shear(const Scene& s) { return s.slips() ? "superposition" : stuck(s); }
const char* cycle(const Scene& s) { return s.history ? "superposition" : "Mindlin's loop"; }
const char* along_surface(const Scene& s) {
    const bool tilted = s.slips() && s.shear->bulk_tension.sign() != 0;
    return s.round || !s.closed() || (tilted && s.profile && !s.profile->piecewise_linear())
               ? "rigorous integration"
               : "closed-form";
}
const char* in_body(const Scene& s) {
    return !s.closed() || (s.round && !s.round->law) ? "rigorous integration"
           : !s.shear                                ? "closed-form"
                                                     : shear(s);
}

const Exact* given_force(const Scene& s) {
    return s.load.kind == Load::Kind::force ? &s.load.value : nullptr;
}
const Exact* given_moment(const Scene& s) { return s.moment ? &*s.moment : nullptr; }

constexpr QuantityRow of_contact(Quantity quantity, std::string_view symbol, std::string_view name,
                                 Unit unit, Evaluators f, RouteName route,
                                 const QuantityOptions& options = {}) {
    return row(quantity, symbol, name, Group::contact, Place::contact, unit, f, route, options);
}
constexpr QuantityRow at_point(Quantity quantity, std::string_view symbol, std::string_view name,
                               Unit unit, Evaluators f, RouteName route,
                               const QuantityOptions& options = {}) {
    const Group group = options.needs == Needs::shear ? Group::shear : Group::pressure;
    return row(quantity, symbol, name, group, Place::point, unit, f, route, options);
}

/// c_k of p, or s_k of q.
template <bool shear_too>
constexpr QuantityRow coefficient(Quantity quantity, std::string_view symbol, std::string_view name,
                                  Unit unit, RouteName route) {
    return row(
        quantity, symbol, name, Group::coefficients, Place::edge, unit,
        {[](BallLevel& level, Asked v) {
             return (shear_too ? level.s(v.edge) : level.c(v.edge)).at(v.k);
         },
         [](ExactValues& level, Asked v) { return level.coefficient(v.edge, v.k, shear_too); }},
        route, {.index = Index::order, .needs = shear_too ? Needs::shear : Needs::nothing});
}
/// The sum of the first k terms at a point, of p or of q.
template <bool of_q>
constexpr QuantityRow sum(Quantity quantity, std::string_view column, std::string_view name) {
    return at_point(
        quantity, "", name, units::stress,
        both([](auto& level, Asked v) { return level.sum(v.edge, level.place(v), v.k, of_q); }),
        "series",
        {.index = Index::terms, .needs = of_q ? Needs::shear : Needs::nothing, .label = column});
}
/// |1 - sum/value|
template <bool of_q>
constexpr QuantityRow error(Quantity quantity, std::string_view column, std::string_view name) {
    return at_point(quantity, "", name, units::number, both([](auto& level, Asked v) {
                        return abs(level.relative_error(v.edge, level.place(v), v.k, of_q));
                    }),
                    "series",
                    {.index = Index::terms,
                     .needs = of_q ? Needs::shear : Needs::nothing,
                     .label = column,
                     .short_error = true});
}
/// A quantity of k terms at an edge that is found by a search for a tolerance.
constexpr QuantityRow searched(Quantity quantity, std::string_view column, std::string_view name,
                               Group group, Unit unit) {
    const bool slips = group == Group::slip;
    const bool named = quantity == Quantity::extent || quantity == Quantity::measure;
    return row(quantity, named ? column : "", name, group, Place::edge, unit, {}, "",
               {.index = Index::terms,
                .needs = slips ? Needs::friction : Needs::nothing,
                .tolerance = !slips || quantity == Quantity::slip_load,
                .label = column,
                .searched = true,
                .short_error = quantity == Quantity::slip_rel});
}
/// A quantity of the slip; `f` takes the level and the slip.
template <class F>
constexpr QuantityRow of_slip(Quantity quantity, std::string_view symbol, std::string_view name,
                              Unit unit, RouteName route, F /*f*/, QuantityOptions options) {
    options.needs = options.needs == Needs::nothing ? Needs::friction : options.needs;
    return row(quantity, symbol, name, Group::slip, Place::contact, unit,
               balls([](BallLevel& level, Asked) {
                   return level.of_slip([&](Slip slip) { return F{}(level, slip); });
               }),
               route, options);
}
/// A member of the stresses at a point of a body; its name is that of the column. The principal
/// stresses have no symbol in recipes, where s_1, s_2 are coefficients.
template <auto member>
constexpr QuantityRow stress(Quantity quantity, std::string_view name, bool symbol = true) {
    constexpr bool alone = std::is_invocable_v<decltype(member), State>;
    return row(quantity, symbol ? name : "", name, Group::stress, Place::body, units::stress,
               balls([](BallLevel& level, Asked v) -> Ball {
                   if constexpr (alone) {
                       return std::invoke(member, level.stress(v));
                   } else {
                       return std::invoke(member, level.stress(v), level.poisson(v));
                   }
               }),
               in_body, {.needs = alone ? Needs::nothing : Needs::poisson, .label = name});
}
template <std::size_t k> Ball principal(State state, const Ball& nu) {
    return state.principal(nu)[k];
}
template <auto member>
constexpr QuantityRow on_surface(Quantity quantity, std::string_view column, Unit unit, Group group,
                                 Needs needs = Needs::nothing, std::string_view name = "") {
    return row(quantity, "", name.empty() ? column : name, group, Place::surface, unit,
               balls([](BallLevel& level, Asked v) { return (level.*member)(v); }), along_surface,
               {.needs = needs, .label = column});
}

/// The rows are in the order of Quantity.
constexpr auto quantity_table = std::to_array<QuantityRow>({
    at_point(Quantity::p, "p", "pressure", units::stress,
             both([](auto& l, Asked v) { return l.p(v.edge, l.place(v)); }), pressure,
             {.cancels_little = true}),
    at_point(Quantity::q, "q", "shear", units::stress,
             both([](auto& l, Asked v) { return l.q(v.edge, l.place(v)); }), shear,
             {.needs = Needs::shear}),
    coefficient<false>(Quantity::c, "c", "coefficient", {1, -1.5}, "series"),
    coefficient<true>(Quantity::s, "s", "shear-coefficient", {1, -0.5}, stuck),
    of_contact(Quantity::a, "a", "right-edge", units::length,
               both([](auto& l, Asked) { return l.a(); }), size_given,
               {.distance_of = Edge::right, .cancels_little = true}),
    of_contact(Quantity::b, "b", "left-edge", units::length,
               both([](auto& l, Asked) { return l.b(); }), left_edge,
               {.distance_of = Edge::left, .cancels_little = true}),
    of_contact(Quantity::P, "P", "load", units::force,
               both([](auto& l, Asked) { return l.whole_force(); }), force, {.given = given_force}),
    of_contact(Quantity::M, "M", "moment", units::moment,
               both([](auto& l, Asked) { return l.moment(); }), moment,
               {.needs = Needs::plane, .given = given_moment}),
    of_contact(Quantity::alpha, "alpha", "tilt", units::number,
               {[](BallLevel& l, Asked) { return l.tilt().alpha; },
                [](ExactValues&, Asked) { return Form(0); }}, // known only if it is zero
               "tilt", {.needs = Needs::unknown_tilt}),
    searched(Quantity::extent, "extent", "extent", Group::extent, units::length),
    searched(Quantity::measure, "measure", "measure", Group::extent, units::length),
    row(Quantity::slip, "slip", "slip-zone", Group::slip, Place::edge, units::length,
        balls([](BallLevel& l, Asked v) { return l.slip_size(v.edge); }), "stick zone",
        {.needs = Needs::friction, .meaning = "size of the slip zone"}),
    of_slip(Quantity::stick_a, "stick_a", "stick-right-edge", units::length, "stick zone",
            [](BallLevel&, Slip slip) { return slip.stick().a; },
            {.meaning = "right edge of the stick zone"}),
    of_slip(Quantity::stick_b, "stick_b", "stick-left-edge", units::length, "stick zone",
            [](BallLevel&, Slip slip) { return slip.stick().b; },
            {.meaning = "left edge of the stick zone"}),
    row(Quantity::p_max, "p_max", "peak-pressure", Group::peak, Place::contact, units::stress,
        both([](auto& l, Asked) { return l.peak(); }), peak, {.meaning = "the greatest pressure"}),
    of_slip(Quantity::cycle_energy, "cycle_energy", "cycle-energy", units::moment, cycle,
            [](BallLevel& l, Slip slip) { return l.cycle_energy(slip); },
            {.needs = Needs::friction_alone,
             .meaning = "the energy dissipated by friction in a cycle",
             .may_be_missing = true}),
    at_point(Quantity::x, "", "coordinate", units::length,
             both([](auto& l, Asked v) { return l.x(v.edge, l.place(v)); }), "given",
             {.label = "x", .cancels_little = true}),
    at_point(Quantity::u, "", "distance", units::length,
             {[](BallLevel& l, Asked v) { return l.distance(v.distance()); },
              [](ExactValues& l, Asked v) { return l.place(v); }},
             "given", {.label = "u", .cancels_little = true}),
    sum<false>(Quantity::local, "local", "local-pressure"),
    error<false>(Quantity::rel, "rel", "relative-error"),
    sum<true>(Quantity::q_local, "q_local", "local-shear"),
    error<true>(Quantity::q_rel, "q_rel", "relative-error-of-shear"),
    searched(Quantity::extent_fraction, "extent_fraction", "extent-fraction", Group::extent,
             units::number),
    searched(Quantity::measure_fraction, "measure_fraction", "measure-fraction", Group::extent,
             units::number),
    searched(Quantity::crossing, "crossing", "crossing", Group::extent, units::length),
    of_slip(Quantity::load_ratio, "", "load-ratio", units::number, "stick zone",
            [](BallLevel&, Slip slip) { return slip.load_ratio(); }, {.label = "load_ratio"}),
    of_slip(Quantity::least_tension, "", "least-bulk-tension", units::stress, "stick zone",
            [](BallLevel& l, Slip slip) { return l.tension_limit(slip, Edge::right); },
            {.label = "least_tension", .may_be_missing = true}),
    of_slip(Quantity::most_tension, "", "most-bulk-tension", units::stress, "stick zone",
            [](BallLevel& l, Slip slip) { return l.tension_limit(slip, Edge::left); },
            {.label = "most_tension", .may_be_missing = true}),
    searched(Quantity::slip_terms, "slip_terms", "slip-zone-by-terms", Group::slip, units::length),
    searched(Quantity::slip_rel, "slip_rel", "relative-error-of-slip-zone", Group::slip,
             units::number),
    searched(Quantity::slip_load, "slip_load", "slip-load", Group::slip, units::number),
    stress<&contact::StressState::sxx>(Quantity::sxx, "sxx"),
    stress<&contact::StressState::szz>(Quantity::szz, "szz"),
    stress<&contact::StressState::sxz>(Quantity::sxz, "sxz"),
    stress<&contact::StressState::mises>(Quantity::mises, "mises"),
    stress<&contact::StressState::tau_max>(Quantity::tau_max, "tau_max"),
    stress<&contact::StressState::syy>(Quantity::syy, "syy"),
    stress<principal<0>>(Quantity::s1, "s1", false),
    stress<principal<1>>(Quantity::s2, "s2", false),
    stress<principal<2>>(Quantity::s3, "s3", false),
    stress<&contact::StressState::tresca>(Quantity::tresca, "tresca"),
    of_slip(Quantity::step_energy, "step_energy", "step-energy", units::moment, "superposition",
            [](BallLevel& l, Slip) { return l.step_energy(); },
            {.needs = Needs::history,
             .meaning = "the energy dissipated by friction in the last step",
             .may_be_missing = true}),
    on_surface<&BallLevel::gap>(Quantity::gap, "gap", units::length, Group::displacement),
    on_surface<&BallLevel::slip_displacement>(Quantity::slip_displacement, "slip_displacement",
                                              units::length, Group::displacement, Needs::nothing,
                                              "slip"),
    of_contact(Quantity::delta, "delta", "approach", units::length,
               both([](auto& l, Asked) { return l.approach(); }), integral,
               {.needs = Needs::round, .meaning = "approach of the bodies"}),
    of_contact(Quantity::stiffness, "stiffness", "contact-stiffness", units::force,
               both([](auto& l, Asked) { return l.stiffness(); }), "closed-form",
               {.needs = Needs::round, .meaning = "contact stiffness dP/d delta"}),
    on_surface<&BallLevel::ux>(Quantity::ux, "ux", units::length, Group::surface, Needs::reference),
    on_surface<&BallLevel::uz>(Quantity::uz, "uz", units::length, Group::surface, Needs::reference),
    on_surface<&BallLevel::surface_slope>(Quantity::slope, "slope", units::number, Group::surface,
                                          Needs::reference),
    on_surface<&BallLevel::dissipation>(Quantity::dissipation, "dissipation", units::force,
                                        Group::surface, Needs::cycle),
});

/// The rows are in the order of QuantityGroup.
constexpr std::array group_table{
    GroupRow{.group = QuantityGroup::pressure, .name = "pressure", .points = true},
    GroupRow{.group = QuantityGroup::coefficients,
             .name = "coefficients",
             .terms = true,
             .incomplete = "coefficients are requested, but no number of terms",
             .instead = "add terms = 3 to [ask]"},
    GroupRow{.group = QuantityGroup::shear, .name = "shear", .points = true, .shear = true},
    GroupRow{.group = QuantityGroup::extent,
             .name = "extent",
             .terms = true,
             .tolerance = true,
             .incomplete = "an extent needs a number of terms and a tolerance",
             .instead = "add terms = 1 and tolerance = \"1%\" to [ask]"},
    GroupRow{.group = QuantityGroup::slip, .name = "slip", .friction = true},
    GroupRow{.group = QuantityGroup::contact, .name = "contact"},
    GroupRow{.group = QuantityGroup::peak, .name = "peak"},
    GroupRow{.group = QuantityGroup::stress, .name = "stress"},
    GroupRow{.group = QuantityGroup::displacement, .name = "displacement"},
    GroupRow{.group = QuantityGroup::surface, .name = "surface"},
};

template <class Table> consteval bool is_in_order(const Table& table, auto key) {
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (static_cast<std::size_t>(table[i].*key) != i) {
            return false;
        }
    }
    return true;
}
static_assert(is_in_order(quantity_table, &QuantityRow::quantity));
static_assert(is_in_order(group_table, &GroupRow::group));

} // namespace

std::span<const QuantityRow> quantity_rows() { return quantity_table; }
const QuantityRow& row_of(Quantity quantity) {
    return quantity_table.at(static_cast<std::size_t>(quantity));
}
std::span<const GroupRow> group_rows() { return group_table; }

const Row* RowsAt::find(Quantity quantity, std::size_t k, std::size_t j) const {
    const auto found = std::find_if(begin(), end(), [&](const Row& row) {
        return row.asked.quantity == quantity && row.asked.k == k && row.asked.j == j;
    });
    return found == end() ? nullptr : &*found;
}

const Row& RowsAt::row(Quantity quantity, std::size_t k) const {
    if (const Row* found = find(quantity, k)) {
        return *found;
    }
    throw Error("a " + std::string(row_of(quantity).name) + " was not computed");
}

const BoundedValue& RowsAt::at(Quantity quantity, std::size_t k) const {
    if (const auto& value = row(quantity, k).value) {
        return *value;
    }
    throw Error("a " + std::string(row_of(quantity).name) + " was not found");
}

} // namespace edgeproof::scene
