// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/real.hpp"

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace edgeproof::algebra {
class Form;
} // namespace edgeproof::algebra

namespace edgeproof::audit {

using contact::Edge;
using formula::Expr;
using formula::order_behind;

/// The assumptions of a symbolic identity. P1, P2, ..., b, b1, ... are free symbols, unless the
/// contact is symmetric (b = a) or P(a), b(a) are given as formulas in a.
struct SymbolicCase {
    bool symmetric = false;
    std::optional<Expr> P;
    std::optional<Expr> b;
    /// Additional names defined by formulas in free symbols, such as P2 = m*P1/a.
    std::map<std::string, Expr, std::less<>> names = {};
    /// right_s0, left_s0, ... are the multipliers of the shear under full stick, not free.
    bool full_stick = false;
    /// Names that are not positive in all contacts considered.
    std::set<std::string, std::less<>> either_sign = {};
};

/// The variable of an expansion, the edge (if the variable is u), and the highest power.
struct ExpansionIn {
    std::string variable;
    Edge edge = Edge::right;
    Rational through;
};

/// A comparison of two expansions, power by power.
struct ExpansionComparison {
    struct Term {
        Rational exponent;
        Expr printed;
        Expr derived;
        bool equal = false;
    };
    std::vector<Term> terms;
    [[nodiscard]] bool equal() const;
    /// The sum of the derived terms as a formula in the variable.
    [[nodiscard]] Expr derived(const std::string& variable) const;
};

/// Returns the form of e (algebra/form.hpp) with right_c0, ... derived and derivatives taken.
[[nodiscard]] algebra::Form form_in(const Expr& e, const SymbolicCase& under);
/// Returns it as a formula.
[[nodiscard]] Expr derive(const Expr& e, const SymbolicCase& under);
/// Returns the partial derivative, with respect to a free name, of a formula returned by derive.
/// Throws Error if a function that contains the name has no symbolic derivative.
[[nodiscard]] Expr derivative(const Expr& e, const std::string& name);
/// True if x - y is shown to vanish identically (lengths positive); false shows nothing. Under full
/// stick, given(f, Q = ...) and given(f, sig0 = ...) have a meaning.
[[nodiscard]] bool proved_equal(const Expr& x, const Expr& y, const SymbolicCase& under);
/// Compares the terms up to `in.through`. Throws DomainError where there is no expansion.
[[nodiscard]] ExpansionComparison compare_expansions(const Expr& printed, const Expr& derived,
                                                     const ExpansionIn& in,
                                                     const SymbolicCase& under);

} // namespace edgeproof::audit
