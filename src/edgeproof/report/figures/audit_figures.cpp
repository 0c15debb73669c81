// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/figures/audit_figures.hpp"

#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/checks/parts/residual_fit.hpp"
#include "edgeproof/contact/curved/proved_slip.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/report/figures/scene_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace edgeproof::report {
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

std::string edge_words(contact::Edge edge) { return scene::edge_name(edge) + "-hand edge"; }

std::string terms_words(std::size_t n) { return fmt::format("{} term{}", n, n == 1 ? "" : "s"); }

struct Coefficient {
    contact::Edge edge;
    std::size_t k;
};

/// Reads "right.c1".
std::optional<Coefficient> coefficient_named(std::string_view text) {
    for (const contact::Edge edge : {contact::Edge::right, contact::Edge::left}) {
        const std::string start = scene::edge_name(edge) + ".c";
        if (text.starts_with(start) && text.size() == start.size() + 1 && text.back() >= '0' &&
            text.back() <= '9') {
            return Coefficient{edge, static_cast<std::size_t>(text.back() - '0')};
        }
    }
    return std::nullopt;
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
    constexpr int places = 33; // u = 0.2 of the reach, then each 10^(-1/4) times the one before
    if (!audit::is_admitted(claim, sample)) {
        return std::nullopt;
    }
    const long bits = formula::bits_for(2 * digits);
    const audit::EnclosedSample at(sample, bits);
    const auto contact = sample.scene.contact(bits);
    const PrecisionScope scope(digits + 10);
    const std::vector<Ball> c = contact->expansion(which.edge, which.k + 1);
    const Ball printed = at.finite(says);
    const Ball corrected = correct ? at.finite(*correct) : c[which.k];
    const auto differ = [&](const Ball& x, int by) {
        const Real size = std::max(Real(abs(printed.midpoint())), Real(abs(c[which.k].midpoint())));
        return abs(Real((x - c[which.k]).midpoint())) > size * pow(Real(10), -by);
    };
    if (!differ(printed, 20) || differ(corrected, 40)) {
        return std::nullopt;
    }
    Plot plot;
    plot.id = "erratum-" + claim.id;
    plot.first_column = "u_over_length";
    const Real start = contact->reach(which.edge).midpoint() / 5;
    const auto size = [](const Ball& x) { return size_of(at_working_precision(x.midpoint())); };
    for (int j = 0; j < places; ++j) {
        const Ball u(Real(start * pow(Real(10), Real(-j) / 4)), bits);
        const std::span<const Ball> known(c.data(), which.k);
        const Ball rest = contact->pressure(which.edge, u) - audit::sum_of_terms(known, u);
        const Ball step = sqrt(u) * pow_int(u, static_cast<long>(which.k));
        plot.rows.push_back({at_working_precision((u / contact->length()).midpoint()),
                             size(rest - printed * step), size(rest - corrected * step)});
    }
    const std::string terms = terms_words(which.k + 1);
    const std::string edge = edge_words(which.edge);
    const std::string as_printed = last_slope(plot, 1);
    const std::string as_corrected = last_slope(plot, 2);
    plot.title = claim.id + ": remainder after " + terms;
    plot.x = {"u/(a + b), from the " + edge, true};
    plot.y = {"|p − p_local|", true};
    plot.curves = {{"printed", "as printed: slope " + as_printed, {Colour::vermilion, 2, {}, 2}},
                   {"corrected", "as corrected: slope " + as_corrected, {Colour::blue, 1, {}, 2}}};
    plot.description =
        fmt::format("The pressure less its first {} at the {}, log-log against the distance from "
                    "it, in the scene {}. With the coefficient as printed the slope is {}, as "
                    "corrected {}.",
                    terms, edge, sample.scene.text(), as_printed, as_corrected);
    return plot;
}

Plot residual_plot(const scene::Scene& scene, contact::Edge edge, const std::string& id) {
    const audit::ResidualFitOptions options{
        .orders = orders, .digits = figure_digits + 5, .start = 2};
    const auto contact =
        contact::proved_contact(*scene.profile, scene.contact_modulus, scene.load, options.bits());
    const audit::ResidualFit fit = audit::fit_residuals(*contact, edge, options);
    Plot plot;
    plot.id = id + "-" + scene::edge_name(edge);
    plot.title = scene.title;
    plot.x = {"u from the " + edge_words(edge), true};
    plot.y = {"|p − first n terms|", true};
    plot.first_column = "u";
    for (const Real& u : fit.u) {
        plot.rows.push_back({u});
    }
    const PrecisionScope scope(figure_digits + 10);
    for (std::size_t n = 0; n < orders; ++n) {
        plot.add_curve(
            fmt::format("r{}", n), fmt::format("n = {}: slope {}", n, fixed(fit.slopes[n], 6)),
            {order_colours[n], n == orders - 1 ? 2U : 1U, static_cast<unsigned>(n + 4), 1.5});
        for (std::size_t j = 0; j < plot.rows.size(); ++j) {
            plot.rows[j].back() = size_of(fit.residuals[n][j]);
        }
    }
    plot.description = fmt::format(
        "Remainder of the pressure after n = 0 to {} terms at the {}, log-log against the "
        "distance from it, with the slopes extrapolated to the edge.",
        orders - 1, edge_words(edge));
    return plot;
}

} // namespace

FiguresOfSource figures_of_source(const std::filesystem::path& ledger) {
    const std::filesystem::path folder = ledger.parent_path() / "figures";
    const std::filesystem::path file = folder / ledger.filename();
    std::error_code none;
    if (!std::filesystem::is_regular_file(file, none)) {
        return {};
    }
    const auto top = io::TomlSection::parse(
        io::read_text(file, "figures (TOML)", io::most_toml_bytes), file.string());
    top.allow({"residuals", "figure"});
    FiguresOfSource figures;
    std::set<std::string> ids; // they name files
    const auto own_id = [&](const io::TomlSection& section, const char* key,
                            const std::string& id) {
        section.require(ids.insert(id).second, key, id + " is there twice", "name each once");
        return id;
    };
    for (const io::TomlSection& section : top.sections_or_none("figure")) {
        section.allow({"id", "title", "caption", "panel", "scenes"});
        const std::string panel = section.text("panel");
        section.require(panel == "pressure" || panel == "errors", "panel",
                        "there is no panel '" + panel + "'", "write \"pressure\" or \"errors\"");
        const Panels panels = panel == "errors" ? Panels::errors : Panels::pressure;
        FigureRecipe figure{own_id(section, "id", section.text("id")),
                            section.text("title"),
                            section.text("caption"),
                            {}};
        for (const std::string& name : section.texts("scenes")) {
            const std::string letter(1, static_cast<char>('a' + figure.plots.size() % 26));
            figure.plots.emplace_back([scene = scene::read_scene(folder / name), panels,
                                       id = own_id(section, "scenes", figure.id + letter)] {
                Plot plot = scene_picture(
                                scene, [](std::size_t, std::size_t) {}, panels)
                                .front();
                plot.id = id;
                plot.title = scene.title;
                return plot;
            });
        }
        figures.printed.push_back(std::move(figure));
    }
    for (const std::string& name :
         top.has("residuals") ? top.texts("residuals") : std::vector<std::string>{}) {
        const scene::Scene scene = scene::read_scene(folder / name);
        if (!scene.profile) {
            throw InputError("the tilt of this scene is not given", "give alpha instead of M")
                .at(scene.file, scene.load_line);
        }
        const std::string id =
            own_id(top, "residuals", "residual-" + std::filesystem::path(name).stem().string());
        FigureRecipe figure{id,
                            "Residual fit: " + scene.title,
                            "Remainder of the exact pressure after n terms of the expansion, "
                            "against the distance from the edge. The slope of order n is n + 1/2 "
                            "if all coefficients before it are right (the next one where a "
                            "coefficient vanishes).",
                            {}};
        for (const contact::Edge edge : scene.ask.edges) {
            figure.plots.emplace_back([scene, edge, id] { return residual_plot(scene, edge, id); });
        }
        figures.residuals.push_back(std::move(figure));
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
        } catch (const Error&) { // not in this scene
        }
    }
    return std::nullopt;
}

} // namespace edgeproof::report
