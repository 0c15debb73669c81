// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/figures_paper.hpp"

#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>

namespace edgeproof::report {
namespace {

constexpr unsigned working = figure_digits + 10;
constexpr std::size_t most_terms = 3;
constexpr Pen exact_pen{Pen::Colour::black, 1, {}, 2.5};
constexpr std::array<Pen, most_terms> term_pens{Pen{Pen::Colour::purple, 2, {}, 2},
                                                Pen{Pen::Colour::blue, 4, {}, 2},
                                                Pen{Pen::Colour::green, 1, {}, 2}};
constexpr std::array term_names{"one term", "two terms", "three terms"};

/// Fractions of the distance from the edge to the origin for a panel: rational, and therefore the
/// same on every machine.
std::vector<Rational> geometric_then_even() {
    std::vector<Rational> w;
    // 10^(-4 + k/20), to five figures.
    static constexpr std::array<long, 20> mantissa{10000, 11220, 12589, 14125, 15849, 17783, 19953,
                                                   22387, 25119, 28184, 31623, 35481, 39811, 44668,
                                                   50119, 56234, 63096, 70795, 79433, 89125};
    for (const long decade : {100'000'000L, 10'000'000L, 1'000'000L}) {
        for (const long m : mantissa) {
            w.emplace_back(m, decade);
        }
    }
    for (int k = 20; k <= 200; ++k) {
        w.emplace_back(k, 200);
    }
    return w;
}

std::vector<Rational> even_steps() {
    std::vector<Rational> w;
    for (const int k : {1, 2, 5, 10, 20, 50}) { // at the edge the square root is steep
        w.emplace_back(k, 10'000);
    }
    for (int k = 1; k <= 160; ++k) {
        w.emplace_back(k, 160);
    }
    return w;
}

Plot table_of(const PanelScene& scene, const std::vector<Rational>& fractions) {
    Plot plot;
    plot.id = scene.id;
    plot.title = scene.title;
    plot.columns = {"fraction", "x_over_a", "p", "p1", "p2", "p3", "e1", "e2", "e3"};
    const contact::NormalContact contact(
        scene.profile, formula::Exact::parse("1"),
        contact::Load::right_edge(formula::Exact::parse(scene.half_width)), working);
    const PrecisionScope scope(working + 5);
    const Real side = scene.edge == contact::Edge::right ? contact.a() : contact.b();
    const Real unit = formula::Exact::parse(scene.pressure_scale).to<Real>();
    const std::vector<Real> c = contact.expansion(scene.edge, most_terms);
    for (const Rational& w : fractions) {
        if (w > scene.until) {
            break;
        }
        const Real fraction = from_rational<Real>(w);
        const Real u = side * fraction;
        Real p;
        try {
            p = contact.pressure(scene.edge, u).value;
        } catch (const DomainError&) {
            continue; // a corner
        }
        const Real x =
            scene.edge == contact::Edge::right ? Real(contact.a() - u) : Real(u - contact.b());
        std::vector<std::optional<Real>> row{fraction, Real(x / contact.a()), Real(p / unit)};
        std::array<Real, most_terms> local;
        Real sum = 0;
        Real power = sqrt(u);
        for (std::size_t n = 0; n < most_terms; ++n) {
            sum += c[n] * power;
            power *= u;
            local[n] = sum;
            row.emplace_back(sum / unit);
        }
        for (const Real& value : local) {
            row.emplace_back(abs(1 - value / p));
        }
        plot.rows.push_back(std::move(row));
    }
    return plot;
}

std::string side_words(const PanelScene& scene) {
    return scene.edge == contact::Edge::right ? "right-hand" : "left-hand";
}

} // namespace

Plot error_plot(const PanelScene& scene) {
    Plot plot = table_of(scene, geometric_then_even());
    plot.x = {scene.edge == contact::Edge::right ? "distance from the edge, 1 − x/a"
                                                 : "distance from the edge, 1 + x/b",
              true,
              {{"1e-4", "1"}}};
    plot.y = {"relative error |1 − p_local/p|", true, {{"1e-12", "10"}}};
    for (std::size_t n = 0; n < most_terms; ++n) {
        plot.curves.push_back({fmt::format("e{}", n + 1), term_names[n], term_pens[n]});
    }
    plot.level = {{"0.01", "1 %"}};
    plot.description =
        fmt::format("Relative error of the one-, two- and three-term approximations at the {} "
                    "edge against the distance from it, both axes logarithmic.",
                    side_words(scene));
    return plot;
}

Plot pressure_plot(const PanelScene& scene) {
    Plot plot = table_of(scene, even_steps());
    // The rows are ordered from left to right.
    if (scene.edge == contact::Edge::right) {
        plot.rows = {plot.rows.rbegin(), plot.rows.rend()};
    }
    for (auto& row : plot.rows) {
        std::swap(row[0], row[1]);
    }
    std::swap(plot.columns[0], plot.columns[1]);
    plot.x = {"x/a"};
    plot.y = {"pressure p/(" + scene.pressure_unit + ")", false, {{"0", "*"}}};
    plot.curves.push_back({"p", "exact", exact_pen});
    for (std::size_t n = 0; n < most_terms; ++n) {
        plot.curves.push_back({fmt::format("p{}", n + 1), term_names[n], term_pens[n]});
    }
    plot.description =
        fmt::format("Exact contact pressure, and its one-, two- and three-term approximations from "
                    "the {} edge, against position.",
                    side_words(scene));
    return plot;
}

} // namespace edgeproof::report
