// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/measures/measures.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace edgeproof::comparison {
namespace {

/// The loaded nodes of a mesh, two elements or more from the edges, relative to the largest p.
struct Inner {
    std::vector<std::pair<double, double>> nodes; ///< x, p
    double width = 0;                             ///< mean, of an element
};

Inner inner_of(const ResultTable& table) {
    std::vector<std::pair<double, double>> all;
    double largest = 0;
    for (const ResultRow& row : table.rows) {
        all.emplace_back(row.x.convert_to<double>(), std::abs(row.p.convert_to<double>()));
        largest = std::max(largest, all.back().second);
    }
    constexpr double loaded_share = 0.02;
    const auto loaded = [&](const auto& node) { return node.second > loaded_share * largest; };
    const auto first = std::ranges::find_if(all, loaded);
    const auto last = std::find_if(all.rbegin(), all.rend(), loaded).base();
    constexpr std::ptrdiff_t left_out = 3; // the edge lies in the element outside the first of them
    constexpr std::ptrdiff_t fewest = 2;
    if (last - first < 2 * left_out + fewest) {
        return {};
    }
    Inner inner{{first + left_out, last - left_out}, 0};
    inner.width = (inner.nodes.back().first - inner.nodes.front().first) /
                  static_cast<double>(inner.nodes.size() - 1);
    if (const auto elements = sampled_elements(table)) {
        inner.width = elements->mean;
    }
    for (auto& [x, p] : inner.nodes) {
        p /= largest;
    }
    return inner;
}

/// The root mean square of the difference at the nodes of `mesh`, by linear interpolation.
std::optional<double> difference(const Inner& mesh, const Inner& finest) {
    double square = 0;
    std::size_t n = 0;
    for (const auto& [x, p] : mesh.nodes) {
        const auto above =
            std::ranges::lower_bound(finest.nodes, x, {}, &std::pair<double, double>::first);
        if (above == finest.nodes.end() || above == finest.nodes.begin() ||
            !(above->first > std::prev(above)->first)) {
            continue;
        }
        const auto& [x0, p0] = *std::prev(above);
        const double there = p0 + (above->second - p0) * (x - x0) / (above->first - x0);
        square += (p - there) * (p - there);
        ++n;
    }
    return n > 0 ? std::optional(std::sqrt(square / static_cast<double>(n))) : std::nullopt;
}

struct Sample {
    double x = 0;
    double p = 0;
    double x_rounding = 0;
    double p_rounding = 0;
};

std::vector<Sample> samples_of(const ResultTable& table) {
    std::vector<Sample> all;
    for (const ResultRow& row : table.rows) {
        all.push_back({row.x.convert_to<double>(), row.p.convert_to<double>(), row.x_rounding,
                       row.p_rounding});
    }
    return all;
}

/// The distance of a sample from the line through its neighbours, relative to what rounding of the
/// written digits, or to binary32, explains.
double change_of_slope(const Sample& before, const Sample& here, const Sample& after,
                       double largest) {
    constexpr double of_binary32 = 1e-6;
    const double slope = (after.p - before.p) / (after.x - before.x);
    const double off = std::abs(here.p - before.p - slope * (here.x - before.x));
    return off /
           (of_binary32 * largest + here.p_rounding +
            std::max(before.p_rounding, after.p_rounding) + 2 * std::abs(slope) * here.x_rounding);
}

} // namespace

std::optional<SampledElements> sampled_elements(const ResultTable& table) {
    const std::vector<Sample> all = samples_of(table);
    const double largest =
        std::abs(std::ranges::max(all, {}, [](const Sample& s) { return std::abs(s.p); }).p);
    constexpr double loaded_share = 0.02;
    constexpr double clearly = 3;
    constexpr std::size_t most_of_a_node = 2; // a node between two samples is seen at both
    constexpr std::size_t fewest_nodes = 4;
    std::vector<double> nodes;
    std::size_t linear = 0;
    std::size_t run = 0; // of samples at which the slope changes
    double greatest = 0; // change of the slope in the run
    for (std::size_t i = 1; i + 1 < all.size(); ++i) {
        if (std::min({std::abs(all[i - 1].p), std::abs(all[i].p), std::abs(all[i + 1].p)}) <=
            loaded_share * largest) {
            continue;
        }
        if (!(all[i - 1].x < all[i].x && all[i].x < all[i + 1].x)) {
            return {};
        }
        const double change = change_of_slope(all[i - 1], all[i], all[i + 1], largest);
        if (change > 1) {
            if (run == 0) {
                nodes.emplace_back();
            }
            nodes.back() = change > greatest ? all[i].x : nodes.back();
            greatest = std::max(greatest, change);
            ++run;
            continue;
        }
        if (run > most_of_a_node || (run > 0 && greatest < clearly)) {
            return {}; // a curve
        }
        ++linear;
        run = 0;
        greatest = 0;
    }
    if (run > 0) {
        nodes.pop_back(); // where the rows end
    }
    const std::size_t n = nodes.size();
    if (n < fewest_nodes || linear < n) {
        return {};
    }
    return SampledElements{{nodes[n - 1] - nodes[n - 2], nodes[1] - nodes[0]},
                           (nodes[n - 1] - nodes[0]) / static_cast<double>(n - 1)};
}

std::optional<std::vector<double>> mesh_errors(const std::vector<ResultTable>& tables) {
    std::vector<Inner> meshes;
    std::ranges::transform(tables, std::back_inserter(meshes), inner_of);
    if (meshes.size() < 2 ||
        std::ranges::any_of(meshes, [](const Inner& mesh) { return !(mesh.width > 0); })) {
        return {};
    }
    const auto finest = std::ranges::min_element(meshes, {}, &Inner::width);
    std::vector<std::pair<double, double>> off; // width, difference from the finest
    for (auto mesh = meshes.begin(); mesh != meshes.end(); ++mesh) {
        constexpr double same = 1.05;
        const auto d = difference(*mesh, *finest);
        if (mesh != finest && d && mesh->width > same * finest->width) {
            off.emplace_back(mesh->width, *d);
        }
    }
    if (off.empty()) {
        return {};
    }
    std::ranges::sort(off);
    const double h = finest->width;
    const auto growth = [h](double width, double q) { return std::pow(width, q) - std::pow(h, q); };
    double q = 1;
    if (off.size() >= 2 && off.back().first > off.front().first && off.front().second > 0) {
        double lower = 0.5;
        double upper = 4;
        for (int k = 0; k < 60; ++k) { // the ratio grows with q
            q = 0.5 * (lower + upper);
            const double ratio = growth(off.back().first, q) / growth(off.front().first, q);
            (ratio < off.back().second / off.front().second ? lower : upper) = q;
        }
    }
    double constant = 0;
    for (const auto& [width, d] : off) {
        constant = std::max(constant, d / growth(width, q));
    }
    std::vector<double> errors;
    for (const Inner& mesh : meshes) {
        errors.push_back(constant * std::pow(mesh.width, q));
    }
    return errors;
}

} // namespace edgeproof::comparison
