// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/enclosed_reach.hpp"
#include "edgeproof/audit/checks/parts/quoted_extent.hpp"
#include "edgeproof/audit/checks/parts/size_scan.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <map>

namespace edgeproof::audit {
namespace {

constexpr std::size_t reading_count = extent_readings.size();

/// The values of a figure at all sizes, and the sizes for which it holds, under each reading.
struct Found {
    std::array<SizeSet, reading_count> holds;
    std::array<Float128, reading_count> least;
    std::array<Float128, reading_count> most;
    std::vector<Float128> breaks;
    std::vector<Float128> sizes;              ///< the sizes tried
    std::array<bool, reading_count> steady{}; ///< see at_all_sizes
};

/// True if between neighbours the figure varies by less than its distance from the interval of
/// numbers that round to the quoted one.
bool is_steady(const std::vector<Float128>& values, const QuotedExtent& q) {
    for (std::size_t i = 0; i + 1 < values.size(); ++i) {
        const Float128 away = std::min(
            std::max(Float128(q.lower - values[i]), Float128(values[i] - q.upper)),
            std::max(Float128(q.lower - values[i + 1]), Float128(values[i + 1] - q.upper)));
        if (!(abs(Float128(values[i + 1] - values[i])) < away)) {
            return false;
        }
    }
    return true;
}

Found find_sizes(const QuotedExtent& q, const contact::Profile& profile, const formula::Exact& from,
                 const formula::Exact& to) {
    const SizeScan scan(profile, from, to);
    const ContactsBySize contacts(profile);
    std::array<std::vector<Float128>, reading_count> table;
    for (const Float128& a : scan.sizes()) {
        ContactsBySize::At contact = contacts.at(a);
        const ContactsBySize::Fractions values = rough_extents_of(q, contact);
        for (std::size_t r = 0; r < reading_count; ++r) {
            table[r].push_back(values[r]);
        }
    }
    Found found;
    for (std::size_t r = 0; r < reading_count; ++r) {
        const auto f = [&](const Float128& a) {
            ContactsBySize::At contact = contacts.at(a);
            return extents_of(q, contact)[r];
        };
        found.holds[r] = scan.between(f, table[r], q.lower, q.upper);
        found.least[r] = *std::min_element(table[r].begin(), table[r].end());
        found.most[r] = *std::max_element(table[r].begin(), table[r].end());
        found.steady[r] = is_steady(table[r], q);
    }
    found.breaks = scan.breaks();
    found.sizes = scan.sizes();
    return found;
}

constexpr unsigned enclosed_digits = 15;

/// Computes the proved extents of an approximation at each size, once in a run.
std::shared_ptr<const std::vector<EnclosedReach>>
reaches(const ExtentOf& of, const formula::Exact& tolerance, const SceneSpec& scene,
        const std::vector<Float128>& sizes, const AuditContext& context) {
    const std::string key = "size-extent/enclosed/" + scene.family + "/" +
                            (of.edge == contact::Edge::right ? "right/" : "left/") +
                            std::to_string(of.terms) + "/" + tolerance.text() + "/" +
                            to_text(sizes.front()) + "/" + to_text(sizes.back());
    return context.once<std::vector<EnclosedReach>>(key, [&] {
        std::vector<EnclosedReach> found;
        for (const Float128& a : sizes) {
            check_interruption();
            found.push_back(enclosed_reach(with_size(scene, a), {of.edge, of.terms, tolerance, {}},
                                           enclosed_digits));
        }
        return found;
    });
}

/// The proved extents at every size tried.
struct QuotedReaches {
    std::shared_ptr<const std::vector<EnclosedReach>> of;
    std::shared_ptr<const std::vector<EnclosedReach>> over; ///< null if there is no divisor
};

/// Decides by enclosures if the figure holds at one size under a reading.
Decision holds_at(const QuotedExtent& q, const QuotedReaches& reached, std::size_t i,
                  const SceneSpec& scene, ExtentReading reading) {
    const auto fraction = [&](const ExtentOf& of, const EnclosedReach& found) {
        if (!found.extents) {
            return std::optional<Ball>();
        }
        const bool exit = reading == ExtentReading::first_exit_of_side ||
                          reading == ExtentReading::first_exit_of_all;
        const EnclosedSample sample({scene, std::nullopt, of.edge, {}}, found.bits);
        const char* side = of.edge == contact::Edge::right ? "a" : "b";
        return std::optional(
            (exit ? found.extents->first_exit : found.extents->measure) /
            sample.evaluate(formula::Expr::symbol(is_of_side(reading) ? side : "L")));
    };
    auto value = fraction(q.of, reached.of->at(i));
    if (value && q.over) {
        const auto divisor = fraction(*q.over, reached.over->at(i));
        value = divisor ? std::optional(*value / *divisor) : std::nullopt;
    }
    if (!value) {
        return {};
    }
    const Rational lower = q.figure - q.unit / 2;
    const Rational upper = q.figure + q.unit / 2;
    const auto below = Refutation::less(*value, Ball(lower, value->bits()));
    return decision(below ? below : Refutation::less(Ball(upper, value->bits()), *value),
                    Confirmation::within(*value, lower, upper));
}

/// Decides if a figure holds at every size tried, or fails at every one. A finite list of sizes
/// does not prove more, as the note states. `steady`: see is_steady.
Judgement at_all_sizes(const QuotedExtent& q, const SceneSpec& scene,
                       const std::vector<Float128>& sizes, ExtentReading reading, bool steady,
                       const AuditContext& context) {
    const QuotedReaches reached{reaches(q.of, q.tolerance, scene, sizes, context),
                                q.over ? reaches(*q.over, q.tolerance, scene, sizes, context)
                                       : nullptr};
    std::vector<Decision> decisions;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        decisions.push_back(holds_at(q, reached, i, with_size(scene, sizes[i]), reading));
        if (decisions.back().index() == 0 || decisions.back().index() != decisions[0].index() ||
            (refutes(decisions.back()) && !steady)) {
            return {};
        }
    }
    return Judgement::of_all(decisions);
}

/// Sizes for which a group of figures holds and no larger group does: "a = 1 ... 2: S39, S40".
struct Group {
    std::vector<std::string> ids;
    SizeSet sizes;
};

std::vector<Group> largest_groups(const std::vector<QuotedExtent>& figures,
                                  const std::vector<SizeSet>& holds) {
    std::vector<Float128> ends;
    for (const SizeSet& set : holds) {
        for (const SizeInterval& i : set) {
            ends.push_back(i.from);
            ends.push_back(i.to);
        }
    }
    std::sort(ends.begin(), ends.end());
    std::map<std::vector<std::size_t>, SizeSet> at;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        const SizeSet cell{{ends[k], ends[k + 1], false, false}};
        std::vector<std::size_t> group;
        for (std::size_t i = 0; i < holds.size(); ++i) {
            if (!intersection(cell, holds[i]).empty()) {
                group.push_back(i);
            }
        }
        if (group.size() > 1) {
            SizeSet& sizes = at[group];
            sizes.push_back(cell.front());
        }
    }
    std::vector<Group> largest;
    for (const auto& found : at) {
        const std::vector<std::size_t>& group = found.first; // a lambda cannot capture a binding
        const bool within_another = std::any_of(at.begin(), at.end(), [&](const auto& other) {
            return other.first.size() > group.size() &&
                   std::includes(other.first.begin(), other.first.end(), group.begin(),
                                 group.end());
        });
        if (!within_another) {
            Group g{{}, found.second};
            for (const std::size_t i : group) {
                g.ids.push_back(figures[i].id);
            }
            largest.push_back(std::move(g));
        }
    }
    return largest;
}

std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) {
        text += (text.empty() ? "" : ", ") + part;
    }
    return text;
}

Outcome check_size_extent(const Claim& claim, const AuditContext& context) {
    const std::vector<SceneSpec> scenes = context.scenes(claim);
    if (scenes.size() != 1) {
        claim.reject("over",
                     "a size is sought for one scene, not for " + std::to_string(scenes.size()),
                     "name a family with count = 1");
    }
    const auto range = claim.list("sizes");
    if (range.size() != 2) {
        claim.reject("sizes", "sizes are not two numbers", "write sizes = [\"FROM\", \"TO\"]");
    }
    const auto size = [&](const std::string& text) {
        try {
            return formula::Exact::parse(text);
        } catch (const InputError& error) {
            claim.reject("sizes", error.problem(), error.instead());
        }
    };
    const contact::Profile profile = scenes.front().make_profile();
    const formula::Exact from = size(range[0]);
    const formula::Exact to = size(range[1]);
    const auto sizes_of = [&](const QuotedExtent& q) {
        return context.once<Found>("size-extent/" + scenes.front().family + "/" + range[0] + "/" +
                                       range[1] + q.key,
                                   [&] { return find_sizes(q, profile, from, to); });
    };
    const QuotedExtent quoted = read_quoted_extent(claim);
    const auto found = sizes_of(quoted);
    const std::vector<QuotedExtent> figures = companion_extents(claim, context);
    std::vector<std::shared_ptr<const Found>> of_figures;
    of_figures.reserve(figures.size());
    for (const QuotedExtent& q : figures) {
        of_figures.push_back(sizes_of(q));
    }

    Outcome outcome;
    outcome.evidence.add("size", "the right edge a; all else is given")
        .add("searched", range[0] + " ... " + range[1])
        .add("sizes_looked_at", found->sizes.size());
    std::vector<std::string> breaks;
    for (const Float128& a : found->breaks) {
        breaks.push_back(to_text(a, 12));
    }
    outcome.evidence.add("edge_on_a_knot_at", breaks);
    const bool of_side = claim.text("base") == "side";
    std::size_t looked = 0;
    std::size_t some = 0;
    std::vector<Judgement> everywhere; // for the readings under which it holds at all sizes
    std::vector<Judgement> nowhere;    // for the readings under which it holds at no size
    bool jointly = false;
    std::string fitting;
    for (std::size_t r = 0; r < reading_count; ++r) {
        const SizeSet& holds = found->holds[r];
        Evidence one;
        one.add("least", to_text(found->least[r], 6)).add("most", to_text(found->most[r], 6));
        one.add("holds_for_a", to_text(holds));
        SizeSet all;
        std::vector<SizeSet> sets;
        for (std::size_t i = 0; i < figures.size(); ++i) {
            sets.push_back(of_figures[i]->holds[r]);
            all = i == 0 ? sets.back() : intersection(all, sets.back());
        }
        if (!figures.empty()) {
            one.add("all_hold_for_a", to_text(all));
            std::vector<std::string> groups;
            for (const Group& group : largest_groups(figures, sets)) {
                groups.push_back("a = " + to_text(group.sizes, 8) + ": " + joined(group.ids));
            }
            one.add("together", groups);
        }
        outcome.evidence.add(text_of(extent_readings[r]), one);
        if (is_of_side(extent_readings[r]) != of_side) {
            continue;
        }
        ++looked;
        some += holds.empty() ? 0 : 1;
        if (is_everything(holds) || holds.empty()) {
            (holds.empty() ? nowhere : everywhere)
                .push_back(at_all_sizes(quoted, scenes.front(), found->sizes, extent_readings[r],
                                        found->steady[r], context));
        }
        jointly = jointly || !all.empty();
        if (fitting.empty() && !holds.empty()) {
            fitting = "a = " + to_text(holds, 4);
        }
    }
    if (some == 0) {
        outcome.verdict = Judgement::of_readings(nowhere);
        outcome.note = "it rounds to this at no size of the contact (at " +
                       std::to_string(found->sizes.size()) + " sizes)";
    } else if (everywhere.size() == looked) {
        outcome.verdict = Judgement::of_readings(everywhere);
        outcome.note = "the size is not given, and it rounds to this at every size (at " +
                       std::to_string(found->sizes.size()) + " sizes)";
    } else if (!everywhere.empty()) {
        // It holds under some readings; under the others it holds for some sizes only.
        everywhere.emplace_back(Undecided::underspecified);
        outcome.verdict = Judgement::of_readings(everywhere);
        outcome.note = "the size is not given; it would hold for " + fitting;
    } else {
        outcome.verdict = Undecided::underspecified;
        outcome.note = "the size is not given; it would hold for " + fitting;
    }
    if (!figures.empty()) {
        outcome.note += jointly ? "; there are sizes at which all figures hold together"
                                : "; there is no size at which all figures hold together";
    }
    return outcome;
}

} // namespace

CheckKind size_extent_kind() {
    using Type = KeySpec::Type;
    return {std::string_view(size_extent_kind_name),
            {{.name = "figure", .type = Type::number, .required = true},
             {.name = "unit", .type = Type::number, .required = true},
             {.name = "tolerance", .type = Type::number, .required = true},
             {.name = "terms", .type = Type::integer, .required = true},
             {.name = "over_terms", .type = Type::integer},
             {.name = "base", .type = Type::choice, .required = true, .choices = {"side", "whole"}},
             {.name = "sizes", .type = Type::list, .required = true},
             {.name = "together", .type = Type::list}},
            check_size_extent};
}

} // namespace edgeproof::audit
