// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/diagnosis/diagnosis.hpp"
#include "edgeproof/contact/enclosure/exact_contact.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/real.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace edgeproof::audit {
namespace {

/// The greatest number of candidates that pass the screening and are checked completely.
constexpr std::size_t most_full_checks = 4;

bool safe(const std::function<bool(const Expr&)>& test, const Expr& e) {
    try {
        return test(e);
    } catch (const Error&) {
        return false; // an edit can produce a formula that is not allowed, or has no value
    }
}

bool accept(const RefutedFormula& refuted, const Expr& edited, Outcome& outcome) {
    const Expr formula = with_one_number(edited);
    if (!safe(refuted.is_right, formula)) {
        return false;
    }
    outcome.correct = to_text(formula);
    return true;
}

std::string factor_text(const Expr& ratio) {
    return "the printed formula is " + to_text(ratio) + " times the right one";
}

void find_correction(const RefutedFormula& refuted, Outcome& outcome) {
    const auto says_more = [](const Expr& ratio) { // than the edit of a sign
        return free_symbols(ratio).empty() &&
               (ratio.rational() == nullptr || *ratio.rational() != -1);
    };
    const std::string factor =
        refuted.ratio && says_more(*refuted.ratio) ? "; " + factor_text(*refuted.ratio) : "";
    std::size_t checked = 0;
    for (const Edit& edit : single_edits(refuted.printed, refuted.alphabet)) {
        if (edit.formula == refuted.exact) {
            continue; // not a useful correction: the exact formula always equals itself
        }
        if (!safe(refuted.passes_screening, edit.formula)) {
            continue;
        }
        if (++checked > most_full_checks) {
            break;
        }
        if (accept(refuted, edit.formula, outcome)) {
            outcome.evidence["edit"] = {
                {"what", edit.what}, {"printed", edit.before}, {"correct", edit.after}};
            outcome.note = edit.what + ": " + edit.before + " should be " + edit.after + factor;
            return;
        }
    }
    // A known formula is a better correction than a factor with names that are not printed: of a
    // formula for a, a factor that is a power of a is of no use.
    const bool other_names =
        refuted.ratio && std::ranges::any_of(free_symbols(*refuted.ratio), [&](const auto& name) {
            return !holds_symbol(refuted.printed, name);
        });
    if (refuted.ratio && !(other_names && refuted.derived)) {
        const Expr& r = *refuted.ratio;
        const Expr corrected =
            r.kind() == Expr::Kind::neg ? -(refuted.printed / r.arg(0)) : refuted.printed / r;
        if (accept(refuted, corrected, outcome)) {
            outcome.note = factor_text(r);
            return;
        }
    }
    if (refuted.derived && accept(refuted, *refuted.derived, outcome)) {
        outcome.note = "no edit makes it right; the derived form is given" + factor;
        outcome.evidence["derived_instead"] = true;
        return;
    }
    outcome.note = "no correction was found";
}

} // namespace

void diagnose(const RefutedFormula& refuted, Outcome& outcome) {
    const std::string why = std::exchange(outcome.note, "");
    find_correction(refuted, outcome);
    if (outcome.verdict == Verdict::underspecified) { // what the formula lacks remains the finding
        outcome.note = outcome.correct ? why + "; " + outcome.note : why;
    }
}

EditAlphabet alphabet_for(const Claim& claim, const Expr& printed, const Expr& exact,
                          const SceneSpec* scene) {
    std::set<std::string> names = free_symbols(printed);
    names.merge(free_symbols(exact));
    const std::set<std::string> written = names;
    const auto any = [&](const char* letter) {
        return std::ranges::any_of(
            names, [&](const std::string& n) { return order_behind(n, letter).has_value(); });
    };
    // The coefficients depend on the derivatives of the contact law.
    const auto is_coefficient = [](const std::string& n) {
        return n.starts_with("right_c") || n.starts_with("left_c");
    };
    const bool coefficient = std::ranges::any_of(names, is_coefficient);
    const bool rates = coefficient || any("P");
    if (rates) {
        names.insert({"P1", "P2", "P3"});
    }
    if (coefficient || any("b")) {
        names.insert({"b", "b1", "b2", "b3"});
    }
    names.insert("a");
    if (claim.has("vary")) {
        for (const auto& [name, values] : claim.table("vary")) {
            names.insert(name);
        }
    }
    // The names in the formula, or in its scene, come before the other names.
    std::vector<std::string> in_order(names.begin(), names.end());
    std::stable_partition(in_order.begin(), in_order.end(), [&](const std::string& name) {
        return written.contains(name) || (scene != nullptr && scene->parameters.contains(name));
    });
    EditAlphabet alphabet;
    alphabet.of_pressure = exact.kind() == Expr::Kind::call && exact.name() == "p";
    for (const std::string& name : in_order) {
        if (is_coefficient(name)) {
            continue;
        }
        alphabet.symbols.push_back(name);
        if (order_behind(name, "P") || name == "x" || name == "P" || name == "M") {
            continue;
        }
        const Expr e = Expr::symbol(name);
        alphabet.factors.push_back(e);
        alphabet.factors.push_back(Expr::call("sqrt", {e}));
        alphabet.factors.push_back(pow(e, Expr::number(2)));
    }
    for (const char* rate : {"P1", "P2", "P3"}) {
        if (rates) {
            alphabet.factors.push_back(Expr::symbol(rate));
        }
    }
    if (scene != nullptr) {
        for (const auto& [name, value] : scene->parameters) {
            if (!names.contains(name)) {
                alphabet.factors.push_back(Expr::symbol(name));
            }
        }
    }
    if (names.contains("b")) {
        const Expr length = Expr::symbol("a") + Expr::symbol("b");
        alphabet.factors.push_back(length);
        alphabet.factors.push_back(Expr::call("sqrt", {length}));
    }
    alphabet.factors.push_back(Expr::pi());
    alphabet.factors.push_back(Expr::call("sqrt", {Expr::number(2)}));
    return alphabet;
}

namespace {

/// Returns the fraction of moderate size within a relative distance 10^-digits of x > 0. Two such
/// fractions differ by more.
std::optional<Rational> simple_fraction(const Real& x, unsigned digits) {
    constexpr long most = 1'000'000;
    const Real tolerance = x * pow(Real(10), -static_cast<int>(digits));
    const auto q =
        contact::simplest_rational(Ball::around(x, tolerance, formula::bits_for(digits + 10)));
    return q && numerator(*q) <= most && denominator(*q) <= most ? q : std::nullopt;
}

Expr power_of(const Expr& base, const Rational& k) {
    return k == 1                ? base
           : k == Rational(1, 2) ? Expr::call("sqrt", {base})
                                 : pow(base, formula::quotient_of(k));
}

/// Returns x as rational * pi^j, as the square root of a rational times pi^j, or as the square or
/// cube root of rational * pi^j.
std::optional<Expr> simple_constant(const Real& x, unsigned digits) {
    // The number under the root, times pi^j.
    const auto with_pi = [](const Expr& number, int j) {
        const Expr power = power_of(Expr::pi(), Rational(std::abs(j)));
        return j == 0 ? number : j > 0 ? number * power : number / power;
    };
    const Real pi_value = pi<Real>();
    for (const bool root : {false, true}) {
        for (const int j : {0, 1, -1, 2, -2}) {
            Real y = x / pow(pi_value, j);
            y = root ? Real(y * y) : y;
            if (const auto q = simple_fraction(y, digits)) {
                const Expr number = formula::quotient_of(*q);
                return with_pi(root ? Expr::call("sqrt", {number}) : number, j);
            }
        }
    }
    for (const int root : {2, 3}) {
        for (const int j : {0, 1, -1, 2, -2}) {
            if (const auto q = simple_fraction(Real(pow(x, root) / pow(pi_value, j)), digits)) {
                return power_of(with_pi(formula::quotient_of(*q), j), Rational(1, root));
            }
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<Expr> recognise_ratio(const std::vector<RatioSample>& samples, unsigned digits) {
    if (samples.size() < 3) {
        return std::nullopt;
    }
    const int sign = samples.front().ratio < 0 ? -1 : 1;
    std::vector<std::string> names;
    for (const auto& [name, value] : samples.front().parameters) {
        const bool everywhere =
            std::ranges::all_of(samples, [&, &key = name](const RatioSample& s) {
                const auto it = s.parameters.find(key);
                return it != s.parameters.end() && it->second > 0;
            });
        if (everywhere) {
            names.push_back(name);
        }
    }
    std::vector<std::vector<double>> rows;
    std::vector<double> right;
    for (const RatioSample& s : samples) {
        if (!(s.ratio * sign > 0)) {
            return std::nullopt; // zero at some sample, or of both signs
        }
        std::vector<double> row{1.0};
        for (const std::string& name : names) {
            row.push_back(log(s.parameters.find(name)->second).convert_to<double>());
        }
        rows.push_back(std::move(row));
        right.push_back(log(Real(s.ratio * sign)).convert_to<double>());
    }
    const auto exponents = least_squares(rows, right, 0.0, 1e-7);
    std::vector<Rational> k;
    for (std::size_t i = 1; i < exponents.size(); ++i) {
        const double exponent = exponents[i].value_or(0.0);
        const double twelfths = std::round(exponent * 12);
        if (std::abs(twelfths) > 240 || std::abs(exponent * 12 - twelfths) > 1e-2) {
            return std::nullopt;
        }
        k.emplace_back(static_cast<long>(twelfths), 12L);
    }
    const auto monomial = [&](const RatioSample& s) {
        Real value(1);
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (k[i] != 0) {
                value *= pow(s.parameters.find(names[i])->second, from_rational<Real>(k[i]));
            }
        }
        return value;
    };
    const Real constant = samples.front().ratio * sign / monomial(samples.front());
    const Real tolerance = pow(Real(10), -static_cast<int>(digits));
    for (const RatioSample& s : samples) {
        if (abs(s.ratio * sign / monomial(s) / constant - 1) > tolerance) {
            return std::nullopt;
        }
    }
    const auto number = simple_constant(constant, digits);
    if (!number) {
        return std::nullopt;
    }
    std::optional<Expr> over;
    std::optional<Expr> under;
    if (!(*number == Expr::number(1))) {
        over = number;
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (k[i] == 0) {
            continue;
        }
        auto& side = k[i] > 0 ? over : under;
        const Expr factor = power_of(Expr::symbol(names[i]), abs(k[i]));
        side = side ? *side * factor : factor;
    }
    if (!over && !under && sign > 0) {
        return std::nullopt; // 1 to the digits compared explains no difference
    }
    Expr ratio = over.value_or(Expr::number(1));
    if (under) {
        ratio = ratio / *under;
    }
    return sign < 0 ? -ratio : ratio;
}

} // namespace edgeproof::audit
