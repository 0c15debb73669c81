// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/size_scan.hpp"

#include "edgeproof/contact/law/contact_law.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/roots/bracketed_root.hpp"

#include <algorithm>

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
    scene.parameters.insert_or_assign("a", formula::Exact::of(Rational(a)));
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

SizeScan::SizeScan(const contact::Profile& profile, const formula::Exact& from,
                   const formula::Exact& to, int per_decade) {
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
    std::sort(breaks_.begin(), breaks_.end());
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
    std::sort(sizes_.begin(), sizes_.end());
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
    std::sort(ends.begin(), ends.end());
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

} // namespace edgeproof::audit
