// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/comparison.hpp"

#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace edgeproof::comparison {
namespace {

constexpr double loaded_share = 0.02; ///< of the largest pressure
constexpr double like_width = 2;      ///< the largest ratio of two widths of one contact

} // namespace

void require_nodes_inside(const FileComparison& file, const ExactContact& exact,
                          const EdgeZone& zone) {
    const auto reject = [&](const std::string& problem, const std::string& instead) {
        throw InputError(problem, instead).at(file.table.file, 0);
    };
    if (file.inside >= fewest_inside) {
        const bool any = std::ranges::any_of(file.data.nodes, [&](const Node& node) {
            return node.place.inside() && is_counted(node, zone, file.contact);
        });
        if (!any) {
            reject(
                fmt::format("all {} nodes inside the contact lie in the edge zones", file.inside),
                "write a narrower --edge-zone, or give a finer mesh");
        }
        return;
    }
    const auto& nodes = file.data.nodes;
    const double a = exact.a().value;
    const double b = exact.b().value;
    double most = 0;
    for (const Node& node : nodes) {
        most = std::max(most, std::abs(node.p.data));
    }
    const auto pressing = [&](const Node& node) {
        return std::abs(node.p.data) > loaded_share * most;
    };
    const auto first = std::ranges::find_if(nodes, pressing);
    const std::string none =
        fmt::format("{} of the {} nodes {} inside the contact, {:.6g} < x < {:.6g}",
                    file.inside == 0 ? "none" : fmt::format("{}", file.inside), nodes.size(),
                    file.inside == 2 ? "lie" : "lies", -b + file.data.origin, a + file.data.origin);
    if (file.inside > 0 &&
        static_cast<std::size_t>(std::ranges::count_if(nodes, pressing)) < fewest_inside) {
        reject(none + ": too few for a comparison",
               "give a finer mesh: three nodes or more inside");
    }
    if (first == nodes.end()) {
        reject(none + ", and every pressure is zero",
               "give the nodes of the contact, with their pressures");
    }
    const auto last = std::find_if(nodes.rbegin(), nodes.rend(), pressing).base() - 1;
    const double from = first->x + file.data.origin;
    const double to = last->x + file.data.origin;
    const double steps = static_cast<double>(last - first);
    // The contact ends half an element beyond the loaded nodes.
    const double width = to - from + (steps > 0 ? (to - from) / steps : 0);
    const double ratio = exact.length() / width;
    const std::string instead =
        ratio > 1 / like_width && ratio < like_width
            ? fmt::format("write --origin {:.4g}, the x of the data at the scene's origin, or "
                          "--origin auto",
                          0.5 * (from + to) - 0.5 * (a - b))
            : fmt::format("write --scale x=..., about {:.2g}, if x is in another unit than the "
                          "scene's, --origin if it is measured from another place",
                          ratio);
    reject(fmt::format("{}: the pressures of the data extend from x = {:.6g} to {:.6g}", none, from,
                       to),
           instead);
}

} // namespace edgeproof::comparison
