// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"
#include "edgeproof/audit/sample/formal_values.hpp"
#include "edgeproof/formula/exact/exact_ball.hpp"
#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace edgeproof::audit {
namespace {

constexpr std::size_t formal_draws = 3;

/// Names of two formulas, and those that the functions along the family of contacts expand into.
std::set<std::string> names_of(const formula::Expr& x, const formula::Expr& y) {
    std::set<std::string> names = free_symbols(x);
    names.merge(free_symbols(y));
    for (unsigned k = 1; k <= 9; ++k) {
        names.insert("P" + std::to_string(k));
        names.insert("b" + std::to_string(k));
    }
    return names;
}

/// Numbers for all symbols: what differs there differs, whatever the symbols say.
std::vector<FormalValues> draw_values(const std::set<std::string>& names,
                                      const SymbolicCase& under) {
    std::vector<FormalValues> values;
    for (std::size_t k = 0; k < formal_draws; ++k) {
        values.emplace_back(names, under, k);
    }
    return values;
}

bool close(const Real& x, const Real& y) {
    const PrecisionScope scope(FormalValues::digits);
    return abs(x - y) <= pow(Real(10), -30) * (abs(x) + abs(y));
}

/// The coefficients differ in numbers, at every draw where both have a value.
std::optional<Difference> differ(const ExpansionComparison::Term& term,
                                 const std::vector<FormalValues>& values) {
    std::optional<Difference> found;
    for (const FormalValues& v : values) {
        try {
            const Real printed = v.evaluate(term.printed);
            const Real derived = v.evaluate(term.derived);
            if (close(printed, derived)) {
                return std::nullopt;
            }
            if (!found) {
                found = Difference::of(printed, derived, Real(0));
            }
        } catch (const Error&) {
            continue; // a draw outside the domain of a root
        }
    }
    return found;
}

/// Both coefficients in balls, at the first draw where both have a value: what is disjoint there
/// is no identity.
void enclose_term(const ExpansionComparison::Term& term, const std::vector<FormalValues>& values,
                  unsigned digits, Outcome& outcome) {
    Enclosed printed;
    Enclosed derived;
    for (const FormalValues& v : values) {
        try {
            const long bits = 2 * formula::bits_for(digits);
            Ball x = v.enclose(term.printed, bits);
            Ball y = v.enclose(term.derived, bits);
            if (x.is_finite() && y.is_finite()) {
                printed.ball = std::move(x);
                derived.ball = std::move(y);
                break;
            }
            printed.problem = "no draw where both coefficients are defined";
        } catch (const Error& error) {
            printed.problem = error.what();
        }
    }
    add_pair("printed_coefficient", printed, "derived_coefficient", derived,
             "numbers drawn for the symbols", digits, outcome);
}

std::string power_text(const std::string& variable, const Rational& exponent) {
    return variable + "^(" + exponent.str() + ")";
}

std::vector<EvidenceItem> terms_evidence(const ExpansionComparison& comparison,
                                         const std::string& variable) {
    std::vector<EvidenceItem> list;
    for (const auto& term : comparison.terms) {
        Evidence e;
        e.add("power", power_text(variable, term.exponent)).add("equal", term.equal);
        if (!term.equal) {
            e.add("printed", to_text(term.printed)).add("derived", to_text(term.derived));
        } else {
            e.add("both", to_text(term.derived));
        }
        list.emplace_back(std::move(e));
    }
    return list;
}

/// What is left of the exact function after the printed terms, in real contacts: an order found
/// with no series at all. The smallest order over the samples; nothing where nothing is left.
struct Remainder {
    std::optional<double> order;
    std::string at;
    std::size_t samples = 0;
};

Remainder measure_remainder(const Claim& claim, const AuditContext& context,
                            const formula::Expr& printed, const formula::Expr& exact,
                            const std::string& variable, const Rational& through) {
    constexpr int step = 3; // decades between the two values of the variable
    // An order needs few digits, but (from the power -1/2 on) that many cancel before it shows.
    constexpr double decades = 18; // the variable goes down to about 1e-18
    const auto digits = static_cast<unsigned>((through.convert_to<double>() + 1.5) * decades) + 30;
    const std::shared_ptr<EvaluatedSamples> sampled = EvaluatedSamples::of(claim, context, digits);
    const EvaluatedSamples& samples_at = *sampled;
    Remainder remainder;
    for (const EvaluatedSample& sample_at : samples_at.all()) {
        EvaluatedSample near = sample_at;
        const auto it = near.variables.find(variable);
        if (it == near.variables.end()) {
            claim.reject("vary", "vary does not say where " + variable + " runs",
                         "write vary = { " + variable + " = [\"a*1e-14\"] }");
        }
        const PrecisionScope scope(digits + 20);
        const auto left_over = [&](const EvaluatedSample& at) {
            const Real value = at.evaluate(exact).value;
            const Real left = abs(value - at.evaluate(printed).value);
            return left <= abs(value) * pow(Real(10), -static_cast<int>(digits) + 10) ? Real(0)
                                                                                      : left;
        };
        const Real far = left_over(near);
        it->second = it->second / pow(Real(10), step);
        const Real close_by = left_over(near);
        ++remainder.samples;
        if (far == 0 || close_by == 0) {
            continue;
        }
        const double order = Real(log10(Real(far / close_by)) / step).convert_to<double>();
        if (!remainder.order || order < *remainder.order) {
            remainder.order = order;
            remainder.at = sample_at.text;
        }
    }
    return remainder;
}

/// Candidates of the diagnosis, in numbers: where the variable is 1e-30 a formula that is right
/// leaves the next power of it, one that is wrong the power where it departs.
class QuickExpansion {
public:
    QuickExpansion(const Claim& claim, const ExpansionIn& in, const ExpansionComparison& comparison,
                   const std::set<std::string>& names, const SymbolicCase& under)
        : claim_(claim) {
        const Rational span = in.through - comparison.terms.front().exponent;
        const auto power = static_cast<unsigned>(ceil(span.convert_to<double>()));
        digits_ = decades * (power + 1) + 40;
        const PrecisionScope scope(digits_);
        const Real small = pow(Real(10), -static_cast<int>(decades));
        tolerance_ = pow(small, from_rational<Real>(Rational(span + Rational(1, 4))));
        for (std::size_t k = 0; k < formal_draws; ++k) {
            FormalValues values(names, under, k, digits_);
            values.set(in.variable, small);
            Real exact(0);
            try {
                for (const auto& term : comparison.terms) {
                    exact += values.evaluate(term.derived) *
                             pow(small, from_rational<Real>(term.exponent));
                }
            } catch (const DomainError&) {
                continue; // a draw outside the domain of a root
            }
            draws_.emplace_back(std::move(values), std::move(exact));
        }
    }
    [[nodiscard]] bool passes_screening(const formula::Expr& written) const {
        const formula::Expr e = expand_definitions(written, claim_.vocabulary);
        const PrecisionScope scope(digits_);
        return !draws_.empty() && std::all_of(draws_.begin(), draws_.end(), [&](const auto& draw) {
            const auto& [values, exact] = draw;
            return abs(values.evaluate(e) - exact) <= tolerance_ * abs(exact);
        });
    }

private:
    static constexpr unsigned decades = 30;
    const Claim& claim_;
    unsigned digits_ = 0;
    Real tolerance_;
    std::vector<std::pair<FormalValues, Real>> draws_;
};

Outcome check_expansion(const Claim& claim, const AuditContext& context) {
    const formula::Expr printed = claim.formula("says");
    const formula::Expr exact = claim.formula("of");
    const std::string variable = claim.text("variable");
    const SymbolicCase under = symbolic_case(claim, context);
    const ExpansionIn in{variable, claim.edge(),
                         formula::Exact::parse(claim.text("through")).rational()};
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"));
    const ExpansionComparison comparison = compare_expansions(printed, exact, in, under);
    outcome.evidence.add("terms", terms_evidence(comparison, variable));

    const Remainder remainder =
        measure_remainder(claim, context, printed, exact, variable, in.through);
    outcome.evidence.add("samples", remainder.samples);
    outcome.evidence.add("order_of_the_rest",
                         remainder.order ? fmt::format("{:.6f}", *remainder.order) : "no rest");
    const double needed = in.through.convert_to<double>() + 0.5 - 1e-3;
    const bool rest_is_small = !remainder.order || *remainder.order >= needed;

    if (comparison.equal()) {
        outcome.verdict = rest_is_small ? NotRefuted::proved : NotRefuted::undecided;
        outcome.note = rest_is_small ? "equal power by power; what is left has the order claimed"
                                     : "equal in symbols, but more is left at " + remainder.at;
        return outcome;
    }
    const std::set<std::string> names = names_of(printed, exact);
    const auto* wrong = comparison.first_wrong();
    const auto difference = differ(*wrong, draw_values(names, under));
    if (!difference) {
        outcome.verdict = rest_is_small ? NotRefuted::confirmed : NotRefuted::undecided;
        outcome.note = "not proved in symbols";
        return outcome;
    }
    outcome.verdict = Judgement(*difference);
    enclose_term(*wrong, draw_values(names, under), context.digits(), outcome);
    const std::string first = "departs at " + power_text(variable, wrong->exponent);
    outcome.evidence.add("first_departure", power_text(variable, wrong->exponent));
    if (!remainder.at.empty()) {
        outcome.evidence.add("worst_at", remainder.at);
    }
    if (claim.has("as_if")) {
        Evidence hypotheses;
        for (std::size_t i = 0; i < claim.table("as_if").size(); ++i) {
            const std::string& text = claim.table("as_if")[i].first;
            const formula::Expr& other = claim.formulas("as_if")[i];
            hypotheses.add(text, compare_expansions(printed, other, in, under).equal()
                                     ? "gives the printed line"
                                     : "does not give the printed line");
        }
        outcome.evidence.add("as_if", std::move(hypotheses));
    }
    RefutedFormula refuted;
    refuted.printed = claim.written("says");
    refuted.exact = claim.written("of");
    refuted.alphabet = alphabet_for(claim, refuted.printed, exact);
    std::erase(refuted.alphabet.symbols, variable);
    std::vector<ExpansionTerm> derived;
    for (const auto& term : comparison.terms) {
        derived.push_back({term.exponent, term.derived});
    }
    refuted.derived = sum_of(derived, variable);
    const QuickExpansion quick(claim, in, comparison, names, under);
    refuted.passes_screening = [&](const formula::Expr& e) { return quick.passes_screening(e); };
    refuted.verdict_of = [&](const formula::Expr& e) -> std::optional<Verdict> {
        return compare_expansions(expand_definitions(e, claim.vocabulary), exact, in, under).equal()
                   ? Verdict::proved
                   : Verdict::refuted;
    };
    diagnose(refuted, outcome);
    outcome.note = first + "; " + outcome.note;
    return outcome;
}

} // namespace

CheckKind expansion_kind() {
    using Type = KeySpec::Type;
    return {"expansion",
            {required_formula("says"),
             required_formula("of"),
             {.name = "variable", .required = true},
             {.name = "through", .type = Type::number, .required = true},
             {.name = "as_if", .type = Type::formula_table},
             {.name = "given", .type = Type::formula_table}},
            check_expansion};
}

} // namespace edgeproof::audit
