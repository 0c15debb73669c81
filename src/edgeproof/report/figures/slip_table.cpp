// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/slip_table.hpp"
#include "edgeproof/contact/slip/slip_reach.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/figures/figures_paper.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace edgeproof::report {
namespace {

constexpr long most_bits_of_slip = 1L << 12;

/// The slip of one of the paper's contacts under a shear force alone, in balls with any number of
/// bits. Relative sizes do not depend on E*, f or P, so that E* = f = 1.
class PaperSlip {
public:
    explicit PaperSlip(const NamedScene& scene) : scene_(scene) {}
    /// Throws BudgetError if these bits do not enclose the contact.
    [[nodiscard]] const contact::BallSlip& at(long bits) {
        auto& level = levels_[bits];
        if (!level) {
            auto made = std::make_unique<Level>();
            made->contact.emplace(
                scene_.profile, formula::Exact::of(Rational(1)),
                contact::Load::right_edge(formula::Exact::parse(scene_.half_width)), bits);
            made->zones = closed_form_zones(*made->contact);
            const Ball P = made->contact->force();
            made->slip.emplace(*made->contact, *made->zones, P,
                               contact::ShearLoad<Ball>{P / 2, Ball(0, bits)}, Ball(1, bits));
            level = std::move(made);
        }
        return *level->slip;
    }

private:
    struct Level {
        std::optional<contact::BallContact> contact;
        std::unique_ptr<contact::ZoneSolver> zones;
        std::optional<contact::BallSlip> slip;
    };
    const NamedScene& scene_;
    std::map<long, std::unique_ptr<Level>> levels_;
};

scene::BoundedValue load_of(PaperSlip& slip, contact::Edge edge, std::size_t n,
                            const formula::Exact& tolerance, const scene::Digits& digits) {
    contact::SlipReachSearch search(
        [&](long bits) -> const contact::BallSlip& { return slip.at(bits); }, edge, n, tolerance);
    for (long bits = formula::bits_for(digits.count) + 96;; bits *= 2) {
        try {
            contact::EnclosedReach reach = search.at(bits);
            if (!reach.leaves) {
                return {std::move(reach.ratio), true, "full sliding", Rational(1)};
            }
            if (has_digits(reach.ratio, digits) || bits > most_bits_of_slip) {
                return {std::move(reach.ratio), true, "sign changes", {}};
            }
        } catch (const BudgetError&) {
            if (bits > most_bits_of_slip) {
                throw;
            }
        }
    }
}

} // namespace

Table slip_table(const std::string& paper, const SlipTableOptions& options) {
    Table table;
    table.title = "Q/(f P) up to which n terms of the slip zone's size are within a tolerance";
    table.notes = {"a shear force alone, P constant; 1: up to full sliding",
                   "every digit is right: proved (docs/partial-slip.md)"};
    table.columns = {
        {"profile", Column::Kind::text}, {"edge", Column::Kind::text}, {"n", Column::Kind::count}};
    table.columns[0].phrase = "{}";
    table.columns[1].phrase = "{}";
    std::vector<formula::Exact> tolerances;
    for (const std::string& text : options.tolerances) {
        tolerances.push_back(scene::parse_tolerance(text));
        table.columns.push_back({"within " + text});
    }
    std::size_t done = 0;
    const std::vector<NamedScene> scenes = paper_scenes(paper);
    for (const NamedScene& scene : scenes) {
        PaperSlip slip(scene);
        for (const contact::Edge edge : scene.edges) {
            for (const std::size_t n : options.terms) {
                std::vector<std::string> row{
                    scene.name, scene.edges.size() == 1 ? "both" : scene::edge_name(edge),
                    std::to_string(n)};
                for (const formula::Exact& tolerance : tolerances) {
                    row.push_back(
                        printed(load_of(slip, edge, n, tolerance, options.digits), options.digits)
                            .text);
                }
                table.rows.push_back(std::move(row));
            }
        }
        ++done;
        if (options.progress) {
            options.progress(done, scenes.size());
        }
    }
    return table;
}

namespace {

constexpr long slip_figure_bits = 160;
constexpr int slip_steps = 100;
constexpr std::size_t slip_terms = 3;

Plot slip_plot(const NamedScene& scene, const contact::BallSlip& slip, contact::Edge edge) {
    const bool alone = scene.edges.size() == 1;
    Plot plot;
    plot.id = "slip-" + scene.id + (alone ? "" : "-" + scene::edge_name(edge));
    plot.title = scene.name + (alone ? "" : ", " + scene::edge_name(edge) + "-hand edge");
    plot.description = fmt::format(
        "Size of the slip zone against the shear force, from none to full sliding: exact, and by "
        "the first one, two and three terms of its series. {}.",
        plot.title);
    plot.x = {"shear force Q/(f P)", false, {{"0", "1"}}};
    plot.y = {edge == contact::Edge::right ? "size of the slip zone d/a"
                                           : "size of the slip zone d/b",
              false,
              {{"0", "*"}}};
    plot.columns = {"load", "d", "d1", "d2", "d3"};
    plot.curves.push_back({"d", "exact", exact_pen});
    add_term_curves(plot, "d");
    const auto series = slip.series(slip_terms);
    const auto& kappa = edge == contact::Edge::right ? series.right : series.left;
    const Ball unit = slip.whole().at(edge);
    contact::BallZone near = slip.whole();
    for (int k = 1; k < slip_steps; ++k) {
        const Ball tau(Rational(k, slip_steps), slip_figure_bits);
        near = slip.stick_at(tau, near);
        std::vector<std::optional<Real>> row{
            tau.midpoint(), Ball((slip.whole().at(edge) - near.at(edge)) / unit).midpoint()};
        for (std::size_t n = 1; n <= slip_terms; ++n) {
            row.emplace_back(Ball(contact::slip_sum(kappa, n, tau) / unit).midpoint());
        }
        plot.rows.push_back(std::move(row));
    }
    return plot;
}

} // namespace

std::vector<Plot> slip_plots(const std::string& paper) {
    std::vector<Plot> plots;
    for (const NamedScene& scene : paper_scenes(paper)) {
        PaperSlip slip(scene);
        for (const contact::Edge edge : scene.edges) {
            plots.push_back(slip_plot(scene, slip.at(slip_figure_bits), edge));
        }
    }
    return plots;
}

} // namespace edgeproof::report
