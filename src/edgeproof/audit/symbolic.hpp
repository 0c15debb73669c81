// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/edge.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/rational.hpp"

#include <optional>
#include <string>
#include <vector>

namespace edgeproof {

/// Under what a symbolic identity is to hold. P1, P2, ..., b, b1, ... are free symbols, unless
/// the contact is symmetric (b = a) or P(a), b(a) are given as formulas in a.
struct SymbolicCase {
    bool symmetric = false;
    std::optional<Expr> P;
    std::optional<Expr> b;
};

/// One term of an expansion: coefficient times variable^exponent.
struct ExpansionTerm {
    Rational exponent;
    Expr coefficient;
};

/// What an expansion is in, from which edge `x` counts if it is u, and up to which power.
struct ExpansionIn {
    std::string variable;
    Edge edge = Edge::right;
    Rational through;
};

/// Two expansions held against each other, power by power.
struct ExpansionComparison {
    struct Term {
        Rational exponent;
        Expr printed;
        Expr derived;
        bool equal = false;
    };
    std::vector<Term> terms;
    [[nodiscard]] bool equal() const;
    /// nullptr if there is none.
    [[nodiscard]] const Term* first_wrong() const;
};

/// Everything here is done by GiNaC, one caller at a time, and deterministic.

/// With right_c0, ... derived, derivatives taken, and tidied. Throws Error for what has no symbolic
/// meaning.
[[nodiscard]] Expr derive(const Expr& e, const SymbolicCase& under);
/// True if x - y is shown to vanish identically (lengths positive); false shows nothing.
[[nodiscard]] bool proved_equal(const Expr& x, const Expr& y, const SymbolicCase& under);
/// The non-vanishing terms of e up to `in.through`. Throws DomainError where e has no expansion.
[[nodiscard]] std::vector<ExpansionTerm> expand(const Expr& e, const ExpansionIn& in,
                                                const SymbolicCase& under);
[[nodiscard]] ExpansionComparison compare_expansions(const Expr& printed, const Expr& derived,
                                                     const ExpansionIn& in,
                                                     const SymbolicCase& under);
/// The sum of the terms, as a formula.
[[nodiscard]] Expr sum_of(const std::vector<ExpansionTerm>& terms, const std::string& variable);

} // namespace edgeproof
