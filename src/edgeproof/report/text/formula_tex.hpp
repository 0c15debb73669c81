// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/printed_source.hpp"
#include "edgeproof/formula/expr.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace edgeproof::report {

/// The same formula as a person writes it who corrects one: exponents as fractions (eps^(3/2), not
/// eps^1.5), and what stands beside a fraction put into it (P1/(4*a)*(X + S), not P1/a*(X + S)/4);
/// all else stays where it stood. The value is the same wherever there is one.
[[nodiscard]] formula::Expr arranged(const formula::Expr& e);
/// The same for a formula that a program derived: every product one fraction, numbers in front,
/// sums of several terms beside it.
[[nodiscard]] formula::Expr gathered(const formula::Expr& e);

/// LaTeX of a formula, in the notation of the source over a family of scenes: to be read, and to be
/// copied into the paper.
[[nodiscard]] std::string formula_tex(const formula::Expr& e, const audit::PrintedSource& source,
                                      std::string_view family = {});

/// A text as a formula of the claim's vocabulary; nothing for words, a list, a relation.
[[nodiscard]] std::optional<formula::Expr> formula_of(std::string_view text,
                                                      const audit::Claim& claim);

} // namespace edgeproof::report
