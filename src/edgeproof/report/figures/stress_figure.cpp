// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/scene_figure.hpp"

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

/// The values of a stress along a line, by the part of the line.
class StressLine {
public:
    StressLine(const scene::Scene& scene, scene::Quantity quantity, scene::BodyPoint from,
               scene::BodyPoint to)
        : quantity_(quantity), from_(std::move(from)), to_(std::move(to)),
          values_(scene, {asked(formula::Exact())}, {line_digits, Rounding::nearest}) {}

    struct Point {
        Rational part;             ///< of the line, from 0 to 1
        std::optional<Real> value; ///< none where the stress is infinite
    };
    /// Returns points in order, denser where the curve is not straight.
    [[nodiscard]] std::vector<Point> points() {
        std::vector<Point> first;
        for (int k = 0; k <= first_points; ++k) {
            first.push_back(at(Rational(k, first_points)));
            add(first.back().value);
        }
        std::vector<Point> all{first.front()};
        for (std::size_t k = 1; k < first.size(); ++k) {
            halve(first[k - 1], first[k], most_halvings, all);
            all.push_back(first[k]);
        }
        return all;
    }
    /// The range of the values at points of equal distances.
    [[nodiscard]] const std::pair<Real, Real>& range() const { return *range_; }

private:
    static constexpr unsigned line_digits = 12;
    static constexpr int first_points = 64;
    static constexpr int most_halvings = 10;
    /// The part of the height by which a chord may differ from the curve: less than a pixel.
    static constexpr double straight = 1.0 / 500;

    [[nodiscard]] scene::AskedValue asked(const formula::Exact& part) const {
        const auto between = [&](const formula::Exact& one, const formula::Exact& other) {
            return formula::Exact(one.expr() + (other.expr() - one.expr()) * part.expr());
        };
        scene::AskedValue value{quantity_};
        value.in_body = {between(from_.x, to_.x), between(from_.z, to_.z), from_.body};
        return value;
    }
    [[nodiscard]] Point at(const Rational& part) {
        check_interruption();
        try {
            return {part, values_.value(asked(formula::Exact::of(part))).value.midpoint()};
        } catch (const InputError&) {
            throw;
        } catch (const Error&) {
            return {part, {}};
        }
    }
    void add(const std::optional<Real>& value) {
        if (value) {
            range_ = range_ ? std::pair(std::min(range_->first, *value),
                                        std::max(range_->second, *value))
                            : std::pair(*value, *value);
        }
    }
    void halve(const Point& one, const Point& other, int halvings, std::vector<Point>& all) {
        const Point middle = at((one.part + other.part) / 2);
        const bool straight_here = one.value && middle.value && other.value && range_ &&
                                   abs(Real(*middle.value - (*one.value + *other.value) / 2)) <=
                                       (range_->second - range_->first) * straight;
        if (halvings > 1 && !straight_here) {
            halve(one, middle, halvings - 1, all);
        }
        all.push_back(middle);
        if (halvings > 1 && !straight_here) {
            halve(middle, other, halvings - 1, all);
        }
    }

    scene::Quantity quantity_;
    scene::BodyPoint from_;
    scene::BodyPoint to_;
    scene::SceneValues values_;
    std::optional<std::pair<Real, Real>> range_;
};

std::string point_text(const scene::BodyPoint& point) {
    return "(" + point.x.text() + ", " + point.z.text() + ")";
}

} // namespace

ScenePicture stress_along(const scene::Scene& scene, scene::Quantity quantity,
                          const scene::BodyPoint& from, const scene::BodyPoint& to) {
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
    StressLine values(scene, quantity, from, to);
    std::optional<std::pair<Real, Real>> all;
    for (const StressLine::Point& point : values.points()) {
        const Real part = formula::number_of<Real>(point.part);
        auto& row = plot.add_row(along_x   ? Real(x + dx * part)
                                 : along_z ? Real(z + dz * part)
                                           : Real(length * part));
        row.back() = point.value;
        if (point.value) {
            all = all ? std::pair(std::min(all->first, *point.value),
                                  std::max(all->second, *point.value))
                      : std::pair(*point.value, *point.value);
        }
    }
    if (!all) {
        throw InputError(name + " is not finite anywhere on the line", "give another line");
    }
    // Near a place where the stress is infinite the curve leaves the range of the other points.
    const auto& [low, high] = values.range();
    if (all->second - all->first > 2 * (high - low)) {
        plot.y.range = {low.str(6), high.str(6)};
    }
    if (along_x || along_z) {
        plot.sort_rows();
    }
    return {{std::move(plot)}, {}};
}

ScenePicture stress_picture(const scene::Scene& scene, scene::Quantity quantity, scene::Body body) {
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
    const auto unit = [&](const std::optional<scene::Unit>& u) {
        return u ? " [" + u->name + "]" : std::string();
    };
    const std::string name(row_of(quantity).name);
    const std::string body_name = body == scene::Body::A ? "A" : "B";
    field.title = name + (scene.units ? unit(scene.units->pressure) : "");
    const std::string length = scene.units ? unit(scene.units->length) : "";
    Plot plot{};
    plot.id = "stress";
    plot.title = name + " in body " + body_name;
    plot.description =
        "Colours and contours of " + name + " in body " + body_name +
        " below the contact, which lies at z = 0. Every finite value is on the scale "
        "or beyond a marked end of it.";
    plot.x.label = "x" + length;
    plot.y.label = "z" + length;
    plot.field = std::move(field);
    return {{std::move(plot)}, {}};
}

} // namespace edgeproof::report
