// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/symbolic/symbolic.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/rational.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// Polynomial relations with rational coefficients between quantities of a contact that hold along
/// every profile, that is identically in the free derivatives of P and b. docs/relations.md has the
/// argument.
namespace edgeproof::audit {

/// A quantity: what a reader calls it, and its formula in a, b, L = a + b, P1, P2, ..., b1, ...,
/// right_c0, left_c0, ..., right_s0, ..., Q, sig0 and names of one's own, which are free. No roots.
struct RelatedQuantity {
    std::string name;
    formula::Expr formula;
};

struct PolynomialRelation {
    struct Term {
        Integer coefficient;
        std::vector<unsigned> exponents; ///< of the quantities
        [[nodiscard]] unsigned degree() const;
    };
    std::vector<Term> terms; ///< their sum is zero; integers without a common factor, leading first
    [[nodiscard]] unsigned degree() const { return terms.front().degree(); }
    [[nodiscard]] std::size_t terms_with(std::size_t quantity) const;
    [[nodiscard]] bool involves(std::size_t quantity) const { return terms_with(quantity) > 0; }
};

struct FoundRelations {
    /// Each proved by symbols, by degree. None follows from those before it by division by leading
    /// terms.
    std::vector<PolynomialRelation> relations;
    /// Every relation up to the degree asked for is a sum of multiples of these: proved by the rank
    /// of the matrix of samples. False only where a candidate was not proved.
    bool complete = true;
    std::size_t monomials = 0; ///< up to that degree
    std::size_t samples = 0;   ///< most of one matrix
    std::size_t grades = 0;    ///< matrices
};

/// All polynomial relations of total degree up to `degree`. Throws InputError where there are too
/// many monomials, or a formula has a root, or a name stands for nothing here.
[[nodiscard]] FoundRelations find_relations(const std::vector<RelatedQuantity>& quantities,
                                            unsigned degree, const SymbolicCase& under);

/// "6*L*b1^2*left.c1 - 6*L*right.c1 - ... = 0".
[[nodiscard]] std::string relation_text(const PolynomialRelation& relation,
                                        const std::vector<RelatedQuantity>& quantities);
/// "left.c1 = (...)/(6*L*b1^2)", where the relation is linear in that quantity.
[[nodiscard]] std::optional<std::string> solved_text(const PolynomialRelation& relation,
                                                     const std::vector<RelatedQuantity>& quantities,
                                                     std::size_t quantity);

} // namespace edgeproof::audit
