// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/decimal_fit.hpp"
#include "edgeproof/audit/checks/parts/residual_fit.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/contact/curved/proved_slip.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

std::vector<Rational> numbers(const Claim& claim, std::string_view key) {
    std::vector<Rational> values;
    for (const std::string& text : claim.list(key)) {
        try {
            values.push_back(Exact::parse(text).rational());
        } catch (const InputError& error) {
            claim.reject(key, error.problem(), error.instead());
        }
    }
    return values;
}

Expr coefficient(Edge edge, std::size_t n) {
    return Expr::symbol((edge == Edge::right ? "right_c" : "left_c") + std::to_string(n));
}

Rational order_after(std::size_t n) { return Rational(static_cast<long>(n)) + Rational(1, 2); }

/// Returns the scale of the errors of c_n.
Ball scale_of(const Ball& exact, std::size_t n, const EnclosedSample& at, Edge edge) {
    return contains_zero(exact)
               ? abs(at.evaluate(coefficient(edge, 0))) / pow_int(at.length(), static_cast<long>(n))
               : abs(exact);
}

/// The result in one scene, by enclosures.
struct SeriesInScene {
    std::vector<Decision> decisions;
    std::size_t vanishing = 0; ///< the number of coefficients that vanish
    std::string problem;
    double digits = 1e6; ///< the fewest digits to which the balls prove a coefficient
};

double proved_digits(const Ball& printed, const Ball& exact, const Ball& scale) {
    const Real most = abs(printed - exact).upper();
    return most == 0 || !certainly_positive(scale)
               ? (most == 0 ? 1e6 : 0)
               : Real(-log10(Real(most / scale.lower()))).convert_to<double>();
}

/// The exact expansion is the sum of c_k u^(k + 1/2) (docs/expansions.md). After n correct terms
/// the remainder therefore has the order n + 1/2, or a higher one if c_n vanishes.
void decide_orders(const EnclosedSample& at, Edge edge, const std::vector<Expr>& terms,
                   const std::vector<Rational>& orders, double needed, SeriesInScene& found) {
    Ball leading;
    for (std::size_t n = 0; n < orders.size(); ++n) {
        const Ball exact = at.evaluate(coefficient(edge, n));
        leading = n == 0 ? exact : leading;
        if (n < terms.size()) {
            const Ball printed = at.evaluate(terms[n]);
            const Ball scale = scale_of(exact, n, at, edge);
            const Decision same = decision(Refutation::disjoint(printed, exact),
                                           Confirmation::agreement(printed, exact, scale, needed));
            found.digits = std::min(found.digits, proved_digits(printed, exact, scale));
            found.decisions.push_back(same);
            if (!confirms(same) && found.problem.empty()) {
                found.problem =
                    refutes(same) ? "coefficient " + std::to_string(n) + " is not the printed one"
                                  : "the enclosures do not decide coefficient " + std::to_string(n);
            }
        }
        found.vanishing += contains_zero(exact) ? 1 : 0;
        if (orders[n] == order_after(n)) {
            continue;
        }
        // c_n is proved to differ from zero, so that the remainder has the order n + 1/2.
        found.decisions.push_back(
            decision(Refutation::disjoint(Ball(0, exact.bits()), exact), std::nullopt));
        if (found.problem.empty()) {
            found.problem = "after " + std::to_string(n) + " terms the remainder is of order u^" +
                            to_decimal(from_rational<Real>(order_after(n)), 6) + ", not u^" +
                            to_decimal(from_rational<Real>(orders[n]), 6);
        }
    }
    if (terms.empty() && found.decisions.empty()) {
        // The leading coefficient is positive, so that the first order is as claimed.
        found.decisions.push_back(
            decision(std::nullopt, Confirmation::less(Ball(0, leading.bits()), abs(leading))));
    }
}

/// Returns the slopes of the residuals after the printed terms, as an illustration; none if they
/// are not enclosed.
std::vector<std::string> slopes_in(const SceneSpec& scene, Edge edge,
                                   const std::vector<Expr>& terms, std::size_t orders) {
    const ResidualFitOptions options{.orders = orders, .digits = 20};
    std::vector<std::string> slopes;
    try {
        const auto contact = contact::proved_contact(
            scene.make_profile(), scene.parameter("Es"),
            contact::Load::right_edge(scene.parameter("a")), options.bits());
        const EnclosedSample at({scene, std::nullopt, edge, {}}, options.bits());
        std::vector<Ball> c = contact->expansion(edge, orders);
        for (std::size_t n = 0; n < terms.size(); ++n) {
            c[n] = at.evaluate(terms[n]);
        }
        for (const Real& slope : fit_residuals(*contact, edge, options, std::move(c)).slopes) {
            slopes.push_back(to_decimal(slope, 8));
        }
    } catch (const Error&) {
        return {};
    }
    return slopes;
}

/// A printed coefficient with decimals, and one equation for each scene.
struct DecimalTerm {
    std::size_t n;
    DecimalFormula printed;
    std::vector<DecimalEquation> equations;
};

std::vector<DecimalTerm> terms_with_decimals(const Claim& claim) {
    std::vector<DecimalTerm> found;
    for (std::size_t n = 0; claim.has("terms") && n < claim.list("terms").size(); ++n) {
        PrintedFormula printed = DecimalFormula::read(claim, claim.list("terms")[n]);
        if (auto* with_decimals = std::get_if<DecimalFormula>(&printed)) {
            found.push_back({n, std::move(*with_decimals), {}});
        }
    }
    return found;
}

void add_equation(const SceneSpec& scene, Edge edge, long bits, DecimalTerm& term) {
    const auto at = std::make_shared<EnclosedSample>(Sample{scene, std::nullopt, edge, {}}, bits);
    const Ball exact = at->evaluate(coefficient(edge, term.n));
    term.equations.push_back(
        equation_at(at, term.printed.expr(), exact, scale_of(exact, term.n, *at, edge)));
}

SeriesInScene series_in(const SceneSpec& scene, Edge edge, const std::vector<Expr>& terms,
                        const std::vector<Rational>& orders, unsigned digits) {
    SeriesInScene found;
    SampleInBalls in_balls({scene, std::nullopt, edge, {}}, digits);
    static_cast<void>(in_balls.until([&](const EnclosedSample& at) {
        found = {};
        decide_orders(at, edge, terms, orders, AuditContext::digits_needed(digits), found);
        return std::ranges::none_of(found.decisions, is_open);
    }));
    if (found.decisions.empty()) {
        found.problem = in_balls.problem();
    }
    return found;
}

/// Finds numbers that round to the printed decimals and fit, separately for each coefficient. A
/// claim with wrong orders, or with further coefficients without decimals, is not decided here.
Judgement judge_decimal_terms(const std::vector<DecimalTerm>& with_decimals,
                              const std::vector<Rational>& orders, std::size_t terms,
                              unsigned digits, Outcome& outcome) {
    std::vector<Judgement> each;
    for (const DecimalTerm& term : with_decimals) {
        each.push_back(judge_decimals(term.printed, term.equations, digits,
                                      formula::bits_for(2 * digits + 30), outcome));
        if (each.back() != Verdict::confirmed) {
            return each.back();
        }
    }
    bool as_expanded = with_decimals.size() == terms;
    for (std::size_t n = 0; n < orders.size(); ++n) {
        as_expanded = as_expanded && orders[n] == order_after(n);
    }
    return as_expanded ? Judgement::of_readings(each) : Judgement();
}

} // namespace

Outcome check_series(const Claim& claim, const AuditContext& context) {
    const PrecisionScope scope(context.digits() + 20);
    const std::vector<Rational> orders = numbers(claim, "orders");
    std::vector<Expr> terms;
    if (claim.has("terms")) {
        terms = claim.formulas("terms");
    }
    if (orders.empty() || orders.size() < terms.size() || orders.size() > 8) {
        claim.reject("orders", "the number of orders does not match the terms",
                     "give one for each term, and one more for the remainder, 8 at most");
    }
    const Edge edge = claim.edge();
    const unsigned everywhere = std::min(context.digits(), ManyDigits::everywhere);
    Outcome outcome;
    std::size_t scenes = 0;
    std::size_t vanishing = 0;
    std::size_t failing = 0;
    std::vector<Decision> decisions;
    double digits = everywhere;
    const SceneSpec* shown = nullptr; // the first that fails, or else the first
    const std::vector<SceneSpec> all = context.scenes(claim);
    std::vector<DecimalTerm> with_decimals = terms_with_decimals(claim);
    // An order needs no more digits than its slope; only the coefficients have many digits.
    std::vector<std::size_t> to_all_digits;
    if (everywhere < context.digits() && !terms.empty()) {
        to_all_digits = spread_first(all.size(), ManyDigits::samples);
        to_all_digits.resize(std::min(all.size(), ManyDigits::samples));
    }
    double all_digits = context.digits();
    for (const SceneSpec& scene : all) {
        const bool more = std::ranges::find(to_all_digits, scenes) != to_all_digits.end();
        const SeriesInScene found =
            series_in(scene, edge, terms, orders, more ? context.digits() : everywhere);
        all_digits = more ? std::min(all_digits, found.digits) : all_digits;
        ++scenes;
        vanishing += found.vanishing > 0 ? 1 : 0;
        digits = std::min(digits, found.digits);
        for (DecimalTerm& term : with_decimals) {
            add_equation(scene, edge, formula::bits_for(2 * everywhere + 30), term);
        }
        const Judgement here = Judgement::of_all(found.decisions);
        decisions.insert(decisions.end(), found.decisions.begin(), found.decisions.end());
        if (found.decisions.empty()) {
            decisions.emplace_back();
        }
        if (here != Verdict::confirmed && ++failing == 1) {
            outcome.note = found.problem + ", in " + full_text(scene);
            outcome.evidence.add("fails_in", full_text(scene));
            shown = &scene;
        }
        shown = shown == nullptr ? &scene : shown;
    }
    outcome.evidence.add("scenes", scenes)
        .add("scenes_failing", failing)
        .add("slopes", shown == nullptr ? std::vector<std::string>()
                                        : slopes_in(*shown, edge, terms, orders.size()))
        .add("orders", claim.list("orders"))
        .add("scenes_where_a_coefficient_vanishes", vanishing);
    if (!terms.empty()) {
        outcome.evidence.add("digits_of_the_coefficients", digits_text(digits));
        if (!to_all_digits.empty()) {
            outcome.evidence.add("scenes_to_all_digits", to_all_digits.size())
                .add("all_digits_of_the_coefficients", digits_text(all_digits));
        }
    }
    outcome.verdict = Judgement::of_all(decisions);
    if (outcome.verdict != Verdict::confirmed && !with_decimals.empty()) {
        // The printed terms alone decide nothing, as their decimals represent intervals.
        outcome.verdict =
            judge_decimal_terms(with_decimals, orders, terms.size(), everywhere, outcome);
        return outcome;
    }
    if (failing == 0 && scenes > 0) {
        outcome.note =
            "the residuals have the orders claimed in " + std::to_string(scenes) + " scenes";
        if (vanishing > 0) {
            outcome.note += " (in " + std::to_string(vanishing) + " a coefficient vanishes)";
        }
    }
    return outcome;
}

} // namespace edgeproof::audit
