// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/algebra/identity.hpp"
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/run.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <set>

namespace edgeproof::audit {
namespace {

constexpr unsigned shown_digits = 8;
constexpr unsigned proving_digits = 20;

/// A number of a list and the effort to calculate with it.
struct Choice {
    Exact value;
    double effort;
};

double effort_of_text(const Exact& value) {
    return value.is_rational() ? effort_of(value.rational())
                               : 20 + static_cast<double>(value.text().size());
}

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
    const Enclosed value = enclosed(e, sample, proving_digits);
    if (!value.ball) {
        return "";
    }
    std::string text = round_ball(*value.ball, shown_digits).text;
    return text.empty() && value.ball->is_finite() && algebra::proved_zero(e) ? "0" : text;
}

/// Returns the middle of a formula's enclosure; throws Error if there is none.
Real middle_of(const Expr& e, const Sample& sample) {
    const Enclosed value = enclosed(e, sample, proving_digits);
    if (!value.ball) {
        throw Error(value.problem);
    }
    return value.ball->midpoint();
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

/// Reads "46 %" or "0.03" as a number.
Rational quoted_number(const std::string& text) {
    const std::size_t percent = text.find(" %");
    const Rational number = parse_decimal(text.substr(0, percent));
    return percent == std::string::npos ? number : Rational(number / 100);
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

std::optional<Evidence> reach_counterexample(const RefutedReading& refuted,
                                             const AuditContext& context) {
    const Claim& claim = *refuted.claim;
    if (!refuted.outcome->computed || !claim.has("quoted")) {
        return std::nullopt;
    }
    const Rational quoted = quoted_number(claim.text("quoted"));
    const Rational computed = quoted_number(*refuted.outcome->computed);
    const Rational at = short_decimal_between(quoted, computed);
    Sample sample = simplest_sample(claim, context);
    const std::string side = claim.edge() == Edge::right ? "right" : "left";
    const std::string terms = claim.text("terms");
    // The distance from the edge is u = at * base.
    const std::string u = "(" + exact_text(at) + ")*(" + claim.text("base") + ")";
    const std::string x = side == "right" ? "a-" + u : "-b+" + u;
    const auto read = [&](const std::string& text) {
        return expand_definitions(parse_formula(text, claim.vocabulary), claim.vocabulary);
    };
    const std::string local = side + "_local(" + terms + "," + x + ")";
    Evidence found;
    found.add("with", numbers_of(sample.scene))
        .add("distance", exact_text(at))
        .add("of", claim.text("base"))
        .add("terms", terms)
        .add("edge", side)
        .add("approximation", enclosed_decimal(read(local), sample))
        .add("pressure", enclosed_decimal(read("p(" + x + ")"), sample))
        .add("error", enclosed_decimal(read("abs(1-" + local + "/p(" + x + "))"), sample))
        .add("tolerance", claim.text("tolerance"))
        .add("printed_means",
             quoted > computed ? "at most the tolerance" : "more than the tolerance");
    return found;
}

std::optional<Evidence> course_counterexample(const RefutedReading& refuted,
                                              const AuditContext& context) {
    const Claim& claim = *refuted.claim;
    const std::string along = claim.text("along");
    const bool rising = claim.text("sense") == "increasing";
    const Expr& of = claim.formula("of");
    Sample base = simplest_sample(claim, context);
    const Family& family = context.ledger().family(base.scene.family);
    const bool of_scene = base.scene.parameters.contains(along);
    const auto choices_of = [&](const std::vector<Expr>& texts) {
        std::vector<Choice> choices;
        for (Expr e : texts) {
            for (const auto& [name, value] : base.scene.parameters) {
                e = substitute(e, name, value.expr());
            }
            const Exact value(e);
            choices.push_back({value, effort_of_text(value)});
        }
        return choices;
    };
    const auto texts_of = [&](const std::string& name) -> std::vector<Expr> {
        for (const auto& [parameter, texts] : family.parameters) {
            if (parameter == name) {
                return texts;
            }
        }
        std::vector<Expr> texts;
        for (const auto& [variable, list] : claim.table("vary")) {
            if (variable == name) {
                for (const std::string& text : list) {
                    texts.push_back(parse_formula(text, claim.vocabulary));
                }
            }
        }
        return texts;
    };
    // If the parameter is a place, the shape of the body can be chosen, too.
    const bool has_shape = !of_scene && base.scene.parameters.contains("m");
    std::vector<Choice> shapes{{Exact::parse("1"), 0}};
    if (has_shape) {
        shapes = choices_of(texts_of("m"));
        std::ranges::stable_sort(shapes, {}, &Choice::effort);
    }
    const std::vector<Choice> steps = choices_of(texts_of(along));
    double least = 0;
    std::optional<Evidence> clearest;
    for (const Choice& shape : shapes) {
        if (has_shape) {
            base.scene.parameters.insert_or_assign("m", shape.value);
        }
        std::vector<std::pair<Real, Sample>> values;
        for (const Choice& step : steps) {
            Sample at = base;
            if (of_scene) {
                at.scene.parameters.insert_or_assign(along, step.value);
            } else {
                at.variables.insert_or_assign(along, step.value);
            }
            values.emplace_back(middle_of(of, at), at);
        }
        for (std::size_t i = 0; i < steps.size(); ++i) {
            for (std::size_t j = i + 1; j < steps.size(); ++j) {
                const Real change = values[j].first - values[i].first;
                const Real size = std::max(Real(abs(values[i].first)), Real(abs(values[j].first)));
                const bool against = (rising ? change < 0 : change > 0) && abs(change) * 20 > size;
                const double effort = shape.effort + steps[i].effort + steps[j].effort;
                if (!against || (clearest && effort >= least)) {
                    continue;
                }
                const std::string first = enclosed_decimal(of, values[i].second);
                const std::string second = enclosed_decimal(of, values[j].second);
                if (first.empty() || second.empty()) {
                    continue;
                }
                least = effort;
                Evidence found;
                found.add("with", numbers_of(base.scene))
                    .add("along", along)
                    .add("of", claim.text("of"))
                    .add("first_at", plain_text(steps[i].value))
                    .add("first", first)
                    .add("second_at", plain_text(steps[j].value))
                    .add("second", second)
                    .add("claimed", rising ? "grows" : "falls");
                if (base.fraction) {
                    found.add("place", "u = " + base.fraction->text() + " of a + b");
                }
                clearest = std::move(found);
            }
        }
        if (clearest) {
            break; // the shapes are sorted by effort, so that the first success is the clearest
        }
    }
    return clearest;
}

std::optional<Evidence> vanishing_counterexample(const RefutedReading& refuted,
                                                 const AuditContext& /*context*/) {
    const Claim& claim = *refuted.claim;
    if (claim.text_or("ratio", "") != "sig0*d/Q") {
        return std::nullopt;
    }
    // A Hertzian contact of half-width d = 1; Q = 3 pi cancels pi in the ratio.
    Sample sample;
    sample.scene = {"", "power-law", {}, {}, {}};
    for (const char* name : {"m", "C", "a", "Es"}) {
        sample.scene.parameters.emplace(name, Exact::parse("1"));
    }
    const Exact force = Exact::parse("3*Pi");
    const Exact tension(claim.formula("says") * force.expr());
    sample.scene.parameters.emplace("Q", force);
    sample.scene.parameters.emplace("sig0", tension);
    const std::string value = enclosed_decimal(claim.formula("of"), sample);
    const std::string ratio = to_decimal(tension.to<Real>(), shown_digits);
    if (value.empty()) {
        return std::nullopt;
    }
    Evidence found;
    found.add("with", Evidence().add("d", "1").add("Q", "3*Pi").add("sig0", ratio))
        .add("of", claim.text("of"))
        .add("value", value)
        .add("claimed_value", "0");
    return found;
}

std::optional<Evidence> integral_counterexample(const RefutedReading& refuted,
                                                const AuditContext& context) {
    const Claim& claim = *refuted.claim;
    if (!claim.has("says") || !claim.has("of") || claim.kind != "value") {
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
