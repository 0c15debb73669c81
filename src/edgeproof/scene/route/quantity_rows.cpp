// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/quantity.hpp"

#include "edgeproof/algebra/identity.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/route/ball_level.hpp"
#include "edgeproof/scene/route/exact_values.hpp"

#include <array>
#include <optional>
#include <type_traits>

namespace edgeproof::scene {
namespace {

using Def = QuantityRow;
using Needs = QuantityRow::Needs;
using Group = QuantityGroup;

bool is_force_given(const Scene& s) { return s.load.kind == Load::Kind::force; }
const char* by_load(const Scene& s) {
    return s.round ? s.round->size_from() : is_force_given(s) ? "from P" : "given";
}
const char* full_stick_or_similar(const Scene& s) {
    return s.together() ? "similar" : "full-stick";
}

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

/// A row, and what is set in it after the fields that all rows have.
struct Made : Def {
    // Assignments instead of calls of `with`, which clang 14 does not evaluate at compile time
    // here.
    [[nodiscard]] constexpr Made with_index(Index k) const {
        Made made = *this;
        made.index = k;
        return made;
    }
    [[nodiscard]] constexpr Made needing(Needs what) const {
        Made made = *this;
        made.needs = what;
        return made;
    }
    [[nodiscard]] constexpr Made explained(std::string_view text) const {
        Made made = *this;
        made.meaning = text;
        return made;
    }
    [[nodiscard]] constexpr Made labelled(std::string_view text) const {
        Made made = *this;
        made.label = text;
        return made;
    }
    [[nodiscard]] constexpr Made by(const char* way) const {
        Made made = *this;
        made.route = way;
        return made;
    }
    [[nodiscard]] constexpr Made by(const char* (*way)(const Scene&)) const {
        Made made = *this;
        made.route_by = way;
        return made;
    }
    template <class Field> [[nodiscard]] constexpr Made with(Field Def::*field, Field value) const {
        Made made = *this;
        made.*field = value;
        return made;
    }
};

constexpr Made row(Quantity quantity, std::string_view symbol, std::string_view name, Group group,
                   Def::Place place, Unit unit) {
    return {{.quantity = quantity,
             .symbol = symbol,
             .name = name,
             .group = group,
             .place = place,
             .force_power = unit.force_power,
             .length_power = unit.length_power}};
}

/// Returns the value of a member function of a level; null if the level has none. A coefficient is
/// an element of a list at the edge.
template <Def::Place place, auto member, bool listed> consteval auto evaluator() {
    if constexpr (std::is_null_pointer_v<decltype(member)>) {
        return nullptr;
    } else {
        return [](auto& level, [[maybe_unused]] const AskedValue& v) {
            if constexpr (listed) {
                return (level.*member)(v.edge).at(v.k);
            } else if constexpr (place == Def::Place::body || place == Def::Place::surface) {
                return (level.*member)(v);
            } else if constexpr (place == Def::Place::contact) {
                return (level.*member)();
            } else if constexpr (place == Def::Place::edge) {
                return (level.*member)(v.edge);
            } else {
                return (level.*member)(v.edge, level.place(v));
            }
        };
    }
}
template <Def::Place place, auto ball, auto exact, bool listed = false>
constexpr Made value(Quantity quantity, std::string_view symbol, std::string_view name, Group group,
                     Unit unit) {
    Made made = row(quantity, symbol, name, group, place, unit);
    made.ball = evaluator<place, ball, listed>();
    made.exact = evaluator<place, exact, listed>();
    return made;
}
template <auto ball, auto exact, class... Fields> constexpr Made of_contact(Fields... fields) {
    return value<Def::Place::contact, ball, exact>(fields...);
}
template <auto ball, auto exact, class... Fields> constexpr Made at_point(Fields... fields) {
    return value<Def::Place::point, ball, exact>(fields...);
}

/// c_k or s_k.
template <auto ball, bool shear>
constexpr Made coefficient(Quantity quantity, std::string_view symbol, std::string_view name,
                           Unit unit) {
    return value<Def::Place::edge, ball, nullptr, true>(quantity, symbol, name, Group::coefficients,
                                                        unit)
        .with_index(Def::Index::order)
        .with(
            &Def::exact, +[](ExactValues& level, const AskedValue& v) {
                return level.coefficient(v.edge, v.k, shear);
            });
}

// The sum of the first k terms at a point, and |1 - sum/value|: of p, or of q (`shear`).
template <bool shear>
constexpr auto sum_at_point =
    [](auto& level, const AskedValue& v) { return level.sum(v.edge, level.place(v), v.k, shear); };
template <bool shear>
constexpr auto error_at_point = [](auto& level, const AskedValue& v) {
    return abs(level.relative_error(v.edge, level.place(v), v.k, shear));
};
template <bool shear>
constexpr Made of_terms(Quantity quantity, std::string_view column, std::string_view name,
                        Unit unit, const auto& evaluator) {
    Made made =
        row(quantity, "", name, shear ? Group::shear : Group::pressure, Def::Place::point, unit)
            .labelled(column)
            .with_index(Def::Index::terms)
            .needing(shear ? Needs::shear : Needs::nothing)
            .by("series");
    made.ball = evaluator;
    made.exact = evaluator;
    return made;
}
template <bool shear>
constexpr Made sum_row(Quantity quantity, std::string_view column, std::string_view name) {
    return of_terms<shear>(quantity, column, name, units::stress, sum_at_point<shear>);
}
template <bool shear>
constexpr Made error_row(Quantity quantity, std::string_view column, std::string_view name) {
    return of_terms<shear>(quantity, column, name, units::number, error_at_point<shear>)
        .with(&Def::short_error, true);
}

/// A quantity of k terms at an edge that is found by a search for a tolerance.
constexpr Made searched(Quantity quantity, std::string_view column, std::string_view name,
                        Group group, Unit unit) {
    const bool slips = group == Group::slip;
    const bool named = quantity == Quantity::extent || quantity == Quantity::measure;
    return row(quantity, named ? column : "", name, group, Def::Place::edge, unit)
        .labelled(column)
        .with_index(Def::Index::terms)
        .needing(slips ? Needs::friction : Needs::nothing)
        .with(&Def::tolerance, !slips || quantity == Quantity::slip_load)
        .with(&Def::searched, true)
        .with(&Def::short_error, quantity == Quantity::slip_rel);
}

/// A quantity of the stick zone.
template <auto ball>
constexpr Made of_stick(Quantity quantity, std::string_view symbol, std::string_view name,
                        Unit unit) {
    return of_contact<ball, nullptr>(quantity, symbol, name, Group::slip, unit)
        .needing(Needs::friction)
        .by("stick zone");
}

/// The route of P and delta of an axisymmetric contact.
const char* way_of_integral(const Scene& s) {
    return s.curved_body() ? "rigorous integration" : "closed-form";
}
/// The route of values along the surface.
const char* way_of_surface(const Scene& s) {
    const bool tilted = s.slips() && s.shear->bulk_tension.sign() != 0;
    return s.round || !s.closed() || (tilted && s.profile && !s.profile->piecewise_linear())
               ? "rigorous integration"
               : "closed-form";
}
const char* way_of_stress(const Scene& s) {
    const bool integrated = !s.closed() || (s.round && !s.round->law);
    return integrated  ? "rigorous integration"
           : !s.shear  ? "closed-form"
           : s.slips() ? "superposition"
                       : full_stick_or_similar(s);
}
/// A stress at a point of a body; its name is that of the column. The principal stresses have no
/// symbol in recipes, where s_1, s_2 are coefficients.
template <auto ball>
constexpr Made stress(Quantity quantity, std::string_view name, std::string_view symbol = "") {
    return value<Def::Place::body, ball, nullptr>(quantity, symbol, name, Group::stress,
                                                  units::stress)
        .labelled(name)
        .by(way_of_stress);
}
template <auto ball> constexpr Made on_surface(Quantity quantity, std::string_view name) {
    return value<Def::Place::surface, ball, nullptr>(quantity, "", name, Group::displacement,
                                                     units::length)
        .labelled(name)
        .by(way_of_surface);
}
template <auto ball>
constexpr Made of_surface(Quantity quantity, std::string_view name, Unit unit) {
    return value<Def::Place::surface, ball, nullptr>(quantity, "", name, Group::surface, unit)
        .labelled(name)
        .by(way_of_surface);
}

/// The rows are in the order of Quantity.
constexpr auto quantity_table = std::to_array<Def>({
    at_point<&BallLevel::p, &ExactValues::p>(Quantity::p, "p", "pressure", Group::pressure,
                                             units::stress)
        .by([](const Scene& scene) {
            return scene.closed()                                   ? "closed-form"
                   : scene.profile && scene.profile->axisymmetric() ? "Abel integral"
                                                                    : "rigorous integration";
        })
        .with(&Def::cancels_little, true),
    at_point<&BallLevel::q, &ExactValues::q>(Quantity::q, "q", "shear", Group::shear, units::stress)
        .needing(Needs::shear)
        .by([](const Scene& s) { return s.slips() ? "superposition" : full_stick_or_similar(s); }),
    coefficient<&BallLevel::c, false>(Quantity::c, "c", "coefficient", {1, -1.5}).by("series"),
    coefficient<&BallLevel::s, true>(Quantity::s, "s", "shear-coefficient", {1, -0.5})
        .needing(Needs::shear)
        .by(full_stick_or_similar),
    of_contact<&BallLevel::a, &ExactValues::a>(Quantity::a, "a", "right-edge", Group::contact,
                                               units::length)
        .by(by_load)
        .with(&Def::distance_of, std::optional(Edge::right))
        .with(&Def::cancels_little, true),
    of_contact<&BallLevel::b, &ExactValues::b>(Quantity::b, "b", "left-edge", Group::contact,
                                               units::length)
        .by([](const Scene& s) { return s.symmetric() ? by_load(s) : "consistency"; })
        .with(&Def::distance_of, std::optional(Edge::left))
        .with(&Def::cancels_little, true),
    of_contact<&BallLevel::whole_force, &ExactValues::whole_force>(Quantity::P, "P", "load",
                                                                   Group::contact, units::force)
        .by([](const Scene& s) {
            return is_force_given(s) || (s.round && by_load(s) == std::string_view("from P"))
                       ? "given"
                   : s.round ? way_of_integral(s)
                             : "contact-law";
        })
        .with(
            &Def::given,
            +[](const Scene& s)
                -> const Exact* { return is_force_given(s) ? &s.load.value : nullptr; }),
    of_contact<&BallLevel::moment, &ExactValues::moment>(Quantity::M, "M", "moment", Group::contact,
                                                         units::moment)
        .needing(Needs::plane)
        .by([](const Scene& s) { return s.moment ? "given" : "contact-law"; })
        .with(
            &Def::given,
            +[](const Scene& s) -> const Exact* { return s.moment ? &*s.moment : nullptr; }),
    of_contact<&BallLevel::alpha, &ExactValues::alpha>(Quantity::alpha, "alpha", "tilt",
                                                       Group::contact, units::number)
        .needing(Needs::unknown_tilt)
        .by("tilt"),
    searched(Quantity::extent, "extent", "extent", Group::extent, units::length),
    searched(Quantity::measure, "measure", "measure", Group::extent, units::length),
    value<Def::Place::edge, &BallLevel::slip_size, nullptr>(Quantity::slip, "slip", "slip-zone",
                                                            Group::slip, units::length)
        .needing(Needs::friction)
        .explained("size of the slip zone")
        .by("stick zone"),
    of_stick<&BallLevel::stick_edge<Edge::right>>(Quantity::stick_a, "stick_a", "stick-right-edge",
                                                  units::length)
        .explained("right edge of the stick zone"),
    of_stick<&BallLevel::stick_edge<Edge::left>>(Quantity::stick_b, "stick_b", "stick-left-edge",
                                                 units::length)
        .explained("left edge of the stick zone"),
    row(Quantity::residual, "", "residual", Group::pressure, Def::Place::point, units::number)
        .with_index(Def::Index::terms),
    row(Quantity::tilt_difference, "", "tilt-difference", Group::pressure, Def::Place::point,
        units::stress)
        .labelled("p minus p without tilt"),
    of_contact<&BallLevel::peak, &ExactValues::peak>(Quantity::p_max, "p_max", "peak-pressure",
                                                     Group::peak, units::stress)
        .explained("the greatest pressure")
        .by([](const Scene& s) {
            return peaks_in_the_middle(s) ? "at the origin" : "branch and bound";
        }),
    of_stick<&BallLevel::cycle_energy>(Quantity::cycle_energy, "cycle_energy", "cycle-energy",
                                       units::moment)
        .needing(Needs::friction_alone)
        .explained("the energy dissipated by friction in a cycle")
        .by([](const Scene& s) { return s.history ? "superposition" : "Mindlin's loop"; })
        .with(&Def::may_be_missing, true),
    at_point<&BallLevel::x, &ExactValues::x>(Quantity::x, "", "coordinate", Group::pressure,
                                             units::length)
        .labelled("x")
        .by("given")
        .with(&Def::cancels_little, true),
    at_point<&BallLevel::u, &ExactValues::u>(Quantity::u, "", "distance", Group::pressure,
                                             units::length)
        .labelled("u")
        .by("given")
        .with(&Def::cancels_little, true),
    sum_row<false>(Quantity::local, "local", "local-pressure"),
    error_row<false>(Quantity::rel, "rel", "relative-error"),
    sum_row<true>(Quantity::q_local, "q_local", "local-shear"),
    error_row<true>(Quantity::q_rel, "q_rel", "relative-error-of-shear"),
    searched(Quantity::extent_fraction, "extent_fraction", "extent-fraction", Group::extent,
             units::number),
    searched(Quantity::measure_fraction, "measure_fraction", "measure-fraction", Group::extent,
             units::number),
    searched(Quantity::crossing, "crossing", "crossing", Group::extent, units::length),
    of_stick<&BallLevel::load_ratio>(Quantity::load_ratio, "", "load-ratio", units::number)
        .labelled("load_ratio"),
    of_stick<&BallLevel::tension_limit<Edge::right>>(Quantity::least_tension, "",
                                                     "least-bulk-tension", units::stress)
        .labelled("least_tension")
        .with(&Def::may_be_missing, true),
    of_stick<&BallLevel::tension_limit<Edge::left>>(Quantity::most_tension, "", "most-bulk-tension",
                                                    units::stress)
        .labelled("most_tension")
        .with(&Def::may_be_missing, true),
    searched(Quantity::slip_terms, "slip_terms", "slip-zone-by-terms", Group::slip, units::length),
    searched(Quantity::slip_rel, "slip_rel", "relative-error-of-slip-zone", Group::slip,
             units::number),
    searched(Quantity::slip_load, "slip_load", "slip-load", Group::slip, units::number),
    stress<&BallLevel::sxx>(Quantity::sxx, "sxx", "sxx"),
    stress<&BallLevel::szz>(Quantity::szz, "szz", "szz"),
    stress<&BallLevel::sxz>(Quantity::sxz, "sxz", "sxz"),
    stress<&BallLevel::mises>(Quantity::mises, "mises", "mises").needing(Needs::poisson),
    stress<&BallLevel::tau_max>(Quantity::tau_max, "tau_max", "tau_max"),
    stress<&BallLevel::syy>(Quantity::syy, "syy", "syy").needing(Needs::poisson),
    stress<&BallLevel::principal<0>>(Quantity::s1, "s1").needing(Needs::poisson),
    stress<&BallLevel::principal<1>>(Quantity::s2, "s2").needing(Needs::poisson),
    stress<&BallLevel::principal<2>>(Quantity::s3, "s3").needing(Needs::poisson),
    stress<&BallLevel::tresca>(Quantity::tresca, "tresca", "tresca").needing(Needs::poisson),
    of_stick<&BallLevel::step_energy>(Quantity::step_energy, "step_energy", "step-energy",
                                      units::moment)
        .needing(Needs::history)
        .explained("the energy dissipated by friction in the last step")
        .by("superposition")
        .with(&Def::may_be_missing, true),
    on_surface<&BallLevel::gap>(Quantity::gap, "gap"),
    on_surface<&BallLevel::slip_displacement>(Quantity::slip_displacement, "slip")
        .labelled("slip_displacement"),
    of_contact<&BallLevel::approach, &ExactValues::approach>(Quantity::delta, "delta", "approach",
                                                             Group::contact, units::length)
        .needing(Needs::round)
        .explained("approach of the bodies")
        .by(way_of_integral),
    of_contact<&BallLevel::stiffness, &ExactValues::stiffness>(
        Quantity::stiffness, "stiffness", "contact-stiffness", Group::contact, units::force)
        .needing(Needs::round)
        .explained("contact stiffness dP/d delta")
        .by("closed-form"),
    of_surface<&BallLevel::ux>(Quantity::ux, "ux", units::length).needing(Needs::reference),
    of_surface<&BallLevel::uz>(Quantity::uz, "uz", units::length).needing(Needs::reference),
    of_surface<&BallLevel::surface_slope>(Quantity::slope, "slope", units::number)
        .needing(Needs::reference),
    of_surface<&BallLevel::dissipation>(Quantity::dissipation, "dissipation", units::force)
        .needing(Needs::cycle),
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
    GroupRow{.group = QuantityGroup::stress, .name = "stress", .of_bodies = true},
    GroupRow{.group = QuantityGroup::displacement, .name = "displacement", .of_bodies = true},
    GroupRow{.group = QuantityGroup::surface, .name = "surface", .of_bodies = true},
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
