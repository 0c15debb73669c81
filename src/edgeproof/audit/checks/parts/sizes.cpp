// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/sizes.hpp"
#include "edgeproof/contact/curved/proved_slip.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>

namespace edgeproof::audit {

namespace {

constexpr int sizes_per_decade = 12;
constexpr int sizes_per_decade_at_a_break = 2;
constexpr int decades_at_a_break = 4; ///< of the relative distance from a break
constexpr unsigned size_places = 6;   ///< the significant digits of a listed size
constexpr long break_bits = 128;
const Rational isolation(1, 2'000); // NOLINT: a constant of a type without a literal

/// Returns a size as an exact number with few digits.
Rational short_size(const Real& a) { return parse_decimal(to_decimal(a, size_places)); }

std::string size_text(const Rational& a) { return to_decimal(from_rational<Real>(a), size_digits); }

/// The right edges of the contacts of a scene with an edge on a knot.
std::vector<Real> breaks_of(const SceneSpec& scene) {
    const contact::Profile profile = scene.make_profile();
    std::vector<Real> breaks;
    for (const Exact& knot : profile.knots()) {
        const Ball at = ball_of(knot, break_bits);
        if (certainly_positive(at)) {
            breaks.push_back(at.midpoint());
        } else if (certainly_negative(at) && !profile.symmetric()) {
            const auto contact = contact::proved_contact(
                profile, scene.parameter("Es"), contact::Load::right_edge(scene.parameter("a")),
                break_bits);
            if (contact->closed_form() == nullptr) {
                throw Error("sizes of contacts are searched for closed forms only");
            }
            breaks.push_back(
                contact->closed_form()->mirrored().with_right_edge(-at).b().midpoint());
        }
    }
    return breaks;
}

} // namespace

SceneSpec with_size(SceneSpec scene, const Rational& a) {
    scene.parameters.insert_or_assign("a", Exact::of(a));
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

std::string to_text(const SizeSet& set) {
    std::string text;
    for (const SizeInterval& i : set) {
        text += text.empty() ? "" : "; ";
        text += size_text(i.from) + (i.open_below ? " (start of the search)" : "") + " ... " +
                size_text(i.to) + (i.open_above ? " (end of the search)" : "");
    }
    return text.empty() ? "none" : text;
}

SizeScan::SizeScan(const SceneSpec& scene, const Exact& from, const Exact& to) {
    if (!from.is_rational() || !to.is_rational() || !(from.rational() > 0) ||
        !(from.rational() < to.rational())) {
        throw InputError("the sizes " + from.text() + " ... " + to.text() +
                             " are not rational numbers that ascend from 0",
                         "give 0 < from < to");
    }
    const PrecisionScope scope(30);
    const auto first = from.to<Real>();
    const auto last = to.to<Real>();
    const auto add = [&](const Real& a) {
        if (a > first && a < last) {
            sizes_.push_back(short_size(a));
        }
    };
    const Real step = pow(Real(10), Real(1) / sizes_per_decade);
    for (Real a = first * step; a < last; a *= step) {
        add(a);
    }
    for (const Real& at : breaks_of(scene)) {
        if (!(at > first && at < last)) {
            continue;
        }
        breaks_.push_back(at);
        for (int k = 1; k <= decades_at_a_break * sizes_per_decade_at_a_break; ++k) {
            const Real off = pow(Real(10), Real(-k) / sizes_per_decade_at_a_break);
            add(at * (1 - off));
            add(at * (1 + off));
        }
    }
    std::ranges::sort(breaks_);
    sizes_.push_back(from.rational());
    sizes_.push_back(to.rational());
    std::ranges::sort(sizes_);
    sizes_.erase(std::unique(sizes_.begin(), sizes_.end()), sizes_.end());
}

void SizeScan::describe(const std::vector<std::string>& range, Evidence& evidence) const {
    std::vector<std::string> breaks;
    for (const Real& a : breaks_) {
        breaks.push_back(to_decimal(a, 12));
    }
    evidence.add("size", "the right edge a; all else is given")
        .add("searched", range[0] + " ... " + range[1])
        .add("sizes_looked_at", sizes_.size())
        .add("edge_on_a_knot_at", breaks);
}

SizeSet SizeScan::where(const std::vector<Side>& at_sizes,
                        const std::function<Side(const Rational& a)>& side) const {
    /// The size between two where a change of the side from `before` is isolated.
    const auto change = [&](Rational lo, Rational hi, Side before, bool& held) {
        while (hi - lo > isolation * hi) {
            const Rational middle = (lo + hi) / 2;
            const Side there = side(middle);
            held = held || there == Side::within;
            (there == before ? lo : hi) = middle;
        }
        return hi;
    };
    SizeSet set;
    std::optional<SizeInterval> now;
    const auto end = [&](const Rational& to, bool open_above) {
        now->to = to;
        now->open_above = open_above;
        set.push_back(*now);
        now.reset();
    };
    for (std::size_t i = 0; i < sizes_.size(); ++i) {
        const bool holds = at_sizes[i] == Side::within;
        if (i == 0) {
            if (holds) {
                now = SizeInterval{sizes_[0], sizes_[0], true, false};
            }
            continue;
        }
        const Side before = at_sizes[i - 1];
        if (before == at_sizes[i] || before == Side::unknown || at_sizes[i] == Side::unknown) {
            if (before != at_sizes[i] && now) {
                end(sizes_[i - 1], false);
            } else if (before != at_sizes[i] && holds) {
                now = SizeInterval{sizes_[i], sizes_[i], false, false};
            }
            continue;
        }
        bool held = holds || before == Side::within;
        const Rational first = change(sizes_[i - 1], sizes_[i], before, held);
        if (now) {
            end(first, false);
        } else if (held) {
            now = SizeInterval{first, first, false, false};
            if (!holds) { // from below to above: the other end is behind the first
                bool ignored = false;
                end(change(first, sizes_[i], Side::within, ignored), false);
            }
        }
    }
    if (now) {
        end(sizes_.back(), true);
    }
    return set;
}

SizedScene sized_scene(const Claim& claim, const AuditContext& context) {
    const std::vector<SceneSpec> scenes = context.scenes(claim);
    const auto& range = claim.list("sizes");
    if (scenes.size() != 1 || range.size() != 2) {
        claim.reject(scenes.size() != 1 ? "over" : "sizes",
                     "a size is sought for one scene and between two sizes",
                     "name a family with count = 1 and write sizes = [\"FROM\", \"TO\"]");
    }
    try {
        return {scenes.front(),
                SizeScan(scenes.front(), Exact::parse(range[0]), Exact::parse(range[1]))};
    } catch (const InputError& error) {
        claim.reject("sizes", error.problem(), error.instead());
    }
}

std::optional<Ball> fraction_within(const contact::EnclosedExtents& extents, const Ball& side,
                                    const ExtentReading& reading) {
    const Ball& end = reading.of_side ? side : extents.length;
    Ball sum(0, end.bits());
    Ball entered(0, end.bits());
    bool within = extents.starts_within;
    std::optional<Ball> first_exit;
    for (const Ball& crossing : extents.crossings) {
        if (!certainly_less(crossing, end)) {
            if (!certainly_less(end, crossing)) {
                return std::nullopt;
            }
            break;
        }
        if (within) {
            sum += crossing - entered;
            first_exit = first_exit ? first_exit : std::optional(crossing);
        }
        entered = crossing;
        within = !within;
    }
    sum += within ? end - entered : Ball(0, end.bits());
    return (reading.first_exit ? first_exit.value_or(end) : sum) / end;
}

} // namespace edgeproof::audit
