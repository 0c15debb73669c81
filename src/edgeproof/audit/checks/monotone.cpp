// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/parameter_sweep.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

std::string step_text(const ParameterSweep& sweep, std::size_t from) {
    return sweep.name() + " = " + sweep.values()[from] + " to " + sweep.values()[from + 1];
}

/// The values at both ends of a step, with as many digits as needed to show which one is larger.
struct Step {
    Enclosed from;
    Enclosed to;
    Decision as_claimed;
};

struct Steps {
    std::vector<Decision> decisions;
    std::vector<std::string> bad_steps; ///< of the first sample that has any
    std::size_t bad_from = 0;           ///< the index of the value where the largest begins
    std::string bad_at;
    Step against;                    ///< the largest bad step
    std::vector<std::string> values; ///< of `of`, at that sample or at the first

    [[nodiscard]] std::size_t count(bool (*is)(const Decision&)) const {
        return static_cast<std::size_t>(std::count_if(decisions.begin(), decisions.end(), is));
    }
};

Step take_step(const Sample& from, const Sample& to, const formula::Expr& of, bool rising,
               unsigned digits) {
    Step step;
    for (const unsigned more : {digits, 2 * digits + 40, 4 * digits + 160}) {
        step.from = enclosed(of, from, more);
        step.to = enclosed(of, to, more);
        if (!step.from.ball || !step.to.ball) {
            break;
        }
        const Ball& lesser = rising ? *step.from.ball : *step.to.ball;
        const Ball& greater = rising ? *step.to.ball : *step.from.ball;
        step.as_claimed =
            decision(Refutation::less(greater, lesser), Confirmation::less(lesser, greater));
        if (!std::holds_alternative<std::monostate>(step.as_claimed)) {
            break;
        }
    }
    return step;
}

Steps count_steps(const ParameterSweep& sweep, const formula::Expr& of, bool rising,
                  unsigned digits) {
    Steps steps;
    for (std::size_t k = 0; k < sweep.samples(); ++k) {
        std::vector<std::string> values;
        std::vector<std::string> bad;
        std::optional<Ball> most;
        std::size_t largest = 0;
        for (std::size_t j = 0; j + 1 < sweep.values().size(); ++j) {
            check_interruption();
            const Step step = take_step(sweep.sample_at(j, k).sample,
                                        sweep.sample_at(j + 1, k).sample, of, rising, digits);
            const auto text = [](const Enclosed& x) {
                return x.ball ? ball_text(*x.ball, 12) : "none: " + x.problem;
            };
            values.push_back(text(step.from));
            if (j + 2 == sweep.values().size()) {
                values.push_back(text(step.to));
            }
            steps.decisions.push_back(step.as_claimed);
            if (!refutes(step.as_claimed)) {
                continue;
            }
            bad.push_back(step_text(sweep, j));
            const Ball fall = abs(*step.to.ball - *step.from.ball);
            if (!most || most->midpoint() < fall.midpoint()) {
                most = fall;
                largest = j;
                if (steps.bad_steps.empty()) {
                    steps.against = step;
                }
            }
        }
        if (k == 0 || (!bad.empty() && steps.bad_steps.empty())) {
            steps.values = values;
        }
        if (!bad.empty() && steps.bad_steps.empty()) {
            steps.bad_steps = bad;
            steps.bad_from = largest;
            steps.bad_at = sweep.sample_at(0, k).text;
        }
    }
    return steps;
}

Outcome check_monotone(const Claim& claim, const AuditContext& context) {
    const bool rising = claim.text("sense") == "increasing";
    const ParameterSweep sweep(claim, context);
    const Steps steps = count_steps(sweep, claim.formula("of"), rising, context.digits());
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"))
        .add("along", sweep.name())
        .add("values_taken", sweep.values())
        .add("samples", sweep.samples())
        .add("steps_as_claimed", steps.count(confirms))
        .add("steps_against", steps.count(refutes));
    const std::size_t good = steps.count(confirms);
    const std::size_t bad = steps.count(refutes);
    const std::size_t unclear = steps.decisions.size() - good - bad;
    if (unclear > 0) {
        outcome.evidence.add("steps_unclear", unclear);
    }
    outcome.evidence.add("values", steps.values);
    outcome.verdict = Judgement::of_all(steps.decisions);
    if (bad > 0) {
        outcome.evidence.add("against_at", steps.bad_at).add("against", steps.bad_steps);
        outcome.note = (rising ? "falls from " : "grows from ") + steps.bad_steps.front() + " (" +
                       std::to_string(bad) + " of " + std::to_string(steps.decisions.size()) +
                       " steps)";
        add_pair({"before", steps.against.from, "after", steps.against.to,
                  steps.bad_at + "; " + step_text(sweep, steps.bad_from)},
                 context.digits(), outcome.evidence);
    } else if (outcome.verdict == Verdict::undecided) {
        outcome.note = "some steps are too small for the enclosures";
    } else {
        outcome.note = (rising ? "grows" : "falls") + std::string(" at each of ") +
                       std::to_string(good) + " steps (sampled)";
    }
    return outcome;
}

} // namespace

CheckKind monotone_kind() {
    using Type = KeySpec::Type;
    return {"monotone",
            {required_formula("of"),
             {.name = "along", .required = true},
             {.name = "sense",
              .type = Type::choice,
              .required = true,
              .choices = {"increasing", "decreasing"}}},
            check_monotone};
}

} // namespace edgeproof::audit
