// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/audit/ledger/printed_formula.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace edgeproof::audit {

/// Numbers in place of the decimals of a printed formula, in balls. Every decimal represents the
/// interval of half a unit in its last place.
using Decimals = std::vector<Ball>;

/// Gives a sample values for the names of the decimals (name_of_decimal).
void set_decimals(EnclosedSample& sample, const Decimals& numbers);

/// One comparison that a printed formula with decimals must pass.
struct DecimalEquation {
    /// Returns the printed value for these decimals. Throws Error if it has no enclosure.
    std::function<Ball(const Decimals&)> printed;
    Ball exact;
    Ball scale; ///< positive; differences are compared with it
};
/// Returns the equation of a formula with names for its decimals and an exact one at a sample. The
/// scale is that of `scale`; without it the exact value, or the sum of the sizes of the terms of
/// `terms` where it may be zero. `integral_digits`: as in EnclosedSample.
[[nodiscard]] DecimalEquation equation_at(const Sample& sample, long bits, unsigned integral_digits,
                                          const Expr& printed, const Expr& exact,
                                          const std::optional<Expr>& scale, const Expr& terms);

/// Judges a formula with decimals, to `digits` digits: confirmed if numbers that round to all of
/// them are proved to satisfy all equations to D - 5 digits; refuted if it is proved that no such
/// numbers do; imprecise if numbers at most one and a half units away do. Adds `rounded` to the
/// evidence. `bits`: of the numbers.
[[nodiscard]] Judgement judge_decimals(const PrintedFormula& printed,
                                       const std::vector<DecimalEquation>& equations,
                                       unsigned digits, long bits, Outcome& outcome);

} // namespace edgeproof::audit
