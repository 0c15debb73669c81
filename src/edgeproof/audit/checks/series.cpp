// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/residual_fit.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

std::vector<Real> numbers(const Claim& claim, std::string_view key) {
    std::vector<Real> values;
    for (const std::string& text : claim.list(key)) {
        try {
            values.push_back(formula::Exact::parse(text).to<Real>());
        } catch (const InputError& error) {
            claim.reject(key, error.problem(), error.instead());
        }
    }
    return values;
}

/// What the residuals of one scene say of the claim.
struct FitInScene {
    bool as_claimed = true;
    std::size_t vanishing = 0;
    std::string problem;
    std::vector<std::string> slopes;
    int digits = 1000000;
    std::optional<Difference> against; ///< of an order, or of a coefficient
};

FitInScene fit_scene(const SceneSpec& scene, contact::Edge edge,
                     const std::vector<formula::Expr>& terms, const std::vector<Real>& orders,
                     unsigned digits) {
    ResidualFitOptions options;
    options.orders = orders.size();
    options.digits = digits;
    options.points = std::max<std::size_t>(12, digits / 4);
    options.route = contact::Route::automatic;
    // The printed coefficients, to as many digits as the fit computes the pressure to.
    const auto enough = digits + static_cast<unsigned>(orders.size() * (options.points / 3 + 6));
    const EvaluatedScene scene_values(scene, enough);
    // Of what is left no coefficient is claimed, only its order. First, as the terms ask for fewer.
    const std::vector<Real> exact = scene_values.expansion(edge, orders.size());
    std::vector<Real> c;
    c.reserve(terms.size());
    for (const formula::Expr& term : terms) {
        c.push_back(scene_values.evaluate(term).value);
    }
    c.insert(c.end(), exact.begin() + static_cast<std::ptrdiff_t>(c.size()), exact.end());
    const std::vector<OrderFit> fits =
        fit_residuals(scene.make_profile(), scene.parameter("Es"),
                      contact::Load::right_edge(scene.parameter("a")), edge, options, c);
    FitInScene found;
    for (const OrderFit& fit : fits) {
        found.slopes.push_back(to_decimal(fit.slope, 12));
        const Real off = abs(fit.slope - orders[fit.n] - (fit.vanishing ? 1 : 0));
        found.vanishing += fit.vanishing ? 1 : 0;
        const bool term = fit.n < terms.size();
        if (term) {
            found.digits = std::min(found.digits, fit.agreeing_digits);
        }
        const bool right = off < pow(Real(10), -9) &&
                           (!term || fit.agreeing_digits + 5 >= static_cast<int>(digits));
        if (!right && found.as_claimed) {
            found.as_claimed = false;
            const Real slope_said = orders[fit.n] + (fit.vanishing ? 1 : 0);
            found.against = Difference::of(slope_said, fit.slope, pow(Real(10), -9));
            found.problem = "after " + std::to_string(fit.n) + " terms the rest goes as u^" +
                            to_decimal(fit.slope, 6) + ", not u^" + to_decimal(orders[fit.n], 6);
            if (off < pow(Real(10), -9)) {
                found.against = Difference::of(c[fit.n], exact[fit.n], Real(0));
                found.problem = "coefficient " + std::to_string(fit.n) + " agrees to " +
                                std::to_string(fit.agreeing_digits) + " digits only";
            }
        }
    }
    return found;
}

Outcome check_series(const Claim& claim, const AuditContext& context) {
    const PrecisionScope scope(context.digits() + 20);
    const std::vector<Real> orders = numbers(claim, "orders");
    std::vector<formula::Expr> terms;
    if (claim.has("terms")) {
        terms = claim.formulas("terms");
    }
    if (orders.empty() || orders.size() < terms.size() || orders.size() > 8) {
        claim.reject("orders", "the orders do not go with the terms",
                     "give one for each term, and one more for what is left, 8 at most");
    }
    const contact::Edge edge = claim.edge();
    Outcome outcome;
    std::size_t scenes = 0;
    std::size_t vanishing = 0;
    std::size_t failing = 0;
    std::optional<Difference> against;
    int digits = 1000000;
    std::vector<std::string> slopes;
    const std::vector<SceneSpec> all = context.scenes(claim);
    const unsigned everywhere = std::min(context.digits(), ManyDigits::everywhere);
    // An order wants no more than its slope; it is the coefficients that have digits.
    std::vector<std::size_t> to_all_digits;
    if (everywhere < context.digits() && !terms.empty()) {
        to_all_digits = spread_first(all.size(), ManyDigits::samples);
        to_all_digits.resize(std::min(all.size(), ManyDigits::samples));
    }
    int all_digits = 1000000;
    for (const SceneSpec& scene : all) {
        const bool more =
            std::find(to_all_digits.begin(), to_all_digits.end(), scenes) != to_all_digits.end();
        const FitInScene found =
            fit_scene(scene, edge, terms, orders, more ? context.digits() : everywhere);
        all_digits = more ? std::min(all_digits, found.digits) : all_digits;
        ++scenes;
        vanishing += found.vanishing > 0 ? 1 : 0;
        digits = std::min(digits, found.digits);
        if (!found.as_claimed && ++failing == 1) {
            against = found.against;
            outcome.note = found.problem + ", in " + scene.family + ": " + scene.text();
            outcome.evidence.add("fails_in", scene.family + ": " + scene.text());
            slopes = found.slopes;
        }
        if (slopes.empty()) {
            slopes = found.slopes;
        }
    }
    outcome.evidence.add("scenes", scenes)
        .add("scenes_failing", failing)
        .add("slopes", slopes)
        .add("orders", claim.list("orders"))
        .add("scenes_where_a_coefficient_vanishes", vanishing);
    if (!terms.empty()) {
        outcome.evidence.add("digits_of_the_coefficients", digits);
        if (!to_all_digits.empty()) {
            outcome.evidence.add("scenes_to_all_digits", to_all_digits.size())
                .add("all_digits_of_the_coefficients", all_digits);
        }
    }
    if (failing == 0 && scenes > 0) {
        outcome.verdict = NotRefuted::confirmed;
        outcome.note =
            "the residuals have the orders claimed in " + std::to_string(scenes) + " scenes";
        if (vanishing > 0) {
            outcome.note += " (in " + std::to_string(vanishing) + " a coefficient vanishes)";
        }
    } else if (failing > 0) {
        outcome.verdict = Judgement(against);
    }
    return outcome;
}

} // namespace

CheckKind series_kind() {
    using Type = KeySpec::Type;
    return {"series",
            {{.name = "terms", .type = Type::formulas},
             {.name = "orders", .type = Type::list, .required = true}},
            check_series};
}

} // namespace edgeproof::audit
