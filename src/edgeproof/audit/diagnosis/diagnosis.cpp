// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/diagnosis/diagnosis.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace edgeproof::audit {
namespace {

/// The greatest number of candidates that pass the screening and are checked completely.
constexpr std::size_t most_full_checks = 4;

bool numbered(const std::string& name, char letter) {
    return name.size() == 2 && name[0] == letter && name[1] >= '1' && name[1] <= '9';
}

bool safe(const std::function<bool(const formula::Expr&)>& test, const formula::Expr& e) {
    try {
        return test(e);
    } catch (const InputError&) {
        return false; // an edit can produce a formula that is not allowed
    } catch (const Error&) {
        return false;
    }
}

std::optional<Verdict> safe_verdict(const RefutedFormula& refuted, const formula::Expr& e) {
    try {
        const auto verdict = refuted.verdict_of(e);
        return verdict && holds(*verdict) ? verdict : std::nullopt;
    } catch (const Error&) {
        return std::nullopt;
    }
}

bool accept(const RefutedFormula& refuted, const formula::Expr& formula, Outcome& outcome) {
    const auto verdict = safe_verdict(refuted, formula);
    if (!verdict) {
        return false;
    }
    outcome.correct = to_text(formula);
    outcome.evidence.add("correct_tex", to_tex(formula));
    outcome.evidence.add("correct_verdict", name_of(*verdict));
    return true;
}

} // namespace

void diagnose(const RefutedFormula& refuted, Outcome& outcome) {
    std::size_t tried = 0;
    std::size_t checked = 0;
    for (const Edit& edit : single_edits(refuted.printed, refuted.alphabet)) {
        ++tried;
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
            Evidence e;
            e.add("what", edit.what).add("printed", edit.before).add("correct", edit.after);
            outcome.evidence.add("edit", std::move(e));
            outcome.evidence.add("edits_tried", tried);
            outcome.note = edit.what + ": " + edit.before + " should be " + edit.after;
            return;
        }
    }
    outcome.evidence.add("edits_tried", tried);
    if (refuted.ratio) {
        const formula::Expr& r = *refuted.ratio;
        const formula::Expr corrected = r.kind() == formula::Expr::Kind::neg
                                            ? -(refuted.printed / r.arg(0))
                                            : refuted.printed / r;
        if (accept(refuted, corrected, outcome)) {
            outcome.note = "the printed formula is " + to_text(r) + " times the right one";
            return;
        }
    }
    if (refuted.derived && accept(refuted, *refuted.derived, outcome)) {
        outcome.note = "no single edit makes it right; the derived form is given";
        outcome.evidence.add("derived_instead", true);
        return;
    }
    outcome.note = "no correction was found";
}

EditAlphabet alphabet_for(const Claim& claim, const formula::Expr& printed,
                          const formula::Expr& exact, const SceneSpec* scene) {
    std::set<std::string> names = free_symbols(printed);
    names.merge(free_symbols(exact));
    const std::set<std::string> written = names;
    const auto any = [&](char letter) {
        return std::any_of(names.begin(), names.end(),
                           [&](const std::string& n) { return numbered(n, letter); });
    };
    // The coefficients depend on the derivatives of the contact law.
    const bool coefficient = std::any_of(names.begin(), names.end(), [](const std::string& n) {
        return n.starts_with("right_c") || n.starts_with("left_c");
    });
    const bool rates = coefficient || any('P');
    if (rates) {
        names.insert({"P1", "P2", "P3"});
    }
    if (coefficient || any('b')) {
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
    for (const std::string& name : in_order) {
        if (name.starts_with("right_c") || name.starts_with("left_c")) {
            continue;
        }
        alphabet.symbols.push_back(name);
        if (numbered(name, 'P') || name == "x" || name == "P" || name == "M") {
            continue;
        }
        const formula::Expr e = formula::Expr::symbol(name);
        alphabet.factors.push_back(e);
        alphabet.factors.push_back(formula::Expr::call("sqrt", {e}));
        alphabet.factors.push_back(pow(e, formula::Expr::number(2)));
    }
    for (const char* rate : {"P1", "P2", "P3"}) {
        if (rates) {
            alphabet.factors.push_back(formula::Expr::symbol(rate));
        }
    }
    if (scene != nullptr) {
        for (const auto& [name, value] : scene->parameters) {
            if (!names.contains(name)) {
                alphabet.factors.push_back(formula::Expr::symbol(name));
            }
        }
    }
    if (names.contains("b")) {
        const formula::Expr length = formula::Expr::symbol("a") + formula::Expr::symbol("b");
        alphabet.factors.push_back(length);
        alphabet.factors.push_back(formula::Expr::call("sqrt", {length}));
    }
    alphabet.factors.push_back(formula::Expr::pi());
    alphabet.factors.push_back(formula::Expr::call("sqrt", {formula::Expr::number(2)}));
    return alphabet;
}

namespace {

/// Returns the simplest fraction of moderate size within a relative distance 10^-digits of x > 0.
std::optional<Rational> simple_fraction(const Real& x, unsigned digits) {
    const Real tolerance = pow(Real(10), -static_cast<int>(digits));
    Integer p0(0);
    Integer q0(1);
    Integer p1(1);
    Integer q1(0);
    Real rest = x;
    for (int k = 0; k < 30; ++k) {
        const Real whole = floor(rest);
        const Integer n = whole.convert_to<Integer>();
        const Integer p2 = n * p1 + p0;
        const Integer q2 = n * q1 + q0;
        if (p2 > 1000000 || q2 > 1000000) {
            return std::nullopt;
        }
        p0 = p1;
        q0 = q1;
        p1 = p2;
        q1 = q2;
        const Rational fraction(p1, q1);
        if (fraction > 0 && abs(from_rational<Real>(fraction) / x - 1) < tolerance) {
            return fraction;
        }
        if (rest == whole) {
            return std::nullopt;
        }
        rest = 1 / (rest - whole);
    }
    return std::nullopt;
}

formula::Expr power_of(const formula::Expr& base, const Rational& k) {
    return k == 1                ? base
           : k == Rational(1, 2) ? formula::Expr::call("sqrt", {base})
                                 : pow(base, formula::quotient_of(k));
}

/// Returns x as rational * pi^j, or as the square root of a rational times pi^j.
std::optional<formula::Expr> simple_constant(const Real& x, unsigned digits) {
    const Real pi_value = pi<Real>();
    for (const bool root : {false, true}) {
        for (const int j : {0, 1, -1, 2, -2}) {
            Real y = x / pow(pi_value, j);
            y = root ? Real(y * y) : y;
            const auto q = simple_fraction(y, digits);
            if (!q) {
                continue;
            }
            const formula::Expr number =
                root ? formula::Expr::call("sqrt", {formula::quotient_of(*q)})
                     : formula::quotient_of(*q);
            if (j == 0) {
                return number;
            }
            const formula::Expr pi_power = power_of(formula::Expr::pi(), Rational(std::abs(j)));
            return j > 0 ? number * pi_power : number / pi_power;
        }
    }
    return std::nullopt;
}

/// Solves the least-squares problem by Gaussian elimination of the normal equations with full
/// pivoting. Columns that the samples cannot distinguish get 0.
std::vector<double> solve_exponents(const std::vector<std::vector<double>>& rows,
                                    const std::vector<double>& right) {
    const std::size_t n = rows.front().size();
    std::vector<std::vector<double>> m(n, std::vector<double>(n + 1, 0.0));
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                m[i][j] += rows[r][i] * rows[r][j];
            }
            m[i][n] += rows[r][i] * right[r];
        }
    }
    std::vector<std::size_t> pivots;
    std::vector<bool> used(n, false);
    for (std::size_t step = 0; step < n; ++step) {
        std::size_t best = n;
        for (std::size_t i = 0; i < n; ++i) {
            if (!used[i] && (best == n || m[i][i] > m[best][best])) {
                best = i;
            }
        }
        if (m[best][best] < 1e-7) {
            break;
        }
        used[best] = true;
        pivots.push_back(best);
        for (std::size_t i = 0; i < n; ++i) {
            if (i == best) {
                continue;
            }
            const double f = m[i][best] / m[best][best];
            for (std::size_t j = 0; j <= n; ++j) {
                m[i][j] -= f * m[best][j];
            }
        }
    }
    std::vector<double> k(n, 0.0);
    for (const std::size_t i : pivots) {
        k[i] = m[i][n] / m[i][i];
    }
    return k;
}

} // namespace

std::optional<formula::Expr> recognise_ratio(const std::vector<RatioSample>& samples,
                                             unsigned digits) {
    if (samples.size() < 3) {
        return std::nullopt;
    }
    const int sign = samples.front().ratio < 0 ? -1 : 1;
    std::vector<std::string> names;
    for (const auto& [name, value] : samples.front().parameters) {
        const bool everywhere =
            std::all_of(samples.begin(), samples.end(), [&, &key = name](const RatioSample& s) {
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
    const std::vector<double> exponents = solve_exponents(rows, right);
    std::vector<Rational> k;
    for (std::size_t i = 1; i < exponents.size(); ++i) {
        const double quarters = std::round(exponents[i] * 4);
        if (std::abs(quarters) > 80 || std::abs(exponents[i] * 4 - quarters) > 1e-2) {
            return std::nullopt;
        }
        k.emplace_back(static_cast<long>(quarters), 4L);
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
    std::optional<formula::Expr> over;
    std::optional<formula::Expr> under;
    if (!(*number == formula::Expr::number(1))) {
        over = number;
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (k[i] == 0) {
            continue;
        }
        auto& side = k[i] > 0 ? over : under;
        const formula::Expr factor = power_of(formula::Expr::symbol(names[i]), abs(k[i]));
        side = side ? *side * factor : factor;
    }
    formula::Expr ratio = over.value_or(formula::Expr::number(1));
    if (under) {
        ratio = ratio / *under;
    }
    return sign < 0 ? -ratio : ratio;
}

} // namespace edgeproof::audit
