// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/causes/suspects.hpp"
#include "edgeproof/comparison/measures/alignment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace edgeproof::comparison {
namespace {

/// Finds the best small shift by the derivative of p. Returns nothing if the shift is not small.
std::optional<double> small_shift(const SuspectMaker& make) {
    const ExactContact& exact = make.exact();
    const double length = exact.length();
    double shift = 0;
    for (int round = 0; round < 6; ++round) {
        double top = 0;
        double bottom = 0;
        for (std::size_t i = 0; i < make.nodes().size(); ++i) {
            const Node& node = make.nodes()[i];
            const double step = 1e-4 * length;
            const double x = node.x - shift;
            const double margin = 0.05 * length;
            const bool by_corner = std::ranges::any_of(exact.knots(), [=](const auto& knot) {
                return knot.corner && std::abs(x - knot.x) < margin;
            });
            if (by_corner || x > exact.a().value - margin || x < -exact.b().value + margin) {
                continue;
            }
            const double p = make.pressure(exact, x);
            const double slope =
                (make.pressure(exact, x + step) - make.pressure(exact, x - step)) / (2 * step);
            if (std::isfinite(slope) && std::isfinite(p)) {
                top += slope * (p - node.p);
                bottom += slope * slope;
            }
        }
        shift += bottom > 0 ? top / bottom : 0;
        if (!(std::abs(shift) <= 0.1 * length)) {
            return {};
        }
    }
    return shift;
}

/// Finds the best shift of at least a fiftieth of a + b.
std::optional<double> large_shift(const SuspectMaker& make) {
    std::vector<RoughPoint> points;
    for (std::size_t i = 0; i < make.nodes().size(); ++i) {
        points.push_back({make.nodes()[i].x, make.nodes()[i].p});
    }
    const auto support = support_of(points);
    const auto found =
        support ? origin_of(points, *support, make.nodes().data.half, make.exact()) : std::nullopt;
    return found ? std::optional(found->exact.convert_to<double>()) : std::nullopt;
}

void suspect_shift(const SuspectMaker& make) {
    const ExactContact& exact = make.exact();
    const double origin = make.nodes().data.origin;
    const auto large = large_shift(make);
    const auto shift = large ? large : small_shift(make);
    if (shift) {
        make.add("shifted-origin",
                 fmt::format(
                     "x is shifted by {:.4g}: --origin {:.10g} if the data are measured from there",
                     *shift, origin + *shift),
                 exact.a().value + *shift, exact.b().value - *shift,
                 [&](std::size_t i) { return make.pressure(exact, make.nodes()[i].x - *shift); });
    }
}

/// Adds suspects in which a program confused the coordinate x, as in the data.
void suspect_maps(const SuspectMaker& make) {
    const ExactContact& exact = make.exact();
    const double a = exact.a().value;
    const double b = exact.b().value;
    const double origin = make.nodes().data.origin; // undoes the shift that was found
    const auto map = [&](const char* name, const std::string& what, double right, double left,
                         const auto& place) {
        make.add(name, what, right - origin, left + origin, [&](std::size_t i) {
            return make.pressure(exact, place(make.nodes()[i].x + origin));
        });
    };
    map("x-for-u", "x is measured from the left edge", a + b, 0, [=](double x) { return x - b; });
    map("x-for-u", "x, understood as measured from the right edge inwards", a + b, 0,
        [=](double x) { return a - x; });
    map("x-for-u", "|x|, understood as measured from the right edge inwards", a + b, a + b,
        [=](double x) { return a - std::abs(x); });
    map("x-for-u", "x is measured from the right edge", 0, a + b, [=](double x) { return x + a; });
    if (exact.symmetric()) {
        return;
    }
    map("x-from-middle", "x is measured from the middle of the contact", (a + b) / 2, (a + b) / 2,
        [=](double x) { return x + (a - b) / 2; });
    map("mirrored", "x has the opposite direction: the tilt is mirrored", b, a,
        [](double x) { return -x; });
    map("edges-swapped", "the edges are swapped: each distance is from the other one", a, b,
        [=](double x) { return a - b - x; });
}

/// Adds nodal values that are means over elements.
void suspect_means(const SuspectMaker& make) {
    const auto of_rows = [&](const std::string& what, double before, double here, double behind) {
        make.add("element-average", what, [&](std::size_t i) {
            double sum = 0;
            for (const auto& [weight, rows] :
                 {std::pair{before, -1}, std::pair{here, 0}, std::pair{behind, 1}}) {
                sum += weight == 0 ? 0 : weight * make.exact_pressure(i, rows);
            }
            return sum;
        });
    };
    of_rows("p of a node is averaged over its two elements", 0.25, 0.5, 0.25);
    of_rows("the mean over an element is given at its left node", 0, 0.5, 0.5);
    of_rows("the mean over an element is given at its right node", 0.5, 0.5, 0);
    // The mean by Gauss's three points; this is inaccurate near an edge, where nodes are not used.
    const auto& all = make.nodes().data.nodes;
    make.add("element-average", "p is the mean over the width of a node", [&](std::size_t i) {
        const std::size_t at = make.nodes().nodes[i];
        if (at == 0 || at + 1 >= all.size()) {
            return std::numeric_limits<double>::quiet_NaN();
        }
        const double middle = (all[at - 1].x + 2 * all[at].x + all[at + 1].x) / 4;
        const double half = (all[at + 1].x - all[at - 1].x) / 4;
        const double reach = half * std::sqrt(0.6);
        return (5 * make.pressure(make.exact(), middle - reach) +
                8 * make.pressure(make.exact(), middle) +
                5 * make.pressure(make.exact(), middle + reach)) /
               18;
    });
}

} // namespace

void suspect_places(const SuspectMaker& make) {
    for (const int rows : {1, -1}) {
        make.add("shifted-rows", "p is in the row next to that of its x",
                 [&](std::size_t i) { return make.exact_pressure(i, rows); });
    }
    suspect_maps(make);
    suspect_means(make);
    suspect_shift(make);
}

void suspect_terms(const SuspectMaker& make) {
    static constexpr std::array names{"one-term", "two-term", "three-term"};
    const ExactContact& exact = make.exact();
    const auto sum = [&exact](contact::Edge edge, double u, std::size_t n) {
        double value = 0;
        for (std::size_t k = n; k-- > 0;) {
            value = value * u + exact.c(edge, k).value;
        }
        return value * std::sqrt(u);
    };
    for (std::size_t n = 1; n <= names.size(); ++n) {
        const std::string terms = n == 1 ? "term" : fmt::format("{} terms", n);
        const auto add = [&](const std::string& where, const auto& edge_of) {
            make.add(names[n - 1],
                     fmt::format("the first {} of the expansion at {} instead of p", terms, where),
                     [&](std::size_t i) {
                         const auto& place = make.nodes()[i].exact;
                         if (!place.inside()) {
                             return 0.0;
                         }
                         const contact::Edge edge = edge_of(place);
                         return sum(
                             edge,
                             edge == contact::Edge::right ? place.from_right : place.from_left, n);
                     });
        };
        add("the nearer edge", [](const auto& place) { return place.nearer(); });
        add("the right edge", [](const auto&) { return contact::Edge::right; });
        add("the left edge", [](const auto&) { return contact::Edge::left; });
    }
}

} // namespace edgeproof::comparison
