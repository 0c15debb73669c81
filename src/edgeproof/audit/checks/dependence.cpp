// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"
#include "edgeproof/audit/relations/relations.hpp"
#include "edgeproof/audit/sample/formal_values.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <set>

namespace edgeproof::audit {
namespace {

constexpr std::size_t gradient_draws = 4;
constexpr long gradient_bits = 800;
constexpr std::size_t most_products = 200; ///< in a symbolic determinant

bool is_zero_expr(const Expr& e) { return e.rational() != nullptr && *e.rational() == 0; }

using Matrix = std::vector<std::vector<Expr>>;

bool contains(const std::vector<std::size_t>& list, std::size_t i) {
    return std::ranges::find(list, i) != list.end();
}

/// Expands the determinant of these columns of the last rows along its first row; returns nothing
/// if it has too many products.
std::optional<Expr> determinant(const Matrix& m, const std::vector<std::size_t>& columns,
                                std::size_t& products) {
    if (columns.empty()) {
        return Expr::number(1);
    }
    std::optional<Expr> sum;
    for (std::size_t j = 0; j < columns.size(); ++j) {
        const Expr& entry = m[m.size() - columns.size()][columns[j]];
        if (is_zero_expr(entry)) {
            continue;
        }
        if (++products > most_products) {
            return std::nullopt;
        }
        std::vector<std::size_t> rest = columns;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(j));
        const auto minor = determinant(m, rest, products);
        if (!minor) {
            return std::nullopt;
        }
        if (is_zero_expr(*minor)) {
            continue;
        }
        const Expr term = entry * *minor;
        if (!sum) {
            sum = j % 2 == 0 ? term : -term;
        } else {
            sum = j % 2 == 0 ? *sum + term : *sum - term;
        }
    }
    return sum.value_or(Expr::number(0));
}

/// Returns the position of the entry with the greatest certain distance from zero.
std::optional<std::pair<std::size_t, std::size_t>>
pivot_of(const std::vector<std::vector<Ball>>& rows, const std::vector<std::size_t>& used) {
    std::optional<std::pair<std::size_t, std::size_t>> best;
    std::optional<Real> most;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (contains(used, i)) {
            continue;
        }
        for (std::size_t j = 0; j < rows[i].size(); ++j) {
            if (contains_zero(rows[i][j])) {
                continue;
            }
            const Real size = abs(rows[i][j]).lower();
            if (!most || size > *most) {
                most = size;
                best = {i, j};
            }
        }
    }
    return best;
}

void subtract(std::vector<Ball>& from, const std::vector<Ball>& pivots_row, std::size_t column) {
    const Ball factor = from[column] / pivots_row[column];
    for (std::size_t j = 0; j < from.size(); ++j) {
        from[j] = j == column ? Ball(0, from[j].bits()) : from[j] - factor * pivots_row[j];
    }
}

/// Decides if a quantity is a function of others near some point, for free names: it is one if its
/// gradient lies in the span of their gradients. Derivatives are taken by symbols. At a point, the
/// rank is bounded from below by minors in balls; near it, the rank is bounded from above by minors
/// that vanish by symbols.
class GradientRank {
public:
    /// The formulas must be derived (symbolic.hpp).
    GradientRank(const Expr& of, const std::vector<Expr>& others, const SymbolicCase& under)
        : under_(under) {
        std::set<std::string> held = free_symbols(of);
        for (const Expr& e : others) {
            held.merge(free_symbols(e));
        }
        names.assign(held.begin(), held.end());
        columns_ = names;
        try {
            of_ = gradient(of);
            for (const Expr& e : others) {
                others_.push_back(gradient(e));
            }
            drop_equal_columns();
            std::optional<Eliminated> best;
            for (std::size_t draw = 0; draw < gradient_draws; ++draw) {
                check_interruption();
                auto found = eliminate(draw);
                if (found && (!best || found->rows.size() > best->rows.size())) {
                    best = std::move(found);
                }
            }
            if (best) {
                decide(*best);
            } else {
                problem = "the gradients have no enclosures at the points drawn";
            }
        } catch (const InputError&) {
            throw;
        } catch (const Error& error) {
            problem = error.what();
        }
    }

    std::vector<std::string> names;
    /// If the quantity is not a function of the others: a component of its gradient at a point
    /// after elimination of the others, certainly positive.
    std::optional<Ball> outside;
    /// If it is a function of the others near the point: the rank, with it and without it.
    std::optional<std::size_t> rank;
    std::string at;      ///< the point, as text
    std::string problem; ///< the reason why neither is proved

private:
    using Row = std::vector<Expr>;
    /// The gradients at a drawn point after elimination as far as pivots are certainly not zero.
    struct Eliminated {
        std::vector<std::size_t> rows;    ///< of the pivots
        std::vector<std::size_t> columns; ///< of the pivots
        std::vector<Ball> left;           ///< the rest of the quantity's gradient
        std::string at;
    };
    [[nodiscard]] GradientRank::Row gradient(const Expr& e) const {
        Row row;
        const std::set<std::string> held = free_symbols(e);
        for (const std::string& name : columns_) {
            row.push_back(held.contains(name) ? derivative(e, name) : Expr::number(0));
        }
        return row;
    }
    /// Formulas that depend only on a + b have equal derivatives with respect to a and b.
    void drop_equal_columns() {
        for (std::size_t j = columns_.size(); j-- > 1;) {
            const auto equals = [&](std::size_t i) {
                return of_[i] == of_[j] &&
                       std::ranges::all_of(others_, [&](const Row& r) { return r[i] == r[j]; });
            };
            std::size_t first = 0;
            while (first < j && !equals(first)) {
                ++first;
            }
            if (first == j) {
                continue;
            }
            const auto column = static_cast<std::ptrdiff_t>(j);
            columns_.erase(columns_.begin() + column);
            of_.erase(of_.begin() + column);
            for (Row& row : others_) {
                row.erase(row.begin() + column);
            }
        }
    }
    [[nodiscard]] std::optional<GradientRank::Eliminated> eliminate(std::size_t draw) const {
        const FormalValues values({names.begin(), names.end()}, under_, draw);
        const auto enclose = [&](const Row& row) {
            std::vector<Ball> balls;
            for (const Expr& e : row) {
                balls.push_back(values.enclose(e, gradient_bits));
            }
            return balls;
        };
        Eliminated found;
        std::vector<std::vector<Ball>> rows;
        for (const Row& row : others_) {
            rows.push_back(enclose(row));
        }
        found.left = enclose(of_);
        const auto finite = [](const std::vector<Ball>& row) {
            return std::ranges::all_of(row, [](const Ball& x) { return x.is_finite(); });
        };
        if (!finite(found.left) || !std::ranges::all_of(rows, finite)) {
            return std::nullopt;
        }
        while (const auto pivot = pivot_of(rows, found.rows)) {
            const auto [row, column] = *pivot;
            found.rows.push_back(row);
            found.columns.push_back(column);
            for (std::size_t i = 0; i < rows.size(); ++i) {
                if (!contains(found.rows, i)) {
                    subtract(rows[i], rows[row], column);
                }
            }
            subtract(found.left, rows[row], column);
        }
        for (const std::string& name : names) {
            const Real value = values.values().at(name);
            found.at += (found.at.empty() ? "" : ", ") + name + " = " + value.str(10);
        }
        return found;
    }
    /// True if the row does not increase the rank of the pivots' rows where their minor is not 0.
    [[nodiscard]] bool adds_nothing(const Row& row, const Eliminated& pivots) const {
        Matrix rows{row};
        for (const std::size_t r : pivots.rows) {
            rows.push_back(others_[r]);
        }
        for (std::size_t j = 0; j < columns_.size(); ++j) {
            if (contains(pivots.columns, j)) {
                continue;
            }
            std::vector<std::size_t> bordered = pivots.columns;
            bordered.push_back(j);
            std::size_t products = 0;
            const auto d = determinant(rows, bordered, products);
            if (!d || !proved_equal(*d, Expr::number(0), under_)) {
                return false;
            }
        }
        return true;
    }
    [[nodiscard]] bool others_add_nothing(const Eliminated& pivots) const {
        for (std::size_t i = 0; i < others_.size(); ++i) {
            if (!contains(pivots.rows, i) && !adds_nothing(others_[i], pivots)) {
                return false;
            }
        }
        return true;
    }
    /// True if the quantity certainly changes with a name that no other formula contains.
    [[nodiscard]] bool by_own_name(const Eliminated& pivots) {
        for (std::size_t j = 0; j < columns_.size(); ++j) {
            const bool own =
                std::ranges::all_of(others_, [&](const Row& row) { return is_zero_expr(row[j]); });
            if (own && !contains_zero(pivots.left[j])) {
                outside = abs(pivots.left[j]);
                return true;
            }
        }
        return false;
    }

    void decide(const Eliminated& pivots) {
        at = pivots.at;
        if (by_own_name(pivots)) {
            return;
        }
        const std::size_t found = pivots.rows.size();
        // The others span all directions, so that any quantity is a function of them.
        if (found == columns_.size()) {
            rank = found;
            return;
        }
        if (found < others_.size() && !others_add_nothing(pivots)) {
            problem = "the rank of the gradients of the others is not proved";
            return;
        }
        for (const Ball& left : pivots.left) {
            if (!contains_zero(left)) {
                outside = abs(left);
                return;
            }
        }
        if (adds_nothing(of_, pivots)) {
            rank = found;
        } else {
            problem =
                "its gradient is a combination of the others at the points drawn, but this is "
                "not proved by symbols";
        }
    }

    const SymbolicCase& under_;
    std::vector<std::string> columns_; ///< the names by which derivatives are taken
    std::vector<Row> others_;
    Row of_;
};

/// The result of a search for polynomial relations; the quantity is the first variable.
struct AlgebraicDependence {
    std::optional<std::string> relation; ///< contains the quantity; proved by symbols
    std::optional<std::string> solved;   ///< the quantity, if the relation is linear in it
    bool none = false;                   ///< it is proved that there is none up to the degree
};

AlgebraicDependence by_relations(const std::vector<RelatedQuantity>& quantities, unsigned degree,
                                 const SymbolicCase& under, Evidence& evidence) {
    const FoundRelations found = find_relations(quantities, degree, under);
    AlgebraicDependence result;
    std::vector<std::string> texts;
    const PolynomialRelation* shortest = nullptr;
    for (const PolynomialRelation& r : found.relations) {
        texts.push_back(relation_text(r, quantities));
        // Prefer the relation that is easiest to solve for the quantity.
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

/// The quantity, and those of which it may be a function, as formulas in free names.
struct FreeFormulas {
    Expr of;
    std::vector<Expr> from;
    std::vector<RelatedQuantity> quantities; ///< as written, with the quantity first
};

FreeFormulas free_formulas(const Claim& claim, const SymbolicCase& under) {
    FreeFormulas all{
        derive(claim.formula("of"), under), {}, {{claim.text("of"), claim.formula("of")}}};
    for (const auto& [text, formula] : named_formulas(claim, "from")) {
        all.quantities.push_back({text, formula});
        all.from.push_back(derive(formula, under));
    }
    return all;
}

/// Returns the names on which the quantity depends and the others do not.
std::string names_alone(const FreeFormulas& formulas) {
    std::set<std::string> known;
    for (const Expr& e : formulas.from) {
        known.merge(free_symbols(e));
    }
    std::string alone;
    for (const std::string& name : free_symbols(formulas.of)) {
        if (!known.contains(name)) {
            alone += (alone.empty() ? "" : ", ") + name;
        }
    }
    return alone;
}

AlgebraicDependence look_for_relations(const Claim& claim, const FreeFormulas& formulas,
                                       const SymbolicCase& under, Evidence& evidence) {
    if (!claim.has("degree")) {
        return {};
    }
    const long degree = claim.integer("degree");
    if (degree < 1 || degree > 12) {
        claim.reject("degree", "relations of degree " + std::to_string(degree),
                     "give a degree from 1 to 12");
    }
    return by_relations(formulas.quantities, static_cast<unsigned>(degree), under, evidence);
}

/// Judges from a proof, at a drawn point, that the quantity is not a function of the others.
void judge_independent(const GradientRank& rank, bool says_independent, unsigned digits,
                       Outcome& outcome) {
    const Ball& left = *rank.outside;
    const Ball none(0, left.bits());
    outcome.verdict =
        Judgement(says_independent ? decision(std::nullopt, Confirmation::less(none, left))
                                   : decision(Refutation::less(none, left), std::nullopt));
    outcome.evidence.add("enclosures",
                         pair_evidence(rank.at, "gradient outside of the span of the others", left,
                                       "of a function of them", none, digits));
}

/// Judges from a proof that near a drawn point the quantity's gradient lies in the span of the
/// others, so that the rank is the same with it and without it.
void judge_function(const GradientRank& rank, bool says_independent, unsigned digits,
                    Outcome& outcome) {
    constexpr long bits = 64;
    const Ball found(static_cast<long>(*rank.rank), bits);
    const Ball of_independent = found + 1;
    outcome.verdict = Judgement(
        says_independent
            ? decision(Refutation::disjoint(of_independent, found), std::nullopt)
            : decision(std::nullopt, Confirmation::agreement(found, found, Ball(1, bits), 1)));
    outcome.evidence.add("enclosures",
                         pair_evidence(rank.at, "rank of all gradients if it were none",
                                       of_independent, "rank proved", found, digits));
}

} // namespace

Outcome check_dependence(const Claim& claim, const AuditContext& context) {
    const SymbolicCase under = symbolic_case(claim, context);
    const FreeFormulas formulas = free_formulas(claim, under);
    const GradientRank rank(formulas.of, formulas.from, under);
    const bool says_independent = claim.text("says") == "independent";
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"))
        .add("from", claim.list("from"))
        .add("derived", to_text(formulas.of))
        .add("derived_tex", to_tex(formulas.of))
        .add("free", rank.names);
    const AlgebraicDependence algebraic =
        look_for_relations(claim, formulas, under, outcome.evidence);
    if (rank.outside) {
        judge_independent(rank, says_independent, context.digits(), outcome);
        outcome.note = claim.text("of") + " is not a function of the others near the point drawn";
        const std::string alone = names_alone(formulas);
        outcome.note += alone.empty() ? "" : ": it depends on " + alone + ", but they do not";
        if (algebraic.none) {
            outcome.note += "; no polynomial relation of degree up to " +
                            std::to_string(claim.integer("degree")) +
                            " contains it, proved by rank";
        }
    } else if (rank.rank) {
        judge_function(rank, says_independent, context.digits(), outcome);
        outcome.note = claim.text("of") + " is a function of the others near the point drawn";
        if (algebraic.relation) {
            outcome.note += ", proved by symbols: " + *algebraic.relation;
            outcome.computed = algebraic.solved ? algebraic.solved : algebraic.relation;
        }
    } else {
        outcome.note = rank.problem;
    }
    return outcome;
}

} // namespace edgeproof::audit
