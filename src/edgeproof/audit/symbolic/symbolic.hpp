// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/rational.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::audit {

/// Under what a symbolic identity is to hold. P1, P2, ..., b, b1, ... are free symbols, unless
/// the contact is symmetric (b = a) or P(a), b(a) are given as formulas in a.
struct SymbolicCase {
    bool symmetric = false;
    std::optional<formula::Expr> P;
    std::optional<formula::Expr> b;
    /// Further names that stand for formulas in free symbols, such as P2 = m*P1/a.
    std::map<std::string, formula::Expr, std::less<>> names = {};
};

/// One term of an expansion: coefficient times variable^exponent.
struct ExpansionTerm {
    Rational exponent;
    formula::Expr coefficient;
};

/// What an expansion is in, from which edge `x` counts if it is u, and up to which power.
struct ExpansionIn {
    std::string variable;
    contact::Edge edge = contact::Edge::right;
    Rational through;
};

/// Two expansions held against each other, power by power.
struct ExpansionComparison {
    struct Term {
        Rational exponent;
        formula::Expr printed;
        formula::Expr derived;
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
[[nodiscard]] formula::Expr derive(const formula::Expr& e, const SymbolicCase& under);
/// The partial derivative by a free name of a formula that is derived, as above. Throws Error where
/// a function that holds the name has no derivative in symbols.
[[nodiscard]] formula::Expr derivative(const formula::Expr& e, const std::string& name);
/// True if x - y is shown to vanish identically (lengths positive); false shows nothing.
[[nodiscard]] bool proved_equal(const formula::Expr& x, const formula::Expr& y,
                                const SymbolicCase& under);
/// The non-vanishing terms of e up to `in.through`. Throws DomainError where e has no expansion.
[[nodiscard]] std::vector<ExpansionTerm> expand(const formula::Expr& e, const ExpansionIn& in,
                                                const SymbolicCase& under);
[[nodiscard]] ExpansionComparison compare_expansions(const formula::Expr& printed,
                                                     const formula::Expr& derived,
                                                     const ExpansionIn& in,
                                                     const SymbolicCase& under);
/// The sum of the terms, as a formula.
[[nodiscard]] formula::Expr sum_of(const std::vector<ExpansionTerm>& terms,
                                   const std::string& variable);

} // namespace edgeproof::audit
