// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/enclosed_reach.hpp"
#include "edgeproof/audit/checks/tail/parameter_sweep.hpp"
#include "edgeproof/audit/sample/evaluated_scene.hpp"
#include "edgeproof/contact/routes/extent.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

namespace edgeproof::audit {
namespace {

constexpr unsigned search_digits = 20;
constexpr unsigned place_digits = 6;
constexpr unsigned reach_digits = 8; ///< for the reach at a value that was tried
constexpr int grid = 12;
constexpr int refinements = 16;

/// The distance from the edge, as a fraction of the length, up to which the approximation with a
/// given number of terms stays within the tolerance, as a function of one parameter.
class Reach {
public:
    Reach(const Claim& claim, const AuditContext& context, std::size_t scene, Exact tolerance)
        : claim_(claim), context_(context),
          scene_(scene), asked_{claim.edge(),
                                static_cast<std::size_t>(claim.integer("terms")),
                                std::move(tolerance),
                                {}} {
        if (claim.has("upto")) {
            asked_.range.to = Exact::parse(claim.text("upto"));
        }
    }
    [[nodiscard]] Real operator()(const Rational& value) {
        const auto known = tried_.find(value);
        if (known != tried_.end()) {
            return known->second;
        }
        const EvaluatedScene scene_values(scene_with(value), search_digits);
        const contact::Extents e = within_tolerance(scene_values.contact(), asked_.edge,
                                                    asked_.terms, asked_.tolerance, asked_.range);
        return tried_[value] = e.first_exit / e.length;
    }
    /// Returns the proved value.
    [[nodiscard]] std::optional<Ball> enclosed(const Rational& value) const {
        const EnclosedReach found = enclosed_reach(scene_with(value), asked_, search_digits);
        return found.extents ? std::optional(found.extents->first_exit / found.extents->length)
                             : std::nullopt;
    }
    /// Returns the neighbours among the values tried; the value itself on a side without one.
    [[nodiscard]] std::pair<Rational, Rational> neighbours(const Rational& value) const {
        const auto at = tried_.find(value);
        const auto next = std::next(at);
        return {at == tried_.begin() ? value : std::prev(at)->first,
                next == tried_.end() ? value : next->first};
    }
    [[nodiscard]] std::size_t calls() const { return tried_.size(); }

private:
    [[nodiscard]] SceneSpec scene_with(const Rational& value) const {
        const Ledger fixed = with_parameter(context_.ledger(), claim_.text("over"),
                                            claim_.text("along"), Expr::number(value));
        return AuditContext(fixed, context_.digits()).scenes(claim_).at(scene_);
    }
    const Claim& claim_;
    const AuditContext& context_;
    std::size_t scene_;
    ReachQuestion asked_;
    std::map<Rational, Real> tried_;
};

struct Best {
    Rational at;
    Real reach;
};

/// Finds the best of an even grid and of values increasingly near to the claimed one, then improves
/// it by golden section between its neighbours. The reach may jump at its maximum, where another
/// exit appears.
Best search(Reach& reach, const Rational& claimed, const Rational& lo, const Rational& hi) {
    std::vector<Rational> values{claimed};
    for (int k = 0; k <= grid; ++k) {
        values.push_back(lo + (hi - lo) * k / grid);
    }
    Rational step = (hi - lo) / 4;
    for (int k = 0; k < 4; ++k) {
        step /= 10;
        for (const Rational& v : {Rational(claimed - step), Rational(claimed + step)}) {
            if (v > lo && v < hi) {
                values.push_back(v);
            }
        }
    }
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    Best best{claimed, Real(-1)};
    const auto probe = [&](const Rational& v) {
        const Real r = reach(v);
        if (r > best.reach) {
            best = {v, r};
        }
        return r;
    };
    std::ranges::for_each(values, probe);
    Rational a;
    Rational b;
    std::tie(a, b) = reach.neighbours(best.at);
    const Rational golden(610, 987);
    // Round to few digits, so that the quotients stay short.
    const auto short_of = [](const Rational& v) {
        const Rational scale(1000000000000L);
        return Rational(boost::multiprecision::mpz_int(v * scale)) / scale;
    };
    Rational x = short_of(b - golden * (b - a));
    Rational y = short_of(a + golden * (b - a));
    Real at_x = probe(x);
    Real at_y = probe(y);
    for (int k = 0; k < refinements; ++k) {
        if (at_x > at_y) {
            b = y;
            y = x;
            at_y = at_x;
            x = short_of(b - golden * (b - a));
            at_x = probe(x);
        } else {
            a = x;
            x = y;
            at_x = at_y;
            y = short_of(a + golden * (b - a));
            at_y = probe(y);
        }
    }
    return best;
}

/// The best value found for one tolerance in one scene.
struct OptimumFound {
    Decision is_best; ///< for the claimed value: no other reaches farther by more than a millionth
    std::optional<Ball> off; ///< the distance from the claimed value to the best, if it is proved
    std::string text;
    Evidence evidence;
};

/// Finds the best of the values that are tried. They can only prove that another value reaches
/// farther.
OptimumFound tried_search(const Claim& claim, const AuditContext& context, std::size_t scene,
                          const std::string& tolerance, const contact::ParameterRange& range,
                          const Rational& claimed, std::size_t& calls) {
    Reach reach(claim, context, scene, Exact::parse(tolerance));
    const Real here = reach(claimed);
    const Best best = search(reach, claimed, range.from, range.to);
    calls += reach.calls();
    const auto enclosed_here = reach.enclosed(claimed);
    const auto enclosed_best = reach.enclosed(best.at);
    OptimumFound found;
    if (enclosed_here && enclosed_best) {
        found.is_best = decision(Refutation::less(*enclosed_here, *enclosed_best), std::nullopt);
    }
    // The reach jumps with the parameter where an inner extremum of the error touches the
    // tolerance: the values tried show only an interval that contains the best value.
    const auto [below, above] = reach.neighbours(best.at);
    const std::string from = to_decimal(below, place_digits, Rounding::down);
    const std::string to = to_decimal(above, place_digits, Rounding::up);
    found.evidence.add("tolerance", tolerance)
        .add("best_value_tried", exact_text(best.at))
        .add("reach_there", to_decimal(best.reach, reach_digits))
        .add("between_the_values_tried", std::vector<std::string>{from, to})
        .add("reach_at_the_value_claimed", to_decimal(here, reach_digits));
    found.text = claim.text("along") + " between " + from + " and " + to + " for the tolerance " +
                 tolerance + ", of the values tried (the reach may jump between them)";
    return found;
}

/// Finds the best value by branch and bound, for families whose error is enclosed over a range:
/// power laws as functions of m.
std::optional<OptimumFound> proved_search(const Claim& claim, const AuditContext& context,
                                          std::size_t scene, const Exact& tolerance,
                                          const contact::ParameterRange& range,
                                          const Rational& claimed) {
    const SceneSpec spec = context.scenes(claim).at(scene);
    if (claim.text("along") != "m" || spec.profile != "power-law" || !tolerance.is_rational()) {
        return {};
    }
    const auto errors =
        contact::power_law_errors(Expr::symbol("m"), {},
                                  {Edge::right, static_cast<std::size_t>(claim.integer("terms")),
                                   contact::ReachUnit::fraction, "m"});
    contact::ReachProblem problem;
    problem.edges = {errors.get()};
    problem.tolerance = tolerance.rational();
    if (claim.has("upto")) {
        problem.part = Exact::parse(claim.text("upto")).rational();
    }
    const ProvedOptimum found =
        proved_optimum(problem, range, Ball(claimed, optimum_bits), claim.text("along"));
    if (!found.proved) {
        return {};
    }
    OptimumFound result;
    const Ball millionth(Rational(1, 1'000'000), optimum_bits);
    result.is_best =
        decision(found.is_best ? std::nullopt
                               : Refutation::less(found.claimed_reach, found.best.shown_reach),
                 Confirmation::less(found.falls_short, millionth * 2));
    result.off = abs(found.best.value - Ball(claimed, optimum_bits));
    result.text = found.text + " for the tolerance " + tolerance.text();
    result.evidence.add("tolerance", tolerance.text());
    found.add_to(result.evidence);
    return result;
}

} // namespace

Outcome check_optimum(const Claim& claim, const AuditContext& context) {
    const Rational claimed = Exact::parse(claim.text("at")).rational();
    const auto& between = claim.list("between");
    if (between.size() != 2) {
        claim.reject("between", "the search needs two ends", "write [\"0\", \"2\"]");
    }
    const Rational lo = Exact::parse(between[0]).rational();
    const Rational hi = Exact::parse(between[1]).rational();
    if (!(lo < claimed && claimed < hi)) {
        claim.reject("between", "the value claimed is not between the ends of the search",
                     "give ends that include it");
    }
    const bool in_the_limit = claim.text_or("sense", "each") == "limit";
    const PrecisionScope scope(search_digits + 20);
    Outcome outcome;
    std::vector<EvidenceItem> list;
    std::vector<Decision> best_at;     // for each tolerance in each scene
    std::vector<Decision> approaching; // from each tolerance to the next
    std::size_t calls = 0;
    const std::size_t scenes = context.scenes(claim).size();
    for (std::size_t k = 0; k < scenes; ++k) {
        std::optional<Ball> last_off;
        for (const std::string& text : claim.list("tolerances")) {
            const Exact tolerance = Exact::parse(text);
            auto found = proved_search(claim, context, k, tolerance, {lo, hi}, claimed);
            if (!found) {
                found = tried_search(claim, context, k, text, {lo, hi}, claimed, calls);
            }
            const bool is_best = confirms(found->is_best);
            best_at.push_back(found->is_best);
            if (!found->off) {
                approaching.emplace_back();
            } else {
                const Ball away = is_best ? Ball(0, optimum_bits) : *found->off;
                if (last_off) {
                    approaching.push_back(is_best
                                              ? found->is_best
                                              : decision(Refutation::less(*last_off, away),
                                                         Confirmation::less(away * 2, *last_off)));
                }
                last_off = away;
            }
            list.emplace_back(std::move(found->evidence));
            if (!outcome.computed) {
                outcome.computed = std::move(found->text);
            }
        }
    }
    outcome.evidence.add("along", claim.text("along"))
        .add("at", claim.text("at"))
        .add("tolerances", std::move(list))
        .add("extents_computed", calls);
    const Judgement best = Judgement::of_all(best_at);
    const Judgement in_limit = in_the_limit ? Judgement::of_all(approaching) : Judgement();
    outcome.verdict = in_the_limit && best != Verdict::confirmed ? in_limit : best;
    outcome.note = best == Verdict::confirmed ? "no value of the range reaches farther: proved"
                   : outcome.verdict == Verdict::confirmed
                       ? "the best value tends to the one claimed as the tolerance is lowered"
                   : outcome.verdict == Verdict::refuted
                       ? "reaches farthest with " + *outcome.computed
                       : "none of the values tried reaches farther, which proves nothing";
    return outcome;
}

} // namespace edgeproof::audit
