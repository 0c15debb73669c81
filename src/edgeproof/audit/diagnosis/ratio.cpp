// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/diagnosis/ratio.hpp"

#include "edgeproof/formula/quotient.hpp"
#include "edgeproof/precision/arithmetic.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace edgeproof::audit {
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
