// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/algebra/identity.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/audit/run.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <set>

namespace edgeproof::audit {
namespace {

constexpr unsigned shown_digits = 8;
constexpr unsigned proving_digits = 20;

/// Computes the parameters that depend on others (t = a*2/5) from the present values of these,
/// except those in `kept`.
void compute_dependent(SceneSpec& scene, const Family& family,
                       const std::set<std::string_view>& kept) {
    formula::Definitions given;
    for (const auto& [name, texts] : family.parameters) {
        const bool dependent = !free_symbols(texts.front()).empty() && !kept.contains(name);
        given.emplace(name, dependent ? texts.front() : scene.parameter(name).expr());
    }
    for (const auto& [name, value] : put_into_each_other(given)) {
        scene.parameters.insert_or_assign(name, Exact(value));
    }
}

/// Returns the drawn scene with simpler numbers: a, C, Es and R are 1 if the family gives them as
/// numbers, and the parameters that depend on others (t = a*2/5) are computed from them.
SceneSpec simplest_scene(const SceneSpec& drawn, const Family& family) {
    SceneSpec scene = drawn;
    for (const auto& [name, texts] : family.parameters) {
        const bool scale = name == "a" || name == "C" || name == "Es" || name == "R";
        const bool plain =
            std::ranges::all_of(texts, [](const Expr& e) { return free_symbols(e).empty(); });
        if (scale && plain) {
            scene.parameters.insert_or_assign(name, Exact::parse("1"));
        }
    }
    compute_dependent(scene, family, {});
    return scene;
}

std::string plain_text(const Exact& value) {
    return value.is_rational() ? exact_text(value.rational()) : value.text();
}

Evidence numbers_of(const SceneSpec& scene) {
    Evidence with;
    for (const auto& [name, value] : scene.parameters) {
        with.add(name, plain_text(value));
    }
    return with;
}

/// Returns a formula's value, rounded from its enclosure; empty if there is no enclosure.
std::string enclosed_decimal(const Expr& e, const Sample& sample) {
    const std::optional<Ball> value = enclosed(e, sample, proving_digits);
    if (!value) {
        return "";
    }
    std::string text = round_ball(*value, shown_digits).text;
    return text.empty() && value->is_finite() && algebra::proved_zero(e) ? "0" : text;
}

Sample simplest_sample(const Claim& claim, const AuditContext& context) {
    const std::vector<Sample> samples = context.samples(claim);
    if (samples.empty()) {
        throw Error("no sample");
    }
    Sample sample = samples.front();
    sample.scene = simplest_scene(sample.scene, context.ledger().family(sample.scene.family));
    return sample;
}

/// Returns the decimal with the fewest places that lies well between the two numbers.
Rational short_decimal_between(const Rational& x, const Rational& y) {
    const Rational low = std::min(x, y);
    const Rational high = std::max(x, y);
    const Rational middle = (low + high) / 2;
    Integer scale = 1;
    for (int places = 0; places < 12; ++places, scale *= 10) {
        const Integer nearest = numerator(Rational(middle * scale + Rational(1, 2))) /
                                denominator(Rational(middle * scale + Rational(1, 2)));
        const Rational candidate(nearest, scale);
        if (candidate > low + (high - low) / 10 && candidate < high - (high - low) / 10) {
            return candidate;
        }
    }
    return middle;
}

} // namespace

Rational quoted_number(const std::string& text) {
    const std::size_t percent = text.find(" %");
    const Rational number = parse_decimal(text.substr(0, percent));
    return percent == std::string::npos ? number : Rational(number / 100);
}

std::optional<QuotedReach> quoted_reach(const Claim& claim) {
    if (!claim.has("quoted") || !claim.has("of") || claim.formula("of").kind() != Expr::Kind::div) {
        return std::nullopt;
    }
    const Expr& reach = claim.formula("of").arg(0);
    const bool is_reach =
        reach.kind() == Expr::Kind::call && (reach.name() == "exit" || reach.name() == "measure");
    return is_reach
               ? std::optional(QuotedReach{reach.arg(0), reach.arg(1), claim.formula("of").arg(1)})
               : std::nullopt;
}

std::optional<Evidence> reach_counterexample(const RefutedReading& refuted,
                                             const AuditContext& context) {
    const Claim& claim = *refuted.claim;
    const auto reach = quoted_reach(claim);
    if (!reach || !refuted.outcome->computed || !claim.has("quoted")) {
        return std::nullopt;
    }
    const Rational quoted = quoted_number(claim.text("quoted"));
    const Rational computed = quoted_number(*refuted.outcome->computed);
    const Rational at = short_decimal_between(quoted, computed);
    Sample sample = simplest_sample(claim, context);
    const std::string side = claim.edge() == Edge::right ? "right" : "left";
    const Expr u = Expr::number(at) * reach->base; // the distance from the edge
    const Expr x = side == "right" ? Expr::symbol("a") - u : -Expr::symbol("b") + u;
    const Expr local = Expr::call(side + "_local", {reach->terms, x});
    const Expr pressure = Expr::call("p", {x});
    const Expr error = Expr::call("abs", {Expr::number(1) - local / pressure});
    const auto value = [&](const Expr& e) {
        return enclosed_decimal(expand_definitions(e, claim.vocabulary), sample);
    };
    Evidence found;
    found.add("with", numbers_of(sample.scene))
        .add("distance", exact_text(at))
        .add("of", to_text(reach->base))
        .add("terms", to_text(reach->terms))
        .add("edge", side)
        .add("approximation", value(local))
        .add("pressure", value(pressure))
        .add("error", value(error))
        .add("tolerance", to_text(reach->tolerance))
        .add("printed_means",
             quoted > computed ? "at most the tolerance" : "more than the tolerance");
    return found;
}

std::optional<Evidence> integral_counterexample(const RefutedReading& refuted,
                                                const AuditContext& context) {
    const Claim& claim = *refuted.claim;
    if (!claim.has("says") || !claim.has("of") || claim.kind != "compare") {
        return std::nullopt;
    }
    Sample sample = simplest_sample(claim, context);
    // The size is 2, so that a wrong power of it changes the value; the corner of the profile (if
    // any) is at 1, half of it.
    sample.scene.parameters.insert_or_assign("a", Exact::parse("2"));
    if (sample.scene.parameters.contains("t")) {
        sample.scene.parameters.insert_or_assign("t", Exact::parse("1"));
    }
    compute_dependent(sample.scene, context.ledger().family(sample.scene.family), {"a", "t"});
    sample.fraction = Exact::parse("1/2");
    Evidence found;
    found.add("with", numbers_of(sample.scene).add("x", "0"))
        .add("printed", claim.text("says"))
        .add("correct", refuted.outcome->correct.value_or(claim.text("of")))
        .add("printed_decimal", enclosed_decimal(claim.formula("says"), sample))
        .add("correct_decimal", enclosed_decimal(claim.formula("of"), sample));
    return found;
}

} // namespace edgeproof::audit
