// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/certificate/theory/theory.hpp"
#include "edgeproof/formula/expr.hpp"

#include <string>
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
    /// Returns `conclusion` after the facts: "exists r0 r1 r2, right_edge_series ... /\ ".
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

} // namespace edgeproof::certificate
