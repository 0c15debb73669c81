// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/size_extents.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/roots/bracketed_root.hpp"

#include <algorithm>
#include <cmath>

namespace edgeproof::audit {
namespace {

constexpr int points_per_decade = 10;  // of the geometrically spaced points
constexpr int nearest_decades = 4;     // their least distance from a knot or the far edge
constexpr int uniform = 24;            // points between landmarks
const Float128 refined_width("1e-24"); // relative, for a crossing

/// Returns 0 within the tolerance, +1 at or above it, -1 at or below its negative.
int side_of(long double f, long double tolerance) {
    return f >= tolerance ? 1 : f <= -tolerance ? -1 : 0;
}

} // namespace

ContactsBySize::ContactsBySize(const contact::Profile& profile)
    : law_(profile, Float128(1)), rough_(profile, 1.0L) {
    if (!profile.piecewise_linear()) {
        throw DomainError("contacts of all sizes are searched for piecewise linear profiles only");
    }
}

std::vector<long double> ContactsBySize::At::places(contact::Edge edge) {
    const std::vector<long double>& c = rough_.coefficients(edge, most_terms);
    const contact::Extent<long double>& e = rough_.extent();
    const long double length = e.length();
    std::vector<long double> marks{0, length};
    for (const long double knot : rough_.knots()) {
        const long double u = edge == contact::Edge::right ? e.a - knot : e.b + knot;
        if (u > 0 && u < length) {
            marks.push_back(u);
        }
    }
    std::sort(marks.begin(), marks.end());
    // Nearer to the edge than this, no omitted term reaches a millionth.
    long double first = marks[1] / 4;
    for (std::size_t k = 1; k < c.size(); ++k) {
        if (c[k] != 0) {
            first = std::min(
                first, std::pow(1e-6L * std::abs(c[0] / c[k]), 1 / static_cast<long double>(k)));
        }
    }
    const long double step = std::pow(10.0L, -1.0L / points_per_decade);
    const long double near = std::pow(10.0L, static_cast<long double>(-nearest_decades));
    std::vector<long double> u{first};
    for (std::size_t i = 0; i + 1 < marks.size(); ++i) {
        const long double width = marks[i + 1] - marks[i];
        const long double least = i == 0 ? first : near * width;
        for (long double d = width / 2; d > least; d *= step) {
            u.push_back(marks[i] + d);
        }
        for (long double d = width / 2; d > near * width; d *= step) {
            u.push_back(marks[i + 1] - d);
        }
        for (int k = 1; k < uniform; ++k) {
            u.push_back(marks[i] + width * static_cast<long double>(k) / uniform);
        }
        if (i > 0) {
            u.push_back(marks[i]);
        }
    }
    // Add the end of the side, as a fraction of the side may be required.
    u.push_back(edge == contact::Edge::right ? e.a : e.b);
    std::sort(u.begin(), u.end());
    u.erase(std::unique(u.begin(), u.end()), u.end());
    std::erase_if(u, [&](long double x) { return !(x > 0 && x < length); });
    return u;
}

const std::vector<ContactsBySize::At::Node>& ContactsBySize::At::pressures(contact::Edge edge) {
    auto& nodes = pressures_.at(index_of(edge));
    if (nodes.empty()) {
        for (const long double u : places(edge)) {
            try {
                nodes.push_back({u, rough_.pressure(edge, u)});
            } catch (const DomainError&) {
                continue; // at a corner, where p is infinite
            }
        }
    }
    return nodes;
}

Float128 ContactsBySize::At::crossing(const ExtentOf& of, const Node& l, const Node& r, int which,
                                      bool refined) {
    const Float128 level = which * of.tolerance;
    const auto rough_level = static_cast<long double>(level);
    const auto rough_f = [&](long double u) { return rough_error(of, u) - rough_level; };
    // A value equal to the level counts as a root.
    const long double u =
        roots::bracketed_root<long double>(rough_f, l.u, l.f - rough_level, r.u, r.f - rough_level,
                                           refined ? 1e-12L : 1e-15L)
            .x;
    if (!refined) {
        return u;
    }
    const auto f = [&](const Float128& x) {
        const Float128 p = fine_.pressure(of.edge, x);
        return Float128(fine_.approximation(of, of.terms, x) / p - 1 - level);
    };
    const long double slack = u * 1e-9L;
    Float128 lo = std::max(u - slack, l.u);
    Float128 hi = std::min(u + slack, r.u);
    Float128 f_lo = f(lo);
    Float128 f_hi = f(hi);
    if ((f_lo > 0) == (f_hi > 0)) {
        lo = l.u;
        hi = r.u;
        f_lo = f(lo);
        f_hi = f(hi);
    }
    if ((f_lo > 0) == (f_hi > 0)) {
        return abs(f_lo) < abs(f_hi) ? lo : hi; // within roundoff of an end
    }
    return roots::bracketed_root<Float128>(f, lo, f_lo, hi, f_hi, refined_width).x;
}

/// p_local/p - 1 at the sampled places, and at extrema between them that may reach the tolerance.
std::vector<ContactsBySize::At::Node> ContactsBySize::At::errors(const ExtentOf& of) {
    std::vector<Node> nodes;
    for (const Node& node : pressures(of.edge)) {
        nodes.push_back({node.u, rough_.approximation(of, most_terms, node.u) / node.f - 1});
    }
    const auto tolerance = static_cast<long double>(of.tolerance);
    std::vector<Node> extrema;
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
        const Node& l = nodes[i - 1];
        const Node& m = nodes[i];
        const Node& r = nodes[i + 1];
        const int side = side_of(m.f, tolerance);
        const bool top = m.f > l.f && m.f > r.f;
        const bool bottom = m.f < l.f && m.f < r.f;
        if (top == bottom || side_of(l.f, tolerance) != side || side_of(r.f, tolerance) != side) {
            continue;
        }
        const long double level = side != 0 ? static_cast<long double>(side) * tolerance
                                  : top     ? tolerance
                                            : -tolerance;
        const long double bend = std::max(std::abs(m.f - l.f), std::abs(m.f - r.f));
        if ((level > m.f) != top || std::abs(level - m.f) > 4 * bend) {
            continue;
        }
        const auto depth = [&](long double u) { return (top ? -1 : 1) * rough_error(of, u); };
        const long double u = roots::place_of_minimum(depth, l.u, r.u, 50);
        extrema.push_back({u, rough_error(of, u)});
    }
    nodes.insert(nodes.end(), extrema.begin(), extrema.end());
    std::ranges::sort(nodes, {}, &Node::u);
    return nodes;
}

ContactsBySize::Fractions ContactsBySize::At::fractions(const ExtentOf& of, bool refined) {
    if (of.terms == 0 || of.terms > most_terms) {
        throw DomainError(
            "an extent is requested for no terms, or for more terms than are computed");
    }
    const std::vector<Node> nodes = errors(of);
    const auto tolerance = static_cast<long double>(of.tolerance);
    std::vector<Float128> crossings; // alternately outwards and inwards
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
        const int before = side_of(nodes[i].f, tolerance);
        const int after = side_of(nodes[i + 1].f, tolerance);
        if (before == after) {
            continue;
        }
        // A step from beyond one tolerance to beyond the other crosses both.
        for (const int which : {before, after}) {
            if (which != 0) {
                crossings.push_back(crossing(of, nodes[i], nodes[i + 1], which, refined));
            }
        }
    }
    const auto within = [&](const Float128& end) {
        Float128 sum(0);
        Float128 entered(0);
        std::size_t i = 0;
        for (; i < crossings.size() && crossings[i] < end; ++i) {
            if (i % 2 == 0) {
                sum += crossings[i] - entered;
            } else {
                entered = crossings[i];
            }
        }
        return i % 2 == 0 ? Float128(sum + end - entered) : sum;
    };
    const auto first = [&](const Float128& end) {
        return crossings.empty() ? end : std::min(end, crossings.front());
    };
    const Float128 b = refined ? fine_.extent().b : Float128(rough_.extent().b);
    const Float128 side = of.edge == contact::Edge::right ? fine_.right_edge() : b;
    const Float128 all = fine_.right_edge() + b;
    return {first(side) / side, within(side) / side, first(all) / all, within(all) / all};
}

} // namespace edgeproof::audit
