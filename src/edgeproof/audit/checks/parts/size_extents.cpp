// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/size_extents.hpp"

#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/contact/routes/pressure_routes.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/roots/bracketed_root.hpp"

#include <algorithm>
#include <cmath>

namespace edgeproof::audit {
namespace {

constexpr int points_per_decade = 10; // of the geometrically spaced points
constexpr int nearest_decades = 4;    // their least distance from a knot or the far edge
constexpr int uniform = 24;           // points between landmarks
const Float128 refined("1e-24");      // relative, for a crossing

template <class T> T approximation(const std::vector<T>& c, std::size_t n, const T& u) {
    using std::sqrt;
    T sum(0);
    for (std::size_t k = n; k-- > 0;) {
        sum = sum * u + c[k];
    }
    return sum * sqrt(u);
}

/// Returns 0 within the tolerance, +1 at or above it, -1 at or below its negative.
int side_of(long double f, long double tolerance) {
    return f >= tolerance ? 1 : f <= -tolerance ? -1 : 0;
}

} // namespace

std::string_view text_of(ExtentReading reading) {
    switch (reading) {
    case ExtentReading::first_exit_of_side:
        return "first exit, of the side from the edge to the origin";
    case ExtentReading::measure_of_side:
        return "all that is within, of the side from the edge to the origin";
    case ExtentReading::first_exit_of_all:
        return "first exit, of the whole contact";
    case ExtentReading::measure_of_all:
        break;
    }
    return "all that is within, of the whole contact";
}

ContactsBySize::ContactsBySize(const contact::Profile& profile)
    : law_(profile, Float128(1)), rough_(profile, 1.0L) {
    if (!profile.piecewise_linear()) {
        throw DomainError("contacts of all sizes are searched for piecewise linear profiles only");
    }
}

ContactsBySize::At::At(const ContactsBySize& contacts, const Float128& a)
    : contacts_(contacts), a_(a) {}

const contact::Extent<long double>& ContactsBySize::At::rough_extent() {
    if (!rough_.extent) {
        rough_.extent = contacts_.rough_.extent(static_cast<long double>(a_));
    }
    return *rough_.extent;
}
long double ContactsBySize::At::rough_pressure(contact::Edge edge, long double u) {
    const contact::Extent<long double>& e = rough_extent();
    if (!rough_.marks) {
        rough_.marks.emplace(e, contacts_.rough_.slope().knots());
    }
    return logarithmic_closed_form(contacts_.rough_, *rough_.marks, point_at(e, edge, u)).value;
}
const contact::Extent<Float128>& ContactsBySize::At::extent() {
    if (!fine_.extent) {
        fine_.extent = contacts_.law_.extent(a_);
    }
    return *fine_.extent;
}
const std::vector<long double>& ContactsBySize::At::rough_coefficients(contact::Edge edge) {
    auto& c = rough_.c.at(index_of(edge));
    if (c.empty()) {
        c = edge_expansion(contacts_.rough_, rough_extent(), edge, most_terms);
    }
    return c;
}
const std::vector<Float128>& ContactsBySize::At::coefficients(contact::Edge edge,
                                                              std::size_t count) {
    auto& c = fine_.c.at(index_of(edge));
    if (c.size() < count) {
        c = edge_expansion(contacts_.law_, extent(), edge, count);
    }
    return c;
}

std::vector<long double> ContactsBySize::At::places(contact::Edge edge) {
    const std::vector<long double>& c = rough_coefficients(edge);
    const contact::Extent<long double>& e = rough_extent();
    const long double length = e.length();
    std::vector<long double> marks{0, length};
    for (const long double knot : contacts_.rough_.slope().knots()) {
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
                nodes.push_back({u, rough_pressure(edge, u)});
            } catch (const DomainError&) {
                continue; // at a corner, where p is infinite
            }
        }
    }
    return nodes;
}

long double ContactsBySize::At::rough_error(const ExtentOf& of, long double u) {
    return approximation(rough_coefficients(of.edge), of.terms, u) / rough_pressure(of.edge, u) - 1;
}

Float128 ContactsBySize::At::error(const ExtentOf& of, const Float128& u) {
    const contact::Extent<Float128>& e = extent();
    if (!fine_.marks) {
        fine_.marks.emplace(e, contacts_.law_.slope().knots());
    }
    const auto p = logarithmic_closed_form(contacts_.law_, *fine_.marks, point_at(e, of.edge, u));
    return approximation(coefficients(of.edge, of.terms), of.terms, u) / p.value - 1;
}

Float128 ContactsBySize::At::crossing(const ExtentOf& of, const Node& l, const Node& r, int which,
                                      bool refine) {
    const Float128 level = which * of.tolerance;
    const auto rough_level = static_cast<long double>(level);
    const auto rough_f = [&](long double u) { return rough_error(of, u) - rough_level; };
    // A value equal to the level counts as a root.
    const long double u =
        roots::bracketed_root<long double>(rough_f, l.u, l.f - rough_level, r.u, r.f - rough_level,
                                           refine ? 1e-12L : 1e-15L)
            .x;
    if (!refine) {
        return u;
    }
    const auto f = [&](const Float128& x) { return Float128(error(of, x) - level); };
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
    return roots::bracketed_root<Float128>(f, lo, f_lo, hi, f_hi, refined).x;
}

/// p_local/p - 1 at the sampled places, and at extrema between them that may reach the tolerance.
std::vector<ContactsBySize::At::Node> ContactsBySize::At::errors(const ExtentOf& of) {
    const std::vector<long double>& c = rough_coefficients(of.edge);
    std::vector<Node> nodes;
    for (const Node& node : pressures(of.edge)) {
        nodes.push_back({node.u, approximation(c, of.terms, node.u) / node.f - 1});
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
        const long double golden = (std::sqrt(5.0L) - 1) / 2;
        long double lo = l.u;
        long double hi = r.u;
        for (int k = 0; k < 50; ++k) {
            const long double x = hi - golden * (hi - lo);
            const long double y = lo + golden * (hi - lo);
            if ((rough_error(of, x) > rough_error(of, y)) == top) {
                hi = y;
            } else {
                lo = x;
            }
        }
        extrema.push_back({(lo + hi) / 2, rough_error(of, (lo + hi) / 2)});
    }
    nodes.insert(nodes.end(), extrema.begin(), extrema.end());
    std::sort(nodes.begin(), nodes.end(), [](const Node& x, const Node& y) { return x.u < y.u; });
    return nodes;
}

ContactsBySize::Fractions ContactsBySize::At::found(const ExtentOf& of, bool refine) {
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
                crossings.push_back(crossing(of, nodes[i], nodes[i + 1], which, refine));
            }
        }
    }
    const auto within = [&](const Float128& end) {
        Float128 sum(0);
        Float128 entered(0);
        for (std::size_t i = 0; i < crossings.size() && crossings[i] < end; ++i) {
            if (i % 2 == 0) {
                sum += crossings[i] - entered;
            } else {
                entered = crossings[i];
            }
            if (i + 1 == crossings.size() || !(crossings[i + 1] < end)) {
                return i % 2 == 0 ? sum : Float128(sum + end - entered);
            }
        }
        return end;
    };
    const auto first = [&](const Float128& end) {
        return crossings.empty() ? end : std::min(end, crossings.front());
    };
    const auto& e = rough_extent();
    const Float128 b = refine ? extent().b : Float128(e.b);
    const Float128 side = of.edge == contact::Edge::right ? a_ : b;
    const Float128 all = a_ + b;
    return {first(side) / side, within(side) / side, first(all) / all, within(all) / all};
}

ContactsBySize::Fractions ContactsBySize::At::fractions(const ExtentOf& of) {
    return found(of, true);
}
ContactsBySize::Fractions ContactsBySize::At::rough_fractions(const ExtentOf& of) {
    return found(of, false);
}

} // namespace edgeproof::audit
