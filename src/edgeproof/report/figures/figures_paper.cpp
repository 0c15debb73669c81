// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/figures_paper.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace edgeproof::report {
namespace {

/// The pen of the exact curve in a figure with such terms.
constexpr Pen exact_pen{Pen::Colour::black, 1, {}, 2.5};

/// Adds the curves of one, two and three terms, with the columns `prefix`1 ... `prefix`3.
void add_term_curves(Plot& plot, const std::string& prefix) {
    plot.curves.push_back({prefix + "1", "one term", {Pen::Colour::purple, 2, {}, 2}});
    plot.curves.push_back({prefix + "2", "two terms", {Pen::Colour::blue, 4, {}, 2}});
    plot.curves.push_back({prefix + "3", "three terms", {Pen::Colour::green, 1, {}, 2}});
}

constexpr const char* moore_hills = "moore-hills";
constexpr unsigned working = figure_digits + 10;
constexpr long contact_bits = 512; // a place at a bend has half of them
constexpr std::size_t most_terms = 3;

struct PanelScene {
    std::string id;    ///< "fig2a"
    std::string title; ///< "a) wedge, m = 0"
    contact::Profile profile;
    std::string half_width;    ///< a, exactly
    std::string pressure_unit; ///< "E*C", in words; its value is 1
    contact::Edge edge = contact::Edge::right;
};

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
    const PrecisionScope scope(working + 5);
    const contact::BallContact contact(
        scene.profile, formula::Exact::parse("1"),
        contact::Load::right_edge(formula::Exact::parse(scene.half_width)), contact_bits);
    const Ball& side = scene.edge == contact::Edge::right ? contact.a() : contact.b();
    const std::vector<Ball> c = contact.expansion(scene.edge, most_terms);
    for (const Rational& w : fractions) {
        const Ball place = side * Ball(w, contact_bits);
        const Ball pressure = contact.pressure(scene.edge, place);
        if (!pressure.is_finite()) {
            continue; // a corner
        }
        const Real p = pressure.midpoint();
        const Real u = place.midpoint();
        const Real fraction = from_rational<Real>(w);
        const Ball x =
            scene.edge == contact::Edge::right ? contact.a() - place : place - contact.b();
        std::vector<std::optional<Real>> row{fraction, Ball(x / contact.a()).midpoint(), p};
        Real sum = 0;
        Real power = sqrt(u);
        for (std::size_t n = 0; n < most_terms; ++n) {
            sum += c[n].midpoint() * power;
            power *= u;
            row.emplace_back(sum);
        }
        for (std::size_t n = 0; n < most_terms; ++n) {
            row.emplace_back(abs(1 - *row[3 + n] / p));
        }
        plot.rows.push_back(std::move(row));
    }
    return plot;
}

Plot error_plot(const PanelScene& scene) {
    const bool right = scene.edge == contact::Edge::right;
    Plot plot = table_of(scene, geometric_then_even());
    plot.x = {right ? "distance from the edge, 1 − x/a" : "distance from the edge, 1 + x/b",
              true,
              {{"1e-4", "1"}}};
    plot.y = {"relative error |1 − p_local/p|", true, {{"1e-12", "10"}}};
    add_term_curves(plot, "e");
    plot.level = {{"0.01", "1 %"}};
    plot.description = "Relative error of the one-, two- and three-term approximations at the " +
                       scene::edge_name(scene.edge) +
                       "-hand edge against the distance from it, both axes logarithmic.";
    return plot;
}

Plot pressure_plot(const PanelScene& scene) {
    Plot plot = table_of(scene, even_steps());
    // The rows are ordered from left to right.
    if (scene.edge == contact::Edge::right) {
        std::ranges::reverse(plot.rows);
    }
    for (auto& row : plot.rows) {
        std::swap(row[0], row[1]);
    }
    std::swap(plot.columns[0], plot.columns[1]);
    plot.x = {"x/a"};
    plot.y = {"pressure p/(" + scene.pressure_unit + ")", false, {{"0", "*"}}};
    plot.curves.push_back({"p", "exact", exact_pen});
    add_term_curves(plot, "p");
    plot.description = "Exact contact pressure, and its one-, two- and three-term approximations "
                       "from the " +
                       scene::edge_name(scene.edge) + "-hand edge, against position.";
    return plot;
}

formula::Exact exact(const char* text) { return formula::Exact::parse(text); }
contact::Profile power_law(const char* m) {
    return contact::Profile::power_law(exact("1"), exact(m));
}
contact::Profile flat_and_rounded(const char* t) {
    return contact::Profile::flat_and_rounded(exact(t), exact("1"));
}
contact::Profile wedge() { return contact::Profile::tilted_wedge(exact("pi/16"), exact("pi/20")); }
contact::Profile tilted_flat() {
    return contact::Profile::tilted_flat_and_rounded(exact("pi/16"), exact("1"), exact("2"));
}

// The paper does not state the size of the tilted flat-and-rounded contact. This one reproduces
// most of the quoted shares within 1 % (left 1, 10 and 15 %, right one term 4 %; not right 43 and
// 69 %), in units of the edge's distance from the origin.
constexpr const char* tilted_flat_half_width = "3/2";
constexpr const char* size_note =
    " The paper does not say how large this contact is; a = 3/2 is chosen here, since it "
    "reproduces most of the shares that the paper quotes: all three of the left-hand edge and the "
    "first of the right-hand one.";

using Maker = Plot (*)(const PanelScene&);

std::vector<std::function<Plot()>> panels(Maker make, std::vector<PanelScene> scenes) {
    std::vector<std::function<Plot()>> plots;
    plots.reserve(scenes.size());
    for (PanelScene& scene : scenes) {
        plots.emplace_back([make, scene = std::move(scene)] { return make(scene); });
    }
    return plots;
}

PanelScene power_law_scene(const char* id, const char* title, const char* m) {
    return {id, title, power_law(m), "1", "E*C aᵐ"};
}
PanelScene flat_scene(const char* id, const char* title, const char* t) {
    return {id, title, flat_and_rounded(t), "1", "E*a/R"};
}
std::vector<PanelScene> both_edges(const std::string& id, const contact::Profile& profile,
                                   const char* half_width) {
    return {{id + "a", "a) left-hand edge", profile, half_width, "E*", contact::Edge::left},
            {id + "b", "b) right-hand edge", profile, half_width, "E*", contact::Edge::right}};
}

} // namespace

std::vector<FigureRecipe> paper_figures(const std::string& name) {
    if (name != moore_hills) {
        return {};
    }
    const char* const wedge_words =
        "wedge with φ = π/16 tilted by α = π/20, at the a) left-hand and b) right-hand edge; the "
        "distance from an edge is in units of that edge's distance from the apex.";
    const char* const flat_words =
        "flat-and-rounded punch with α = π/16, t = 1 and R = 2, at the a) left-hand and b) "
        "right-hand edge; the distance from an edge is in units of that edge's distance from the "
        "punch's minimum.";
    std::vector<FigureRecipe> figures;
    figures.push_back({"fig2", "Figure 2. Relative error, power-law indenters",
                       "Relative error of the one-, two- and three-term approximations against the "
                       "distance from the right-hand edge. For m = 5/8 the second coefficient "
                       "vanishes, so the curves for one and two terms lie on each other.",
                       panels(error_plot, {power_law_scene("fig2a", "a) wedge, m = 0", "0"),
                                           power_law_scene("fig2b", "b) m = 5/8", "5/8"),
                                           power_law_scene("fig2c", "c) Hertz, m = 1", "1"),
                                           power_law_scene("fig2d", "d) m = 10", "10")})});
    figures.push_back({"fig3", "Figure 3. Pressure, wedge and Hertz",
                       "Exact pressure and the one-, two- and three-term approximations. The "
                       "wedge's pressure is infinite at its apex, x = 0.",
                       panels(pressure_plot, {power_law_scene("fig3a", "a) wedge, m = 0", "0"),
                                              power_law_scene("fig3b", "b) Hertz, m = 1", "1")})});
    figures.push_back({"fig4", "Figure 4. Relative error, flat-and-rounded punches",
                       "Relative error of the one-, two- and three-term approximations. The flat "
                       "begins at 1 − x/a = 1 − t/a.",
                       panels(error_plot, {flat_scene("fig4a", "a) t/a = 0.4", "0.4"),
                                           flat_scene("fig4b", "b) t/a = 0.8", "0.8")})});
    figures.push_back({"fig5", "Figure 5. Pressure, flat-and-rounded punches",
                       "Exact pressure and the one-, two- and three-term approximations, from "
                       "the line of symmetry to the edge.",
                       panels(pressure_plot, {flat_scene("fig5a", "a) t/a = 0.4", "0.4"),
                                              flat_scene("fig5b", "b) t/a = 0.8", "0.8")})});
    figures.push_back({"fig6", "Figure 6. Relative error, tilted wedge",
                       std::string("Relative error of the approximations for a ") + wedge_words,
                       panels(error_plot, both_edges("fig6", wedge(), "1"))});
    figures.push_back({"fig7", "Figure 7. Pressure, tilted wedge",
                       std::string("Exact pressure and the approximations for a ") + wedge_words,
                       panels(pressure_plot, both_edges("fig7", wedge(), "1"))});
    figures.push_back(
        {"fig8", "Figure 8. Relative error, tilted flat-and-rounded punch",
         std::string("Relative error of the approximations for a ") + flat_words + size_note,
         panels(error_plot, both_edges("fig8", tilted_flat(), tilted_flat_half_width))});
    figures.push_back(
        {"fig9", "Figure 9. Pressure, tilted flat-and-rounded punch",
         std::string("Exact pressure and the approximations for a ") + flat_words + size_note,
         panels(pressure_plot, both_edges("fig9", tilted_flat(), tilted_flat_half_width))});
    return figures;
}

std::vector<NamedScene> paper_scenes(const std::string& name) {
    if (name != moore_hills) {
        return {};
    }
    const std::vector<contact::Edge> right{contact::Edge::right};
    const std::vector<contact::Edge> both{contact::Edge::left, contact::Edge::right};
    return {{"wedge", "wedge, m = 0", power_law("0"), "1", right},
            {"five-eighths", "power law, m = 5/8", power_law("5/8"), "1", right},
            {"hertz", "Hertz, m = 1", power_law("1"), "1", right},
            {"tenth-power", "power law, m = 10", power_law("10"), "1", right},
            {"flat-04", "flat-and-rounded, t/a = 0.4", flat_and_rounded("0.4"), "1", right},
            {"flat-08", "flat-and-rounded, t/a = 0.8", flat_and_rounded("0.8"), "1", right},
            {"tilted-wedge", "tilted wedge, φ = π/16, α = π/20", wedge(), "1", both},
            {"tilted-flat", "tilted punch, α = π/16, t = 1, R = 2, a = 3/2", tilted_flat(),
             tilted_flat_half_width, both}};
}

} // namespace edgeproof::report
