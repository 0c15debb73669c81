// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/certificate/theory/theory.hpp"
#include "edgeproof/formula/expr.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Common parts of theorems about one contact with given numbers.
namespace edgeproof::certificate {

/// The tolerance for statements of agreement.
inline constexpr std::string_view agreement = "1 / 10 ^ 12";

/// A lower bound of |first - second| at a sample, and the same relative to the larger of both.
struct Gap {
    double least = 0;
    double relative = 0;
};
/// Returns no value if there are no enclosures.
[[nodiscard]] std::optional<Gap> gap_at(const formula::Expr& first, const formula::Expr& second,
                                        const audit::Sample& sample);
/// Returns a lower bound of first at one sample minus second at another; no value if it is not
/// positive.
[[nodiscard]] std::optional<double> excess(const formula::Expr& first, const audit::Sample& at,
                                           const formula::Expr& second, const audit::Sample& other);

/// Returns a fraction of three digits slightly below `gap`: "253 / 10 ^ 3".
[[nodiscard]] std::string fraction_below(double gap);

/// Returns the definitions of the numbers, and the tactics that use them.
[[nodiscard]] std::string constants(const std::vector<Constant>& all);

/// Returns "Print Assumptions" for the theorems, once for all of them, because it takes longer than
/// most proofs.
[[nodiscard]] std::string assumptions(const std::vector<std::string>& theorems);
/// Returns a theorem and its proof, without "Print Assumptions".
[[nodiscard]] std::string bare_theorem(const std::string& name, const std::string& statement,
                                       const std::string& proof);
/// Returns a theorem and its proof, with "Print Assumptions".
[[nodiscard]] std::string theorem_text(const std::string& name, const std::string& statement,
                                       const std::string& proof);

} // namespace edgeproof::certificate
