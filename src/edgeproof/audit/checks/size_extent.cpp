// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/quoted_figure.hpp"
#include "edgeproof/audit/checks/parts/sizes.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

namespace edgeproof::audit {
namespace {

constexpr std::array<ExtentReading, 4> extent_readings{
    {{"first exit, of the side from the edge to the origin", true, true},
     {"all that is within, of the side from the edge to the origin", false, true},
     {"first exit, of the whole contact", true, false},
     {"all that is within, of the whole contact", false, false}}};
constexpr unsigned enclosed_digits = 15;
constexpr long most_terms = 4;

/// A quoted extent: the figure, and the quantity that it gives.
struct QuotedExtent {
    std::string id;
    std::string key; ///< everything except the scene on which the figure and its meaning depend
    Edge edge = Edge::right;
    std::size_t terms = 1;
    std::optional<std::size_t> over; ///< the number of terms of the divisor, if any
    Rational lower;                  ///< the numbers that round to the figure: lower end ...
    Rational upper;                  ///< ... and upper end (excluded)
    Exact tolerance;
    bool of_side = true; ///< false: of the whole contact
};

/// Reads the keys of a claim. Throws InputError for values that are not possible.
QuotedExtent read_quoted_extent(const Claim& claim) {
    const auto terms = [&](std::string_view key) {
        const long n = claim.integer(key);
        if (n < 1 || n > most_terms) {
            claim.reject(key, "an approximation of " + std::to_string(n) + " terms",
                         "write 1 to 4");
        }
        return static_cast<std::size_t>(n);
    };
    QuotedExtent q;
    q.id = claim.id;
    for (const char* name :
         {"edge", "terms", "over_terms", "tolerance", "figure", "unit", "base"}) {
        q.key += "/" + claim.text_or(name, "");
    }
    q.tolerance = Exact::parse(claim.text("tolerance"));
    q.edge = claim.edge();
    q.terms = terms("terms");
    if (claim.has("over_terms")) {
        q.over = terms("over_terms");
    }
    q.of_side = claim.text("base") == "side";
    const Rational figure = Exact::parse(claim.text("figure")).rational();
    const Rational half = Exact::parse(claim.text("unit")).rational() / 2;
    q.lower = figure - half;
    q.upper = figure + half;
    if (!(half > 0) || q.tolerance.sign() <= 0) {
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

/// The proved extents of an approximation at one size, and the side of the contact.
struct ReachAtSize {
    std::optional<contact::EnclosedExtents> extents;
    Ball side;
};

ReachAtSize reach_at(const SceneSpec& scene, Edge edge, std::size_t terms, const Exact& tolerance) {
    check_interruption();
    const EnclosedReach found =
        enclosed_reach(scene, {edge, terms, tolerance, {}}, enclosed_digits);
    if (!found.extents) {
        return {};
    }
    const EnclosedSample sample({scene, std::nullopt, edge, {}}, found.bits);
    return {found.extents, sample.evaluate(Expr::symbol(edge == Edge::right ? "a" : "b"))};
}

/// The extents at all sizes of the scan, for several claims with the same approximation.
class ReachesBySize {
public:
    ReachesBySize(const SceneSpec& scene, const SizeScan& scan, const AuditContext& context)
        : scene_(scene), scan_(scan), context_(context) {}

    /// Returns the extent, or the quotient of two extents, at each size of the scan.
    [[nodiscard]] std::vector<std::optional<Ball>> of(const QuotedExtent& q,
                                                      const ExtentReading& reading) const {
        const auto reaches = at_sizes(q, q.terms);
        const auto over = q.over ? at_sizes(q, *q.over) : nullptr;
        std::vector<std::optional<Ball>> values;
        for (std::size_t i = 0; i < reaches->size(); ++i) {
            values.push_back(value(reaches->at(i), over ? &over->at(i) : nullptr, reading));
        }
        return values;
    }
    [[nodiscard]] std::optional<Ball> at(const QuotedExtent& q, const ExtentReading& reading,
                                         const Rational& a) {
        const auto reach = [&](std::size_t terms) -> const ReachAtSize& {
            const auto [known, added] = known_.try_emplace({q.key, terms, a});
            if (added) {
                known->second = reach_at(with_size(scene_, a), q.edge, terms, q.tolerance);
            }
            return known->second;
        };
        return value(reach(q.terms), q.over ? &reach(*q.over) : nullptr, reading);
    }

private:
    using Reaches = std::vector<ReachAtSize>;
    [[nodiscard]] std::shared_ptr<const Reaches> at_sizes(const QuotedExtent& q,
                                                          std::size_t terms) const {
        const std::string key =
            fmt::format("size-extent/enclosed/{}/{}/{}/{}/{}/{}", scene_.family,
                        q.edge == Edge::right ? "right" : "left", terms, q.tolerance.text(),
                        exact_text(scan_.sizes().front()), exact_text(scan_.sizes().back()));
        return context_.once<Reaches>(key, [&] {
            Reaches found;
            for (const Rational& a : scan_.sizes()) {
                found.push_back(reach_at(with_size(scene_, a), q.edge, terms, q.tolerance));
            }
            return found;
        });
    }
    static std::optional<Ball> value(const ReachAtSize& reach, const ReachAtSize* over,
                                     const ExtentReading& reading) {
        if (!reach.extents || (over != nullptr && !over->extents)) {
            return std::nullopt;
        }
        const auto x = fraction_within(*reach.extents, reach.side, reading);
        const auto y = over == nullptr ? x : fraction_within(*over->extents, over->side, reading);
        return !x || !y ? std::nullopt : over == nullptr ? x : std::optional(*x / *y);
    }
    const SceneSpec& scene_;
    const SizeScan& scan_;
    const AuditContext& context_;
    std::map<std::tuple<std::string, std::size_t, Rational>, ReachAtSize> known_; ///< of `at`
};

/// What is found for a figure under one reading.
struct InReading {
    ExtentReading reading;
    std::vector<Decision> decisions; ///< at the sizes of the scan
    SizeSet holds;
    std::optional<Ball> least;
    std::optional<Ball> most;
    /// Between neighbours the figure varies by less than its distance from the interval of numbers
    /// that round to the quoted one.
    bool steady = true;

    /// Decides if a figure holds at every size tried, or fails at every one. A finite list of sizes
    /// does not prove more, as the note states.
    [[nodiscard]] Judgement judgement() const {
        const bool fails = std::ranges::all_of(decisions, refutes);
        return std::ranges::all_of(decisions, confirms) || (fails && steady)
                   ? Judgement::of_all(decisions)
                   : Judgement();
    }
};
using Found = std::vector<InReading>;

InReading look_at_sizes(const QuotedExtent& q, const ExtentReading& reading, const SizeScan& scan,
                        ReachesBySize& reaches) {
    const PrecisionScope scope(2 * enclosed_digits);
    const auto decided = [&](const std::optional<Ball>& value) {
        return value ? decide_within(*value, {q.lower, q.upper}) : Decision();
    };
    const auto side_at = [&](const std::optional<Ball>& value) {
        const Decision found = decided(value);
        return refutes(found) && certainly_less(*value, Ball(q.lower, value->bits()))
                   ? Side::below
                   : side_of(found);
    };
    InReading found{reading, {}, {}, {}, {}, true};
    const auto away = [&](const Real& x) {
        return std::max(Real(from_rational<Real>(q.lower) - x),
                        Real(x - from_rational<Real>(q.upper)));
    };
    std::vector<Side> sides;
    std::optional<Real> before;
    for (const auto& value : reaches.of(q, reading)) {
        found.decisions.push_back(decided(value));
        sides.push_back(side_at(value));
        if (!value) {
            found.steady = false;
            continue;
        }
        found.least = found.least ? min(*found.least, *value) : *value;
        found.most = found.most ? max(*found.most, *value) : *value;
        const Real here = value->midpoint();
        found.steady = found.steady &&
                       (!before || abs(Real(here - *before)) < std::min(away(here), away(*before)));
        before = here;
    }
    found.holds =
        scan.where(sides, [&](const Rational& a) { return side_at(reaches.at(q, reading, a)); });
    return found;
}

/// Returns the sizes for which a group of figures holds and no larger group does, as texts such as
/// "a = 1 ... 2: S39, S40".
std::vector<std::string> largest_groups(const std::vector<QuotedExtent>& figures,
                                        const std::vector<SizeSet>& holds) {
    std::vector<Rational> ends;
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
                fmt::format("a = {}: {}", to_text(found.second), fmt::join(ids, ", ")));
        }
    }
    return largest;
}

} // namespace

Outcome check_size_extent(const Claim& claim, const AuditContext& context) {
    const auto [scene, scan] = sized_scene(claim, context);
    const QuotedExtent quoted = read_quoted_extent(claim);
    ReachesBySize reaches(scene, scan, context);
    const auto& range = claim.list("sizes");
    const auto look = [&, &of = scan, &family = scene.family](const QuotedExtent& q) {
        return context.once<Found>(
            "size-extent/" + family + "/" + range[0] + "/" + range[1] + q.key, [&] {
                Found found;
                for (const ExtentReading& reading : extent_readings) {
                    if (reading.of_side == q.of_side) {
                        found.push_back(look_at_sizes(q, reading, of, reaches));
                    }
                }
                return found;
            });
    };
    const auto found = look(quoted);
    const std::vector<QuotedExtent> figures = companion_extents(claim, context);
    std::vector<std::shared_ptr<const Found>> of_figures;
    for (const QuotedExtent& q : figures) {
        of_figures.push_back(look(q));
    }

    Outcome outcome;
    scan.describe(range, outcome.evidence);
    std::vector<Judgement> everywhere; // for the readings under which it holds at all sizes
    std::vector<Judgement> nowhere;    // for the readings under which it holds at no size
    bool jointly = false;
    std::string fitting;
    for (std::size_t r = 0; r < found->size(); ++r) {
        const InReading& in = found->at(r);
        Evidence one;
        if (in.least) {
            one.add("least", to_decimal(in.least->midpoint(), 6))
                .add("most", to_decimal(in.most->midpoint(), 6));
        }
        one.add("holds_for_a", to_text(in.holds));
        SizeSet all;
        std::vector<SizeSet> sets;
        for (const auto& figure : of_figures) {
            sets.push_back(figure->at(r).holds);
            all = sets.size() == 1 ? sets.back() : intersection(all, sets.back());
        }
        if (!figures.empty()) {
            one.add("all_hold_for_a", to_text(all)).add("together", largest_groups(figures, sets));
        }
        outcome.evidence.add(in.reading.text, one);
        if (in.holds.empty()) {
            nowhere.push_back(in.judgement());
        } else if (std::ranges::none_of(in.decisions, refutes)) {
            everywhere.push_back(in.judgement());
        }
        jointly = jointly || !all.empty();
        if (fitting.empty() && !in.holds.empty()) {
            fitting = "a = " + to_text(in.holds);
        }
    }
    const std::string at_sizes = " (at " + std::to_string(scan.sizes().size()) + " sizes)";
    if (nowhere.size() == found->size()) {
        outcome.verdict = Judgement::of_readings(nowhere);
        outcome.note = outcome.verdict == Verdict::refuted
                           ? "it rounds to this at no size of the contact" + at_sizes
                           : "the enclosures do not decide at some sizes";
    } else if (everywhere.size() == found->size()) {
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
