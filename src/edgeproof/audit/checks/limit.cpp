// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/parameter_sweep.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

enum class Trend { towards, away, unclear };

/// Distances from the limit claimed: do they die away?
Trend finite_trend(const std::vector<Real>& f, const Real& limit, const Real& noise) {
    std::vector<Real> d;
    d.reserve(f.size());
    for (const Real& value : f) {
        d.push_back(abs(value - limit));
    }
    const std::size_t n = d.size();
    const Real most = *std::max_element(d.begin(), d.end());
    if (d[n - 1] <= noise * std::max(Real(abs(limit)), most)) {
        return Trend::towards;
    }
    const Real last_step = abs(f[n - 1] - f[n - 2]);
    if (d[n - 1] >= d[n - 2] || last_step * 100 < d[n - 1]) {
        return Trend::away; // it grows, or converges elsewhere
    }
    // It must fall, and not by less and less: then it would converge short of the limit.
    const bool falls = d[n - 1] < d[n - 2] && d[n - 2] < d[n - 3] && d[n - 1] * 50 < most;
    const bool keeps_falling = d[n - 1] * d[n - 3] * 4 < d[n - 2] * d[n - 2] * 5;
    return falls && keeps_falling ? Trend::towards : Trend::unclear;
}

/// Does it grow without end? The logarithm of a bounded quantity rises by less and less.
Trend infinite_trend(const std::vector<Real>& f) {
    const std::size_t n = f.size();
    for (const Real& value : f) {
        if (value == 0) {
            return Trend::unclear;
        }
    }
    const Real last = log(Real(abs(f[n - 1] / f[n - 2])));
    const Real before = log(Real(abs(f[n - 2] / f[n - 3])));
    if (last <= 0 || last * 2 < before) {
        return Trend::away;
    }
    return before > 0 && abs(f[n - 1]) > abs(f[0]) * 10 ? Trend::towards : Trend::unclear;
}

Outcome check_limit(const Claim& claim, const AuditContext& context) {
    const bool infinite = claim.text("limit") == "infinity";
    const formula::Expr of = claim.formula("of");
    const ParameterSweep sweep(claim, context, context.digits());
    const PrecisionScope scope(context.digits() + 20);
    const Real noise = pow(Real(10), 5 - static_cast<int>(context.digits()));
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"))
        .add("limit", claim.text("limit"))
        .add("along", sweep.name())
        .add("values_taken", sweep.values())
        .add("samples", sweep.samples());
    Trend worst = Trend::towards;
    std::string against;
    std::optional<Difference> apart;
    for (std::size_t k = 0; k < sweep.samples(); ++k) {
        std::vector<Real> f;
        std::vector<std::string> texts;
        for (std::size_t j = 0; j < sweep.values().size(); ++j) {
            f.push_back(sweep.sample_at(j, k).evaluate(of).value);
            texts.push_back(value_text(f.back(), 12));
            if (!isfinite(f.back())) {
                outcome.note = "not evaluated here: a number beyond the range of the arithmetic";
                return outcome;
            }
        }
        const EvaluatedSample& last = sweep.sample_at(sweep.values().size() - 1, k);
        const Trend trend =
            infinite ? infinite_trend(f)
                     : finite_trend(f, last.evaluate(claim.formula("limit")).value, noise);
        if (k == 0 || (trend != Trend::towards && worst == Trend::towards)) {
            outcome.evidence.add("at", last.text).add("values", texts);
        }
        if (trend == Trend::away && worst != Trend::away) {
            worst = trend;
            against = last.text;
            // The last value and the limit, or where there is none two values that do not grow.
            apart = infinite
                        ? Difference::not_above(Real(abs(f[f.size() - 2]) * 2), Real(abs(f.back())))
                        : Difference::of(last.evaluate(claim.formula("limit")).value, f.back(),
                                         Real(0));
        } else if (trend == Trend::unclear && worst == Trend::towards) {
            worst = trend;
        }
    }
    const std::string samples = std::to_string(sweep.samples()) + " samples";
    switch (worst) {
    case Trend::towards:
        outcome.verdict = NotRefuted::confirmed;
        outcome.note =
            (infinite ? "grows without end at " : "the distance from the limit dies away at ") +
            samples + " (sampled)";
        break;
    case Trend::away:
        outcome.verdict = Judgement(apart);
        outcome.note = (infinite ? "does not grow without end: " : "goes elsewhere: ") + against;
        break;
    case Trend::unclear:
        outcome.note = "more values along " + sweep.name() + " might decide";
        break;
    }
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
