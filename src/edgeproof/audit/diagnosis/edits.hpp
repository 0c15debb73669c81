// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <functional>
#include <string>
#include <vector>

namespace edgeproof::audit {

/// A printed formula with one thing changed.
struct Edit {
    formula::Expr formula;
    std::string what;   ///< "sign", "coefficient", "exponent", "symbol", "factor", "bracket", ...
    std::string before; ///< the smallest part that shows the change
    std::string after;
    int cost = 1; ///< 1: one character; 2: an insertion or a removal; 3: rarer
};

/// The names and factors that an edit may insert.
struct EditAlphabet {
    std::vector<std::string> symbols;   ///< names that may be exchanged for each other
    std::vector<formula::Expr> factors; ///< factors that may have been lost
};

/// Returns every single edit of the formula, sorted by cost and then by position in the text:
/// signs, coefficients, exponents, roots, symbols and primes, factors lost, added or inverted, the
/// sign of a bracket, an extra term. No edit is equal to the formula itself.
[[nodiscard]] std::vector<Edit> single_edits(const formula::Expr& formula,
                                             const EditAlphabet& alphabet);

} // namespace edgeproof::audit
