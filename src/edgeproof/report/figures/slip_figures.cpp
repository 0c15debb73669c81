// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/slip_figures.hpp"

#include "edgeproof/report/figures/slip_table.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <fmt/format.h>

#include <array>

namespace edgeproof::report {
namespace {

constexpr long slip_figure_bits = 160;
constexpr int slip_steps = 100;
constexpr std::size_t slip_terms = 3;
constexpr std::array slip_term_names{"one term", "two terms", "three terms"};
constexpr std::array<Pen, slip_terms> slip_term_pens{Pen{Pen::Colour::purple, 2, {}, 2},
                                                     Pen{Pen::Colour::blue, 4, {}, 2},
                                                     Pen{Pen::Colour::green, 1, {}, 2}};

Plot slip_plot(PaperSlip& paper, contact::Edge edge) {
    const contact::BallSlip& slip = paper.at(slip_figure_bits);
    const NamedScene& scene = paper.scene();
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
    plot.curves.push_back({"d", "exact", {Pen::Colour::black, 1, {}, 2.5}});
    for (std::size_t n = 0; n < slip_terms; ++n) {
        plot.curves.push_back({fmt::format("d{}", n + 1), slip_term_names[n], slip_term_pens[n]});
    }
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
            plots.push_back(slip_plot(slip, edge));
        }
    }
    return plots;
}

} // namespace edgeproof::report
