// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/measures/measures.hpp"
#include "edgeproof/scene/input/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace edgeproof::comparison {
namespace {

/// The rms pressure of nodes that lie more than two elements outside the exact contact.
double scatter_outside(const AlignedResult& data, double element) {
    double sum = 0;
    std::size_t n = 0;
    for (const Node& node : data.nodes) {
        if (node.place.u() < -2 * element) {
            sum += node.p.data * node.p.data;
            ++n;
        }
    }
    return n > 2 ? std::sqrt(sum / static_cast<double>(n)) : 0;
}

/// The nodes from an edge inwards: distances grow with the index.
struct Inwards {
    std::vector<double> d; ///< along x, outermost first, from any origin
    std::vector<double> p;
};

Inwards inwards(const AlignedResult& data, contact::Edge edge) {
    const bool right = edge == contact::Edge::right;
    Inwards out;
    for (std::size_t i = 0; i < data.nodes.size(); ++i) {
        const Node& node = data.nodes[right ? data.nodes.size() - 1 - i : i];
        out.d.push_back(right ? -node.x : node.x);
        out.p.push_back(node.p.data);
    }
    return out;
}

/// The zero of p^2 outside d[i], between there and `limit`.
double vanishing_point(const Inwards& nodes, std::size_t i, double limit) {
    const double x0 = nodes.d[i];
    const double y0 = nodes.p[i] * nodes.p[i];
    std::vector<std::pair<double, double>> next; // at other places, all loaded
    for (std::size_t j = i + 1; j < nodes.d.size() && next.size() < 2; ++j) {
        const double x = nodes.d[j] - x0;
        const bool new_place = next.empty() ? x > 0 : x > next.back().first;
        if (new_place && nodes.p[j] > 0) {
            next.emplace_back(x, nodes.p[j] * nodes.p[j] - y0);
        }
    }
    if (next.empty() || next[0].second <= 0) {
        return 0.5 * (x0 + limit);
    }
    double slope = next[0].second / next[0].first;
    double root = -y0 / slope;
    if (next.size() == 2) {
        const double second = next[1].second / next[1].first;
        const double curvature = (second - slope) / (next[1].first - next[0].first);
        slope -= curvature * next[0].first;
        const double discriminant = slope * slope - 4 * curvature * y0;
        if (slope > 0 && discriminant >= 0) {
            root = -2 * y0 / (slope + std::sqrt(discriminant));
        }
    }
    return std::clamp(x0 + root, std::min(limit, x0), x0);
}

std::optional<double> edge_of(const Inwards& nodes, double threshold) {
    const auto found = std::ranges::find_if(nodes.p, [=](double p) { return p > threshold; });
    if (found == nodes.p.end()) {
        return {};
    }
    const auto i = static_cast<std::size_t>(found - nodes.p.begin());
    double limit = 0;
    if (i > 0) {
        limit = nodes.d[i - 1];
    } else { // the data end on a loaded node
        std::size_t j = 1;
        while (j + 1 < nodes.d.size() && nodes.d[j] == nodes.d[0]) {
            ++j;
        }
        limit = nodes.d[0] - (nodes.d[std::min(j, nodes.d.size() - 1)] - nodes.d[0]);
    }
    return vanishing_point(nodes, i, limit);
}

/// The width of the interval that contains the edge, or of the closest one.
double element_at(const AlignedResult& data, double edge) {
    double width = 0;
    double nearest = 0;
    for (std::size_t i = 1; i < data.nodes.size(); ++i) {
        const double left = data.nodes[i - 1].x;
        const double right = data.nodes[i].x;
        if (!(right > left)) {
            continue;
        }
        const double away = edge < left ? left - edge : edge > right ? edge - right : 0;
        if (width == 0 || away < nearest) {
            width = right - left;
            nearest = away;
        }
    }
    return width;
}

} // namespace

DataContact contact_of(const AlignedResult& data, const ExactContact& exact) {
    DataContact found;
    const double a = exact.a().value;
    const double b = exact.b().value;
    found.element = {element_at(data, a), element_at(data, -b)};
    const double slack = 1e-9 * exact.length();
    found.reaches = {data.nodes.back().x >= a - found.element[0] - slack,
                     data.nodes.front().x <= -b + found.element[1] + slack};
    double first = 0;
    double last = 0;
    std::size_t inside = 0;
    for (const Node& node : data.nodes) {
        found.largest = std::max(found.largest, node.p.data);
        if (node.place.inside()) {
            first = inside == 0 ? node.x : first;
            last = node.x;
            ++inside;
        }
    }
    if (inside > 1) {
        found.mean_element = (last - first) / static_cast<double>(inside - 1);
    }
    found.force = force_of(data, exact, [](const Node& n) { return std::optional(n.p.data); });
    if (!(found.largest > 0)) {
        return found;
    }
    constexpr double most_of_scatter = 0.05; // a second contact is not scatter
    const double scatter = 4 * scatter_outside(data, std::max(found.element[0], found.element[1]));
    const double threshold = std::max(pressing_fraction * found.largest,
                                      std::min(scatter, most_of_scatter * found.largest));
    for (const contact::Edge edge : both_edges) {
        if (data.has(edge)) {
            const auto d = edge_of(inwards(data, edge), threshold);
            (edge == contact::Edge::right ? found.a : found.b) = d ? std::optional(-*d) : d;
        }
    }
    bool pressed = false;
    bool gap = false;
    for (const Node& node : data.nodes) {
        if (node.p.data > threshold) {
            found.gaps += gap ? 1 : 0;
            pressed = true;
            gap = false;
        } else {
            gap = pressed;
        }
    }
    return found;
}

namespace {

constexpr double most_off = 0.1;    ///< error of the rules for the exact pressure
constexpr double widest_gap = 0.25; ///< between neighbours inside, relative to a + b

/// Returns the reason why the nodes do not determine an edge, if they do not.
std::optional<std::string> no_edge(const AlignedResult& data, const DataContact& of_exact,
                                   const ExactContact& exact, contact::Edge at) {
    const bool right = at == contact::Edge::right;
    const char* const name = right ? "a" : "b";
    const auto& found = of_exact.at(at);
    if (!of_exact.reaches[index_of(at)]) {
        return fmt::format("{} is not determined: the data end at x = {:.6g}, inside the contact, "
                           "before its {} edge",
                           name, right ? data.nodes.back().x : data.nodes.front().x,
                           scene::edge_name(at));
    }
    if (!found || !(std::abs(*found - exact.edge(at)) <= most_off * exact.length())) {
        return fmt::format("{} is not determined: the exact pressure at these nodes gives {:.6g}, "
                           "but the exact value is {:.6g}",
                           name, found.value_or(0), exact.edge(at));
    }
    return {};
}

/// The widest interval between neighbours, limited to the contact.
double widest_interval(const AlignedResult& data, const ExactContact& exact) {
    double widest = 0;
    for (std::size_t i = 1; i < data.nodes.size(); ++i) {
        const double from = std::max(data.nodes[i - 1].x, -exact.b().value);
        const double to = std::min(data.nodes[i].x, exact.a().value);
        widest = std::max(widest, to - from);
    }
    return widest;
}

/// The distance of the beginning of the half from the middle, if that is more than an element.
std::optional<double> missing_middle(const AlignedResult& data) {
    if (!data.half) {
        return {};
    }
    const auto& nodes = data.nodes;
    const bool right = *data.half == contact::Edge::right;
    const double first = right ? nodes.front().x : -nodes.back().x;
    const double element =
        right ? nodes[1].x - nodes[0].x : nodes.back().x - nodes[nodes.size() - 2].x;
    return std::abs(first) <= element * (1 + 1e-9) ? std::nullopt : std::optional(first);
}

/// Returns the reason why the nodes do not determine P, if they do not.
std::optional<std::string> no_force(const AlignedResult& data, const ExactContact& exact) {
    const double value = exact.force().value;
    const double found = // without corners
        force_of(data, exact, [](const Node& n) { return n.p.exact; });
    const double widest = widest_interval(data, exact);
    if (const auto from = missing_middle(data)) {
        return fmt::format("P is not determined: the half of the contact begins {:.6g} from its "
                           "middle",
                           *from);
    }
    if (!(widest <= widest_gap * exact.length())) {
        return fmt::format("P is not determined: {:.6g} of the contact's {:.6g} lie between two "
                           "neighbouring nodes",
                           widest, exact.length());
    }
    if (!(std::abs(found / value - 1) <= most_off)) {
        return fmt::format("P is not determined: the exact pressure at these nodes gives {:.6g}, "
                           "but the exact value is {:.6g}",
                           found, value);
    }
    return {};
}

} // namespace

std::vector<Undetermined> undetermined(const AlignedResult& data, const DataContact& of_exact,
                                       const ExactContact& exact) {
    std::vector<Undetermined> list;
    const auto add = [&](std::string_view quantity, const std::optional<std::string>& why) {
        if (why) {
            list.push_back({quantity, *why});
        }
    };
    for (const contact::Edge at : both_edges) {
        if (data.has(at)) {
            add(at == contact::Edge::right ? "a" : "b", no_edge(data, of_exact, exact, at));
        }
    }
    add("P", no_force(data, exact));
    double most = 0;
    for (const Node& node : data.nodes) {
        most = std::max(most, node.p.exact.value_or(0));
    }
    if (!exact.scale().mean && !(most >= (1 - most_off) * exact.scale().value)) {
        add("largest p",
            fmt::format("the largest p is not determined: it is {:.6g}, and the exact pressure at "
                        "these nodes reaches {:.6g}",
                        exact.scale().value, most));
    }
    return list;
}

} // namespace edgeproof::comparison
