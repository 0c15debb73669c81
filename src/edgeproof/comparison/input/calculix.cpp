// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/input/result_lines.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace edgeproof::comparison {
namespace {

constexpr std::string_view printed_title = "contact stress (slave ";

/// A node with contact output.
struct SurfaceNode {
    std::size_t line = 0;
    std::vector<FrdNumber> place;   ///< x, y, z
    std::vector<FrdNumber> contact; ///< contact_values
    std::vector<FrdNumber> stress;  ///< or empty

    [[nodiscard]] double at(std::size_t axis) const { return place[axis].value; }
    [[nodiscard]] double p() const { return contact[cpress].value; }
};
using SurfaceNodes = std::vector<SurfaceNode>;

/// Joins the output of each node with its place. Throws InputError without contact output, and for
/// a node without a place.
SurfaceNodes nodes_of(const FrdContents& contents, const std::string& file) {
    if (contents.contact.empty()) {
        throw InputError("there is no contact output",
                         "add *CONTACT FILE with CDIS, CSTR to the deck")
            .at(file, 0);
    }
    SurfaceNodes nodes;
    for (const auto& [node, row] : contents.contact) {
        const auto place = contents.places.find(node);
        if (place == contents.places.end()) {
            throw InputError("node " + printable(node) + " has no place", "give the whole file")
                .at(file, row.line);
        }
        const auto stress = contents.stress.find(node);
        nodes.push_back(
            {row.line, place->second.values, row.values,
             stress == contents.stress.end() ? std::vector<FrdNumber>{} : stress->second.values});
    }
    return nodes;
}

/// The coordinates of a plane contact: along it, normal to it, and across the planes of nodes.
using Axes = std::array<std::size_t, 3>;

/// Nodes with the same coordinate.
struct PressureGroup {
    double n = 0;
    double sum = 0; ///< of their pressures
};
/// The variance at equal places times the number of nodes, and with `neighbours` half the squares
/// of the differences of neighbours: of the few nodes of a coarse mesh these are large.
double roughness(const std::map<double, PressureGroup>& by_place, double squares, bool neighbours) {
    const PressureGroup* before = nullptr;
    for (const auto& [at, group] : by_place) {
        squares -= group.sum * group.sum / group.n;
        if (before != nullptr && neighbours) {
            const double difference = group.sum / group.n - before->sum / before->n;
            squares += (group.n + before->n) / 4 * difference * difference;
        }
        before = &group;
    }
    return squares;
}

/// Finds the axes from the pressures: they are a smooth function of the place along the contact.
/// The contact lies along the first coordinate unless nodes of different pressures have the same,
/// or a longer one is another such function.
Axes axes_of(const SurfaceNodes& all, const FrdRows& places) {
    constexpr double most_rough = 0.5; // of the variance of all
    SurfaceNodes nodes;
    std::ranges::copy_if(all, std::back_inserter(nodes),
                         [](const SurfaceNode& node) { return node.p() != 0; });
    std::array<std::map<double, PressureGroup>, 3> groups;
    double sum = 0;
    double squares = 0;
    for (const SurfaceNode& node : nodes) {
        for (std::size_t k = 0; k < 3; ++k) {
            PressureGroup& group = groups.at(k)[node.at(k)];
            group.n += 1;
            group.sum += node.p();
        }
        sum += node.p();
        squares += node.p() * node.p();
    }
    const double variance = squares - sum * sum / std::max(static_cast<double>(nodes.size()), 1.0);
    std::size_t along = 0;
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& at = groups.at(k);
        const double range = at.empty() ? 0 : at.rbegin()->first - at.begin()->first;
        if (range > longest && roughness(at, squares, k > 0) <= most_rough * variance) {
            along = k;
            longest = range;
        }
    }
    const std::size_t one = along == 0 ? 1 : 0;
    const std::size_t other = along == 2 ? 1 : 2;
    // Several nodes at one place along the contact lie in several planes; otherwise the planes are
    // those in whose direction the model is thin.
    const auto planes = [&](std::size_t k) {
        std::set<std::pair<double, double>> different;
        for (const SurfaceNode& node : nodes) {
            different.emplace(node.at(along), node.at(k));
        }
        return different.size();
    };
    const auto thickness = [&](std::size_t k) {
        double least = std::numeric_limits<double>::infinity();
        double most = -least;
        for (const auto& [node, row] : places) {
            least = std::min(least, row.values[k].value);
            most = std::max(most, row.values[k].value);
        }
        return most - least;
    };
    const bool across_one = planes(one) != planes(other) ? planes(one) > planes(other)
                                                         : thickness(one) < thickness(other);
    return across_one ? Axes{along, other, one} : Axes{along, one, other};
}

/// Returns the nodes without output that continue the line through the two outermost of `line` on
/// one side, to three elements, so that the data show where the contact ends.
std::vector<std::size_t> continued(SurfaceNodes line, const Axes& axes, const SurfaceNodes& all,
                                   bool right) {
    constexpr double elements = 3;
    constexpr double off_line = 0.25; // of an element
    std::ranges::stable_sort(line, {}, [&](const SurfaceNode& node) {
        return right ? -node.at(axes[0]) : node.at(axes[0]);
    });
    const double end = line[0].at(axes[0]);
    const double height = line[0].at(axes[1]);
    const auto other = std::ranges::find_if(
        line, [&](const SurfaceNode& node) { return node.at(axes[0]) != end; });
    if (other == line.end()) {
        return {};
    }
    const double dx = end - other->at(axes[0]);
    const double slope = (height - other->at(axes[1])) / dx;
    // If several nodes have one x, such as those of the other body, the nearest to the line counts.
    std::map<std::pair<double, double>, std::pair<double, std::size_t>> nearest; // by x and plane
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double x = all[i].at(axes[0]);
        const double part = (x - end) / dx;
        const double off = std::abs(all[i].at(axes[1]) - height - slope * (x - end));
        if (part > 0 && part < elements + off_line && off < off_line * std::abs(dx)) {
            const auto [known, is_new] =
                nearest.try_emplace({x, all[i].at(axes[2])}, std::pair(off, i));
            if (!is_new && off < known->second.first) {
                known->second = {off, i};
            }
        }
    }
    std::vector<std::size_t> found;
    for (const auto& [at, node] : nearest) {
        found.push_back(node.second);
    }
    return found;
}

/// Contact from surface to surface writes a row for each node of the model, with zeros if the node
/// is in no face in contact. Keeps the nodes of these faces, and the next ones of the surface.
void keep_surface(SurfaceNodes& nodes, const Axes& axes) {
    const auto is_zero = [](const SurfaceNode& node) {
        return std::ranges::all_of(node.contact, [](const FrdNumber& n) { return n.value == 0; });
    };
    SurfaceNodes in_contact;
    std::ranges::remove_copy_if(nodes, std::back_inserter(in_contact), is_zero);
    if (in_contact.empty() || in_contact.size() == nodes.size()) {
        return;
    }
    std::set<std::size_t> kept;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!is_zero(nodes[i])) {
            kept.insert(i);
        }
    }
    for (const bool right : {true, false}) {
        for (const std::size_t i : continued(in_contact, axes, nodes, right)) {
            nodes[i].contact.assign(contact_values, {});
            for (const std::size_t zero : {cpress, cshear1, cshear2}) {
                nodes[i].contact[zero] = {"0"};
            }
            kept.insert(i);
        }
    }
    SurfaceNodes surface;
    for (const std::size_t i : kept) {
        surface.push_back(std::move(nodes[i]));
    }
    nodes = std::move(surface);
}

/// 1 if the second tangential direction of the faces lies along the contact, 0 if the first does.
std::size_t tangent_along(const SurfaceNodes& nodes) {
    const auto greatest = [&](ContactValue value) {
        double most = 0;
        for (const SurfaceNode& node : nodes) {
            most = std::max(most, std::abs(node.contact[value].value));
        }
        return most;
    };
    return std::pair(greatest(cshear2), greatest(cslip2)) >
                   std::pair(greatest(cshear1), greatest(cslip1))
               ? 1
               : 0;
}

} // namespace

std::optional<ResultText> calculix_table(std::string_view text, const std::string& file) {
    if (!text.starts_with("    1C") || text.find("\n    2C") == std::string_view::npos) {
        if (text.find(printed_title) != std::string_view::npos) {
            throw InputError("the contact output of a .dat file has no places of the nodes",
                             "give the .frd file, with *CONTACT FILE and CDIS, CSTR in the deck")
                .at(file, 0);
        }
        return {};
    }
    const FrdContents contents = read_frd(text, file);
    SurfaceNodes nodes = nodes_of(contents, file);
    const Axes axes = axes_of(nodes, contents.places);
    keep_surface(nodes, axes);
    const std::size_t tangent = tangent_along(nodes);
    const bool has_gap = std::ranges::any_of(
        nodes, [](const SurfaceNode& node) { return !node.contact[copen].text.empty(); });
    const bool has_stress = !contents.stress.empty();
    const bool turned = axes[0] != 0;
    ResultText rows{file, {}};
    rows.separator = ',';
    rows.size = 5U + (turned ? 1U : 0U) + (has_gap ? 2U : 0U) + (has_stress ? 1U : 0U);
    rows.first_row = 1;
    rows.lines.push_back({1, std::string(turned ? "x," : "") +
                                 "COORD1,COORD2,COORD3,CPRESS,CSHEAR1" +
                                 (has_gap ? ",COPEN,CSLIP1" : "") + (has_stress ? ",S11" : "")});
    std::set<double> planes; // the places across
    for (const SurfaceNode& node : nodes) {
        planes.insert(node.at(axes[2]));
    }
    std::ranges::stable_sort(nodes, {}, [&](const SurfaceNode& node) { return node.at(axes[0]); });
    for (const SurfaceNode& node : nodes) {
        if (node.at(axes[2]) != *planes.begin()) {
            continue;
        }
        std::string line = turned ? node.place[axes[0]].text + "," : "";
        line += fmt::format("{},{},{},{},{}", node.place[0].text, node.place[1].text,
                            node.place[2].text, node.contact[cpress].text,
                            node.contact[cshear1 + tangent].text);
        line += has_gap ? "," + node.contact[copen].text + "," + node.contact[cslip1 + tangent].text
                        : "";
        line += node.stress.empty() ? "" : "," + node.stress[axes[0]].text;
        rows.lines.push_back({node.line, std::move(line)});
    }
    if (contents.steps > 1) {
        rows.findings.push_back(fmt::format(
            "the file has contact output of {} times: the last is compared", contents.steps));
    }
    if (tangent == 1) {
        rows.findings.emplace_back("CSHEAR2 and CSLIP2 are compared: the second tangential "
                                   "direction lies along the contact");
    }
    if (turned) {
        rows.findings.push_back(fmt::format("x is COORD{}, along which the contact lies{}",
                                            axes[0] + 1,
                                            has_stress ? ", and S11 the stress there" : ""));
    }
    if (planes.size() > 1) {
        rows.findings.push_back(
            fmt::format("the nodes of the surface lie in {} planes: those at COORD{} = {:g} are "
                        "compared",
                        planes.size(), axes[2] + 1, *planes.begin()));
    }
    return rows;
}

} // namespace edgeproof::comparison
