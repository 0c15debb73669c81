// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"
#include "edgeproof/audit/relations/relations.hpp"
#include "edgeproof/audit/sample/formal_values.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <set>

namespace edgeproof::audit {
namespace {

constexpr unsigned working = 60;
constexpr std::size_t gradient_draws = 4;

/// The gradient of a formula by all names, by central differences good to about 20 digits.
std::vector<Real> gradient(const formula::Expr& e, const FormalValues& at,
                           const std::vector<std::string>& names) {
    const PrecisionScope scope(working);
    const Real step = pow(Real(10), -10);
    std::vector<Real> g;
    for (const std::string& name : names) {
        const Real x = at.values().at(name);
        FormalValues up = at;
        FormalValues down = at;
        up.set(name, Real(x + step));
        down.set(name, Real(x - step));
        g.emplace_back((up.evaluate(e) - down.evaluate(e)) / (2 * step));
    }
    return g;
}

Real largest(const std::vector<Real>& v) {
    Real most(0);
    for (const Real& x : v) {
        most = std::max(most, Real(abs(x)));
    }
    return most;
}

/// What is left of a row after the others are eliminated from it, relative to its own size.
Real left_over(std::vector<std::vector<Real>> others, std::vector<Real> row) {
    const PrecisionScope scope(working);
    const Real size = largest(row);
    const Real negligible = pow(Real(10), -15);
    if (size == 0) {
        return size;
    }
    for (std::size_t i = 0; i < others.size(); ++i) {
        // The largest pivot left among all rows and columns.
        std::size_t best_row = i;
        std::size_t best_column = 0;
        Real best(0);
        for (std::size_t r = i; r < others.size(); ++r) {
            for (std::size_t c = 0; c < row.size(); ++c) {
                if (abs(others[r][c]) > best) {
                    best = abs(others[r][c]);
                    best_row = r;
                    best_column = c;
                }
            }
        }
        if (best < negligible) {
            break;
        }
        std::swap(others[i], others[best_row]);
        const auto eliminate = [&](std::vector<Real>& from) {
            const Real factor = from[best_column] / others[i][best_column];
            for (std::size_t c = 0; c < from.size(); ++c) {
                from[c] -= factor * others[i][c];
            }
        };
        for (std::size_t r = i + 1; r < others.size(); ++r) {
            eliminate(others[r]);
        }
        eliminate(row);
    }
    return largest(row) / size;
}

/// What a search for polynomial relations says of the quantity, which comes first among them.
struct AlgebraicDependence {
    std::optional<std::string> relation; ///< one that holds it, proved by symbols
    std::optional<std::string> solved;   ///< for it, where it is linear in it
    bool none = false;                   ///< proved that there is none up to the degree
};

AlgebraicDependence by_relations(const std::vector<RelatedQuantity>& quantities, unsigned degree,
                                 const SymbolicCase& under, Evidence& evidence) {
    const FoundRelations found = find_relations(quantities, degree, under);
    AlgebraicDependence result;
    std::vector<std::string> texts;
    const PolynomialRelation* shortest = nullptr;
    for (const PolynomialRelation& r : found.relations) {
        texts.push_back(relation_text(r, quantities));
        // The one that a reader can solve most easily.
        const auto size = [](const PolynomialRelation& of) {
            return std::pair(of.terms_with(0), of.terms.size());
        };
        if (r.involves(0) && (shortest == nullptr || size(r) < size(*shortest))) {
            shortest = &r;
        }
    }
    if (shortest != nullptr) {
        result.relation = relation_text(*shortest, quantities);
        result.solved = solved_text(*shortest, quantities, 0);
    }
    result.none = found.complete && !result.relation;
    evidence.add("relations_up_to_degree", std::to_string(degree))
        .add("relations_proved_by_symbols", texts)
        .add("every_other_is_a_sum_of_their_multiples", found.complete)
        .add("monomials", found.monomials)
        .add("samples", found.samples);
    return result;
}

/// Whether a quantity is a function of others, P', P'', b', b'', ... being free: it is one, near a
/// point, if its gradient is a combination of theirs.
Outcome check_dependence(const Claim& claim, const AuditContext& context) {
    const SymbolicCase under = symbolic_case(claim, context);
    const formula::Expr of = derive(claim.formula("of"), under);
    std::vector<formula::Expr> from;
    std::vector<RelatedQuantity> quantities{{claim.text("of"), claim.formula("of")}};
    std::set<std::string> names = free_symbols(of);
    const std::vector<std::string>& texts = claim.list("from");
    const auto& formulas = claim.formulas("from");
    for (std::size_t i = 0; i < formulas.size(); ++i) {
        quantities.push_back({texts[i], formulas[i]});
        from.push_back(derive(formulas[i], under));
        names.merge(free_symbols(from.back()));
    }
    const std::vector<std::string> variables(names.begin(), names.end());
    std::size_t independent = 0;
    std::size_t dependent = 0;
    const PrecisionScope scope(working);
    Real least(1);
    for (std::size_t draw = 0; draw < gradient_draws; ++draw) {
        const FormalValues values(names, under, draw, working);
        std::vector<std::vector<Real>> others;
        for (const formula::Expr& e : from) {
            std::vector<Real> g = gradient(e, values, variables);
            const Real size = largest(g);
            for (Real& x : g) {
                x /= size == 0 ? Real(1) : size;
            }
            others.push_back(std::move(g));
        }
        const Real rest = left_over(std::move(others), gradient(of, values, variables));
        least = std::min(least, rest);
        if (rest > pow(Real(10), -6)) {
            ++independent;
        } else if (rest < pow(Real(10), -12)) {
            ++dependent;
        }
    }
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"))
        .add("from", claim.list("from"))
        .add("derived", to_text(of))
        .add("derived_tex", to_tex(of))
        .add("free", variables)
        .add("draws", gradient_draws)
        .add("left_of_the_gradient_at_least", value_text(least, 6));
    std::set<std::string> known;
    for (const formula::Expr& e : from) {
        known.merge(free_symbols(e));
    }
    std::string alone;
    for (const std::string& name : free_symbols(of)) {
        if (!known.contains(name)) {
            alone += (alone.empty() ? "" : ", ") + name;
        }
    }
    AlgebraicDependence algebraic;
    if (claim.has("degree")) {
        const long degree = claim.integer("degree");
        if (degree < 1 || degree > 12) {
            claim.reject("degree", "relations of degree " + std::to_string(degree),
                         "give a degree from 1 to 12");
        }
        algebraic =
            by_relations(quantities, static_cast<unsigned>(degree), under, outcome.evidence);
    }
    if (independent == gradient_draws) {
        outcome.note = claim.text("of") + " is no function of the others" +
                       (alone.empty() ? "" : ": it depends on " + alone + ", and they do not");
    } else if (dependent == gradient_draws) {
        outcome.note = claim.text("of") + " is a function of the others";
    }
    if (algebraic.relation && dependent == gradient_draws) {
        outcome.note += ", proved by symbols: " + *algebraic.relation;
        outcome.computed = algebraic.solved ? algebraic.solved : algebraic.relation;
    } else if (algebraic.none && independent == gradient_draws) {
        outcome.note += "; no polynomial relation of degree up to " +
                        std::to_string(claim.integer("degree")) + " holds it, proved by rank";
    }
    const bool says_independent = claim.text("says") == "independent";
    if ((says_independent ? independent : dependent) == gradient_draws) {
        outcome.verdict = NotRefuted::confirmed;
    } else if (independent == gradient_draws || dependent == gradient_draws) {
        // What is left of the gradient: nothing, where it is a function; else at least 1e-6.
        outcome.verdict =
            Judgement(says_independent ? Difference::of(pow(Real(10), -6), least, pow(Real(10), -7))
                                       : Difference::of(Real(0), least, pow(Real(10), -6)));
    }
    return outcome;
}

} // namespace

CheckKind dependence_kind() {
    using Type = KeySpec::Type;
    return {"dependence",
            {{.name = "says",
              .type = Type::choice,
              .required = true,
              .choices = {"independent", "function"}},
             required_formula("of"),
             {.name = "from", .type = Type::formulas, .required = true},
             {.name = "degree", .type = Type::integer},
             {.name = "given", .type = Type::formula_table}},
            check_dependence};
}

} // namespace edgeproof::audit
