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
    int cost = 1; ///< 1: one stroke of the pen; 2: something put in or taken out; 3: rarer
};

/// What an edit may put in.
struct EditAlphabet {
    std::vector<std::string> symbols;   ///< names that may stand for one another
    std::vector<formula::Expr> factors; ///< factors that may have been lost
};

/// Every single edit of the formula, cheapest first and then in the order of the text: signs,
/// coefficients, exponents, roots, symbols and primes, factors lost, added or inverted, the sign of
/// a bracket, a term too many. None is equal to the formula as it stands.
[[nodiscard]] std::vector<Edit> single_edits(const formula::Expr& formula,
                                             const EditAlphabet& alphabet);

} // namespace edgeproof::audit
