// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/enclosed_reach.hpp"
#include "edgeproof/precision/error.hpp"

#include <utility>

namespace edgeproof::audit {
namespace {

constexpr unsigned search_digits = 20;

/// The best value found for one tolerance in one scene.
struct OptimumFound {
    Decision is_best; ///< for the claimed value: no other reaches farther by more than a millionth
    std::optional<Ball> off; ///< the distance from the claimed value to the best, if it is proved
    std::string text;
    std::string problem; ///< the reason why the best value is not proved
    Evidence evidence;
};

/// Finds the best value by branch and bound, for families whose error is enclosed over a range:
/// power laws as functions of m.
OptimumFound proved_search(const Claim& claim, const AuditContext& context, std::size_t scene,
                           const Exact& tolerance, const contact::ParameterRange& range,
                           const Rational& claimed) {
    OptimumFound result;
    result.evidence.add("tolerance", tolerance.text());
    const SceneSpec spec = context.scenes(claim).at(scene);
    if (claim.text("along") != "m" || spec.profile != "power-law" || !tolerance.is_rational()) {
        result.problem = "the best value is proved only for the exponent m of a power law and a "
                         "rational tolerance";
        result.evidence.add("not_proved", result.problem);
        return result;
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
    found.add_to(result.evidence);
    if (!found.proved) {
        result.problem = found.best.missing;
        return result;
    }
    const Ball millionth(Rational(1, 1'000'000), optimum_bits);
    result.is_best =
        decision(found.is_best ? std::nullopt
                               : Refutation::less(found.claimed_reach, found.best.shown_reach),
                 Confirmation::less(found.falls_short, millionth * 2));
    result.off = abs(found.best.value - Ball(claimed, optimum_bits));
    result.text = found.text + " for the tolerance " + tolerance.text();
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
    std::string problem;
    const std::size_t scenes = context.scenes(claim).size();
    for (std::size_t k = 0; k < scenes; ++k) {
        std::optional<Ball> last_off;
        for (const std::string& text : claim.list("tolerances")) {
            const Exact tolerance = Exact::parse(text);
            OptimumFound found = proved_search(claim, context, k, tolerance, {lo, hi}, claimed);
            const bool is_best = confirms(found.is_best);
            best_at.push_back(found.is_best);
            if (!found.off) {
                approaching.emplace_back();
                problem = problem.empty() ? found.problem : problem;
            } else {
                const Ball away = is_best ? Ball(0, optimum_bits) : *found.off;
                if (last_off) {
                    approaching.push_back(is_best
                                              ? found.is_best
                                              : decision(Refutation::less(*last_off, away),
                                                         Confirmation::less(away * 2, *last_off)));
                }
                last_off = away;
            }
            list.emplace_back(std::move(found.evidence));
            if (!outcome.computed && !found.text.empty()) {
                outcome.computed = std::move(found.text);
            }
        }
    }
    outcome.evidence.add("along", claim.text("along"))
        .add("at", claim.text("at"))
        .add("tolerances", std::move(list));
    const Judgement best = Judgement::of_all(best_at);
    const Judgement in_limit = in_the_limit ? Judgement::of_all(approaching) : Judgement();
    outcome.verdict = in_the_limit && best != Verdict::confirmed ? in_limit : best;
    outcome.note = best == Verdict::confirmed ? "no value of the range reaches farther: proved"
                   : outcome.verdict == Verdict::confirmed
                       ? "the best value tends to the one claimed as the tolerance is lowered"
                   : outcome.verdict == Verdict::refuted
                       ? "reaches farthest with " + *outcome.computed
                   : !problem.empty() ? problem
                                      : "the best value is not decided";
    return outcome;
}

} // namespace edgeproof::audit
