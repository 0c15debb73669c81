// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

constexpr int first_rung = 20; // decades from the length of the contact
constexpr int rungs_to_the_edge = 4;
constexpr int decades_per_rung = 2;
/// What the measured orders and the constants may differ by.
constexpr const char* order_tolerance = "1e-6";
/// A constant is a pure number of order one if over the family it varies by less than this.
constexpr int most_spread = 100;

/// One scene: the order of `of`, that of `says`, and the limit of of/says at the edge.
struct OrderInScene {
    std::string text;
    Real order;
    Real order_said;
    Real ratio;
    bool clear = true; ///< neighbouring steps agree
};

Real slope(const Real& near, const Real& far, const Real& decades) {
    return log10(Real(far / near)) / decades;
}

/// nullopt where `says` is zero: nothing is of the order of zero.
std::optional<OrderInScene> measure(const EvaluatedScene& scene_values, const Sample& sample,
                                    const formula::Expr& of, const formula::Expr& says,
                                    const std::string& text) {
    OrderInScene found;
    found.text = text;
    std::vector<Real> f;
    std::vector<Real> g;
    const Variables variables = scene_values.values_of(sample.variables);
    for (int k = 0; k < rungs_to_the_edge; ++k) {
        const Real u = scene_values.length() * pow(Real(10), -(first_rung + k * decades_per_rung));
        const Place place = scene_values.place_at_u(sample.edge, u);
        f.push_back(abs(scene_values.evaluate(of, &place, variables).value));
        g.push_back(abs(scene_values.evaluate(says, &place, variables).value));
        if (g.back() == 0) {
            return std::nullopt;
        }
        if (f.back() == 0) {
            found.clear = false;
            return found;
        }
    }
    const std::size_t last = f.size() - 1;
    const Real step(decades_per_rung);
    found.order = slope(f[last], f[last - 1], step);
    found.order_said = slope(g[last], g[last - 1], step);
    found.ratio = f[last] / g[last];
    const Real before = slope(f[last - 1], f[last - 2], step);
    found.clear = isfinite(found.order_said) && isfinite(found.ratio) &&
                  abs(found.order - before) < Real(order_tolerance);
    return found;
}

struct Scenes {
    std::vector<OrderInScene> all;
    std::size_t left_out = 0; ///< where `says` is zero or `where` does not hold
};

Scenes measure_all(const Claim& claim, const AuditContext& context, const formula::Expr& says) {
    const formula::Expr of = claim.formula("of");
    // Errors near the edge are differences of nearly equal numbers.
    const unsigned digits =
        context.digits() + first_rung + rungs_to_the_edge * decades_per_rung + 20;
    Scenes scenes;
    const PrecisionScope scope(digits + 20);
    for (const Sample& sample : context.samples(claim)) {
        const EvaluatedScene scene_values(sample.scene, digits);
        if (claim.has("where") && !scene_values.holds(claim.condition("where"))) {
            ++scenes.left_out;
            continue;
        }
        if (auto found = measure(scene_values, sample, of, says,
                                 sample.scene.family + ": " + sample.scene.text())) {
            scenes.all.push_back(std::move(*found));
        } else {
            ++scenes.left_out;
        }
    }
    return scenes;
}

Judgement judge(const Scenes& scenes, bool universal, std::string& note) {
    if (scenes.all.empty()) {
        note = "no scene admits the claim";
        return NotRefuted::undecided;
    }
    const Real slack(order_tolerance);
    bool higher = false;
    for (const OrderInScene& s : scenes.all) {
        if (!s.clear) {
            note = "the order is not determined in " + s.text;
            return NotRefuted::undecided;
        }
        if (s.order < s.order_said - slack) {
            note = "of order " + to_decimal(s.order, 4) + ", not " + to_decimal(s.order_said, 4) +
                   ", in " + s.text;
            return Judgement(Difference::not_above(Real(s.order_said - slack), s.order));
        }
        higher = higher || s.order > s.order_said + slack;
    }
    if (higher) {
        note = "of a higher order than is said";
        return NotRefuted::imprecise;
    }
    const auto [least, most] = std::minmax_element(
        scenes.all.begin(), scenes.all.end(),
        [](const OrderInScene& x, const OrderInScene& y) { return x.ratio < y.ratio; });
    if (universal && most->ratio > least->ratio * most_spread) {
        note = "the factor is no pure number: from " + to_decimal(least->ratio, 4) + " to " +
               to_decimal(most->ratio, 4) + " over the scenes";
        return Judgement(Difference::of(least->ratio, most->ratio, Real(0)));
    }
    note = "the order is that claimed in " + std::to_string(scenes.all.size()) + " scenes";
    if (universal) {
        note += "; the factor lies between " + to_decimal(least->ratio, 4) + " and " +
                to_decimal(most->ratio, 4);
    }
    return NotRefuted::confirmed;
}

void report(const Scenes& scenes, Evidence& evidence) {
    evidence.add("scenes", scenes.all.size());
    if (scenes.left_out > 0) {
        evidence.add("scenes_left_out", scenes.left_out);
    }
    if (scenes.all.empty()) {
        return;
    }
    const auto range = [&](auto&& value) {
        Real least = value(scenes.all.front());
        Real most = least;
        for (const OrderInScene& s : scenes.all) {
            least = std::min(least, Real(value(s)));
            most = std::max(most, Real(value(s)));
        }
        return std::vector<std::string>{to_decimal(least, 10), to_decimal(most, 10)};
    };
    evidence.add("order", range([](const OrderInScene& s) { return s.order; }))
        .add("order_said", range([](const OrderInScene& s) { return s.order_said; }))
        .add("factor", range([](const OrderInScene& s) { return s.ratio; }));
}

Outcome check_order(const Claim& claim, const AuditContext& context) {
    const bool universal = claim.text_or("factor", "of-the-scene") == "pure-number";
    const PrecisionScope scope(context.digits() + 20);
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"));
    const Scenes scenes = measure_all(claim, context, claim.formula("says"));
    outcome.verdict = judge(scenes, universal, outcome.note);
    report(scenes, outcome.evidence);
    if (!holds(outcome.verdict) && claim.has("candidates")) {
        for (std::size_t i = 0; i < claim.list("candidates").size(); ++i) {
            const std::string& text = claim.list("candidates")[i];
            const Scenes anew = measure_all(claim, context, claim.formulas("candidates")[i]);
            std::string note;
            if (judge(anew, universal, note) == Verdict::confirmed) {
                outcome.correct = text;
                Evidence corrected;
                report(anew, corrected);
                outcome.evidence.add("with_the_correction", corrected);
                break;
            }
        }
    }
    return outcome;
}

} // namespace

CheckKind order_kind() {
    using Type = KeySpec::Type;
    return {"order",
            {required_formula("says"),
             required_formula("of"),
             {.name = "factor", .type = Type::choice, .choices = {"of-the-scene", "pure-number"}},
             {.name = "candidates", .type = Type::formulas}},
            check_order};
}

} // namespace edgeproof::audit
