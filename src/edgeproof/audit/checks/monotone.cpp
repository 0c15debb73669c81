// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/parameter_sweep.hpp"

namespace edgeproof::audit {
namespace {

std::string step_text(const ParameterSweep& sweep, std::size_t from) {
    return sweep.name() + " = " + sweep.values()[from] + " to " + sweep.values()[from + 1];
}

/// Falls (or rises) where the claim has it rise (or fall), or cannot be told.
struct Steps {
    std::size_t good = 0;
    std::size_t bad = 0;
    std::size_t unclear = 0;
    std::vector<std::string> bad_steps; ///< of the first sample that has any
    std::size_t bad_sample = 0;
    std::size_t bad_from = 0; ///< the value that the largest of them begins at
    std::string bad_at;
    std::optional<Difference> against; ///< two values that go the other way
    std::vector<std::string> values;   ///< of `of`, at that sample or at the first
};

Steps count_steps(const ParameterSweep& sweep, const formula::Expr& of, bool rising,
                  unsigned digits) {
    Steps steps;
    const PrecisionScope scope(digits + 20);
    const Real noise = pow(Real(10), 2 - static_cast<int>(digits));
    for (std::size_t k = 0; k < sweep.samples(); ++k) {
        std::vector<Real> f;
        std::vector<std::string> bad;
        std::size_t largest = 0;
        Real most(0);
        bool good_digits = true;
        for (std::size_t j = 0; j < sweep.values().size(); ++j) {
            const FormulaValue value = sweep.sample_at(j, k).evaluate(of);
            good_digits = good_digits && value.converged;
            f.push_back(value.value);
        }
        for (std::size_t j = 0; j + 1 < f.size(); ++j) {
            const Real rise = rising ? Real(f[j + 1] - f[j]) : Real(f[j] - f[j + 1]);
            if (!good_digits || abs(rise) <= noise * (abs(f[j]) + abs(f[j + 1]))) {
                ++steps.unclear;
            } else if (rise > 0) {
                ++steps.good;
            } else if (!(rise < 0)) {
                ++steps.unclear; // not a number
            } else {
                ++steps.bad;
                bad.push_back(step_text(sweep, j));
                if (!steps.against) {
                    steps.against = Difference::of(f[j], f[j + 1], Real(0));
                }
                if (-rise > most) {
                    most = -rise;
                    largest = j;
                }
            }
        }
        if (k == 0 || (!bad.empty() && steps.bad_steps.empty())) {
            steps.values.clear();
            for (const Real& value : f) {
                steps.values.push_back(value_text(value, 12));
            }
        }
        if (!bad.empty() && steps.bad_steps.empty()) {
            steps.bad_steps = bad;
            steps.bad_sample = k;
            steps.bad_from = largest;
            steps.bad_at = sweep.sample_at(0, k).text;
        }
    }
    return steps;
}

Outcome check_monotone(const Claim& claim, const AuditContext& context) {
    const bool rising = claim.text("sense") == "increasing";
    const ParameterSweep sweep(claim, context, context.digits());
    const Steps steps = count_steps(sweep, claim.formula("of"), rising, context.digits());
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"))
        .add("along", sweep.name())
        .add("values_taken", sweep.values())
        .add("samples", sweep.samples())
        .add("steps_as_claimed", steps.good)
        .add("steps_against", steps.bad);
    if (steps.unclear > 0) {
        outcome.evidence.add("steps_unclear", steps.unclear);
    }
    outcome.evidence.add("values", steps.values);
    const std::string sense = rising ? "grows" : "falls";
    if (steps.bad > 0) {
        outcome.verdict = Judgement(steps.against);
        outcome.evidence.add("against_at", steps.bad_at).add("against", steps.bad_steps);
        outcome.note = (rising ? "falls from " : "grows from ") + steps.bad_steps.front() + " (" +
                       std::to_string(steps.bad) + " of " +
                       std::to_string(steps.bad + steps.good + steps.unclear) + " steps)";
        const formula::Expr of = claim.formula("of");
        const auto at = [&](std::size_t value) {
            return enclosed(of, sweep.sample_at(value, steps.bad_sample).sample, context.digits());
        };
        add_pair("before", at(steps.bad_from), "after", at(steps.bad_from + 1),
                 steps.bad_at + "; " + step_text(sweep, steps.bad_from), context.digits(), outcome);
    } else if (steps.unclear > 0 || steps.good == 0) {
        outcome.note = "some steps are too small for the digits at hand";
    } else {
        outcome.verdict = NotRefuted::confirmed;
        outcome.note = sense + " at each of " + std::to_string(steps.good) + " steps (sampled)";
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
