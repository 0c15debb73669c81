// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/printed_source.hpp"
#include "edgeproof/formula/expr.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace edgeproof::report {

/// Returns the formula in the style of a manual correction: exponents as fractions (eps^(3/2), not
/// eps^1.5), and factors next to a fraction moved into it (P1/(4*a)*(X + S), not P1/a*(X + S)/4);
/// the rest keeps its order. The value is the same wherever it is defined.
[[nodiscard]] formula::Expr arranged(const formula::Expr& e);
/// Returns a derived formula in a similar style: every product as one fraction, numbers in front,
/// sums of several terms next to it.
[[nodiscard]] formula::Expr gathered(const formula::Expr& e);

/// Returns LaTeX of a formula, in the notation of the source for a family of scenes, suitable for
/// the paper.
[[nodiscard]] std::string formula_tex(const formula::Expr& e, const audit::PrintedSource& source,
                                      std::string_view family = {});

/// Reads a text as a formula of the claim's vocabulary; nothing for words, a list, a relation.
[[nodiscard]] std::optional<formula::Expr> formula_of(std::string_view text,
                                                      const audit::Claim& claim);

} // namespace edgeproof::report
