// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/input/result_lines.hpp"

#include "edgeproof/conformance/answers/number_text.hpp"

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

double value_of(const std::string& text) {
    return conformance::written_number(*number_of({text}, Separator::blank))
        .value.convert_to<double>();
}

double place_of(const NodeTable& places, const std::string& node, std::size_t axis) {
    return value_of(places.find(node)->second.values[axis]);
}

bool is_zero(const NodeValues& row) {
    return std::ranges::all_of(
        row.values, [](const std::string& text) { return text.empty() || value_of(text) == 0; });
}

/// The coordinates of a plane contact: along it, normal to it, and across the planes of nodes.
using Axes = std::array<std::size_t, 3>;

/// Finds the axes from the pressures: they are a smooth function of the place along the contact.
/// The contact lies along the first coordinate unless nodes of different pressures have the same,
/// or a longer one is another such function.
Axes axes_of(const NodeTable& places, const NodeTable& contact) {
    constexpr double most_rough = 0.5; // of the variance of all
    struct Group {
        double n = 0;
        double sum = 0;
    };
    std::array<std::map<double, Group>, 3> groups;
    Group all;
    double squares = 0;
    std::set<std::array<double, 3>> nodes;
    for (const auto& [node, row] : contact) {
        const double p = value_of(row.values[cpress]);
        if (p == 0) {
            continue;
        }
        std::array<double, 3> place{};
        for (std::size_t k = 0; k < 3; ++k) {
            place.at(k) = place_of(places, node, k);
            Group& group = groups.at(k)[place.at(k)];
            group.n += 1;
            group.sum += p;
        }
        nodes.insert(place);
        all.n += 1;
        all.sum += p;
        squares += p * p;
    }
    const double variance = squares - all.sum * all.sum / std::max(all.n, 1.0);
    // The variance at equal places, and half the squares of the differences of neighbours: of the
    // few nodes of a coarse mesh these are large.
    const auto roughness = [&](const std::map<double, Group>& by_place, bool neighbours) {
        double rough = squares;
        const Group* before = nullptr;
        for (const auto& [at, group] : by_place) {
            rough -= group.sum * group.sum / group.n;
            if (before != nullptr && neighbours) {
                const double difference = group.sum / group.n - before->sum / before->n;
                rough += (group.n + before->n) / 4 * difference * difference;
            }
            before = &group;
        }
        return rough;
    };
    std::optional<std::size_t> along;
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& at = groups.at(k);
        const double range = at.empty() ? 0 : at.rbegin()->first - at.begin()->first;
        if (range > longest && roughness(at, k > 0) <= most_rough * variance) {
            along = k;
            longest = range;
        }
    }
    Axes axes{along.value_or(0), 0, 0};
    const std::size_t one = axes[0] == 0 ? 1 : 0;
    const std::size_t other = axes[0] == 2 ? 1 : 2;
    // Several nodes at one place along the contact lie in several planes; otherwise the planes are
    // those in whose direction the model is thin.
    const auto planes = [&](std::size_t k) {
        std::set<std::pair<double, double>> different;
        for (const auto& place : nodes) {
            different.emplace(place.at(axes[0]), place.at(k));
        }
        return different.size();
    };
    const auto thickness = [&](std::size_t k) {
        double least = std::numeric_limits<double>::infinity();
        double most = -least;
        for (const auto& [node, row] : places) {
            least = std::min(least, value_of(row.values[k]));
            most = std::max(most, value_of(row.values[k]));
        }
        return most - least;
    };
    const bool first = planes(one) != planes(other) ? planes(one) > planes(other)
                                                    : thickness(one) < thickness(other);
    axes[1] = first ? other : one;
    axes[2] = first ? one : other;
    return axes;
}

/// Adds to `kept` the nodes without output that continue the line through its two outermost nodes
/// on one side, to three elements, so that the data show where the contact ends.
void continue_surface(const NodeTable& places, const Axes& axes, const NodeTable& all, bool right,
                      NodeTable& kept) {
    constexpr double elements = 3;
    constexpr double off_line = 0.25; // of an element
    std::vector<std::array<double, 3>> line;
    for (const auto& [node, row] : kept) {
        line.push_back({place_of(places, node, axes[0]), place_of(places, node, axes[1]),
                        place_of(places, node, axes[2])});
    }
    std::ranges::sort(
        line, [right](const auto& s, const auto& t) { return right ? s[0] > t[0] : s[0] < t[0]; });
    const auto other =
        std::ranges::find_if(line, [&](const auto& p) { return p[0] != line[0][0]; });
    if (other == line.end()) {
        return;
    }
    const double dx = line[0][0] - (*other)[0];
    const double slope = (line[0][1] - (*other)[1]) / dx;
    // If several nodes have one x, such as those of the other body, the nearest to the line counts.
    std::map<std::pair<double, double>, std::pair<double, std::string>> nearest; // by x and plane
    for (const auto& [node, row] : all) {
        const double x = place_of(places, node, axes[0]);
        const double part = (x - line[0][0]) / dx;
        const double off =
            std::abs(place_of(places, node, axes[1]) - line[0][1] - slope * (x - line[0][0]));
        if (part > 0 && part < elements + off_line && off < off_line * std::abs(dx)) {
            const auto at = std::pair(x, place_of(places, node, axes[2]));
            const auto known = nearest.find(at);
            if (known == nearest.end() || off < known->second.first) {
                nearest.insert_or_assign(at, std::pair(off, node));
            }
        }
    }
    NodeTable more;
    for (const auto& [at, node] : nearest) {
        NodeValues outside{std::vector<std::string>(contact_values),
                           all.find(node.second)->second.line};
        outside.values[cpress] = outside.values[cshear1] = outside.values[cshear2] = "0";
        more.emplace(node.second, std::move(outside));
    }
    kept.merge(more);
}

/// Contact from surface to surface writes a row for each node of the model, with zeros if the node
/// is in no face in contact. Keeps the nodes of these faces, and the next ones of the surface.
void keep_surface(CalculixContents& contents, const Axes& axes) {
    NodeTable kept;
    for (const auto& [node, row] : contents.contact) {
        if (!is_zero(row)) {
            kept.emplace(node, row);
        }
    }
    if (kept.empty() || kept.size() == contents.contact.size()) {
        return;
    }
    const NodeTable in_contact = kept;
    for (const bool right : {true, false}) {
        NodeTable wider = in_contact;
        continue_surface(contents.places, axes, contents.contact, right, wider);
        kept.merge(wider);
    }
    contents.contact = std::move(kept);
}

/// 1 if the second tangential direction of the faces lies along the contact, 0 if the first does.
std::size_t tangent_along(const NodeTable& contact) {
    std::array<double, 4> greatest{}; // CSHEAR1, CSHEAR2, CSLIP1, CSLIP2
    for (const auto& [node, row] : contact) {
        for (const auto& [at, value] : {std::pair{0U, cshear1}, std::pair{1U, cshear2},
                                        std::pair{2U, cslip1}, std::pair{3U, cslip2}}) {
            const std::string& text = row.values[value];
            greatest.at(at) =
                std::max(greatest.at(at), text.empty() ? 0 : std::abs(value_of(text)));
        }
    }
    return greatest[1] > greatest[0] || (greatest[1] == greatest[0] && greatest[3] > greatest[2])
               ? 1
               : 0;
}

} // namespace

std::optional<CalculixTable> calculix_table(std::string_view text, const std::string& file) {
    auto found = calculix_contents(text, file);
    if (!found) {
        return {};
    }
    CalculixContents& contents = *found;
    CalculixTable table{{file, {}}, {}};
    ResultText& rows = table.text;
    rows.separator = Separator::comma;
    const Axes axes = axes_of(contents.places, contents.contact);
    keep_surface(contents, axes);
    const std::size_t tangent = tangent_along(contents.contact);
    const bool has_gap = std::ranges::any_of(
        contents.contact, [](const auto& row) { return !row.second.values[copen].empty(); });
    const bool has_stress = !contents.stress.empty();
    const bool turned = axes[0] != 0;
    rows.size = 5U + (turned ? 1U : 0U) + (has_gap ? 2U : 0U) + (has_stress ? 1U : 0U);
    rows.first_row = 1;
    rows.lines.push_back({1, std::string(turned ? "x," : "") +
                                 "COORD1,COORD2,COORD3,CPRESS,CSHEAR1" +
                                 (has_gap ? ",COPEN,CSLIP1" : "") + (has_stress ? ",S11" : "")});
    std::map<double, std::size_t> planes; // the number of nodes by their place across
    for (const auto& [node, row] : contents.contact) {
        ++planes[place_of(contents.places, node, axes[2])];
    }
    std::multimap<double, ResultLine> by_place;
    for (const auto& [node, row] : contents.contact) {
        const auto& place = contents.places.find(node)->second.values;
        if (planes.size() > 1 && value_of(place[axes[2]]) != planes.begin()->first) {
            continue;
        }
        std::string line = turned ? place[axes[0]] + "," : "";
        line += fmt::format("{},{},{},{},{}", place[0], place[1], place[2], row.values[cpress],
                            row.values[cshear1 + tangent]);
        line += has_gap ? "," + row.values[copen] + "," + row.values[cslip1 + tangent] : "";
        const auto stress = contents.stress.find(node);
        line += stress != contents.stress.end() ? "," + stress->second.values[axes[0]] : "";
        by_place.emplace(value_of(place[axes[0]]), ResultLine{row.line, std::move(line)});
    }
    for (auto& [x, line] : by_place) {
        rows.lines.push_back(std::move(line));
    }
    if (contents.steps > 1) {
        table.findings.push_back(fmt::format(
            "the file has contact output of {} times: the last is compared", contents.steps));
    }
    if (tangent == 1) {
        table.findings.emplace_back("CSHEAR2 and CSLIP2 are compared: the second tangential "
                                    "direction lies along the contact");
    }
    if (turned) {
        table.findings.push_back(fmt::format("x is COORD{}, along which the contact lies{}",
                                             axes[0] + 1,
                                             has_stress ? ", and S11 the stress there" : ""));
    }
    if (planes.size() > 1) {
        table.findings.push_back(
            fmt::format("the nodes of the surface lie in {} planes: those at COORD{} = {:g} are "
                        "compared",
                        planes.size(), axes[2] + 1, planes.begin()->first));
    }
    return table;
}

} // namespace edgeproof::comparison
