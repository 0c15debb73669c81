// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/sizes.hpp"
#include "edgeproof/contact/law/contact_law.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/roots/bracketed_root.hpp"

#include <algorithm>
#include <cmath>

namespace edgeproof::audit {

namespace {

/// The least relative distance from a size with an edge on a knot.
const Float128 nearness("1e-8");
/// The relative accuracy of the ends.
const Float128 isolation("1e-16");
/// An interval of at most this relative width is a jump that crosses both bounds.
const Float128 width_of_a_jump("1e-13");

struct Value {
    Float128 a;
    Float128 f;
};

/// Adds the extrema between sizes, indicated by three successive values, that may reach the level.
void add_extrema(const SizeScan::Function& f, const Float128& level, std::vector<Value>& values) {
    std::vector<Value> found;
    for (std::size_t i = 1; i + 1 < values.size(); ++i) {
        const Value& l = values[i - 1];
        const Value& m = values[i];
        const Value& r = values[i + 1];
        const bool above = m.f >= level;
        if ((l.f >= level) != above || (r.f >= level) != above) {
            continue;
        }
        const bool towards = above ? m.f <= l.f && m.f <= r.f && m.f < std::max(l.f, r.f)
                                   : m.f >= l.f && m.f >= r.f && m.f > std::min(l.f, r.f);
        const Float128 bend = std::max(abs(Float128(m.f - l.f)), abs(Float128(m.f - r.f)));
        if (towards && abs(Float128(level - m.f)) <= 4 * bend) {
            const auto depth = [&](const Float128& a) { return above ? f(a) : Float128(-f(a)); };
            const Float128 a = roots::place_of_minimum(depth, l.a, r.a, 30);
            found.push_back({a, f(a)});
        }
    }
    values.insert(values.end(), found.begin(), found.end());
    std::ranges::sort(values, {}, &Value::a);
}

} // namespace

SceneSpec with_size(SceneSpec scene, const Float128& a) {
    scene.parameters.insert_or_assign("a", Exact::of(Rational(a)));
    return scene;
}

SizeSet intersection(const SizeSet& x, const SizeSet& y) {
    SizeSet both;
    for (const SizeInterval& i : x) {
        for (const SizeInterval& j : y) {
            const SizeInterval k{std::max(i.from, j.from), std::min(i.to, j.to),
                                 i.open_below && j.open_below, i.open_above && j.open_above};
            if (k.from < k.to) {
                both.push_back(k);
            }
        }
    }
    return both;
}

std::string to_text(const Float128& a, unsigned digits) {
    const PrecisionScope scope(40);
    return to_decimal(Real(a), digits);
}

std::string to_text(const SizeSet& set, unsigned digits) {
    std::string text;
    for (const SizeInterval& i : set) {
        text += text.empty() ? "" : "; ";
        text += to_text(i.from, digits) + (i.open_below ? " (start of the search)" : "") + " ... " +
                to_text(i.to, digits) + (i.open_above ? " (end of the search)" : "");
    }
    return text.empty() ? "none" : text;
}

bool is_everything(const SizeSet& set) {
    return set.size() == 1 && set.front().open_below && set.front().open_above;
}

SizeScan::SizeScan(const contact::Profile& profile, const Exact& from, const Exact& to,
                   int per_decade) {
    const Float128 first = from.to<Float128>();
    const Float128 last = to.to<Float128>();
    if (!(first > 0) || !(first < last)) {
        throw InputError("the sizes " + from.text() + " ... " + to.text() + " do not ascend from 0",
                         "give 0 < from < to");
    }
    const contact::ContactLaw<Float128> law(profile, Float128(1));
    for (const Float128& knot : law.slope().knots()) {
        const Float128 a = knot > 0                       ? knot
                           : knot < 0 && !law.symmetric() ? law.right_edge(Float128(-knot))
                                                          : Float128(0);
        if (a > first && a < last) {
            breaks_.push_back(a);
        }
    }
    std::ranges::sort(breaks_);
    std::vector<Float128> ends{first};
    ends.insert(ends.end(), breaks_.begin(), breaks_.end());
    ends.push_back(last);
    sizes_ = {first, last};
    const Float128 step = pow(Float128(10), Float128(-1) / per_decade);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const Float128 width = ends[i + 1] - ends[i];
        for (Float128 d = width / 2; d > nearness * ends[i]; d *= step) {
            sizes_.push_back(ends[i] + d);
        }
        for (Float128 d = width / 2; d > nearness * ends[i + 1]; d *= step) {
            sizes_.push_back(ends[i + 1] - d);
        }
    }
    std::ranges::sort(sizes_);
    sizes_.erase(std::unique(sizes_.begin(), sizes_.end()), sizes_.end());
}

void SizeScan::describe(const std::vector<std::string>& range, Evidence& evidence) const {
    std::vector<std::string> breaks;
    for (const Float128& a : breaks_) {
        breaks.push_back(to_text(a));
    }
    evidence.add("size", "the right edge a; all else is given")
        .add("searched", range[0] + " ... " + range[1])
        .add("sizes_looked_at", sizes_.size())
        .add("edge_on_a_knot_at", breaks);
}

SizeSet SizeScan::joined(bool inside, std::vector<Float128> ends) const {
    std::ranges::sort(ends);
    SizeSet set;
    SizeInterval now{sizes_.front(), sizes_.back(), true, false};
    for (const Float128& end : ends) {
        if (inside) {
            now.to = end;
            // A jump through the interval is not a set of sizes.
            if (now.to - now.from > width_of_a_jump * now.to) {
                set.push_back(now);
            }
        }
        inside = !inside;
        now = {end, sizes_.back(), false, false};
    }
    if (inside) {
        now.open_above = true;
        set.push_back(now);
    }
    return set;
}

SizeSet SizeScan::between(const Function& f, const std::vector<Float128>& at_sizes,
                          const Float128& lower, const Float128& upper) const {
    std::vector<Value> values;
    for (std::size_t i = 0; i < sizes_.size(); ++i) {
        values.push_back({sizes_[i], at_sizes.at(i)});
    }
    add_extrema(f, lower, values);
    add_extrema(f, upper, values);
    std::vector<Float128> ends;
    for (std::size_t i = 0; i + 1 < values.size(); ++i) {
        const Value& l = values[i];
        const Value& r = values[i + 1];
        for (const Float128& level : {lower, upper}) {
            if ((l.f >= level) == (r.f >= level)) {
                continue;
            }
            // A value equal to the level counts as above it.
            const auto over = [&](const Float128& value) {
                return value == level ? isolation : Float128(value - level);
            };
            ends.push_back(
                roots::bracketed_root<Float128>([&](const Float128& a) { return over(f(a)); }, l.a,
                                                over(l.f), r.a, over(r.f), isolation)
                    .x);
        }
    }
    const Float128& start = at_sizes.front();
    return joined(start >= lower && start < upper, std::move(ends));
}

SizeSet SizeScan::where(const Test& test) const {
    std::vector<Float128> ends;
    bool before = test(sizes_.front());
    const bool start = before;
    for (std::size_t i = 1; i < sizes_.size(); ++i) {
        const bool now = test(sizes_[i]);
        if (now != before) {
            Float128 lo = sizes_[i - 1];
            Float128 hi = sizes_[i];
            while (hi - lo > isolation * hi) {
                const Float128 middle = (lo + hi) / 2;
                (test(middle) == before ? lo : hi) = middle;
            }
            ends.push_back((lo + hi) / 2);
        }
        before = now;
    }
    return joined(start, std::move(ends));
}

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

std::vector<long double> ContactsBySize::At::places(Edge edge) {
    const std::vector<long double>& c = rough_.coefficients(edge, most_terms);
    const contact::Extent<long double>& e = rough_.extent();
    const long double length = e.length();
    std::vector<long double> marks{0, length};
    for (const long double knot : rough_.knots()) {
        const long double u = edge == Edge::right ? e.a - knot : e.b + knot;
        if (u > 0 && u < length) {
            marks.push_back(u);
        }
    }
    std::ranges::sort(marks);
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
    u.push_back(edge == Edge::right ? e.a : e.b);
    std::ranges::sort(u);
    u.erase(std::unique(u.begin(), u.end()), u.end());
    std::erase_if(u, [&](long double x) { return !(x > 0 && x < length); });
    return u;
}

const std::vector<ContactsBySize::At::Node>& ContactsBySize::At::pressures(Edge edge) {
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
    const Float128 side = of.edge == Edge::right ? fine_.right_edge() : b;
    const Float128 all = fine_.right_edge() + b;
    return {first(side) / side, within(side) / side, first(all) / all, within(all) / all};
}

} // namespace edgeproof::audit
