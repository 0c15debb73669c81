// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/certificate/theory/theory.hpp"
#include "edgeproof/formula/expr.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::certificate {

/// A theorem about formulas of a ledger: the facts of a theory that they need, and their text in
/// Coq.
class Statement {
public:
    explicit Statement(const Theory& theory) : theory_(theory) {}

    /// Returns the formula in Coq. Coefficients, the load and the pressure become unknowns of their
    /// facts. Throws NotStated.
    [[nodiscard]] std::string operator()(const formula::Expr& e);
    /// Returns `conclusion` after the facts: "exists r0 r1 r2, is_the_right_series ... /\ ". Throws
    /// NotStated if there are no facts: such a theorem is not about a contact.
    [[nodiscard]] std::string text(const std::string& conclusion) const;
    /// Returns the proof of the facts, then `last`, the proof of the conclusion.
    [[nodiscard]] std::string proof(const std::string& last) const;

private:
    void need(const Fact& fact, const std::string& what);
    std::string call(const formula::Expr& e, const CoqNames& names);
    std::string local_sum(const formula::Expr& e);
    std::string integral(const formula::Expr& e, CoqNames names);

    const Theory& theory_;
    std::vector<Fact> facts_;
};

/// Common parts of theorems about one contact with given numbers.
/// The tolerance for statements of agreement, relative to the exact value.
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

/// Returns a theorem and its proof.
[[nodiscard]] std::string theorem_text(const std::string& name, const std::string& statement,
                                       const std::string& proof);

} // namespace edgeproof::certificate
