// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/figures/scene_figure.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/binary64_values.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace edgeproof::report {
namespace {

constexpr std::size_t columns = 241;
constexpr std::size_t lines = 121;

} // namespace

Plot stress_picture(const scene::Scene& scene, std::string_view stress, scene::Body body) {
    using scene::Quantity;
    const std::string name(stress);
    const auto named = scene::column_named(stress);
    const Quantity quantity = named ? named->quantity : Quantity::p;
    const Quantity drawn[] = {Quantity::sxx, Quantity::szz, Quantity::sxz, Quantity::tau_max,
                              Quantity::mises};
    const bool known = std::ranges::find(drawn, quantity) != std::end(drawn);
    require(known && (quantity != Quantity::mises || scene.poisson(body)),
            "there are no contours of " + name + (known ? " without a Poisson's ratio" : ""),
            "write sxx, szz, sxz, tau_max, or, with nu in [load], mises");
    const auto end = [&](Quantity of) {
        const scene::AskedValue asked{of};
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
    scene::PictureStresses found = picture_stresses(scene, quantity, body, x, z);
    field.values = std::move(found.values);
    if (std::ranges::none_of(field.values, [](double v) { return std::isfinite(v); })) {
        throw InputError(name + " is not finite at any point of the grid", "draw another stress");
    }
    field.is_signed = quantity != Quantity::mises && quantity != Quantity::tau_max;
    field.contact = {-b, a};
    if (scene.slips()) {
        field.stick = {-end(Quantity::stick_b), end(Quantity::stick_a)};
    }
    field.is_unbounded = scene.shear && !scene.slips() && !scene.proportional(); // K_II
    const scene::Units units = scene.units.value_or(scene::Units{});
    const std::string body_name = body == scene::Body::A ? "A" : "B";
    field.title = name + unit_label(units.pressure);
    Plot plot{};
    plot.id = "stress";
    plot.title = name + " in body " + body_name + (found.estimates ? " (estimates)" : "");
    plot.description =
        "Colours and contours of " + name + " in body " + body_name +
        " below the contact, which lies at z = 0. Every finite value is on the scale "
        "or beyond a marked end of it." +
        (found.estimates ? " The values are estimates; the greatest, and those at other places "
                           "that were proved, differ from them by less than 2e-4 of the greatest."
                         : "");
    plot.x.label = "x" + unit_label(units.length);
    plot.y.label = "z" + unit_label(units.length);
    plot.field = std::move(field);
    return plot;
}

} // namespace edgeproof::report
