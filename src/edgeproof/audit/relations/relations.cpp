// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/relations/relations.hpp"
#include "edgeproof/audit/relations/residue_sample.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>

namespace edgeproof::audit {
namespace {

constexpr std::size_t most_monomials = 20'000;
constexpr std::size_t most_columns = 1'200;
constexpr std::size_t spare_samples = 8;
constexpr std::size_t most_draws_a_sample = 200;

using Exponents = std::vector<unsigned>;
using Row = std::vector<Residue>;

unsigned degree_of(const Exponents& e) { return std::accumulate(e.begin(), e.end(), 0U); }

/// Orders by total degree, then by the powers of the first quantity, the second, ...
bool precedes(const Exponents& x, const Exponents& y) {
    const unsigned dx = degree_of(x);
    const unsigned dy = degree_of(y);
    return dx != dy ? dx < dy : x < y;
}

bool divides(const Exponents& x, const Exponents& y) {
    return std::equal(x.begin(), x.end(), y.begin(), [](unsigned p, unsigned q) { return p <= q; });
}

void all_monomials(Exponents& at, std::size_t from, unsigned left, std::vector<Exponents>& all) {
    if (from == at.size()) {
        all.push_back(at);
        if (all.size() > most_monomials) {
            throw InputError("there are more than " + std::to_string(most_monomials) +
                                 " monomials of that degree",
                             "give fewer quantities or a lower degree");
        }
        return;
    }
    for (unsigned k = 0; k <= left; ++k) {
        at[from] = k;
        all_monomials(at, from + 1, left - k, all);
    }
    at[from] = 0;
}

/// Returns the formula of s_k under full stick (contact/law/shear.hpp) for GiNaC; beta_k are the
/// coefficients of (1 - z)^(-1/2).
Expr full_stick_formula(bool right, unsigned k) {
    Rational beta(1);
    Rational before(0);
    for (unsigned j = 1; j <= k; ++j) {
        before = beta;
        beta *= Rational(2 * static_cast<long>(j) - 1, 2 * static_cast<long>(j));
    }
    const Expr L = Expr::symbol("L");
    const Expr tension = Expr::number(right ? 1 : -1) * Expr::symbol("sig0") * L;
    const Expr load = Expr::symbol("Q") / Expr::pi() + tension / Expr::number(8);
    return (formula::quotient_of(beta) * load -
            formula::quotient_of(before) * tension / Expr::number(4)) /
           (pow(L, Expr::number(Rational(static_cast<long>(k)))) * Expr::call("sqrt", {L}));
}

Expr with_shear_put_in(Expr e) {
    for (const std::string& name : free_symbols(e)) {
        const bool right = name.starts_with("right_s");
        if (right || name.starts_with("left_s")) {
            e = substitute(e, name,
                           full_stick_formula(right, static_cast<unsigned>(name.back() - '0')));
        }
    }
    return e;
}

/// The quantities at many samples.
class SampleValues {
public:
    SampleValues(const std::vector<RelatedQuantity>& quantities, const SymbolicCase& under)
        : quantities_(quantities), under_(under) {}
    [[nodiscard]] const Row& at(std::size_t sample) {
        while (values_.size() <= sample) {
            values_.push_back(next());
        }
        return values_[sample];
    }

private:
    [[nodiscard]] static Residue value_of(const RelatedQuantity& q, const ResidueSample& sample) {
        try {
            return formula::evaluate<Residue>(q.formula, sample);
        } catch (const DomainError&) {
            throw;
        } catch (const InputError&) {
            throw;
        } catch (const Error& problem) {
            throw InputError(q.name + ": " + problem.what(),
                             "write a quotient of polynomials in names");
        }
    }
    [[nodiscard]] Row next() {
        for (std::size_t k = 0;; ++k) {
            check_interruption();
            try {
                const ResidueSample sample(under_, ++seed_);
                Row row;
                for (const RelatedQuantity& q : quantities_) {
                    row.push_back(value_of(q, sample));
                }
                return row;
            } catch (const DomainError& problem) {
                if (k == most_draws_a_sample) {
                    throw InputError(std::string("the quantities have no value: ") + problem.what(),
                                     "leave out what is divided by zero everywhere");
                }
            }
        }
    }
    const std::vector<RelatedQuantity>& quantities_;
    const SymbolicCase& under_;
    std::uint64_t seed_ = 0;
    std::vector<Row> values_;
};

/// A vector of the null space of a matrix: 1 at a column without a pivot, and entries at columns
/// before it.
struct NullVector {
    std::size_t leading;
    std::vector<std::pair<std::size_t, Residue>> others;
};

/// Computes the reduced echelon form, column by column: one vector for each column that depends on
/// the columns before it.
std::vector<NullVector> null_space(std::vector<Row> m) {
    const std::size_t columns = m.front().size();
    std::vector<std::size_t> pivots;
    std::vector<NullVector> found;
    for (std::size_t c = 0; c < columns; ++c) {
        check_interruption();
        const std::size_t rank = pivots.size();
        const auto pivot = std::find_if(m.begin() + static_cast<std::ptrdiff_t>(rank), m.end(),
                                        [c](const Row& row) { return !(row[c] == Residue(0)); });
        if (pivot == m.end()) {
            NullVector v{c, {}};
            for (std::size_t i = 0; i < rank; ++i) {
                if (!(m[i][c] == Residue(0))) {
                    v.others.emplace_back(pivots[i], -m[i][c]);
                }
            }
            found.push_back(std::move(v));
            continue;
        }
        std::swap(*pivot, m[rank]);
        const Residue scale = Residue(1) / m[rank][c];
        for (std::size_t k = c; k < columns; ++k) {
            m[rank][k] *= scale;
        }
        for (std::size_t i = 0; i < m.size(); ++i) {
            const Residue factor = m[i][c];
            if (i == rank || factor == Residue(0)) {
                continue;
            }
            for (std::size_t k = c; k < columns; ++k) {
                m[i][k] -= factor * m[rank][k];
            }
        }
        pivots.push_back(c);
    }
    return found;
}

std::optional<PolynomialRelation> over_integers(const NullVector& v,
                                                const std::vector<Exponents>& monomials) {
    std::vector<std::pair<Rational, Exponents>> terms{{Rational(1), monomials[v.leading]}};
    for (auto it = v.others.rbegin(); it != v.others.rend(); ++it) {
        const auto q = it->second.fraction();
        if (!q) {
            return {};
        }
        terms.emplace_back(*q, monomials[it->first]);
    }
    Integer common = 1;
    for (const auto& [q, e] : terms) {
        common = lcm(common, Integer(denominator(q)));
    }
    PolynomialRelation relation;
    for (auto& [q, e] : terms) {
        relation.terms.push_back({Integer(numerator(Rational(q * Rational(common)))), e});
    }
    return relation;
}

bool proved(const PolynomialRelation& relation, const std::vector<Expr>& formulas,
            const SymbolicCase& under) {
    Expr sum = Expr::number(0);
    for (const PolynomialRelation::Term& term : relation.terms) {
        Expr product = Expr::number(Rational(term.coefficient));
        for (std::size_t i = 0; i < formulas.size(); ++i) {
            if (term.exponents[i] > 0) {
                product =
                    product * pow(formulas[i], Expr::number(static_cast<long>(term.exponents[i])));
            }
        }
        sum = sum + product;
    }
    return proved_equal(sum, Expr::number(0), under);
}

} // namespace

unsigned PolynomialRelation::Term::degree() const { return degree_of(exponents); }

std::size_t PolynomialRelation::terms_with(std::size_t quantity) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(terms, [&](const Term& t) { return t.exponents[quantity] > 0; }));
}

FoundRelations find_relations(const std::vector<RelatedQuantity>& quantities, unsigned degree,
                              const SymbolicCase& under) {
    std::vector<Expr> formulas;
    std::vector<ScalingWeights> weights;
    bool graded = true;
    for (const RelatedQuantity& q : quantities) {
        formulas.push_back(with_shear_put_in(q.formula));
        const auto w = scaling_weights(derive(formulas.back(), under));
        graded = graded && w;
        weights.push_back(w.value_or(ScalingWeights{}));
    }
    std::vector<Exponents> all;
    Exponents none(quantities.size(), 0);
    all_monomials(none, 0, degree, all);
    std::ranges::sort(all, precedes);
    // Terms that scale differently cannot cancel, so that a relation splits into its grades.
    std::map<ScalingWeights, std::vector<Exponents>> grades;
    for (const Exponents& e : all) {
        ScalingWeights sum{};
        for (std::size_t i = 0; graded && i < e.size(); ++i) {
            for (std::size_t j = 0; j < sum.size(); ++j) {
                sum[j] += weights[i][j] * static_cast<long>(e[i]);
            }
        }
        grades[sum].push_back(e);
    }
    FoundRelations result;
    result.monomials = all.size();
    result.grades = grades.size();
    SampleValues values(quantities, under);
    struct Candidate {
        NullVector vector;
        const std::vector<Exponents>* monomials;
        [[nodiscard]] const Exponents& leading() const { return (*monomials)[vector.leading]; }
    };
    std::vector<Candidate> candidates;
    for (const auto& [weight, monomials] : grades) {
        if (monomials.size() > most_columns) {
            throw InputError(std::to_string(monomials.size()) +
                                 " monomials scale alike, more than " +
                                 std::to_string(most_columns),
                             "give fewer quantities or a lower degree");
        }
        const std::size_t rows = monomials.size() + spare_samples;
        result.samples = std::max(result.samples, rows);
        std::vector<Row> matrix;
        for (std::size_t i = 0; i < rows; ++i) {
            const Row& at = values.at(i);
            Row row;
            for (const Exponents& e : monomials) {
                Residue product(1);
                for (std::size_t j = 0; j < e.size(); ++j) {
                    product *= Residue::power(at[j], e[j]);
                }
                row.push_back(product);
            }
            matrix.push_back(std::move(row));
        }
        for (NullVector& v : null_space(std::move(matrix))) {
            candidates.push_back({std::move(v), &monomials});
        }
    }
    std::ranges::sort(candidates, [](const Candidate& x, const Candidate& y) {
        return precedes(x.leading(), y.leading());
    });
    for (const Candidate& candidate : candidates) {
        check_interruption();
        const bool follows =
            std::ranges::any_of(result.relations, [&](const PolynomialRelation& r) {
                return divides(r.terms.front().exponents, candidate.leading());
            });
        if (follows) {
            continue; // minus a multiple of that one, it has a lower leading term
        }
        auto relation = over_integers(candidate.vector, *candidate.monomials);
        if (relation && proved(*relation, formulas, under)) {
            result.relations.push_back(std::move(*relation));
        } else {
            result.complete = false;
        }
    }
    return result;
}

namespace {

ScalingWeights weights_of_name(const std::string& name) {
    if (name == "a" || name == "b" || name == "L") {
        return {0, 1, 0};
    }
    if (name == "P" || name == "M") {
        return {1, name == "M" ? 1 : 0, 0};
    }
    if (name == "Q" || name == "sig0") {
        return {0, name == "Q" ? 0 : -1, 1};
    }
    if (name.size() == 2 && name[1] >= '1' && name[1] <= '9') {
        const int k = name[1] - '0';
        if (name[0] == 'P') {
            return {1, -k, 0};
        }
        if (name[0] == 'b') {
            return {0, 1 - k, 0};
        }
    }
    return {0, 0, 0};
}

ScalingWeights times(ScalingWeights w, const Rational& q) {
    for (Rational& x : w) {
        x *= q;
    }
    return w;
}

ScalingWeights plus(ScalingWeights w, const ScalingWeights& o, int sign) {
    for (std::size_t i = 0; i < w.size(); ++i) {
        w[i] += sign * o[i];
    }
    return w;
}

} // namespace

std::optional<ScalingWeights> scaling_weights(const Expr& e) {
    using Kind = Expr::Kind;
    if (e.rational() != nullptr || e.kind() == Kind::pi) {
        return ScalingWeights{0, 0, 0};
    }
    if (e.kind() == Kind::symbol) {
        return weights_of_name(e.name());
    }
    const auto first = e.args().empty() ? std::nullopt : scaling_weights(e.arg(0));
    if (!first) {
        return {};
    }
    if (e.kind() == Kind::neg) {
        return first;
    }
    if (e.kind() == Kind::call) {
        return e.builtin() == formula::Builtin::sqrt ? std::optional(times(*first, Rational(1, 2)))
                                                     : std::nullopt;
    }
    if (e.kind() == Kind::pow) {
        const Rational* q = e.arg(1).rational();
        return q != nullptr ? std::optional(times(*first, *q)) : std::nullopt;
    }
    if (e.is_binder()) {
        return {};
    }
    const auto second = scaling_weights(e.arg(1));
    if (!second) {
        return {};
    }
    switch (e.kind()) {
    case Kind::mul:
        return plus(*first, *second, 1);
    case Kind::div:
        return plus(*first, *second, -1);
    default: // a sum; it is not necessary to know if a part is zero
        return *first == *second ? first : std::nullopt;
    }
}

} // namespace edgeproof::audit
