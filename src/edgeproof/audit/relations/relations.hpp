// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/symbolic/symbolic.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/real.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Polynomial relations with rational coefficients between quantities of a contact that hold for
/// every profile, that is, identically in the free derivatives of P and b. docs/relations.md
/// explains the argument.
namespace edgeproof::audit {

/// A quantity: its name for the user, and its formula in a, b, L = a + b, P1, P2, ..., b1, ...,
/// right_c0, left_c0, ..., right_s0, ..., Q, sig0 and additional free names: a quotient of
/// polynomials in names and square roots.
struct RelatedQuantity {
    std::string name;
    Expr formula;
};

struct PolynomialRelation {
    struct Term {
        Integer coefficient;
        std::vector<unsigned> exponents; ///< of the quantities
        [[nodiscard]] unsigned degree() const;
    };
    std::vector<Term> terms; ///< coprime integers, leading term first; the sum is 0
    [[nodiscard]] unsigned degree() const { return terms.front().degree(); }
    [[nodiscard]] std::size_t terms_with(std::size_t quantity) const;
    [[nodiscard]] bool involves(std::size_t quantity) const { return terms_with(quantity) > 0; }
};

struct FoundRelations {
    /// In ascending degree, each proved by symbols. None follows from the previous ones by division
    /// by leading terms.
    std::vector<PolynomialRelation> relations;
    /// True if every relation up to the given degree is a sum of multiples of these, as proved by
    /// the rank of the matrix of samples. False only if a candidate was not proved.
    bool complete = true;
    std::size_t monomials = 0; ///< the number of monomials up to that degree
    std::size_t samples = 0;   ///< the most samples of one matrix
};

/// Finds all polynomial relations of total degree up to `degree`. Throws InputError if there are
/// too many monomials, or if a formula has another function or an unknown name.
[[nodiscard]] FoundRelations find_relations(const std::vector<RelatedQuantity>& quantities,
                                            unsigned degree, const SymbolicCase& under);

/// Whether the first of the quantities is a function of the others near some point, for free names,
/// by the ranks of their gradients: of the others alone and of all. A rank modulo a prime is a
/// lower bound; the upper one is the number of rows or of columns that differ.
struct GradientRanks {
    std::size_t others = 0;
    std::size_t all = 0;
    std::optional<bool> function; ///< nothing if the bounds do not decide
};
[[nodiscard]] GradientRanks gradient_ranks(const std::vector<RelatedQuantity>& quantities,
                                           const SymbolicCase& under);

/// True if the derivative of a relation by a quantity is proved not to vanish identically: where it
/// does not vanish, the quantity is a function of the others.
[[nodiscard]] bool determines(const PolynomialRelation& relation, std::size_t quantity,
                              const std::vector<RelatedQuantity>& quantities,
                              const SymbolicCase& under);

/// Returns "6*L*b1^2*left.c1 - 6*L*right.c1 - ... = 0".
[[nodiscard]] std::string relation_text(const PolynomialRelation& relation,
                                        const std::vector<RelatedQuantity>& quantities);
/// Returns "left.c1 = (...)/(6*L*b1^2)" if the relation is linear in that quantity.
[[nodiscard]] std::optional<std::string> solved_text(const PolynomialRelation& relation,
                                                     const std::vector<RelatedQuantity>& quantities,
                                                     std::size_t quantity);

inline constexpr long most_relation_degree = 12;

/// A search for relations, as the user writes it (docs/relations.md).
struct RelationQuestion {
    std::vector<std::string> quantities; ///< "left.c1", "b1", "L", ...
    long degree = 4;
    bool symmetric = false;                                 ///< b = a
    std::vector<std::pair<std::string, std::string>> given; ///< not free: {"P2", "m*P1/a"}
    std::vector<std::string> free;                          ///< additional free names: "m"
};

/// The result of find_relations, and the quantities in which it is written.
struct AskedRelations {
    std::vector<RelatedQuantity> quantities;
    FoundRelations found;
};

/// Searches for relations. Throws InputError for a degree outside 1 ... 12, unknown names and
/// malformed formulas, and as find_relations does; Interrupted.
[[nodiscard]] AskedRelations asked_relations(const RelationQuestion& question);

/// The exponents of a formula's scaling with the units of force, of length and of shear force.
using ScalingWeights = std::array<Rational, 3>;

/// Finds the weights from the expression tree. Returns nothing if the terms of a sum have different
/// weights, or if a function other than sqrt is called.
[[nodiscard]] std::optional<ScalingWeights> scaling_weights(const Expr& e);

} // namespace edgeproof::audit
