// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <array>

namespace edgeproof::audit {
namespace {

/// Decades from the length of the contact down to the places, in two pairs. At these places even a
/// term with a factor of 1e-90 dominates.
constexpr std::array<int, 4> decades_of_places{150, 152, 300, 302};
constexpr int decades_per_pair = 2;
constexpr unsigned first_digits_of_places = 170; // initial digits of the enclosures
/// The tolerance for the measured orders and constants.
const Rational order_tolerance(1, 1000000); // NOLINT: a constant of a type without a literal
/// A constant counts as a pure number of order one if it varies by less than this over the family.
constexpr int most_spread = 100;

/// One scene in balls: the orders of `of` and of `says`, and the limit of of/says at the edge.
struct OrderInScene {
    std::string text;
    Ball order;
    Ball order_said;
    Ball ratio;
};

Ball slope(const Ball& near, const Ball& far) {
    return log(far / near) / (log(Ball(10, far.bits())) * decades_per_pair);
}

bool narrow(const Ball& x) {
    return x.is_finite() &&
           certainly_less(Ball(x.radius(), x.bits()), Ball(order_tolerance, x.bits()) / 10);
}

/// Evaluates both formulas at places successively nearer to the edge, with the given number of
/// bits. Returns nothing if the orders of neighbouring steps differ, or if the balls are too wide.
std::optional<OrderInScene> measure_at(EnclosedSample& at, Edge edge, const Expr& of,
                                       const Expr& says) {
    std::vector<Ball> f;
    std::vector<Ball> g;
    for (const int decades : decades_of_places) {
        at.set_place(edge, at.length() * pow_int(Ball(10, at.bits()), -decades));
        f.push_back(abs(at.evaluate(of)));
        g.push_back(abs(at.evaluate(says)));
    }
    const Ball before = slope(f[1], f[0]);
    OrderInScene found{"", slope(f[3], f[2]), slope(g[3], g[2]), f[3] / g[3]};
    const bool steady =
        narrow(found.order) && narrow(found.order_said) && found.ratio.is_finite() &&
        certainly_less(abs(found.order - before), Ball(order_tolerance, before.bits()));
    return steady ? std::optional(found) : std::nullopt;
}

struct Scenes {
    std::vector<OrderInScene> all;
    std::size_t left_out = 0; ///< scenes in which `says` is zero or `where` does not certainly hold
    std::string undetermined; ///< a scene in which the order could not be determined
};

Scenes measure_all(const Claim& claim, const AuditContext& context, const Expr& says) {
    const Expr of = claim.formula("of");
    Scenes scenes;
    for (const Sample& sample : context.samples(claim)) {
        SampleInBalls in_balls(sample, first_digits_of_places);
        if (claim.has("where") &&
            !confirms(decide(claim.condition("where"), in_balls, context.digits_needed()))) {
            ++scenes.left_out;
            continue;
        }
        std::optional<OrderInScene> found;
        bool says_zero = false;
        static_cast<void>(in_balls.until([&](EnclosedSample& at) {
            at.set_place(sample.edge, at.length() / 1000);
            const Ball said = at.evaluate(says);
            says_zero = arb_is_zero(said.data()) != 0;
            found = says_zero ? std::nullopt : measure_at(at, sample.edge, of, says);
            return says_zero || found.has_value();
        }));
        const std::string text = full_text(sample.scene);
        if (says_zero) {
            ++scenes.left_out; // no quantity has the order of zero
        } else if (!found) {
            scenes.undetermined = text;
        } else {
            found->text = text;
            scenes.all.push_back(std::move(*found));
        }
    }
    return scenes;
}

std::string short_text(const Ball& x, unsigned digits = 4) {
    return to_decimal(x.midpoint(), digits);
}

Judgement judge(const Scenes& scenes, bool universal, std::string& note) {
    if (!scenes.undetermined.empty() || scenes.all.empty()) {
        note = scenes.all.empty() && scenes.undetermined.empty()
                   ? "no scene fulfils the condition of the claim"
                   : "the order is not determined in " + scenes.undetermined;
        return {};
    }
    std::vector<Decision> as_said;
    std::optional<Confirmation> higher;
    for (const OrderInScene& s : scenes.all) {
        const Ball slack(order_tolerance, s.order.bits());
        if (const auto lower = Refutation::less(s.order, s.order_said - slack)) {
            note = "of order " + short_text(s.order) + ", not " + short_text(s.order_said) +
                   ", in " + s.text;
            return Judgement(*lower);
        }
        if (const auto above = Confirmation::less(s.order_said + slack, s.order)) {
            higher = above;
        }
        as_said.push_back(
            decision(std::nullopt, Confirmation::less(abs(s.order - s.order_said), slack)));
    }
    if (higher) {
        note = "of a higher order than claimed";
        return Judgement::imprecise(*higher);
    }
    const auto [least, most] = std::ranges::minmax_element(
        scenes.all, {}, [](const OrderInScene& s) { return s.ratio.midpoint(); });
    if (universal) {
        if (const auto apart = Refutation::less(least->ratio * most_spread, most->ratio)) {
            note = "the factor is not a pure number: from " + short_text(least->ratio) + " to " +
                   short_text(most->ratio) + " over the scenes";
            return Judgement(*apart);
        }
    }
    const Judgement all = Judgement::of_all(as_said);
    if (all == Verdict::confirmed) {
        note = "the order is that claimed in " + std::to_string(scenes.all.size()) + " scenes";
        if (universal) {
            note += "; the factor lies between " + short_text(least->ratio) + " and " +
                    short_text(most->ratio);
        }
    }
    return all;
}

void report(const Scenes& scenes, Evidence& evidence) {
    evidence.add("scenes", scenes.all.size());
    if (scenes.left_out > 0) {
        evidence.add("scenes_left_out", scenes.left_out);
    }
    if (scenes.all.empty()) {
        return;
    }
    const auto range = [&](Ball OrderInScene::*value) {
        const auto [least, most] = std::ranges::minmax_element(
            scenes.all, {}, [&](const OrderInScene& s) { return (s.*value).midpoint(); });
        return std::vector<std::string>{short_text(*least.*value, 10),
                                        short_text(*most.*value, 10)};
    };
    evidence.add("order", range(&OrderInScene::order))
        .add("order_said", range(&OrderInScene::order_said))
        .add("factor", range(&OrderInScene::ratio));
}

} // namespace

Outcome check_order(const Claim& claim, const AuditContext& context) {
    const bool universal = claim.text_or("factor", "of-the-scene") == "pure-number";
    const PrecisionScope scope(context.digits() + 20);
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"));
    const Scenes scenes = measure_all(claim, context, claim.formula("says"));
    outcome.verdict = judge(scenes, universal, outcome.note);
    report(scenes, outcome.evidence);
    for (const auto& [text, candidate] : named_formulas(claim, "candidates")) {
        if (holds(outcome.verdict) || outcome.correct) {
            break;
        }
        const Scenes anew = measure_all(claim, context, candidate);
        std::string note;
        if (judge(anew, universal, note) == Verdict::confirmed) {
            outcome.correct = text;
            Evidence corrected;
            report(anew, corrected);
            outcome.evidence.add("with_the_correction", corrected);
        }
    }
    return outcome;
}

} // namespace edgeproof::audit
