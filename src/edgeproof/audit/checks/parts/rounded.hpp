// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/agreement/samples.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::audit {

/// A decimal in a formula, as it is printed: "0.418".
struct PrintedDecimal {
    std::string text;
    std::size_t offset = 0;
    Rational value;
    Rational unit; ///< of its last place
};

/// Numbers with a decimal point, in the order in which they stand: "0.418*sqrt(2*x)" has one.
[[nodiscard]] std::vector<PrintedDecimal> printed_decimals(std::string_view formula);

/// A formula that would be right with other constants in the place of some of its decimals.
struct RoundedFormula {
    struct Constant {
        PrintedDecimal printed;
        Real exact;          ///< within 10^-digits of itself
        bool rounds = false; ///< to what is printed: within half a unit of its last place
        Real units_off;      ///< exact - printed, in units of the last place
    };
    std::vector<Constant> constants;
    std::string with_them; ///< the formula, each constant rounded to the printed place
    std::size_t samples = 0;
    int digits = 0;
};

/// The constants with which a printed formula, refuted as it stands, is right at every sample: one
/// of its decimals, or all of them. Found by Newton's iteration at as many samples as there are
/// constants, of more; then proved at every sample: in balls the exact value lies between those of
/// the formula for the constant lowered and raised by 10^-digits of itself. Nothing where there are
/// no such constants, or the balls do not tell.
[[nodiscard]] std::optional<RoundedFormula> find_rounded(const Claim& claim,
                                                         const EvaluatedSamples& samples_at,
                                                         const formula::Expr& exact,
                                                         unsigned digits);

/// Of a claim that came out refuted, which has decimals in it: confirmed, if each stands for a
/// constant that rounds to it; imprecise, if one is off by a unit of its last place; else refuted
/// still, and `correct` has the decimals as they should be. Evidence `rounded`. Claims with
/// `decimals = "exact"` are left alone.
void judge_rounded(const Claim& claim, const EvaluatedSamples& samples_at,
                   const formula::Expr& exact, unsigned digits, Outcome& outcome);

} // namespace edgeproof::audit
