// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/scene_figure.hpp"

#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/scene/binary64_values.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace edgeproof::report {
namespace {

constexpr std::size_t columns = 241;
constexpr std::size_t lines = 121;
constexpr unsigned line_digits_of_picture = 24; ///< of coordinates and values along a line
constexpr unsigned line_digits = 12;            ///< of values

constexpr int first_points = 64; ///< along a line, to which others are added
constexpr int line_halvings = 10;

/// A point of a line: its part, from 0 to 1, and the stress; none where that is infinite.
struct LinePoint {
    Rational part;
    std::optional<Real> value;
};
using Range = std::optional<std::pair<Real, Real>>;

Range range_of(const std::vector<LinePoint>& points) {
    Range range;
    for (const LinePoint& p : points) {
        if (p.value) {
            range = range ? std::pair(std::min(range->first, *p.value),
                                      std::max(range->second, *p.value))
                          : std::pair(*p.value, *p.value);
        }
    }
    return range;
}

std::string point_text(const scene::BodyPoint& point) {
    return "(" + point.x.text() + ", " + point.z.text() + ")";
}

} // namespace

Plot stress_along(const scene::Scene& scene, scene::Quantity quantity, const scene::BodyPoint& from,
                  const scene::BodyPoint& to) {
    const std::string name(row_of(quantity).name);
    const std::string body = from.body == scene::Body::A ? "A" : "B";
    if (from == to) {
        throw InputError("both ends of the line are " + point_text(from), "give two points");
    }
    if (row_of(quantity).needs == scene::QuantityRow::Needs::poisson && !scene.poisson(from.body)) {
        throw InputError(name + " needs Poisson's ratio", "add nu = \"0.3\" to [load]");
    }
    const PrecisionScope precision(line_digits_of_picture);
    const scene::Units units = scene.units.value_or(scene::Units{});
    const bool along_x = from.z == to.z;
    const bool along_z = from.x == to.x;
    const std::string line = " from " + point_text(from) + " to " + point_text(to);
    Plot plot{};
    plot.id = "stress";
    plot.title = name + " in body " + body;
    plot.description = "The stress " + name + " in body " + body + " along the line" + line + ".";
    plot.x = {(along_x   ? "x"
               : along_z ? "z"
                         : "distance from " + point_text(from)) +
              unit_label(units.length)};
    plot.y = {name + unit_label(units.pressure)};
    plot.columns = {along_x ? "x" : along_z ? "z" : "distance"};
    plot.add_curve(name, name + line, {Pen::Colour::black, 1, {}, 2.5});
    const Real x = from.x.to<Real>();
    const Real z = from.z.to<Real>();
    const Real dx = to.x.to<Real>() - x;
    const Real dz = to.z.to<Real>() - z;
    const Real length = sqrt(Real(dx * dx + dz * dz));
    const auto asked = [&](const Rational& part) {
        const auto between = [&](const formula::Exact& one, const formula::Exact& other) {
            return formula::Exact(one.expr() +
                                  (other.expr() - one.expr()) * formula::Exact::of(part).expr());
        };
        scene::AskedValue value{quantity};
        value.in_body = {between(from.x, to.x), between(from.z, to.z), from.body};
        return value;
    };
    scene::SceneValues values(scene, {asked(0)}, {line_digits, Rounding::nearest});
    const auto at = [&](const Rational& part) -> LinePoint {
        check_interruption();
        try {
            return {part, values.value(asked(part)).value.midpoint()};
        } catch (const InputError&) {
            throw;
        } catch (const Error&) {
            return {part, {}};
        }
    };
    std::vector<LinePoint> first;
    for (int k = 0; k <= first_points; ++k) {
        first.push_back(at(Rational(k, first_points)));
    }
    const Range usual = range_of(first);
    const std::vector<LinePoint> points = with_halved_steps(
        first, line_halvings,
        [&](const LinePoint& one, const LinePoint& other) {
            return at((one.part + other.part) / 2);
        },
        [&](const LinePoint& one, const LinePoint& middle, const LinePoint& other) {
            return one.value && middle.value && other.value && usual &&
                   abs(Real(*middle.value - (*one.value + *other.value) / 2)) <=
                       (usual->second - usual->first) * straight_enough;
        });
    for (const LinePoint& point : points) {
        const Real part = formula::number_of<Real>(point.part);
        plot.add_row(along_x   ? Real(x + dx * part)
                     : along_z ? Real(z + dz * part)
                               : Real(length * part))
            .back() = point.value;
    }
    const Range all = range_of(points);
    if (!all) {
        throw InputError(name + " is not finite anywhere on the line", "give another line");
    }
    // Near a place where the stress is infinite the curve leaves the range of the other points.
    if (usual && all->second - all->first > 2 * (usual->second - usual->first)) {
        plot.y.range = {usual->first.str(6), usual->second.str(6)};
    }
    if (along_x || along_z) {
        plot.sort_rows();
    }
    return plot;
}

Plot stress_picture(const scene::Scene& scene, scene::Quantity quantity, scene::Body body) {
    using scene::Quantity;
    const auto end = [&](Quantity edge) {
        const scene::AskedValue asked{edge};
        return scene::SceneValues(scene, {asked}, scene.ask.digits)
            .value(asked)
            .value.midpoint()
            .convert_to<double>();
    };
    const double a = end(Quantity::a);
    const double b = end(Quantity::b);
    PlaneField field;
    std::vector<double> x;
    std::vector<double> z;
    // The points lie off the surface, where a stress may be infinite.
    for (std::size_t i = 0; i < columns; ++i) {
        field.x.push_back(-b + (a + b) * (2 * static_cast<double>(i) / (columns - 1) - 0.5));
    }
    for (std::size_t j = 0; j < lines; ++j) {
        field.y.push_back((a + b) * (static_cast<double>(j) + 0.5) / lines);
    }
    for (const double depth : field.y) {
        x.insert(x.end(), field.x.begin(), field.x.end());
        z.insert(z.end(), field.x.size(), depth);
    }
    std::vector<std::vector<double>> values(6, std::vector<double>(x.size()));
    const bool has_mises = scene.poisson(body).has_value();
    const scene::Binary64Stresses all{values[0],
                                      values[1],
                                      values[2],
                                      values[3],
                                      has_mises ? std::span(values[4]) : std::span<double>(),
                                      values[5]};
    const Quantity order[] = {Quantity::sxx, Quantity::szz, Quantity::sxz, Quantity::tau_max,
                              Quantity::mises};
    const auto* const found = std::ranges::find(order, quantity);
    if (found == std::end(order) || (*found == Quantity::mises && !has_mises)) {
        throw InputError("there are no contours of " + std::string(row_of(quantity).name) +
                             (quantity == Quantity::mises ? " without a Poisson's ratio" : ""),
                         "write sxx, szz, sxz, tau_max, or, with nu in [load], mises");
    }
    compute_binary64(scene, body, x, z, all);
    field.values = std::move(values[static_cast<std::size_t>(found - std::begin(order))]);
    if (std::ranges::none_of(field.values, [](double v) { return std::isfinite(v); })) {
        throw InputError(std::string(row_of(quantity).name) +
                             " is not finite at any point of the grid",
                         "draw another stress");
    }
    field.is_signed = quantity != Quantity::mises && quantity != Quantity::tau_max;
    field.contact = {-b, a};
    const scene::Units units = scene.units.value_or(scene::Units{});
    const std::string name(row_of(quantity).name);
    const std::string body_name = body == scene::Body::A ? "A" : "B";
    field.title = name + unit_label(units.pressure);
    Plot plot{};
    plot.id = "stress";
    plot.title = name + " in body " + body_name;
    plot.description =
        "Colours and contours of " + name + " in body " + body_name +
        " below the contact, which lies at z = 0. Every finite value is on the scale "
        "or beyond a marked end of it.";
    plot.x.label = "x" + unit_label(units.length);
    plot.y.label = "z" + unit_label(units.length);
    plot.field = std::move(field);
    return plot;
}

} // namespace edgeproof::report
