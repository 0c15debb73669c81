// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/input/quantity.hpp"

#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

namespace edgeproof::scene {
namespace {

constexpr std::size_t most_k = 399;
constexpr std::size_t most_suggested = 4;

using Index = QuantityRow::Index;

std::string indexed(const QuantityRow& row, const std::string& k) {
    return std::string(row.symbol) + (row.index == Index::none ? "" : "_" + k);
}

/// Returns the index in "c_1" after "c"; nothing if the name does not belong to this row.
std::optional<std::size_t> index_behind(std::string_view name, std::string_view symbol,
                                        const QuantityRow& row) {
    const std::size_t from = symbol.size() + 1;
    if (!name.starts_with(symbol) || name.size() <= from || name[from - 1] != '_') {
        return {};
    }
    std::size_t k = 0;
    const char* const end = name.data() + name.size();
    const auto [stop, error] = std::from_chars(name.data() + from, end, k);
    const bool read = error == std::errc{} && stop == end && k <= most_k;
    return read && (k > 0 || row.index != Index::terms) ? std::optional(k) : std::nullopt;
}

/// The quantity whose `symbol`, a field of the rows, is in the name.
std::optional<NamedQuantity> named_by(std::string_view QuantityRow::*symbol,
                                      std::string_view name) {
    for (const QuantityRow& row : quantity_rows()) {
        const bool indexed = row.index != Index::none;
        if ((row.*symbol).empty() || (!indexed && row.*symbol != name)) {
            continue;
        }
        const auto k = indexed ? index_behind(name, row.*symbol, row) : 0;
        if (k) {
            return NamedQuantity{row.quantity, *k};
        }
    }
    return {};
}

} // namespace

std::optional<NamedQuantity> quantity_named(std::string_view symbol) {
    // the words of scenes and of the columns of slip
    const std::string_view name = symbol == "peak" ? "p_max" : symbol == "d" ? "slip" : symbol;
    return named_by(&QuantityRow::symbol, name);
}

std::optional<NamedQuantity> column_named(std::string_view name) {
    const auto named = quantity_named(name);
    return named ? named : named_by(&QuantityRow::label, name);
}

Digits digits_of(Quantity quantity, const Digits& asked) {
    constexpr unsigned most_of_an_error = 20;
    return row_of(quantity).short_error
               ? Digits{std::min(asked.count, most_of_an_error), asked.rounding, false}
               : asked;
}

std::optional<BoundedValue> value_outside(Quantity quantity, long bits) {
    return quantity == Quantity::p || quantity == Quantity::q
               ? std::optional(
                     BoundedValue{Ball(0, bits), true, "outside the contact", Rational(0)})
               : std::nullopt;
}

std::string symbol_of(const AskedValue& asked) {
    return indexed(row_of(asked.quantity), std::to_string(asked.k));
}

Coordinate::Coordinate(const Place& place)
    : text_(place.text().substr(std::string_view("x = ").size())), number_(place.number()) {
    if (!number_) {
        formula_ = place;
    }
}

Ball Coordinate::enclosure(const Ball& a, const Ball& b, long bits) const {
    return number_ ? formula::ball_of(*number_, bits)
                   : formula_->distance(Edge::right).x_enclosure(a, b, bits);
}

std::string family_of(const AskedValue& asked) { return indexed(row_of(asked.quantity), "k"); }

std::string text_of(const AskedValue& asked) {
    const QuantityRow& row = row_of(asked.quantity);
    const std::string what = row.index == Index::terms ? std::string(row.name) + " of " +
                                                             std::to_string(asked.k) + " terms"
                             : row.label.empty() ? symbol_of(asked)
                                                 : std::string(row.label);
    const std::string edge = edge_name(asked.edge) + " edge";
    if (asked.in_body) {
        return what + " at x = " + asked.in_body->x.text() + ", z = " + asked.in_body->z.text();
    }
    return row.at_point()  ? what + " at u = " + asked.u->text() + " from the " + edge
           : row.at_edge() ? what + " at the " + edge
                           : what;
}

std::string quantity_advice(std::string_view name) {
    std::vector<std::string> ways;    // the ways to write a quantity
    std::vector<std::string> symbols; // the names that may have been meant
    std::string meant;
    for (const QuantityRow& row : quantity_rows()) {
        if (row.symbol.empty()) {
            continue;
        }
        const std::size_t first = row.index == Index::terms ? 1 : 0;
        ways.push_back(indexed(row, std::to_string(first)));
        meant = row.name == name ? ways.back() : meant;
        for (std::size_t k = first; k < (row.index == Index::none ? 1 : most_suggested); ++k) {
            symbols.push_back(indexed(row, std::to_string(k)));
        }
        if (row.index == Index::order) {
            ways.insert(ways.end(), {indexed(row, "1"), "..."});
        }
    }
    if (meant.empty()) {
        meant = near_name(name, std::vector<std::string_view>(symbols.begin(), symbols.end()));
    }
    std::string list;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        list += (i == 0 ? "" : i + 1 == ways.size() ? " or " : ", ") + ways[i];
    }
    return (meant.empty() ? "" : "did you mean " + meant + "? ") + "write " + list;
}

double scale_of(const AskedValue& asked, double force, double length) {
    const QuantityRow& row = row_of(asked.quantity);
    const double power =
        row.length_power - (row.index == Index::order ? static_cast<double>(asked.k) : 0.0);
    const double unit = row.force_power == 0 ? 1 : force;
    return power < 0 ? unit / std::pow(length, -power) : unit * std::pow(length, power);
}

namespace {

/// A condition under which something lacks.
struct LackIf {
    bool lacks;
    Lack what;
};
/// The lack of a scene of which no part slips next to one that sticks.
Lack no_slip(const Scene& scene) {
    if (scene.slides()) {
        return {"the whole contact slides, and nothing sticks",
                "give Q, |Q| < f P, in place of sliding"};
    }
    return {"there is no friction", "add friction = \"0.6\" to [shear], and Q"};
}
std::optional<Lack> first_of(const std::vector<LackIf>& conditions) {
    const auto found = std::ranges::find(conditions, true, &LackIf::lacks);
    return found == conditions.end() ? std::nullopt : std::optional(found->what);
}

} // namespace

std::optional<Lack> lack_of(const Scene& scene, const AskedValue& asked) {
    using Needs = QuantityRow::Needs;
    const QuantityRow& row = row_of(asked.quantity);
    const bool unnamed = symbol_of(asked).empty(); // in recipes
    const std::string symbol = unnamed ? std::string(row.name) : symbol_of(asked);
    const Needs needs = row.needs;
    const bool plane = needs == Needs::plane || needs == Needs::reference || needs == Needs::cycle;
    const bool poisson = scene.poisson(asked.in_body ? asked.in_body->body : Body::A).has_value();
    const bool rubbed = row.of_friction();
    const bool energy = needs == Needs::friction_alone || needs == Needs::history;
    const bool curved = rubbed && energy && !scene.round && !scene.closed();
    auto lack = first_of({
        {needs == Needs::shear && !scene.shear, {"there is no shear", "add Q or bulk_tension"}},
        {needs == Needs::unknown_tilt && !scene.punch,
         {"is not an unknown of the scene", "give P and M and no " + symbol}},
        {needs == Needs::reference && !asked.reference,
         {"there is no place without displacement", "give a reference"}},
        {plane && scene.round, {"the contact is axisymmetric", ""}},
        {needs == Needs::round && !scene.round,
         {"the contact is plane, where the approach is undetermined", ""}},
        {(needs == Needs::poisson || needs == Needs::reference) && !poisson,
         {"there is no Poisson's ratio", "add nu to [load]"}},
        {rubbed && !scene.slips(), no_slip(scene)},
        {asked.quantity == Quantity::slip_displacement && asked.reference && scene.slides(),
         no_slip(scene)},
        {(needs == Needs::friction_alone || needs == Needs::cycle) && scene.slips() &&
             scene.shear->bulk_tension.sign() != 0,
         {"there is a bulk tension", "leave bulk_tension out"}},
        {rubbed && (row.searched || needs == Needs::cycle) && scene.history,
         {"is not computed for load histories", ""}},
        {needs == Needs::history && !scene.history,
         {"there are no steps", "add [[step]] sections with P and Q"}},
        {asked.quantity == Quantity::cycle_energy && scene.history && !scene.history->pass,
         {"the last step is not the end of a cycle",
          "add cycles = 2 to the [[step]] with which the cycle begins"}},
        {energy && scene.history && scene.round,
         {"is not computed for load histories of axisymmetric contacts", ""}},
        {needs == Needs::friction_alone && scene.round && !scene.poisson(Body::A),
         {"there is no Poisson's ratio", "add nu to [load]"}},
        {curved && !scene.symmetric(),
         {"is not computed for curved slopes that are not symmetric", ""}},
        {curved && scene.symmetric() &&
             contact::AxisymmetricContact::not_analytic_at(*scene.profile),
         {"is not computed where g' is not analytic at the end of a piece", ""}},
    });
    if (lack) {
        lack->problem = symbol + " is requested, but " + lack->problem;
        lack->instead += (lack->instead.empty() ? "leave " : ", or leave ") + symbol + " out" +
                         (needs == Needs::unknown_tilt ? " of the quantities" : "");
    }
    return lack;
}

std::optional<Lack> lack_of(const Scene& scene, const GroupRow& group) {
    const std::string name(group.name);
    const std::string wanted = name + " is requested, but ";
    const std::string problem = wanted + "there is no ";
    const bool round_stress = scene.round && group.group == QuantityGroup::stress;
    const auto lack = first_of({
        {group.shear && !scene.shear, {problem + "[shear]", "add [shear] with Q or bulk_tension"}},
        {group.friction && !scene.slips(),
         {wanted + no_slip(scene).problem, no_slip(scene).instead}},
        {round_stress && scene.shear,
         {name + " of an axisymmetric contact is computed without shear, under which it is not "
                 "axisymmetric",
          "leave [shear] out"}},
        {round_stress && !scene.poisson(Body::A),
         {problem + "Poisson's ratio", "add nu = \"0.3\" to [load]"}},
    });
    if (lack || group.group != QuantityGroup::surface) {
        return lack;
    }
    AskedValue displacement{.quantity = Quantity::ux, .reference = scene.ask.reference};
    displacement.in_body = BodyPoint{{}, {}, scene.ask.surface_of};
    return lack_of(scene, displacement);
}

std::string group_name(QuantityGroup group) {
    return std::string(group_rows()[static_cast<std::size_t>(group)].name);
}

std::string edge_name(Edge edge) { return edge == Edge::right ? "right" : "left"; }

std::optional<Edge> edge_named(std::string_view name) {
    for (const Edge edge : {Edge::right, Edge::left}) {
        if (name == edge_name(edge)) {
            return edge;
        }
    }
    return {};
}

Edge edge_of(std::string_view name) {
    const auto edge = edge_named(name);
    require(edge.has_value(), "there is no edge '" + std::string(name) + "'",
            "write \"right\" or \"left\"");
    return *edge;
}

Body body_named(std::string_view name) {
    require(name == "A" || name == "B", "there is no body '" + std::string(name) + "'",
            "write A (on which Q acts) or B");
    return name == "A" ? Body::A : Body::B;
}

} // namespace edgeproof::scene
