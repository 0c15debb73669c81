// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/slip_table.hpp"

#include "edgeproof/formula/exact/exact_ball.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <optional>
#include <utility>

namespace edgeproof::report {
namespace {

constexpr long most_bits_of_slip = 1L << 12;

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

struct PaperSlip::Level {
    std::optional<contact::BallContact> contact;
    std::unique_ptr<contact::ZoneSolver> zones;
    std::optional<contact::BallSlip> slip;
};

const contact::BallSlip& PaperSlip::at(long bits) {
    auto& level = levels_[bits];
    if (!level) {
        const formula::Exact one = formula::Exact::of(Rational(1));
        auto made = std::make_shared<Level>();
        made->contact.emplace(scene_.profile, one,
                              contact::Load::right_edge(formula::Exact::parse(scene_.half_width)),
                              bits);
        made->zones = closed_form_zones(*made->contact);
        const Ball P = made->contact->force();
        made->slip.emplace(*made->contact, *made->zones, P,
                           contact::ShearLoad<Ball>{P / 2, Ball(0, bits)}, Ball(1, bits));
        level = std::move(made);
    }
    return *level->slip;
}

Table slip_table(const std::string& paper, const SlipTableOptions& options) {
    Table table;
    table.title = "Q/(f P) up to which n terms of the slip zone's size are within a tolerance";
    table.notes = {"a shear force alone, P constant; 1: up to full sliding",
                   "every digit is right: proved (docs/partial-slip.md)"};
    table.columns = {
        {"profile", Column::Kind::text}, {"edge", Column::Kind::text}, {"n", Column::Kind::count}};
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

} // namespace edgeproof::report
