// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/enclosed_reach.hpp"
#include "edgeproof/audit/checks/parts/quoted_figure.hpp"
#include "edgeproof/audit/checks/parts/sizes.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>

namespace edgeproof::audit {
namespace {

/// Evaluates a, b, L and the coefficients at both edges in binary128.
class SizeEnvironment {
public:
    explicit SizeEnvironment(ContactsBySize::At& contact) : contact_(contact) {}
    [[nodiscard]] Float128 number(const Rational& q) const { return from_rational<Float128>(q); }
    [[nodiscard]] Float128 pi() const { return edgeproof::pi<Float128>(); }
    [[nodiscard]] Float128 symbol(std::string_view name) const {
        const auto& e = contact_.extent();
        if (name == "a" || name == "b" || name == "L") {
            return name == "a" ? e.a : name == "b" ? e.b : e.length();
        }
        for (const Edge edge : {Edge::right, Edge::left}) {
            const std::string_view prefix = edge == Edge::right ? "right_c" : "left_c";
            if (name.starts_with(prefix) && name.size() == prefix.size() + 1) {
                const auto k = static_cast<std::size_t>(name.back() - '0');
                if (k < ContactsBySize::most_terms) {
                    return contact_.coefficients(edge, k + 1)[k];
                }
            }
        }
        throw Error("'" + std::string(name) + "' is not known where the size varies");
    }

private:
    ContactsBySize::At& contact_;
};

/// Throws BudgetError if a side is not finite.
bool holds(const Relation& r, const SizeEnvironment& at) {
    const auto lhs = evaluate<Float128>(r.lhs, at);
    const auto rhs = evaluate<Float128>(r.rhs, at);
    if (lhs - lhs != 0 || rhs - rhs != 0) {
        throw BudgetError("a number beyond the range of the arithmetic");
    }
    return compare(r.op, lhs, rhs);
}

std::string relation_text(const Relation& r) {
    static constexpr std::array signs{" < ", " <= ", " > ", " >= ", " = "};
    return to_text(r.lhs) + signs.at(static_cast<std::size_t>(r.op)) + to_text(r.rhs);
}

/// Judges a condition at the tried sizes, by enclosures. A finite list of sizes confirms it only at
/// these sizes, as the note states; if it fails at all of them, it may still hold between them.
Judgement at_sizes(const SceneSpec& scene, const Condition& condition,
                   const std::vector<Float128>& sizes, const Claim& claim,
                   const AuditContext& context) {
    std::size_t holding = 0;
    std::size_t failing = 0;
    Judgement last;
    for (const Float128& a : sizes) {
        SampleInBalls sample({with_size(scene, a), std::nullopt, claim.edge(), {}},
                             context.digits());
        const Decision found = decide(condition, sample, context.digits_needed());
        holding += confirms(found) ? 1 : 0;
        failing += refutes(found) ? 1 : 0;
        last = Judgement(found);
    }
    if (holding == sizes.size()) {
        return last;
    }
    return holding > 0 && failing > 0 ? Judgement(Undecided::underspecified) : Judgement();
}

} // namespace

Outcome check_size_condition(const Claim& claim, const AuditContext& context) {
    const std::vector<SceneSpec> scenes = context.scenes(claim);
    const auto& range = claim.list("sizes");
    if (scenes.size() != 1 || range.size() != 2) {
        claim.reject(scenes.size() != 1 ? "over" : "sizes",
                     "a size is sought for one scene and between two sizes",
                     "name a family with count = 1 and write sizes = [\"FROM\", \"TO\"]");
    }
    const Condition condition = claim.condition("says");
    const contact::Profile profile = scenes.front().make_profile();
    const ContactsBySize contacts(profile);
    const SizeScan scan(profile, Exact::parse(range[0]), Exact::parse(range[1]), 4);
    const auto where = [&](const Condition& all) {
        return scan.where([&](const Float128& a) {
            ContactsBySize::At contact = contacts.at(a);
            const SizeEnvironment at(contact);
            return std::ranges::all_of(all, [&](const Relation& r) { return holds(r, at); });
        });
    };
    const SizeSet set = where(condition);
    Outcome outcome;
    scan.describe(range, outcome.evidence);
    outcome.evidence.add("holds_for_a", to_text(set));
    outcome.verdict = at_sizes(scenes.front(), condition, scan.sizes(), claim, context);
    const std::string looked_at = " (at " + std::to_string(scan.sizes().size()) + " sizes)";
    if (outcome.verdict == Verdict::confirmed) {
        outcome.note = "the size is not given, and it holds at every size" + looked_at;
    } else if (outcome.verdict == Verdict::undecided) {
        outcome.note = set.empty() ? "it holds at no size that was examined" + looked_at
                                   : "the enclosures do not decide at some sizes";
    } else {
        outcome.note = "the size is not given; it would hold for a = " + to_text(set, 4);
        Evidence each;
        for (const Relation& r : condition) {
            each.add(relation_text(r), to_text(where({r})));
        }
        outcome.evidence.add("each_holds_for_a", each);
    }
    return outcome;
}

namespace {

constexpr std::size_t reading_count = extent_readings.size();
constexpr unsigned enclosed_digits = 15;

/// A quoted extent: the figure, and the quantity that it gives.
struct QuotedExtent {
    std::string id;
    std::string key; ///< everything except the scene on which the figure and its meaning depend
    ExtentOf of;
    std::optional<ExtentOf> over; ///< the divisor, if any
    Rational lower;               ///< the numbers that round to the figure: lower end ...
    Rational upper;               ///< ... and upper end (excluded)
    Exact tolerance;

    /// Returns the extent, or the quotient of two extents, of a contact under each reading.
    [[nodiscard]] ContactsBySize::Fractions in(ContactsBySize::At contact, bool refined) const {
        ContactsBySize::Fractions x = contact.fractions(of, refined);
        if (over) {
            const ContactsBySize::Fractions y = contact.fractions(*over, refined);
            std::ranges::transform(x, y, x.begin(), std::divides<>());
        }
        return x;
    }
};

/// Reads the keys of a claim. Throws InputError for values that are not possible.
QuotedExtent read_quoted_extent(const Claim& claim) {
    const auto terms = [&](std::string_view key) {
        const long n = claim.integer(key);
        if (n < 1 || n > static_cast<long>(ContactsBySize::most_terms)) {
            claim.reject(key, "an approximation of " + std::to_string(n) + " terms",
                         "write 1 to 4");
        }
        return static_cast<std::size_t>(n);
    };
    QuotedExtent q;
    q.id = claim.id;
    for (const char* name : {"edge", "terms", "over_terms", "tolerance", "figure", "unit"}) {
        q.key += "/" + claim.text_or(name, "");
    }
    q.tolerance = Exact::parse(claim.text("tolerance"));
    q.of = {claim.edge(), terms("terms"), q.tolerance.to<Float128>()};
    if (claim.has("over_terms")) {
        q.over = ExtentOf{q.of.edge, terms("over_terms"), q.of.tolerance};
    }
    const Rational figure = Exact::parse(claim.text("figure")).rational();
    const Rational half = Exact::parse(claim.text("unit")).rational() / 2;
    q.lower = figure - half;
    q.upper = figure + half;
    if (!(half > 0) || !(q.of.tolerance > 0)) {
        claim.reject("unit", "a unit or a tolerance that is not positive",
                     "give both as positive numbers, such as 1/100");
    }
    return q;
}

/// Reads the other claims of this kind that the key `together` names.
std::vector<QuotedExtent> companion_extents(const Claim& claim, const AuditContext& context) {
    std::vector<QuotedExtent> all;
    const auto& claims = context.ledger().claims;
    for (const std::string& id : claim.has("together") ? claim.list("together") : Field::List()) {
        const auto it = std::ranges::find_if(claims, [&](const Claim& c) {
            return c.id == id && c.kind == claim.kind && c.text("over") == claim.text("over");
        });
        if (it == claims.end()) {
            claim.reject("together",
                         "there is no claim " + id + " of this kind over the same scene",
                         "name claims of kind size-extent over " + claim.text("over"));
        }
        all.push_back(read_quoted_extent(*it));
    }
    return all;
}

/// The values of a figure at all sizes, and the sizes for which it holds, under one reading.
struct InReading {
    SizeSet holds;
    Float128 least;
    Float128 most;
    bool steady = false; ///< see is_steady
};
using Found = std::array<InReading, reading_count>;

/// True if between neighbours the figure varies by less than its distance from the interval of
/// numbers that round to the quoted one.
bool is_steady(const std::vector<Float128>& values, const Float128& lower, const Float128& upper) {
    const auto away = [&](const Float128& x) {
        return std::max(Float128(lower - x), Float128(x - upper));
    };
    return std::ranges::adjacent_find(values, [&](const Float128& x, const Float128& y) {
               return !(abs(Float128(y - x)) < std::min(away(x), away(y)));
           }) == values.end();
}

Found find_sizes(const QuotedExtent& q, const SizeScan& scan, const ContactsBySize& contacts) {
    const auto lower = from_rational<Float128>(q.lower);
    const auto upper = from_rational<Float128>(q.upper);
    std::array<std::vector<Float128>, reading_count> table;
    for (const Float128& a : scan.sizes()) {
        const ContactsBySize::Fractions values = q.in({contacts, a}, false);
        for (std::size_t r = 0; r < reading_count; ++r) {
            table[r].push_back(values[r]);
        }
    }
    Found found;
    for (std::size_t r = 0; r < reading_count; ++r) {
        const auto f = [&](const Float128& a) { return q.in({contacts, a}, true)[r]; };
        const auto [least, most] = std::ranges::minmax(table[r]);
        found[r] = {scan.between(f, table[r], lower, upper), least, most,
                    is_steady(table[r], lower, upper)};
    }
    return found;
}

using Reaches = std::vector<EnclosedReach>;

/// Computes the proved extents of an approximation at each size, once in a run.
std::shared_ptr<const Reaches> reaches(const ExtentOf& of, const Exact& tolerance,
                                       const SceneSpec& scene, const std::vector<Float128>& sizes,
                                       const AuditContext& context) {
    const std::string key =
        fmt::format("size-extent/enclosed/{}/{}/{}/{}/{}/{}", scene.family,
                    of.edge == Edge::right ? "right" : "left", of.terms, tolerance.text(),
                    to_text(sizes.front()), to_text(sizes.back()));
    return context.once<Reaches>(key, [&] {
        Reaches found;
        for (const Float128& a : sizes) {
            check_interruption();
            found.push_back(enclosed_reach(with_size(scene, a), {of.edge, of.terms, tolerance, {}},
                                           enclosed_digits));
        }
        return found;
    });
}

/// Returns the proved fraction of a contact under a reading; nothing if there is none.
std::optional<Ball> fraction(const ExtentOf& of, const EnclosedReach& found, const SceneSpec& scene,
                             const ExtentReading& reading) {
    if (!found.extents) {
        return std::nullopt;
    }
    const EnclosedSample sample({scene, std::nullopt, of.edge, {}}, found.bits);
    const char* side = of.edge == Edge::right ? "a" : "b";
    return (reading.first_exit ? found.extents->first_exit : found.extents->measure) /
           sample.evaluate(Expr::symbol(reading.of_side ? side : "L"));
}

/// Decides if a figure holds at every size tried, or fails at every one. A finite list of sizes
/// does not prove more, as the note states. `steady`: see is_steady.
Judgement at_all_sizes(const QuotedExtent& q, const SceneSpec& scene,
                       const std::vector<Float128>& sizes, const ExtentReading& reading,
                       bool steady, const AuditContext& context) {
    const auto of = reaches(q.of, q.tolerance, scene, sizes, context);
    const auto over = q.over ? reaches(*q.over, q.tolerance, scene, sizes, context) : nullptr;
    std::vector<Decision> decisions;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const SceneSpec sized = with_size(scene, sizes[i]);
        auto value = fraction(q.of, of->at(i), sized, reading);
        const auto divisor = over ? fraction(*q.over, over->at(i), sized, reading) : std::nullopt;
        if (!value || (over && !divisor)) {
            return {};
        }
        if (divisor) {
            *value /= *divisor;
        }
        decisions.push_back(decide_within(*value, {q.lower, q.upper}));
        if (is_open(decisions.back()) || decisions.back().index() != decisions[0].index() ||
            (refutes(decisions.back()) && !steady)) {
            return {};
        }
    }
    return Judgement::of_all(decisions);
}

/// Returns the sizes for which a group of figures holds and no larger group does, as texts such as
/// "a = 1 ... 2: S39, S40".
std::vector<std::string> largest_groups(const std::vector<QuotedExtent>& figures,
                                        const std::vector<SizeSet>& holds) {
    std::vector<Float128> ends;
    for (const SizeSet& set : holds) {
        for (const SizeInterval& i : set) {
            ends.push_back(i.from);
            ends.push_back(i.to);
        }
    }
    std::ranges::sort(ends);
    std::map<std::vector<std::size_t>, SizeSet> at;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        const SizeInterval cell{ends[k], ends[k + 1], false, false};
        std::vector<std::size_t> group;
        for (std::size_t i = 0; i < holds.size(); ++i) {
            if (!intersection({cell}, holds[i]).empty()) {
                group.push_back(i);
            }
        }
        if (group.size() > 1) {
            at[group].push_back(cell);
        }
    }
    std::vector<std::string> largest;
    for (const auto& found : at) {
        const std::vector<std::size_t>& group = found.first; // a lambda cannot capture a binding
        const bool within_another = std::ranges::any_of(at, [&](const auto& other) {
            return other.first.size() > group.size() && std::ranges::includes(other.first, group);
        });
        if (!within_another) {
            std::vector<std::string> ids;
            for (const std::size_t i : group) {
                ids.push_back(figures[i].id);
            }
            largest.push_back(
                fmt::format("a = {}: {}", to_text(found.second, 8), fmt::join(ids, ", ")));
        }
    }
    return largest;
}

} // namespace

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
            return Exact::parse(text);
        } catch (const InputError& error) {
            claim.reject("sizes", error.problem(), error.instead());
        }
    };
    const SceneSpec& scene = scenes.front();
    const contact::Profile profile = scene.make_profile();
    const Exact from = size(range[0]);
    const Exact to = size(range[1]);
    const QuotedExtent quoted = read_quoted_extent(claim);
    const SizeScan scan(profile, from, to);
    const ContactsBySize contacts(profile);
    const auto sizes_of = [&](const QuotedExtent& q) {
        return context.once<Found>("size-extent/" + scene.family + "/" + range[0] + "/" + range[1] +
                                       q.key,
                                   [&] { return find_sizes(q, scan, contacts); });
    };
    const auto found = sizes_of(quoted);
    const std::vector<QuotedExtent> figures = companion_extents(claim, context);
    std::vector<std::shared_ptr<const Found>> of_figures;
    for (const QuotedExtent& q : figures) {
        of_figures.push_back(sizes_of(q));
    }

    Outcome outcome;
    scan.describe(range, outcome.evidence);
    const bool of_side = claim.text("base") == "side";
    std::size_t looked = 0;
    std::size_t some = 0;
    std::vector<Judgement> everywhere; // for the readings under which it holds at all sizes
    std::vector<Judgement> nowhere;    // for the readings under which it holds at no size
    bool jointly = false;
    std::string fitting;
    for (std::size_t r = 0; r < reading_count; ++r) {
        const ExtentReading& reading = extent_readings[r];
        const auto& [holds, least, most, steady] = (*found)[r];
        Evidence one;
        one.add("least", to_text(least, 6))
            .add("most", to_text(most, 6))
            .add("holds_for_a", to_text(holds));
        SizeSet all;
        std::vector<SizeSet> sets;
        for (const auto& figure : of_figures) {
            sets.push_back((*figure)[r].holds);
            all = sets.size() == 1 ? sets.back() : intersection(all, sets.back());
        }
        if (!figures.empty()) {
            one.add("all_hold_for_a", to_text(all)).add("together", largest_groups(figures, sets));
        }
        outcome.evidence.add(reading.text, one);
        if (reading.of_side != of_side) {
            continue;
        }
        ++looked;
        some += holds.empty() ? 0 : 1;
        if (is_everything(holds) || holds.empty()) {
            (holds.empty() ? nowhere : everywhere)
                .push_back(at_all_sizes(quoted, scene, scan.sizes(), reading, steady, context));
        }
        jointly = jointly || !all.empty();
        if (fitting.empty() && !holds.empty()) {
            fitting = "a = " + to_text(holds, 4);
        }
    }
    const std::string at_sizes = " (at " + std::to_string(scan.sizes().size()) + " sizes)";
    if (some == 0) {
        outcome.verdict = Judgement::of_readings(nowhere);
        outcome.note = "it rounds to this at no size of the contact" + at_sizes;
    } else if (everywhere.size() == looked) {
        outcome.verdict = Judgement::of_readings(everywhere);
        outcome.note = "the size is not given, and it rounds to this at every size" + at_sizes;
    } else {
        // Under the other readings it holds for some sizes only.
        everywhere.emplace_back(Undecided::underspecified);
        outcome.verdict = Judgement::of_readings(everywhere);
        outcome.note = "the size is not given; it would hold for " + fitting;
    }
    if (!figures.empty()) {
        outcome.note += jointly ? "; there are sizes at which all figures hold together"
                                : "; there is no size at which all figures hold together";
    }
    return outcome;
}

} // namespace edgeproof::audit
