// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/algebra/identity.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/audit/run.hpp"
#include "edgeproof/audit/symbolic/symbolic.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace edgeproof::audit {
namespace {

/// The printed and the correct formula, or those of the first wrong coefficient of an expansion.
std::optional<WrongCoefficient> formulas_of(const SpokenOf& refuted) {
    if (refuted.outcome->wrong_coefficient) {
        return refuted.outcome->wrong_coefficient;
    }
    const Expr* printed = refuted.claim->find_written("says");
    if (printed == nullptr || !refuted.outcome->correct) {
        return std::nullopt;
    }
    return WrongCoefficient{"", *printed,
                            parse_formula(*refuted.outcome->correct, refuted.claim->vocabulary)};
}

std::vector<Rational> candidates_for(const std::string& name) {
    static const std::set<std::string, std::less<>> may_vanish{"P2", "P3", "P4", "b2",
                                                               "b3", "b4", "x",  "xhat"};
    if (name == "gam") { // b/a < 1; both values have a rational square root
        return {Rational(1, 4), Rational(4, 9)};
    }
    if (name == "sigma" || name == "delta") { // between 0 and 1
        return {Rational(1, 2), Rational(3, 4), Rational(1, 4)};
    }
    std::vector<Rational> values{1, 2, 3, 4, 5};
    if (may_vanish.contains(name)) {
        values.insert(values.begin(), 0);
    }
    if (name == "x" || name == "xhat") {
        for (const Rational& fraction : {Rational(1, 2), Rational(3, 2), Rational(3, 5)}) {
            values.push_back(fraction);
        }
    } else if (name == "b") {
        values.push_back(Rational(1, 4));
    } else {
        values.resize(std::min<std::size_t>(values.size(), name.size() == 2 ? 3 : 5));
    }
    return values;
}

/// Returns a measure of the effort to calculate with a number by hand.
double effort_of(const Rational& value) {
    const Rational size = abs(value);
    const double top = Integer(numerator(size)).convert_to<double>();
    const double below = Integer(denominator(size)).convert_to<double>();
    return top + (below == 1 ? 0 : 2 * below);
}

using Assignment = std::map<std::string, Rational, std::less<>>;

const Rational* value_in(const Assignment& values, std::string_view name) {
    const auto it = values.find(name);
    return it == values.end() ? nullptr : &it->second;
}

/// True if the numbers describe a possible contact.
bool admissible(const Assignment& v) {
    const auto less = [&](std::string_view x, std::string_view y) {
        const Rational* left = value_in(v, x);
        const Rational* right = value_in(v, y);
        return left == nullptr || right == nullptr || *left < *right;
    };
    const Rational* a = value_in(v, "a");
    const Rational* b = value_in(v, "b");
    const Rational* gam = value_in(v, "gam");
    const Rational* S = value_in(v, "S");
    const Rational* X = value_in(v, "X");
    return less("x", "a") && less("t", "a") && less("xhat", "d") &&
           (a == nullptr || b == nullptr || gam == nullptr || *b == *gam * *a) &&
           (S == nullptr || X == nullptr || *S <= *X);
}

/// Returns all assignments in the order of their effort.
std::vector<std::pair<double, Assignment>> assignments(const std::set<std::string>& names) {
    constexpr std::size_t most = 20'000;
    std::vector<std::pair<double, Assignment>> all{{0.0, {}}};
    for (const std::string& name : names) {
        std::vector<std::pair<double, Assignment>> next;
        for (const auto& [effort, values] : all) {
            for (const Rational& value : candidates_for(name)) {
                Assignment more = values;
                more.insert_or_assign(name, value);
                if (admissible(more)) {
                    next.emplace_back(effort + effort_of(value), std::move(more));
                }
            }
        }
        std::ranges::stable_sort(next, {}, [](const auto& entry) { return entry.first; });
        next.resize(std::min(next.size(), most));
        all = std::move(next);
    }
    return all;
}

Expr with_values(Expr e, const Assignment& values) {
    for (const auto& [name, value] : values) {
        e = substitute(e, name, Expr::number(value));
    }
    return e;
}

std::optional<Ball> constant_ball(const Expr& e) {
    constexpr long bits = 200;
    try {
        return formula::enclose(e, bits);
    } catch (const Error&) {
        return std::nullopt; // not defined for these numbers
    }
}

/// Returns the simplest exact form of a constant, checked against its enclosure.
std::optional<std::string> exact_form(const Expr& constant, const Ball& ball) {
    try {
        const Expr simple = derive(constant, {});
        const std::optional<Ball> same = constant_ball(simple);
        std::string text = to_text(simple);
        constexpr std::size_t most = 40; // a longer text is too hard to compare by eye
        return same && overlaps(*same, ball) && text.size() <= most ? std::optional(std::move(text))
                                                                    : std::nullopt;
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// True if the two values are disjoint and differ by more than a fifth of the larger one.
bool clearly_apart(const Ball& x, const Ball& y) {
    const Real larger = std::max(Real(abs(x.midpoint())), Real(abs(y.midpoint())));
    return disjoint(x, y) && abs(x.midpoint() - y.midpoint()) * 5 > larger;
}

/// Returns a constant rounded for reading; "0" if it is proved to be zero. Empty if the ball has no
/// certain digit.
std::string decimal_of(const Expr& constant, const Ball& ball) {
    constexpr unsigned digits = 8;
    std::string text = round_ball(ball, digits).text;
    return text.empty() && algebra::proved_zero(constant) ? "0" : text;
}

double effort_to_read(const std::string& exact) {
    double effort = static_cast<double>(exact.size()) / 3;
    for (const std::string_view hard : {"sqrt", "log", "asin", "^("}) {
        for (std::size_t at = 0; (at = exact.find(hard, at)) != std::string::npos; ++at) {
            effort += 3;
        }
    }
    return effort;
}

std::optional<Evidence> formula_counterexample(const SpokenOf& refuted) {
    const auto pair = formulas_of(refuted);
    if (!pair || has_binder(pair->printed) || has_binder(pair->correct)) {
        return std::nullopt;
    }
    std::set<std::string> names = free_symbols(pair->printed);
    names.merge(free_symbols(pair->correct));
    constexpr std::size_t enough = 24; // the clearest of this number of candidates is chosen
    std::size_t seen = 0;
    double least = 0;
    std::optional<Evidence> clearest;
    for (const auto& [effort, values] : assignments(names)) {
        const Expr printed = with_values(pair->printed, values);
        const Expr correct = with_values(pair->correct, values);
        const std::optional<Ball> x = constant_ball(printed);
        const std::optional<Ball> y = constant_ball(correct);
        if (!x || !y || !clearly_apart(*x, *y)) {
            continue;
        }
        const std::optional<std::string> printed_value = exact_form(printed, *x);
        const std::optional<std::string> correct_value = exact_form(correct, *y);
        constexpr double effort_without = 30; // for a value that has no short exact form
        const double total = effort +
                             (printed_value ? effort_to_read(*printed_value) : effort_without) +
                             (correct_value ? effort_to_read(*correct_value) : effort_without);
        if (!clearest || total < least) {
            least = total;
            Evidence with = Evidence::object();
            for (const auto& [name, value] : values) {
                with[name] = exact_text(value);
            }
            Evidence found;
            if (!pair->of.empty()) {
                found["coefficient_of"] = pair->of;
            }
            found.update({{"with", std::move(with)},
                          {"printed", to_text(pair->printed)},
                          {"correct", to_text(pair->correct)}});
            if (printed_value && correct_value) {
                found.update(
                    {{"printed_value", *printed_value}, {"correct_value", *correct_value}});
            }
            found.update({{"printed_decimal", decimal_of(printed, *x)},
                          {"correct_decimal", decimal_of(correct, *y)}});
            clearest = std::move(found);
        }
        if (++seen == enough) {
            break;
        }
    }
    return clearest;
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

Evidence numbers_of(const SceneSpec& scene) {
    Evidence with = Evidence::object();
    for (const auto& [name, value] : scene.parameters) {
        with[name] = value.is_rational() ? exact_text(value.rational()) : value.text();
    }
    return with;
}

/// Returns a formula's value, rounded from its enclosure; empty if there is no enclosure.
std::string enclosed_decimal(const Expr& e, const Sample& sample) {
    constexpr unsigned proving_digits = 20;
    const std::optional<Ball> value = enclosed(e, sample, proving_digits);
    return value ? decimal_of(e, *value) : "";
}

/// Returns the first sample with simpler numbers: a, C, Es and R are 1 if the family gives them as
/// numbers, and the parameters that depend on others (t = a*2/5) are computed from them.
Sample simplest_sample(const Claim& claim, const AuditContext& context) {
    const std::vector<Sample> samples = context.samples(claim);
    if (samples.empty()) {
        throw Error("no sample");
    }
    Sample sample = samples.front();
    const Family& family = context.ledger().family(sample.scene.family);
    for (const auto& [name, texts] : family.parameters) {
        const bool scale = name == "a" || name == "C" || name == "Es" || name == "R";
        if (scale &&
            std::ranges::all_of(texts, [](const Expr& e) { return free_symbols(e).empty(); })) {
            sample.scene.parameters.insert_or_assign(name, Exact::parse("1"));
        }
    }
    compute_dependent(sample.scene, family, {});
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

std::optional<Evidence> reach_counterexample(const SpokenOf& refuted, const AuditContext& context) {
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
    return Evidence{
        {"with", numbers_of(sample.scene)},
        {"distance", exact_text(at)},
        {"of", to_text(reach->base)},
        {"terms", to_text(reach->terms)},
        {"edge", side},
        {"approximation", value(local)},
        {"pressure", value(pressure)},
        {"error", value(error)},
        {"tolerance", to_text(reach->tolerance)},
        {"printed_means", quoted > computed ? "at most the tolerance" : "more than the tolerance"}};
}

std::optional<Evidence> integral_counterexample(const SpokenOf& refuted,
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
    Evidence with = numbers_of(sample.scene);
    with["x"] = "0";
    return Evidence{{"with", with},
                    {"printed", claim.text("says")},
                    {"correct", refuted.outcome->correct.value_or(claim.text("of"))},
                    {"printed_decimal", enclosed_decimal(claim.formula("says"), sample)},
                    {"correct_decimal", enclosed_decimal(claim.formula("of"), sample)}};
}

} // namespace

SpokenOf spoken_of(const ClaimResult& result) {
    SpokenOf found{&result.claim, &result.outcome};
    for (std::size_t i = 0; i < result.readings.size(); ++i) {
        if (result.readings[i].second.verdict == Verdict::refuted) {
            found = {&result.claim.readings[i], &result.readings[i].second};
        }
    }
    return found;
}

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

std::optional<Evidence> clearest_counterexample(const ClaimResult& result,
                                                const AuditContext& context) {
    if (result.outcome.verdict != Verdict::refuted) {
        return std::nullopt;
    }
    const SpokenOf refuted = spoken_of(result);
    try {
        if (quoted_reach(*refuted.claim)) {
            return reach_counterexample(refuted, context);
        }
        auto found = formula_counterexample(refuted);
        return found ? found : integral_counterexample(refuted, context);
    } catch (const Interrupted&) {
        throw;
    } catch (const Error&) { // no simple counterexample was found; the verdict does not need one
        return std::nullopt;
    }
}

} // namespace edgeproof::audit
