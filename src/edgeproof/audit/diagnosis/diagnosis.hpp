// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/formula/expr.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::audit {

/// A printed formula with one thing changed.
struct Edit {
    Expr formula;
    std::string what;   ///< "sign", "coefficient", "exponent", "symbol", "factor", "bracket", ...
    std::string before; ///< the smallest part that shows the change
    std::string after;
    int cost = 1; ///< 1: one character; 2: an insertion or a removal; 3: rarer
};

/// The names and factors that an edit may insert.
struct EditAlphabet {
    std::vector<std::string> symbols; ///< names that may be exchanged for each other
    std::vector<Expr> factors;        ///< factors that may have been lost
    bool of_pressure = false;         ///< the right value is a pressure
};

/// Returns the formula with one number in place of its integer factors: x/4 for x/2/2.
[[nodiscard]] Expr with_one_number(const Expr& formula);

/// Returns every single edit of the formula, sorted by cost and then by position in the text:
/// signs, coefficients, exponents, roots, symbols and primes, factors lost, added or inverted, the
/// sign of a bracket, an extra term. No edit is equal to the formula itself.
[[nodiscard]] std::vector<Edit> single_edits(const Expr& formula, const EditAlphabet& alphabet);

/// A refuted formula and the exact one, with the tests for candidate corrections.
struct RefutedFormula {
    Expr printed; ///< as written, without definitions put in
    Expr exact;   ///< the formula that it should equal, as written
    EditAlphabet alphabet;
    /// A cheap test: true if a formula agrees with the exact one at a few points, to a few digits.
    std::function<bool(const Expr&)> passes_screening;
    /// The complete check: true if the formula is proved or confirmed.
    std::function<bool(const Expr&)> is_right;
    std::optional<Expr> ratio;   ///< printed/exact, if a closed form was recognised
    std::optional<Expr> derived; ///< the exact formula, if it is derived or known
};

/// Adds the diagnosis to the outcome: the smallest single edit that makes the formula confirmed or
/// proved; failing that, the printed formula divided by the ratio; failing that, the derived
/// formula. `correct` is set only to a formula that is itself confirmed or proved. If the outcome
/// is underspecified, its note is kept, and the correction follows.
void diagnose(const RefutedFormula& refuted, Outcome& outcome);

/// Returns the names that may be exchanged for each other in a claim, and the factors that may have
/// been lost: powers of those names and of a scene's parameters.
[[nodiscard]] EditAlphabet alphabet_for(const Claim& claim, const Expr& printed, const Expr& exact,
                                        const SceneSpec* scene = nullptr);

/// The ratio printed/exact for given values of the parameters.
struct RatioSample {
    std::map<std::string, Real, std::less<>> parameters;
    Real ratio;
};

/// Returns the ratio as a closed form that agrees with every sample to `digits` digits: a sign, a
/// rational, a power of pi, or a square or cube root of them, and powers of the parameters whose
/// exponents are twelfths. Returns nothing if there is no such form of moderate size, or too few
/// samples to decide.
[[nodiscard]] std::optional<Expr> recognise_ratio(const std::vector<RatioSample>& samples,
                                                  unsigned digits);

/// Solves (J^T J + damping) x = J^T r by Gauss-Jordan elimination, with the largest pivot on the
/// diagonal first. It ends at a pivot that is not above `least_pivot`: the unknowns that are left,
/// which the rows of J do not distinguish, get no value. Without a bound of the roundoff.
template <class T>
[[nodiscard]] std::vector<std::optional<T>> least_squares(const std::vector<std::vector<T>>& J,
                                                          const std::vector<T>& r, const T& damping,
                                                          const T& least_pivot) {
    const std::size_t n = J.front().size();
    std::vector<std::vector<T>> m(n, std::vector<T>(n + 1, T(0)));
    for (std::size_t k = 0; k < J.size(); ++k) {
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                m[i][j] += J[k][i] * J[k][j];
            }
            m[i][n] += J[k][i] * r[k];
        }
    }
    std::vector<bool> used(n, false);
    for (std::size_t i = 0; i < n; ++i) {
        m[i][i] += damping;
    }
    for (std::size_t step = 0; step < n; ++step) {
        std::size_t best = n;
        for (std::size_t i = 0; i < n; ++i) {
            if (!used[i] && (best == n || m[i][i] > m[best][best])) {
                best = i;
            }
        }
        if (!(m[best][best] > least_pivot)) {
            break;
        }
        used[best] = true;
        for (std::size_t i = 0; i < n; ++i) {
            if (i == best) {
                continue;
            }
            const T f = m[i][best] / m[best][best];
            for (std::size_t j = 0; j <= n; ++j) {
                m[i][j] -= f * m[best][j];
            }
        }
    }
    std::vector<std::optional<T>> x(n);
    for (std::size_t i = 0; i < n; ++i) {
        if (used[i]) {
            x[i] = T(m[i][n] / m[i][i]);
        }
    }
    return x;
}

} // namespace edgeproof::audit
