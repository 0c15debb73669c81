// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/input/result_lines.hpp"
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace edgeproof::comparison {
namespace {

/// The contact output of a node, in the order of an .frd file.
enum ContactValue : std::size_t { copen, cslip1, cslip2, cpress, cshear1, cshear2, contact_values };

/// A number as it stands in the file; without a text there is none.
struct FrdNumber {
    std::string text;
    double value = 0;
};
struct FrdRow {
    std::vector<FrdNumber> values;
    std::size_t line = 0;
};
using FrdRows = std::map<std::string, FrdRow, std::less<>>; ///< by the number of the node

/// The values of a file at each node; the last step replaces those before.
struct FrdContents {
    FrdRows places;
    FrdRows contact; ///< contact_values
    FrdRows stress;  ///< SXX, SYY, SZZ
    std::size_t steps = 0;
};

constexpr std::string_view white_space = " \t\r";

/// Reads an .frd file of CalculiX in text: lines of fixed columns, one for a node. Throws
/// InputError, with the line, for a row that is not as CalculiX writes it, a node with two rows and
/// a file that ends inside a block; of a binary file for its first block.
class FrdReader {
public:
    FrdReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    FrdContents read() {
        while (next_line()) {
            if (line_.starts_with("    2C")) {
                const std::size_t width = node_width();
                if (next_line()) {
                    read_rows(contents_.places, width, {0, 1, 2});
                }
            } else if (line_.starts_with("  100C")) {
                read_result();
            }
        }
        return std::move(contents_);
    }

private:
    bool next_line() {
        if (at_ >= text_.size()) {
            return false;
        }
        if (++number_ % 4096 == 0) {
            check_interruption();
        }
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        line_ = text_.substr(at_, end - at_);
        at_ = end + 1;
        return true;
    }
    [[noreturn]] void
    reject(const std::string& problem,
           const std::string& instead = "give the file as CalculiX writes it") const {
        throw InputError(problem, instead).at(file_, number_);
    }
    /// A part of the line, without white space; empty beyond its end.
    [[nodiscard]] std::string cell(std::size_t from, std::size_t size) const {
        return from < line_.size() ? std::string(trimmed(line_.substr(from, size), white_space))
                                   : std::string();
    }
    /// Returns the width of the number of a node from the format in the head of a block.
    std::size_t node_width() {
        const std::size_t last = line_.find_last_not_of(white_space);
        const std::string format = last == std::string_view::npos ? "" : cell(last, 1);
        if (format != "0" && format != "1") {
            reject("the file is not an .frd file in text",
                   "let CalculiX write it in text (no OUTPUT=BINARY)");
        }
        return format == "0" ? 5 : 10;
    }
    void read_result() {
        const std::size_t width = node_width();
        std::string name;
        std::vector<std::string> components;
        while (next_line()) {
            const std::string key = cell(0, 3);
            if (key == "-4") {
                name = cell(5, 8);
            } else if (key == "-5") {
                components.push_back(cell(5, 8));
            } else {
                break;
            }
        }
        const auto indices = [&](std::initializer_list<const char*> wanted) {
            std::vector<std::size_t> found;
            for (const char* one : wanted) {
                const auto at = std::ranges::find(components, one);
                if (at == components.end()) {
                    reject(fmt::format("{} has no {}", name, one),
                           "give a file that CalculiX writes");
                }
                found.push_back(static_cast<std::size_t>(at - components.begin()));
            }
            return found;
        };
        FrdRows rows;
        if (name == "CONTACT") {
            read_rows(rows, width,
                      indices({"COPEN", "CSLIP1", "CSLIP2", "CPRESS", "CSHEAR1", "CSHEAR2"}));
            contents_.contact = std::move(rows);
            ++contents_.steps;
        } else if (name == "STRESS") {
            read_rows(rows, width, indices({"SXX", "SYY", "SZZ"}));
            contents_.stress = std::move(rows);
        } else {
            read_rows(rows, width, {});
        }
    }
    /// Reads the rows from the present line to the end of the block.
    void read_rows(FrdRows& rows, std::size_t width, const std::vector<std::size_t>& wanted) {
        constexpr std::size_t value_width = 12;
        constexpr std::size_t values_of_line = 6;
        do {
            const std::string key = cell(0, 3);
            if (key == "-3") {
                return;
            }
            if (key != "-1" && key != "-2") {
                reject("a row of an .frd file begins with -1, -2 or -3");
            }
            if (key == "-2" || wanted.empty()) {
                continue; // more components of the same node, which are not used
            }
            FrdRow row{{}, number_};
            for (const std::size_t index : wanted) {
                if (index >= values_of_line) {
                    reject("the row has too few values");
                }
                row.values.push_back(number_at(3 + width + value_width * index, value_width));
            }
            const std::string node = cell(3, width);
            if (!rows.emplace(node, std::move(row)).second) {
                reject("node " + printable(node) + " has two rows", "give one row for each node");
            }
        } while (next_line());
        reject("the file ends inside a block", "give the whole file");
    }
    [[nodiscard]] FrdNumber number_at(std::size_t from, std::size_t size) const {
        const std::string text = cell(from, size);
        const auto number = number_of({text}, ' ');
        if (!number) {
            reject("'" + printable(text) + "' is no number");
        }
        return {text, io::read_number(*number).value().convert_to<double>()};
    }

    std::string_view text_;
    const std::string& file_;
    std::string_view line_;
    std::size_t at_ = 0;
    std::size_t number_ = 0;
    FrdContents contents_;
};

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
    const FrdContents contents = FrdReader(text, file).read();
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
