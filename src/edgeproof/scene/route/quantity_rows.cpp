// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/quantity.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/route/ball_level.hpp"
#include "edgeproof/scene/route/exact_values.hpp"
#include "edgeproof/scene/route/plan.hpp"
#include "edgeproof/scene/route/real_level.hpp"

#include <array>
#include <cmath>

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
    Def{.quantity = Quantity::extent,
        .symbol = "extent",
        .name = "extent",
        .group = QuantityGroup::extent,
        .place = Def::Place::edge,
        .index = Def::Index::terms,
        .tolerance = true,
        .length_power = 1,
        .searched = true},
    Def{.quantity = Quantity::measure,
        .symbol = "measure",
        .name = "measure",
        .group = QuantityGroup::extent,
        .place = Def::Place::edge,
        .index = Def::Index::terms,
        .tolerance = true,
        .length_power = 1,
        .searched = true},
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
    Def{.quantity = Quantity::stick_a,
        .symbol = "stick_a",
        .name = "stick-right-edge",
        .group = QuantityGroup::slip,
        .needs = Def::Needs::friction,
        .length_power = 1,
        .meaning = "right edge of the stick zone",
        .ball = [](BallLevel& l,
                   const AskedValue& /*asked*/) { return l.stick_edge(contact::Edge::right); },
        .exact = no_exact_form_of,
        .real = [](RealLevel& l,
                   const AskedValue& /*asked*/) { return l.stick_edge(contact::Edge::right); },
        .route = stick_zone},
    Def{.quantity = Quantity::stick_b,
        .symbol = "stick_b",
        .name = "stick-left-edge",
        .group = QuantityGroup::slip,
        .needs = Def::Needs::friction,
        .length_power = 1,
        .meaning = "left edge of the stick zone",
        .ball = [](BallLevel& l,
                   const AskedValue& /*asked*/) { return l.stick_edge(contact::Edge::left); },
        .exact = no_exact_form_of,
        .real = [](RealLevel& l,
                   const AskedValue& /*asked*/) { return l.stick_edge(contact::Edge::left); },
        .route = stick_zone},
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
    Def{.quantity = Quantity::local,
        .symbol = "",
        .name = "local-pressure",
        .group = QuantityGroup::pressure,
        .place = Def::Place::point,
        .index = Def::Index::terms,
        .force_power = 1,
        .length_power = -1,
        .ball = ball_sum<false>,
        .exact = exact_sum<false>,
        .real = real_sum<false>,
        .route = series},
    Def{.quantity = Quantity::rel,
        .symbol = "",
        .name = "relative-error",
        .group = QuantityGroup::pressure,
        .place = Def::Place::point,
        .index = Def::Index::terms,
        .ball = ball_error<false>,
        .exact = exact_error<false>,
        .real = real_error<false>,
        .route = series,
        .short_error = true},
    Def{.quantity = Quantity::q_local,
        .symbol = "",
        .name = "local-shear",
        .group = QuantityGroup::shear,
        .place = Def::Place::point,
        .index = Def::Index::terms,
        .needs = Def::Needs::shear,
        .force_power = 1,
        .length_power = -1,
        .ball = ball_sum<true>,
        .exact = exact_sum<true>,
        .real = real_sum<true>,
        .route = series},
    Def{.quantity = Quantity::q_rel,
        .symbol = "",
        .name = "relative-error-of-shear",
        .group = QuantityGroup::shear,
        .place = Def::Place::point,
        .index = Def::Index::terms,
        .needs = Def::Needs::shear,
        .ball = ball_error<true>,
        .exact = exact_error<true>,
        .real = real_error<true>,
        .route = series,
        .short_error = true},
    Def{.quantity = Quantity::extent_fraction,
        .symbol = "",
        .name = "extent-fraction",
        .group = QuantityGroup::extent,
        .place = Def::Place::edge,
        .index = Def::Index::terms,
        .tolerance = true,
        .searched = true},
    Def{.quantity = Quantity::measure_fraction,
        .symbol = "",
        .name = "measure-fraction",
        .group = QuantityGroup::extent,
        .place = Def::Place::edge,
        .index = Def::Index::terms,
        .tolerance = true,
        .searched = true},
    Def{.quantity = Quantity::crossing,
        .symbol = "",
        .name = "crossing",
        .group = QuantityGroup::extent,
        .place = Def::Place::edge,
        .index = Def::Index::terms,
        .tolerance = true,
        .length_power = 1,
        .searched = true},
    Def{.quantity = Quantity::load_ratio,
        .symbol = "",
        .name = "load-ratio",
        .group = QuantityGroup::slip,
        .needs = Def::Needs::friction,
        .ball = [](BallLevel& l, const AskedValue& /*asked*/) { return l.load_ratio(); },
        .exact = no_exact_form_of,
        .real = [](RealLevel& l, const AskedValue& /*asked*/) { return l.load_ratio(); },
        .route = stick_zone},
    Def{.quantity = Quantity::least_tension,
        .symbol = "",
        .name = "least-bulk-tension",
        .group = QuantityGroup::slip,
        .needs = Def::Needs::friction,
        .force_power = 1,
        .length_power = -1,
        .ball = [](BallLevel& l,
                   const AskedValue& /*asked*/) { return l.tension_limit(contact::Edge::right); },
        .exact = no_exact_form_of,
        .route = stick_zone,
        .may_be_missing = true},
    Def{.quantity = Quantity::most_tension,
        .symbol = "",
        .name = "most-bulk-tension",
        .group = QuantityGroup::slip,
        .needs = Def::Needs::friction,
        .force_power = 1,
        .length_power = -1,
        .ball = [](BallLevel& l,
                   const AskedValue& /*asked*/) { return l.tension_limit(contact::Edge::left); },
        .exact = no_exact_form_of,
        .route = stick_zone,
        .may_be_missing = true},
    Def{.quantity = Quantity::slip_terms,
        .symbol = "",
        .name = "slip-zone-by-terms",
        .group = QuantityGroup::slip,
        .place = Def::Place::edge,
        .index = Def::Index::terms,
        .needs = Def::Needs::friction,
        .length_power = 1,
        .searched = true},
    Def{.quantity = Quantity::slip_rel,
        .symbol = "",
        .name = "relative-error-of-slip-zone",
        .group = QuantityGroup::slip,
        .place = Def::Place::edge,
        .index = Def::Index::terms,
        .needs = Def::Needs::friction,
        .searched = true,
        .short_error = true},
    Def{.quantity = Quantity::slip_load,
        .symbol = "",
        .name = "slip-load",
        .group = QuantityGroup::slip,
        .place = Def::Place::edge,
        .index = Def::Index::terms,
        .needs = Def::Needs::friction,
        .tolerance = true,
        .searched = true},
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

double scale_of(const AskedValue& asked, double force, double length) {
    const QuantityRow& row = row_of(asked.quantity);
    const double power =
        row.length_power -
        (row.index == QuantityRow::Index::order ? static_cast<double>(asked.k) : 0.0);
    const double unit = row.force_power == 0 ? 1 : force;
    return power < 0 ? unit / std::pow(length, -power) : unit * std::pow(length, power);
}

bool has_cycle_energy(const Scene& scene) {
    return scene.shear->bulk_tension.sign() == 0 &&
           (scene.punch || scene.profile->has_closed_form());
}

std::optional<Lack> lack_of(const Scene& scene, const AskedValue& asked) {
    const std::string symbol = symbol_of(asked);
    switch (row_of(asked.quantity).needs) {
    case QuantityRow::Needs::nothing:
        break;
    case QuantityRow::Needs::shear:
        if (!scene.shear) {
            return Lack{symbol + " is requested, but there is no shear",
                        "add Q or bulk_tension, or leave " + symbol + " out"};
        }
        break;
    case QuantityRow::Needs::friction:
        if (!scene.slips()) {
            return Lack{symbol + " is requested, but there is no friction",
                        "add friction, or leave " + symbol + " out"};
        }
        break;
    case QuantityRow::Needs::friction_alone:
        if (!scene.slips() || scene.shear->bulk_tension.sign() != 0) {
            return Lack{symbol + " is requested, but there is " +
                            (scene.slips() ? "a bulk tension" : "no friction"),
                        scene.slips() ? "leave bulk_tension out, or leave " + symbol + " out"
                                      : "add friction, or leave " + symbol + " out"};
        }
        if (!has_cycle_energy(scene)) {
            return Lack{symbol + " is requested, but is not computed for curved slopes",
                        "leave " + symbol + " out"};
        }
        break;
    case QuantityRow::Needs::unknown_tilt:
        if (!scene.punch) {
            return Lack{symbol + " is requested, but is not an unknown of the scene",
                        "give P and M and no " + symbol + ", or leave " + symbol +
                            " out of the quantities"};
        }
        break;
    }
    return {};
}

} // namespace edgeproof::scene
