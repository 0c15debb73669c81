// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/decimal_fit.hpp"
#include "edgeproof/audit/diagnosis/diagnosis.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/audit/ledger/printed_formula.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace edgeproof::audit {
namespace {

/// The powers of a length and of a pressure in a parameter.
struct Powers {
    int length = 0;
    int pressure = 0;
};

const std::map<std::string_view, Powers>& known_parameters() {
    static const std::map<std::string_view, Powers> known{
        {"m", {}},     {"phi", {}},      {"alpha", {}},    {"a", {1, 0}}, {"t", {1, 0}},
        {"R", {1, 0}}, {"Es", {0, 1}},   {"P", {1, 1}},    {"M", {2, 1}}, {"Q", {1, 1}},
        {"f", {}},     {"friction", {}}, {"sig0", {0, 1}}, {"nu", {}},
    };
    return known;
}

/// Returns samples that the family of a claim may not contain, to test corrections: a formula with
/// the right value at a few samples may be right by chance, such as P/Pi for 2 P/(Pi a) if a = 2.
/// Of a power law with given a, the constant, a and E* are changed one by one; of other profiles
/// all lengths, and then all moduli and forces, by a common factor. None if the sample has
/// parameters or variables of other kinds.
std::vector<Sample> other_contacts(const Sample& sample) {
    const auto& parameters = sample.scene.parameters;
    const bool power_law = sample.scene.profile == "power-law";
    if (!sample.variables.empty() || !sample.scene.knots.empty() ||
        sample.scene.as_scene()->round) {
        return {};
    }
    for (const auto& [name, value] : parameters) {
        if (!known_parameters().contains(name) && !(power_law && name == "C")) {
            return {};
        }
    }
    std::vector<Sample> others;
    const auto add = [&](const auto& factor_of) {
        Sample other = sample;
        for (auto& [name, value] : other.scene.parameters) {
            if (const Rational factor = factor_of(name); factor != 1) {
                value = Exact(value.expr() * Expr::number(factor));
            }
        }
        others.push_back(std::move(other));
    };
    const bool plain = parameters.size() == 4 && parameters.contains("m") &&
                       parameters.contains("C") && parameters.contains("a") &&
                       parameters.contains("Es");
    if (power_law && plain) {
        const std::pair<std::string_view, Rational> changes[] = {{"a", Rational(7, 5)},
                                                                 {"C", Rational(3, 5)},
                                                                 {"Es", Rational(11, 7)},
                                                                 {"a", Rational(5, 9)}};
        for (const auto& change : changes) {
            add([&change](const std::string& name) {
                return name == change.first ? change.second : Rational(1);
            });
        }
    } else if (!power_law) {
        add([](const std::string& name) {
            const int power = known_parameters().at(name).length;
            return power == 0 ? Rational(1) : power == 1 ? Rational(7, 5) : Rational(49, 25);
        });
        add([](const std::string& name) {
            return known_parameters().at(name).pressure == 0 ? Rational(1) : Rational(11, 7);
        });
    }
    return others;
}

constexpr unsigned most_fitted_digits = 100; ///< for numbers in place of decimals
constexpr std::size_t most_with_integrals = 8;
constexpr unsigned screening_digits = 10;

/// Returns the distance of a sample from a fifth of the contact's length, in decades.
double away_from(const Sample& sample) {
    return sample.fraction ? std::abs(std::log10(5 * sample.fraction->to<double>())) : 0;
}
constexpr std::size_t most_screening_samples = 4;

/// Returns a test of candidates for a correction in numbers, to a few digits: true for a formula
/// (as written in the claim) that has the exact value at a few samples of the claim and at other
/// contacts. It refers to the claim.
std::function<bool(const Expr&)> screening(const Claim& claim, const AuditContext& context) {
    using Point = std::pair<EnclosedSample, Real>; // with the exact value
    const auto points = std::make_shared<std::vector<Point>>();
    const PrecisionScope digits(screening_digits + 10);
    const auto add_contact = [&](const Sample& sample) {
        try {
            EnclosedSample at(sample, 2 * formula::bits_for(screening_digits), screening_digits);
            Real exact = at.finite(claim.formula("of")).midpoint();
            points->emplace_back(std::move(at), std::move(exact));
        } catch (const Error&) {
            return; // no enclosure here
        }
    };
    std::vector<Sample> samples = context.samples(claim);
    // Samples far from the edge come first, as integrals converge fastest there.
    std::ranges::stable_sort(samples, {}, away_from);
    for (const Sample& sample : samples) {
        if (points->size() < most_screening_samples && is_admitted(claim, sample)) {
            add_contact(sample);
        }
    }
    if (!points->empty()) {
        std::ranges::for_each(other_contacts(samples.front()), add_contact);
    }
    return [&claim, points](const Expr& written) {
        const Expr e = expand_definitions(written, claim.vocabulary);
        const PrecisionScope scope(screening_digits + 10);
        const Real tolerance = pow(Real(10), -static_cast<int>(screening_digits - 2));
        return !points->empty() && std::ranges::all_of(*points, [&](const Point& point) {
            const auto& [at, exact] = point;
            return abs(at.finite(e).midpoint() - exact) <= tolerance * abs(exact);
        });
    };
}

/// The formulas `says` and `of` of a claim, compared at its samples; `scale`, if the claim has it,
/// is the reference for their difference.
class FormulaComparison {
public:
    /// `identical`: the formulas are proved to be equal in symbols.
    FormulaComparison(const Claim& claim, const AuditContext& context, bool identical)
        : claim_(claim), printed_(printed_formula(claim)), exact_(claim.formula("of")),
          scale_(claim.has("scale") ? std::optional(claim.formula("scale")) : std::nullopt),
          digits_(context.digits()), identical_(identical), samples_(claim, context),
          agreement_(claim.formula("says"), with()) {}

    [[nodiscard]] std::size_t samples() const { return samples_.all().size(); }
    /// Judges the printed formula by enclosures, and adds the note and the evidence: the digits,
    /// the samples, the worst sample and its enclosures. A printed formula with decimals is
    /// confirmed as it stands or with other numbers that round to them (then the evidence has
    /// `rounded`), and refuted if no such numbers fit. There must be samples.
    [[nodiscard]] Judgement judge(Outcome& outcome) const {
        report(outcome.evidence);
        if (printed_.is_exact()) {
            return agreement_.judge(outcome);
        }
        Outcome as_printed;
        const Decision found = agreement_.decide(as_printed);
        if (const auto* holds = std::get_if<Confirmation>(&found)) {
            outcome.evidence["enclosures"] = as_printed.evidence["enclosures"];
            outcome.note = as_printed.note;
            return Judgement(*holds);
        }
        return by_decimals(outcome);
    }
    /// True if the judged formula is refuted, or has no value at some samples, so that a correction
    /// is sought: not for a formula with decimals, for which `judge` has found numbers that fit.
    [[nodiscard]] bool needs_correction(const Outcome& outcome) const {
        return (outcome.verdict == Verdict::refuted ||
                outcome.verdict == Verdict::underspecified) &&
               printed_.is_exact();
    }
    /// True if a formula that the program made is confirmed at the samples, by enclosures, and not
    /// proved to differ at more digits.
    [[nodiscard]] bool confirms(const Expr& made) const {
        Outcome ignored;
        return audit::confirms(Agreement(made, with()).decide(ignored)) &&
               !provably_different(made, with());
    }
    /// Returns the data for the diagnosis: the formulas, the names of the claim and of the first
    /// sample's scene, and printed/exact at all samples, if it is recognised. Also adds the range
    /// of this ratio to the evidence.
    [[nodiscard]] RefutedFormula refuted(Evidence& evidence) const {
        RefutedFormula refuted;
        refuted.printed = claim_.written("says");
        refuted.exact = claim_.written("of");
        refuted.alphabet =
            alphabet_for(claim_, refuted.printed, refuted.exact, &samples_.all().front().scene);
        refuted.ratio = ratio(evidence);
        refuted.derived = of_cylinder();
        return refuted;
    }

private:
    [[nodiscard]] SampledComparison with() const {
        return {samples_, exact_, scale_, digits_, identical_};
    }
    void report(Evidence& evidence) const {
        evidence.update({{"samples", samples()}, {"scenes", samples_.scenes()}});
        if (samples_.left_out() > 0) {
            evidence["samples_left_out"] = samples_.left_out();
        }
        if (agreement_.screened() > 0) {
            evidence["samples_to_few_digits"] = agreement_.screened();
        }
        const Pair& worst = agreement_.worst();
        evidence.update(
            {{"digits", digits_text(std::min(worst.digits(), static_cast<double>(digits_)))},
             {"worst_at", full_text(samples_.all()[worst.sample])}});
        if (!worst.printed) {
            evidence[worst.no_value ? "no_value" : "limit"] =
                worst.no_value.value_or(worst.problem);
            return;
        }
        const unsigned shown = worst.digits() > 12 ? digits_ : 20;
        const auto text = [&](const Ball& value) {
            return contains_zero(value) && !value.is_exact()
                       ? "0 +- " + bound_text(abs(value).upper())
                       : value_text(value.midpoint(), shown);
        };
        evidence.update(
            {{"printed_there", text(*worst.printed)}, {"exact_there", text(*worst.exact)}});
    }
    /// One equation for each sample. Undecided if a sample has no enclosure.
    [[nodiscard]] Judgement by_decimals(Outcome& outcome) const {
        const unsigned digits = std::min(digits_, most_fitted_digits);
        const long bits = formula::bits_for(2 * digits + 30);
        const bool integrals = has_binder(printed_.named) || has_binder(exact_);
        const std::size_t most = std::min(samples(), integrals ? most_with_integrals : samples());
        std::vector<std::size_t> order = spread_first(samples(), most);
        order.resize(most);
        try {
            std::vector<DecimalEquation> equations;
            for (const std::size_t i : order) {
                equations.push_back(equation_at(samples_.all()[i], bits, digits + 15,
                                                printed_.named, exact_, scale_,
                                                printed_.as_printed));
            }
            return judge_decimals(printed_, equations, digits, bits, outcome);
        } catch (const Error& error) {
            outcome.note = std::string("no enclosure: ") + error.what();
            return {};
        }
    }
    /// Recognises printed/exact from all samples, and adds its range to the evidence.
    [[nodiscard]] std::optional<Expr> ratio(Evidence& evidence) const {
        std::vector<RatioSample> samples;
        const PrecisionScope scope(30);
        const auto add = [&](const Sample& sample, const EnclosedSample& at, const Ball& ratio) {
            std::map<std::string, Real, std::less<>> parameters;
            for (const auto* values : {&sample.variables, &sample.scene.parameters}) {
                for (const auto& [name, value] : *values) {
                    parameters.emplace(name, value.to<Real>());
                }
            }
            const Ball b = at.evaluate(Expr::symbol("b"));
            if (disjoint(b, at.evaluate(Expr::symbol("a")))) {
                parameters.emplace("b", at_working_precision(b.midpoint()));
                parameters.emplace("L", at_working_precision(at.length().midpoint()));
            }
            samples.push_back({std::move(parameters), at_working_precision(ratio.midpoint())});
        };
        for (const Pair& pair : agreement_.pairs()) {
            if (!pair.printed || contains_zero(*pair.exact)) {
                continue;
            }
            const Sample& sample = samples_.all()[pair.sample];
            add(sample, EnclosedSample(sample, formula::bits_for(40)), *pair.printed / *pair.exact);
        }
        if (samples.empty()) {
            return std::nullopt;
        }
        const auto [least, most] = std::ranges::minmax_element(samples, {}, &RatioSample::ratio);
        evidence["ratio_range"] =
            std::vector<std::string>{value_text(least->ratio, 12), value_text(most->ratio, 12)};
        for (const Sample& other : other_contacts(samples_.all().front())) {
            try {
                const EnclosedSample contact(other, formula::bits_for(30));
                const Ball off =
                    contact.evaluate(claim_.formula("says")) / contact.evaluate(exact_);
                if (off.is_finite()) {
                    add(other, contact, off);
                }
            } catch (const Error&) {
                continue;
            }
        }
        auto ratio = recognise_ratio(samples, 20);
        if (ratio) {
            ratio = substitute(*ratio, "L", Expr::symbol("a") + Expr::symbol("b"));
            evidence["ratio"] = to_text(*ratio);
        }
        return ratio;
    }
    /// The textbook's formula for a cylinder (johnson1985, section 4.2), if the formula should
    /// equal a, P or the pressure, and all contacts are cylinders: what is printed may be that of a
    /// sphere.
    [[nodiscard]] std::optional<Expr> of_cylinder() const {
        const bool cylinders = std::ranges::all_of(samples_.all(), [](const Sample& sample) {
            const SceneSpec& scene = sample.scene;
            const auto m = scene.parameters.find("m");
            return scene.profile == "power-law" && scene.geometry != "axisymmetric" &&
                   m != scene.parameters.end() && m->second == Exact::parse("1");
        });
        const Expr of = claim_.written("of");
        const bool by_load = !holds_symbol(claim_.written("says"), "a");
        const std::string name = to_text(of);
        const std::string text = name == "a"      ? "sqrt(4*P/(Pi*Es*C))"
                                 : name == "P"    ? "Pi/4*Es*C*a^2"
                                 : name == "p(0)" ? (by_load ? "sqrt(P*Es*C/Pi)" : "2*P/(Pi*a)")
                                 : name == "p(x)" ? "2*P/(Pi*a)*sqrt(1 - (x/a)^2)"
                                                  : "";
        try {
            return cylinders && !text.empty()
                       ? std::optional(parse_formula(text, claim_.vocabulary))
                       : std::nullopt;
        } catch (const Error&) { // a name that the claim does not have
            return {};
        }
    }
    const Claim& claim_;
    PrintedFormula printed_;
    Expr exact_;
    std::optional<Expr> scale_;
    unsigned digits_;
    bool identical_;
    ClaimSamples samples_;
    Agreement agreement_; ///< of the formula as it is printed
};

/// True for a formula in the derivatives of P and b, which the derived formula contains.
bool holds_derivative(const Expr& e) {
    return std::ranges::any_of(free_symbols(e), [](const std::string& name) {
        return order_behind(name, "P") || order_behind(name, "b");
    });
}

} // namespace

Outcome check_compare(const Claim& claim, const AuditContext& context) {
    if (claim.has("quoted")) {
        for (const char* const key : {"says", "scale", "given"}) {
            if (claim.has(key)) {
                claim.reject(key,
                             "a quoted number is compared by rounding, without " + std::string(key),
                             "write says or quoted, not both");
            }
        }
        return compare_figure(claim, context);
    }
    const SymbolicCase under = symbolic_case(claim, context);
    bool proved = false;            // identically equal to the derived form
    std::optional<Expr> derivation; // of the exact formula
    if (!claim.has("over") || !context.ledger().family(claim.text("over")).axisymmetric()) {
        try {
            proved = proved_equal(claim.formula("says"), claim.formula("of"), under);
            if (proved || holds_derivative(claim.formula("says"))) {
                derivation = derive(claim.formula("of"), under);
            }
        } catch (const Error&) {
            proved = false; // without algebra
        }
    }
    const FormulaComparison comparison(claim, context, proved);
    Outcome outcome;
    if (comparison.samples() == 0) {
        outcome.note = "no sample fulfils the condition";
        return outcome;
    }
    outcome.evidence["of"] = claim.text("of");
    if (proved) {
        outcome.evidence["derived"] = to_text(*derivation);
    }
    outcome.verdict = comparison.judge(outcome);
    if (proved && outcome.verdict == Verdict::confirmed && !is_rounded(outcome)) {
        outcome.verdict = Judgement::proved_by_symbols();
        outcome.note = "identically equal to the derived form; " + outcome.note;
    } else if (proved && outcome.verdict == Verdict::refuted) {
        outcome.verdict = {};
        outcome.note = "equal in symbols but not at the samples";
    } else if (comparison.needs_correction(outcome)) {
        RefutedFormula refuted = comparison.refuted(outcome.evidence);
        if (derivation) {
            refuted.derived = derivation;
        }
        refuted.passes_screening = screening(claim, context);
        refuted.is_right = [&](const Expr& e) {
            return comparison.confirms(expand_definitions(e, claim.vocabulary));
        };
        diagnose(refuted, outcome);
    }
    return outcome;
}

} // namespace edgeproof::audit
