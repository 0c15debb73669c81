// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/certificate/theory/theory.hpp"
#include "edgeproof/formula/expr.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What theorems about one contact with numbers have in common.
namespace edgeproof::certificate {

/// What agreement is stated to.
inline constexpr std::string_view agreement = "1 / 10 ^ 12";

/// |first - second| at a sample, as far as the enclosures have it, and beside the larger of both.
struct Gap {
    double least = 0;
    double relative = 0;
};
/// None where there are no enclosures.
[[nodiscard]] std::optional<Gap> gap_at(const formula::Expr& first, const formula::Expr& second,
                                        const audit::Sample& sample);
/// The least that first at one sample is above second at another; none where it is not.
[[nodiscard]] std::optional<double> excess(const formula::Expr& first, const audit::Sample& at,
                                           const formula::Expr& second, const audit::Sample& other);

/// "253 / 10 ^ 3": three digits, a little below.
[[nodiscard]] std::string fraction_below(double gap);

/// The definitions of the numbers, and the tactics that use them.
[[nodiscard]] std::string constants(const std::vector<Constant>& all);

/// "Print Assumptions" of theorems, once for all of them: it takes longer than most proofs.
[[nodiscard]] std::string assumptions(const std::vector<std::string>& theorems);
/// A theorem and its proof, without "Print Assumptions".
[[nodiscard]] std::string bare_theorem(const std::string& name, const std::string& statement,
                                       const std::string& proof);
/// A theorem and its proof as a file has them.
[[nodiscard]] std::string theorem_text(const std::string& name, const std::string& statement,
                                       const std::string& proof);

} // namespace edgeproof::certificate
