// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/quantity.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/route/ball_level.hpp"
#include "edgeproof/scene/route/exact_values.hpp"
#include "edgeproof/scene/route/plan.hpp"
#include "edgeproof/scene/route/real_level.hpp"

#include <array>

namespace edgeproof::scene {
namespace {

using Def = QuantityRow;
using formula::ExactNumber;

bool is_together(const Scene& s) {
    return s.shear && s.shear->path == contact::LoadingPath::together;
}
bool is_force_given(const Scene& s) { return s.load.kind == contact::Load::Kind::force; }
const char* traction_route(const Scene& s, const Plan& /*plan*/) {
    return s.slips() ? "superposition" : is_together(s) ? "similar" : "full-stick";
}
const char* given(const Scene& /*scene*/, const Plan& /*plan*/) { return "given"; }
const char* series(const Scene& /*scene*/, const Plan& /*plan*/) { return "series"; }
const char* stick_zone(const Scene& /*scene*/, const Plan& /*plan*/) { return "stick zone"; }
ExactNumber no_exact_form_of(ExactValues& /*values*/, const AskedValue& /*asked*/) {
    return ExactNumber::unknown();
}
const char* full_stick_or_similar(const Scene& s, const Plan& /*plan*/) {
    return is_together(s) ? "similar" : "full-stick";
}
const char* by_load(const Scene& s, const Plan& /*plan*/) {
    return is_force_given(s) ? "from P" : "given";
}

// The sum of the first k terms at a point, and |1 - sum/value|: of p, or of q (`shear`).
template <bool shear> Ball ball_sum(BallLevel& l, const AskedValue& v) {
    return l.sum(v.edge, v.distance(), v.k, shear);
}
template <bool shear> ExactNumber exact_sum(ExactValues& e, const AskedValue& v) {
    return e.sum(v.edge, e.u(v.distance()), v.k, shear);
}
template <bool shear> BoundedValue real_sum(RealLevel& l, const AskedValue& v) {
    return {l.sum(v.edge, *v.u, v.k, shear), false, l.series_name()};
}
template <bool shear> Ball ball_error(BallLevel& l, const AskedValue& v) {
    return abs(l.relative_error(v.edge, v.distance(), v.k, shear));
}
template <bool shear> ExactNumber exact_error(ExactValues& e, const AskedValue& v) {
    return abs(e.error(v.edge, e.u(v.distance()), v.k, shear));
}
template <bool shear> BoundedValue real_error(RealLevel& l, const AskedValue& v) {
    const Ball value = (shear ? l.q(v.edge, *v.u) : l.p(v.edge, *v.u)).value;
    return {abs(Ball(1 - l.sum(v.edge, *v.u, v.k, shear) / value)), false, l.series_name()};
}

/// A quantity of k terms at an edge that is found by a search for a tolerance.
constexpr Def searched(Quantity quantity, std::string_view symbol, std::string_view name,
                       QuantityGroup group, double length_power) {
    const bool slips = group == QuantityGroup::slip;
    return {.quantity = quantity,
            .symbol = symbol,
            .name = name,
            .group = group,
            .place = Def::Place::edge,
            .index = Def::Index::terms,
            .needs = slips ? Def::Needs::friction : Def::Needs::nothing,
            .tolerance = !slips || quantity == Quantity::slip_load,
            .length_power = length_power,
            .searched = true,
            .short_error = quantity == Quantity::slip_rel};
}
template <bool shear> constexpr Def sum_of_terms(Quantity quantity, std::string_view name) {
    return {.quantity = quantity,
            .symbol = "",
            .name = name,
            .group = shear ? QuantityGroup::shear : QuantityGroup::pressure,
            .place = Def::Place::point,
            .index = Def::Index::terms,
            .needs = shear ? Def::Needs::shear : Def::Needs::nothing,
            .force_power = 1,
            .length_power = -1,
            .ball = ball_sum<shear>,
            .exact = exact_sum<shear>,
            .real = real_sum<shear>,
            .route = series};
}
template <bool shear> constexpr Def error_of_terms(Quantity quantity, std::string_view name) {
    Def def = sum_of_terms<shear>(quantity, name);
    def.force_power = 0;
    def.length_power = 0;
    def.ball = ball_error<shear>;
    def.exact = exact_error<shear>;
    def.real = real_error<shear>;
    def.short_error = true;
    return def;
}
template <contact::Edge edge>
constexpr Def edge_of_stick(Quantity quantity, std::string_view symbol, std::string_view name,
                            std::string_view meaning) {
    return {.quantity = quantity,
            .symbol = symbol,
            .name = name,
            .group = QuantityGroup::slip,
            .needs = Def::Needs::friction,
            .length_power = 1,
            .meaning = meaning,
            .ball = [](BallLevel& l, const AskedValue& /*asked*/) { return l.stick_edge(edge); },
            .exact = no_exact_form_of,
            .real = [](RealLevel& l, const AskedValue& /*asked*/) { return l.stick_edge(edge); },
            .route = stick_zone};
}
template <contact::Edge ahead>
constexpr Def tension_limit(Quantity quantity, std::string_view name) {
    return {
        .quantity = quantity,
        .symbol = "",
        .name = name,
        .group = QuantityGroup::slip,
        .needs = Def::Needs::friction,
        .force_power = 1,
        .length_power = -1,
        .ball = [](BallLevel& l, const AskedValue& /*asked*/) { return l.tension_limit(ahead); },
        .exact = no_exact_form_of,
        .route = stick_zone,
        .may_be_missing = true};
}

/// The rows are in the order of Quantity.
constexpr std::array quantity_table{
    Def{.quantity = Quantity::p,
        .symbol = "p",
        .name = "pressure",
        .group = QuantityGroup::pressure,
        .place = Def::Place::point,
        .force_power = 1,
        .length_power = -1,
        .ball = [](BallLevel& l, const AskedValue& v) { return l.p(v.edge, v.distance()); },
        .exact = [](ExactValues& e, const AskedValue& v) { return e.p(v.edge, e.u(v.distance())); },
        .real = [](RealLevel& l, const AskedValue& v) { return l.p(v.edge, *v.u); },
        .route =
            [](const Scene& /*scene*/, const Plan& plan) {
                return plan.route == contact::Route::closed_form ? "closed-form"
                                                                 : "singular-integral";
            },
        .cancels_little = true},
    Def{.quantity = Quantity::q,
        .symbol = "q",
        .name = "shear",
        .group = QuantityGroup::shear,
        .place = Def::Place::point,
        .needs = Def::Needs::shear,
        .force_power = 1,
        .length_power = -1,
        .ball = [](BallLevel& l, const AskedValue& v) { return l.q(v.edge, v.distance()); },
        .exact = [](ExactValues& e, const AskedValue& v) { return e.q(v.edge, e.u(v.distance())); },
        .real = [](RealLevel& l, const AskedValue& v) { return l.q(v.edge, *v.u); },
        .route = traction_route},
    Def{.quantity = Quantity::c,
        .symbol = "c",
        .name = "coefficient",
        .group = QuantityGroup::coefficients,
        .place = Def::Place::edge,
        .index = Def::Index::order,
        .force_power = 1,
        .length_power = -1.5,
        .ball = [](BallLevel& l, const AskedValue& v) { return l.c(v.edge).at(v.k); },
        .exact = [](ExactValues& e, const AskedValue& v) { return e.c_k(v.edge, v.k); },
        .real = [](RealLevel& l, const AskedValue& v) { return l.c(v.edge).at(v.k); },
        .route = series},
    Def{.quantity = Quantity::s,
        .symbol = "s",
        .name = "shear-coefficient",
        .group = QuantityGroup::coefficients,
        .place = Def::Place::edge,
        .index = Def::Index::order,
        .needs = Def::Needs::shear,
        .force_power = 1,
        .length_power = -0.5,
        .ball = [](BallLevel& l, const AskedValue& v) { return l.s(v.edge).at(v.k); },
        .exact = [](ExactValues& e, const AskedValue& v) { return e.s_k(v.edge, v.k); },
        .real = [](RealLevel& l, const AskedValue& v) { return l.s(v.edge).at(v.k); },
        .route = full_stick_or_similar},
    Def{.quantity = Quantity::a,
        .symbol = "a",
        .name = "right-edge",
        .length_power = 1,
        .ball = [](BallLevel& l, const AskedValue& /*asked*/) { return l.a(); },
        .exact = [](ExactValues& e, const AskedValue& /*asked*/) { return e.a(); },
        .real = [](RealLevel& l, const AskedValue& /*asked*/) { return l.a(); },
        .route = by_load,
        .distance_of = contact::Edge::right,
        .cancels_little = true},
    Def{.quantity = Quantity::b,
        .symbol = "b",
        .name = "left-edge",
        .length_power = 1,
        .ball = [](BallLevel& l, const AskedValue& /*asked*/) { return l.b(); },
        .exact = [](ExactValues& e, const AskedValue& /*asked*/) { return e.b(); },
        .real = [](RealLevel& l, const AskedValue& /*asked*/) { return l.b(); },
        .route = [](const Scene& s,
                    const Plan& plan) { return s.symmetric() ? by_load(s, plan) : "consistency"; },
        .distance_of = contact::Edge::left,
        .cancels_little = true},
    Def{.quantity = Quantity::P,
        .symbol = "P",
        .name = "load",
        .force_power = 1,
        .ball = [](BallLevel& l, const AskedValue& /*asked*/) { return l.force(); },
        .exact = [](ExactValues& e, const AskedValue& /*asked*/) { return e.force(); },
        .real = [](RealLevel& l, const AskedValue& /*asked*/) { return l.force(); },
        .route = [](const Scene& s,
                    const Plan& /*plan*/) { return is_force_given(s) ? "given" : "contact-law"; },
        .given = [](const Scene& s) { return is_force_given(s) ? &s.load.value : nullptr; }},
    Def{.quantity = Quantity::M,
        .symbol = "M",
        .name = "moment",
        .force_power = 1,
        .length_power = 1,
        .ball = [](BallLevel& l, const AskedValue& /*asked*/) { return l.moment(); },
        .exact = [](ExactValues& e, const AskedValue& /*asked*/) { return e.moment(); },
        .real = [](RealLevel& l, const AskedValue& /*asked*/) { return l.moment(); },
        .route = [](const Scene& s,
                    const Plan& /*plan*/) { return s.moment ? "given" : "contact-law"; },
        .given = [](const Scene& s) { return s.moment ? &*s.moment : nullptr; }},
    Def{.quantity = Quantity::alpha,
        .symbol = "alpha",
        .name = "tilt",
        .needs = Def::Needs::unknown_tilt,
        .ball = [](BallLevel& l, const AskedValue& /*asked*/) { return l.tilt().alpha; },
        // Under a tilt that is solved for, exact values exist only if the tilt is known to be zero.
        .exact = [](ExactValues& /*values*/,
                    const AskedValue& /*asked*/) { return ExactNumber(0); },
        .real = [](RealLevel& l, const AskedValue& /*asked*/) { return l.alpha(); },
        .route = [](const Scene& /*scene*/, const Plan& /*plan*/) { return "tilt"; }},
    searched(Quantity::extent, "extent", "extent", QuantityGroup::extent, 1),
    searched(Quantity::measure, "measure", "measure", QuantityGroup::extent, 1),
    Def{.quantity = Quantity::slip,
        .symbol = "slip",
        .name = "slip-zone",
        .group = QuantityGroup::slip,
        .place = Def::Place::edge,
        .needs = Def::Needs::friction,
        .length_power = 1,
        .meaning = "size of the slip zone",
        .ball = [](BallLevel& l, const AskedValue& v) { return l.slip_size(v.edge); },
        .exact = no_exact_form_of,
        .real = [](RealLevel& l, const AskedValue& v) { return l.slip_size(v.edge); },
        .route = stick_zone},
    edge_of_stick<contact::Edge::right>(Quantity::stick_a, "stick_a", "stick-right-edge",
                                        "right edge of the stick zone"),
    edge_of_stick<contact::Edge::left>(Quantity::stick_b, "stick_b", "stick-left-edge",
                                       "left edge of the stick zone"),
    Def{.quantity = Quantity::residual,
        .symbol = "",
        .name = "residual",
        .group = QuantityGroup::pressure,
        .place = Def::Place::point,
        .index = Def::Index::terms},
    Def{.quantity = Quantity::tilt_difference,
        .symbol = "",
        .name = "tilt-difference",
        .group = QuantityGroup::pressure,
        .place = Def::Place::point,
        .force_power = 1,
        .length_power = -1,
        .label = "p minus p without tilt"},
    Def{.quantity = Quantity::p_max,
        .symbol = "p_max",
        .name = "peak-pressure",
        .group = QuantityGroup::peak,
        .force_power = 1,
        .length_power = -1,
        .meaning = "the greatest pressure",
        .ball = [](BallLevel& l, const AskedValue& /*asked*/) { return l.peak(); },
        .exact = [](ExactValues& e, const AskedValue& /*asked*/) { return e.peak(); },
        .real = [](RealLevel& l, const AskedValue& /*asked*/) { return l.peak(); },
        .route =
            [](const Scene& s, const Plan& /*plan*/) {
                return peaks_in_the_middle(s) ? "at the origin" : "branch and bound";
            }},
    Def{.quantity = Quantity::cycle_energy,
        .symbol = "cycle_energy",
        .name = "cycle-energy",
        .group = QuantityGroup::slip,
        .needs = Def::Needs::friction_alone,
        .force_power = 1,
        .length_power = 1,
        .meaning = "the energy dissipated by friction in a cycle of Q",
        .ball = [](BallLevel& l, const AskedValue& /*asked*/) { return l.cycle_energy(); },
        .exact = no_exact_form_of,
        .real = [](RealLevel& l, const AskedValue& /*asked*/) { return l.cycle_energy(); },
        .route = [](const Scene& /*scene*/, const Plan& /*plan*/) { return "Mindlin's loop"; },
        .may_be_missing = true},
    Def{.quantity = Quantity::x,
        .symbol = "",
        .name = "coordinate",
        .group = QuantityGroup::pressure,
        .place = Def::Place::point,
        .length_power = 1,
        .label = "x",
        .ball = [](BallLevel& l, const AskedValue& v) { return l.x(v.edge, v.distance()); },
        .exact = [](ExactValues& e, const AskedValue& v) { return e.x(v.edge, e.u(v.distance())); },
        .route = given,
        .cancels_little = true},
    Def{.quantity = Quantity::u,
        .symbol = "",
        .name = "distance",
        .group = QuantityGroup::pressure,
        .place = Def::Place::point,
        .length_power = 1,
        .label = "u",
        .ball = [](BallLevel& l, const AskedValue& v) { return l.distance(v.distance()); },
        .exact = [](ExactValues& e, const AskedValue& v) { return e.u(v.distance()); },
        .route = given,
        .cancels_little = true},
    sum_of_terms<false>(Quantity::local, "local-pressure"),
    error_of_terms<false>(Quantity::rel, "relative-error"),
    sum_of_terms<true>(Quantity::q_local, "local-shear"),
    error_of_terms<true>(Quantity::q_rel, "relative-error-of-shear"),
    searched(Quantity::extent_fraction, "", "extent-fraction", QuantityGroup::extent, 0),
    searched(Quantity::measure_fraction, "", "measure-fraction", QuantityGroup::extent, 0),
    searched(Quantity::crossing, "", "crossing", QuantityGroup::extent, 1),
    Def{.quantity = Quantity::load_ratio,
        .symbol = "",
        .name = "load-ratio",
        .group = QuantityGroup::slip,
        .needs = Def::Needs::friction,
        .ball = [](BallLevel& l, const AskedValue& /*asked*/) { return l.load_ratio(); },
        .exact = no_exact_form_of,
        .real = [](RealLevel& l, const AskedValue& /*asked*/) { return l.load_ratio(); },
        .route = stick_zone},
    tension_limit<contact::Edge::right>(Quantity::least_tension, "least-bulk-tension"),
    tension_limit<contact::Edge::left>(Quantity::most_tension, "most-bulk-tension"),
    searched(Quantity::slip_terms, "", "slip-zone-by-terms", QuantityGroup::slip, 1),
    searched(Quantity::slip_rel, "", "relative-error-of-slip-zone", QuantityGroup::slip, 0),
    searched(Quantity::slip_load, "", "slip-load", QuantityGroup::slip, 0),
};

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
const QuantityRow& evaluated_row(Quantity quantity) {
    const QuantityRow& row = row_of(quantity);
    if (!row.searched && row.ball == nullptr) {
        throw Error("a " + std::string(row.name) + " is made of other quantities");
    }
    return row;
}
std::span<const GroupRow> group_rows() { return group_table; }

} // namespace edgeproof::scene
