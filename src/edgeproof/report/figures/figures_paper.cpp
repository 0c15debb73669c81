// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/figures_paper.hpp"
#include "edgeproof/audit/checks/parts/residual_fit.hpp"
#include "edgeproof/audit/sample/evaluated_scene.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace edgeproof::report {
namespace {

constexpr const char* moore_hills = "moore-hills";

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
    return {id, title, power_law(m), "1", "E*C aᵐ", "1"};
}
PanelScene flat_scene(const char* id, const char* title, const char* t) {
    return {id, title, flat_and_rounded(t), "1", "E*a/R", "1"};
}
std::vector<PanelScene> both_edges(const std::string& id, const contact::Profile& profile,
                                   const char* half_width) {
    return {{id + "a", "a) left-hand edge", profile, half_width, "E*", "1", contact::Edge::left},
            {id + "b", "b) right-hand edge", profile, half_width, "E*", "1", contact::Edge::right}};
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
            {"tilted-flat", "tilted flat-and-rounded, α = π/16, t = 1, R = 2, a = 3/2",
             tilted_flat(), tilted_flat_half_width, both}};
}

namespace {

using Colour = Pen::Colour;

constexpr std::size_t orders = 8;
/// Colours for distinct curves; yellow is too faint on white for a line.
constexpr std::array<Colour, orders> order_colours{
    Colour::black,  Colour::blue,   Colour::vermilion, Colour::green,
    Colour::purple, Colour::orange, Colour::sky_blue,  Colour::black};

std::string fixed(const Real& x, int places) {
    return fmt::format("{:.{}f}", x.convert_to<double>(), places);
}

std::string edge_words(contact::Edge edge) {
    return edge == contact::Edge::right ? "right-hand" : "left-hand";
}

struct Coefficient {
    contact::Edge edge;
    std::size_t k;
};

/// Reads "right.c1".
std::optional<Coefficient> coefficient_named(std::string_view text) {
    const std::size_t dot = text.find('.');
    const std::string_view side = text.substr(0, dot);
    if (dot == std::string_view::npos || (side != "right" && side != "left") ||
        text.size() < dot + 3 || text[dot + 1] != 'c') {
        return std::nullopt;
    }
    std::size_t k = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + dot + 2, end, k);
    if (error != std::errc() || stop != end || k > 9) {
        return std::nullopt;
    }
    return Coefficient{side == "right" ? contact::Edge::right : contact::Edge::left, k};
}

/// Returns the slope between the two rows nearest to the edge; "none" if a residual is 0.
std::string last_slope(const Plot& plot, std::size_t column) {
    const auto& near = plot.rows.back();
    const auto& next = plot.rows[plot.rows.size() - 2];
    if (!near[column] || !next[column]) {
        return "none";
    }
    return fixed(log(*next[column] / *near[column]) / log(*next[0] / *near[0]), 4);
}

std::optional<Real> size_of(const Real& x) {
    return x == 0 ? std::nullopt : std::optional<Real>(abs(x));
}

std::optional<Plot> plot_in(const audit::Sample& sample, const audit::Claim& claim,
                            const formula::Expr& says, const std::optional<formula::Expr>& correct,
                            const Coefficient& which) {
    constexpr unsigned digits = 60;
    constexpr int places = 33; // u = 0.2 of the radius, then each 10^(-1/4) times the one before
    const audit::EvaluatedScene scene_values(sample.scene, digits);
    const PrecisionScope scope(digits + 10);
    audit::Variables variables;
    for (const auto& [name, value] : sample.variables) {
        variables.emplace(name, value.to<Real>());
    }
    if (claim.has("where") && !scene_values.holds(claim.condition("where"), nullptr, variables)) {
        return std::nullopt;
    }
    const std::vector<Real> c = scene_values.expansion(which.edge, which.k + 2);
    const Real printed = scene_values.evaluate(says, nullptr, variables).value;
    const Real corrected =
        correct ? scene_values.evaluate(*correct, nullptr, variables).value : c[which.k];
    const Real size = std::max(Real(abs(printed)), Real(abs(c[which.k])));
    if (abs(printed - c[which.k]) <= size * pow(Real(10), -20) ||
        abs(corrected - c[which.k]) > size * pow(Real(10), -40)) {
        return std::nullopt;
    }
    Plot plot;
    plot.id = "erratum-" + claim.id;
    plot.columns = {"u_over_length", "printed", "corrected"};
    const Real start = scene_values.contact().convergence_radius(which.edge) / 5;
    for (int j = 0; j < places; ++j) {
        const Real u = start * pow(Real(10), Real(-j) / 4);
        Real sum = 0;
        for (std::size_t k = which.k; k-- > 0;) {
            sum = sum * u + c[k];
        }
        const Real rest = scene_values.pressure(which.edge, u) - sqrt(u) * sum;
        const Real step = sqrt(u) * pow(u, static_cast<int>(which.k));
        plot.rows.push_back({Real(u / scene_values.length()), size_of(rest - printed * step),
                             size_of(rest - corrected * step)});
    }
    plot.title = fmt::format("{}: remainder after {} term{}", claim.id, which.k + 1,
                             which.k == 0 ? "" : "s");
    const std::string as_printed = last_slope(plot, 1);
    const std::string as_corrected = last_slope(plot, 2);
    plot.x = {"u/(a + b), from the " + edge_words(which.edge) + " edge", true};
    plot.y = {"|p − p_local|", true};
    plot.curves = {{"printed", "as printed: slope " + as_printed, {Colour::vermilion, 2, {}, 2}},
                   {"corrected", "as corrected: slope " + as_corrected, {Colour::blue, 1, {}, 2}}};
    plot.description =
        fmt::format("The pressure less its first {} term{} at the {} edge, log-log against the "
                    "distance from it, in the scene {}. With the coefficient as printed the slope "
                    "is {}, as corrected {}.",
                    which.k + 1, which.k == 0 ? "" : "s", edge_words(which.edge),
                    sample.scene.text(), as_printed, as_corrected);
    return plot;
}

} // namespace

Plot residual_fit_plot(const NamedScene& scene, contact::Edge edge) {
    const auto fits = audit::fit_residuals(
        scene.profile, formula::Exact::parse("1"),
        contact::Load::right_edge(formula::Exact::parse(scene.half_width)), edge,
        {.orders = orders, .points = 12, .digits = figure_digits + 5, .start = 2});
    Plot plot;
    plot.id = "residual-" + scene.id + (edge == contact::Edge::right ? "-right" : "-left");
    plot.title = scene.name + ", " + edge_words(edge) + " edge";
    plot.x = {"distance u from the edge (same unit as a)", true};
    plot.y = {"|p − first n terms|/E*", true};
    plot.columns = {"u"};
    for (const Real& u : fits.front().u) {
        plot.rows.push_back({u});
    }
    const PrecisionScope scope(figure_digits + 10);
    for (const audit::OrderFit& fit : fits) {
        const std::string column = fmt::format("r{}", fit.n);
        plot.columns.push_back(column);
        for (std::size_t j = 0; j < plot.rows.size(); ++j) {
            plot.rows[j].push_back(size_of(fit.residual[j]));
        }
        plot.curves.push_back({column,
                               fmt::format("n = {}: slope {}", fit.n, fixed(fit.slope, 6)),
                               {order_colours[fit.n], fit.n == orders - 1 ? 2U : 1U,
                                static_cast<unsigned>(fit.n + 4), 1.5}});
    }
    plot.description = fmt::format(
        "Remainder of the pressure after n = 0 to {} terms at the {} edge, log-log against the "
        "distance from it, with the slopes extrapolated to the edge.",
        orders - 1, edge_words(edge));
    return plot;
}

std::vector<FigureRecipe> residual_figures(const std::string& name) {
    std::vector<FigureRecipe> figures;
    for (const NamedScene& scene : paper_scenes(name)) {
        FigureRecipe figure{"residual-" + scene.id,
                            "Residual fit: " + scene.name,
                            "Remainder of the exact pressure after n terms of the expansion, "
                            "against the distance from the edge. The slope of order n is n + 1/2 "
                            "if all coefficients before it are right (the next one where a "
                            "coefficient vanishes).",
                            {}};
        for (const contact::Edge edge : scene.edges) {
            figure.plots.emplace_back([scene, edge] { return residual_fit_plot(scene, edge); });
        }
        figures.push_back(std::move(figure));
    }
    return figures;
}

std::optional<Plot> erratum_plot(const audit::ClaimResult& result, const audit::Ledger& ledger) {
    const audit::Claim& claim = result.claim;
    if (result.outcome.verdict != audit::Verdict::refuted || !claim.has("of") ||
        !claim.has("says")) {
        return std::nullopt;
    }
    const auto which = coefficient_named(claim.text("of"));
    if (!which) {
        return std::nullopt;
    }
    std::optional<formula::Expr> correct;
    if (result.outcome.correct) {
        try {
            correct = expand_definitions(parse_formula(*result.outcome.correct, claim.vocabulary),
                                         claim.vocabulary);
        } catch (const Error&) { // it is in words: the coefficient of the mechanics is used instead
        }
    }
    const audit::AuditContext context(ledger, 50);
    for (const audit::Sample& sample : context.samples(claim)) {
        try {
            if (auto plot = plot_in(sample, claim, claim.formula("says"), correct, *which)) {
                return plot;
            }
        } catch (const DomainError&) { // not in this scene
        }
    }
    return std::nullopt;
}

} // namespace edgeproof::report
