// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/parameter_sweep.hpp"
#include "edgeproof/audit/checks/tail/followed_tail.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

/// Returns the listed values of the name at one sample.
std::vector<formula::Exact> listed_values(const ParameterSweep& sweep, std::size_t sample) {
    std::vector<formula::Exact> values;
    for (std::size_t j = 0; j < sweep.values().size(); ++j) {
        values.push_back(sweep.value_at(j, sample));
    }
    return values;
}

/// Returns the numbers of which the end of the sweep may be a multiple.
std::vector<formula::Exact> other_numbers(const ParameterSweep& sweep, std::size_t sample) {
    const Sample& at = sweep.sample_at(0, sample).sample;
    std::vector<formula::Exact> numbers;
    for (const auto* names : {&at.scene.parameters, &at.variables}) {
        for (const auto& [name, value] : *names) {
            if (name != sweep.name()) {
                numbers.push_back(value);
            }
        }
    }
    return numbers;
}

std::vector<std::string> values_listed(const ParameterSweep& sweep, std::size_t sample,
                                       const formula::Expr& of) {
    constexpr unsigned digits_shown = 12;
    std::vector<std::string> texts;
    for (std::size_t j = 0; j < sweep.values().size(); ++j) {
        const Enclosed value = enclosed(of, sweep.sample_at(j, sample).sample, digits_shown);
        texts.push_back(!value.ball                   ? "none: " + value.problem
                        : can_be_printed(*value.ball) ? ball_text(*value.ball, digits_shown)
                                                      : "beyond the range of decimals");
    }
    return texts;
}

/// The sample followed to the end of the sweep, or the reason why it was not.
struct SeenLimit {
    std::optional<FollowedTail> tail;
    std::string problem;
    [[nodiscard]] Decision decision() const { return tail ? tail->decision() : Decision(); }
};

SeenLimit look_at(const ParameterSweep& sweep, std::size_t sample, const LimitClaimed& claimed,
                  unsigned digits) {
    SeenLimit seen;
    const auto target = SweepTarget::of(listed_values(sweep, sample), other_numbers(sweep, sample));
    if (target) {
        seen.tail.emplace(sweep, sample, *target, claimed, digits);
        seen.problem = seen.tail->problem();
    } else {
        seen.problem =
            "the values of " + sweep.name() +
            " do not show which value it approaches; list values that halve, or double, at each "
            "step, or whose distance from a simple number halves";
    }
    return seen;
}

void report(const ParameterSweep& sweep, std::size_t sample, const SeenLimit& seen,
            const formula::Expr& of, unsigned digits, Evidence& evidence) {
    const std::string& at = sweep.sample_at(sweep.values().size() - 1, sample).text;
    evidence.add("at", at).add("values", values_listed(sweep, sample, of));
    if (!seen.tail) {
        return;
    }
    evidence.add("goes_to", seen.tail->target().text()).add("followed", seen.tail->texts());
    if (const auto& pair = seen.tail->compared()) {
        add_pair({pair->first_name,
                  {pair->first, ""},
                  pair->second_name,
                  {pair->second, ""},
                  at + "; followed from there"},
                 digits, evidence);
    }
}

std::string note_of(const Judgement& verdict, bool infinite, unsigned decades,
                    const ParameterSweep& sweep, std::size_t sample, const SeenLimit& seen) {
    const std::string far = "followed by 10^" + std::to_string(decades);
    if (verdict == Verdict::confirmed) {
        return (infinite ? "grows without bound at "
                         : "the distance from the limit tends to zero at ") +
               std::to_string(sweep.samples()) + " samples (sampled; " + far + ")";
    }
    if (verdict == Verdict::refuted) {
        return (infinite ? "does not grow without bound: " : "does not approach the limit: ") +
               sweep.sample_at(sweep.values().size() - 1, sample).text + " (" + far + ")";
    }
    return seen.problem;
}

Outcome check_limit(const Claim& claim, const AuditContext& context) {
    const bool infinite = claim.text("limit") == "infinity";
    const LimitClaimed claimed{claim.formula("of"),
                               infinite ? std::nullopt : std::optional(claim.formula("limit"))};
    const ParameterSweep sweep(claim, context);
    std::vector<Decision> decisions;
    std::size_t shown = 0;
    std::optional<SeenLimit> worst;
    unsigned decades = 0;
    for (std::size_t k = 0; k < sweep.samples(); ++k) {
        SeenLimit seen = look_at(sweep, k, claimed, context.digits());
        const Decision decision = seen.decision();
        decisions.push_back(decision);
        const unsigned far = seen.tail ? seen.tail->decades() : 0;
        decades = k == 0 ? far : std::min(decades, far);
        const bool worse = worst && confirms(worst->decision()) && !confirms(decision);
        if (!worst || worse || (refutes(decision) && !refutes(worst->decision()))) {
            shown = k;
            worst.emplace(std::move(seen));
        }
        if (refutes(decision)) {
            decades = far;
            break;
        }
    }
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"))
        .add("limit", claim.text("limit"))
        .add("along", sweep.name())
        .add("values_taken", sweep.values())
        .add("samples", sweep.samples());
    report(sweep, shown, *worst, claimed.of, context.digits(), outcome.evidence);
    outcome.verdict = Judgement::of_all(decisions);
    outcome.note = note_of(outcome.verdict, infinite, decades, sweep, shown, *worst);
    return outcome;
}

} // namespace

CheckKind limit_kind() {
    using Type = KeySpec::Type;
    return {"limit",
            {required_formula("of"),
             {.name = "along", .required = true},
             {.name = "limit", .type = Type::formula, .required = true, .choices = {"infinity"}}},
            check_limit};
}

} // namespace edgeproof::audit
