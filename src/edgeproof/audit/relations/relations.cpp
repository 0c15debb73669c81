// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/relations/relations.hpp"

#include "edgeproof/algebra/form.hpp"
#include "edgeproof/precision/ball/arb_values.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <flint/fmpq.h>
#include <flint/nmod_mat.h>
#include <flint/ulong_extras.h>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>

namespace edgeproof::audit {
namespace {

constexpr std::size_t most_monomials = 20'000;
constexpr std::size_t most_columns = 1'200;
constexpr std::size_t spare_samples = 8;
constexpr std::size_t most_draws_a_sample = 200;

constexpr ulong prime = (1UL << 61U) - 1;

using algebra::Form;
using Exponents = std::vector<unsigned>;

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

/// Numbers modulo the prime for the free symbols, drawn on first use. Pi is drawn like a symbol,
/// because it is transcendental; a square root is a root modulo the prime.
class Draw {
public:
    explicit Draw(std::uint64_t seed) : random_(seed) {}
    /// Returns nothing if a number under a root is no square, or for a division by zero.
    [[nodiscard]] std::optional<ulong> value(const Form& f) {
        bool defined = true;
        const auto y = f.modulo(prime, [&](const algebra::Generator& g) {
            const auto x = of(g);
            defined = defined && x;
            return x.value_or(0);
        });
        return defined ? y : std::nullopt;
    }

private:
    [[nodiscard]] std::optional<ulong> of(const algebra::Generator& g) {
        using Kind = algebra::Generator::Kind;
        if (const auto it = known_.find(g.key); it != known_.end()) {
            return it->second;
        }
        std::optional<ulong> x;
        if (g.kind == Kind::name || g.kind == Kind::pi) {
            x = (random_() >> 3U) % prime;
        } else if (g.kind == Kind::root && g.index == 2) {
            const auto square = value(g.parts[0]);
            const ulong root = square ? n_sqrtmod(*square, prime) : 0;
            x = root != 0 ? std::optional(root) : std::nullopt;
        } else {
            throw InputError("a quantity has a function other than sqrt",
                             "write a quotient of polynomials in names and square roots");
        }
        known_.emplace(g.key, x);
        return x;
    }
    std::mt19937_64 random_;
    std::map<std::string, std::optional<ulong>> known_;
};

/// The quantities at many draws.
class SampleValues {
public:
    explicit SampleValues(const std::vector<Form>& quantities) : quantities_(quantities) {}
    [[nodiscard]] const std::vector<ulong>& at(std::size_t sample) {
        while (values_.size() <= sample) {
            values_.push_back(next());
        }
        return values_[sample];
    }

private:
    [[nodiscard]] std::vector<ulong> next() {
        for (std::size_t k = 0; k < most_draws_a_sample; ++k) {
            check_interruption();
            Draw draw(++seed_);
            std::vector<ulong> row;
            std::optional<ulong> x = 0;
            for (std::size_t i = 0; x && i < quantities_.size(); ++i) {
                x = draw.value(quantities_[i]);
                row.push_back(x.value_or(0));
            }
            if (x) {
                return row;
            }
        }
        throw InputError("the quantities have no value modulo a prime",
                         "leave out roots of negative numbers");
    }
    const std::vector<Form>& quantities_;
    std::uint64_t seed_ = 0;
    std::vector<std::vector<ulong>> values_;
};

/// A vector of the null space of a matrix: the entries that are not 0, with their columns. The last
/// is 1, at a column without a pivot.
using NullVector = std::vector<std::pair<std::size_t, ulong>>;

/// A matrix modulo the prime.
class Matrix {
public:
    Matrix(std::size_t rows, std::size_t columns) {
        nmod_mat_init(m_, static_cast<slong>(rows), static_cast<slong>(columns), prime);
    }
    Matrix(const Matrix&) = delete;
    Matrix& operator=(const Matrix&) = delete;
    ~Matrix() { nmod_mat_clear(m_); }
    [[nodiscard]] ulong& at(std::size_t i, std::size_t j) { return nmod_mat_entry(m_, i, j); }
    [[nodiscard]] std::size_t rank() { return static_cast<std::size_t>(nmod_mat_rank(m_)); }
    /// Returns one vector for each column that depends on the columns before it.
    [[nodiscard]] std::vector<NullVector> null_space() {
        const auto columns = static_cast<std::size_t>(nmod_mat_ncols(m_));
        Matrix basis(columns, columns);
        const slong count = nmod_mat_nullspace(basis.m_, m_);
        std::vector<NullVector> found(static_cast<std::size_t>(count));
        for (std::size_t k = 0; k < found.size(); ++k) {
            for (std::size_t i = 0; i < columns; ++i) {
                if (basis.at(i, k) != 0) {
                    found[k].emplace_back(i, basis.at(i, k));
                }
            }
        }
        return found;
    }

private:
    nmod_mat_t m_;
};

/// Returns the fraction n/d with n^2, d^2 < prime/2 that equals x modulo the prime; there is at
/// most one.
std::optional<Rational> fraction(ulong x) {
    FmpqValue q;
    FmpzValue residue;
    FmpzValue modulus;
    fmpz_set_ui(residue, x);
    fmpz_set_ui(modulus, prime);
    return fmpq_reconstruct_fmpz(q, residue, modulus) != 0 ? std::optional(from_fmpq(q))
                                                           : std::nullopt;
}

std::optional<PolynomialRelation> over_integers(const NullVector& v,
                                                const std::vector<Exponents>& monomials) {
    std::vector<std::pair<Rational, Exponents>> terms;
    for (auto it = v.rbegin(); it != v.rend(); ++it) {
        const auto q = fraction(it->second);
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

bool proved(const PolynomialRelation& relation, const std::vector<Form>& quantities) {
    Form sum;
    for (const PolynomialRelation::Term& term : relation.terms) {
        Form product(Rational(term.coefficient));
        for (std::size_t i = 0; i < quantities.size(); ++i) {
            product *= pow(quantities[i], Rational(term.exponents[i]));
        }
        sum += product;
    }
    return sum.is_zero();
}

std::vector<Form> forms_of(const std::vector<RelatedQuantity>& quantities, SymbolicCase under) {
    under.full_stick = true;
    std::vector<Form> forms;
    for (const RelatedQuantity& q : quantities) {
        forms.push_back(form_in(q.formula, under));
    }
    return forms;
}

} // namespace

unsigned PolynomialRelation::Term::degree() const { return degree_of(exponents); }

std::size_t PolynomialRelation::terms_with(std::size_t quantity) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(terms, [&](const Term& t) { return t.exponents[quantity] > 0; }));
}

FoundRelations find_relations(const std::vector<RelatedQuantity>& quantities, unsigned degree,
                              const SymbolicCase& under) {
    const std::vector<Form> formulas = forms_of(quantities, under);
    std::vector<ScalingWeights> weights;
    bool graded = true;
    for (const Form& f : formulas) {
        const auto w = scaling_weights(f.expr());
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
    SampleValues values(formulas);
    struct Candidate {
        NullVector vector;
        const std::vector<Exponents>* monomials;
        [[nodiscard]] const Exponents& leading() const { return (*monomials)[vector.back().first]; }
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
        Matrix matrix(rows, monomials.size());
        for (std::size_t i = 0; i < rows; ++i) {
            const std::vector<ulong>& at = values.at(i);
            for (std::size_t k = 0; k < monomials.size(); ++k) {
                ulong product = 1;
                for (std::size_t j = 0; j < at.size(); ++j) {
                    product = n_mulmod2(product, n_powmod2(at[j], monomials[k][j], prime), prime);
                }
                matrix.at(i, k) = product;
            }
        }
        check_interruption();
        for (NullVector& v : matrix.null_space()) {
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
        if (relation && proved(*relation, formulas)) {
            result.relations.push_back(std::move(*relation));
        } else {
            result.complete = false;
        }
    }
    return result;
}

bool determines(const PolynomialRelation& relation, std::size_t quantity,
                const std::vector<RelatedQuantity>& quantities, const SymbolicCase& under) {
    PolynomialRelation rate;
    for (const PolynomialRelation::Term& term : relation.terms) {
        if (term.exponents[quantity] > 0) {
            rate.terms.push_back(
                {Integer(term.coefficient * term.exponents[quantity]), term.exponents});
            --rate.terms.back().exponents[quantity];
        }
    }
    return !rate.terms.empty() && !proved(rate, forms_of(quantities, under));
}

GradientRanks gradient_ranks(const std::vector<RelatedQuantity>& quantities,
                             const SymbolicCase& under) {
    const std::vector<Form> forms = forms_of(quantities, under);
    std::set<std::string> names;
    for (const Form& f : forms) {
        names.merge(free_symbols(f.expr()));
    }
    GradientRanks ranks;
    std::vector<std::size_t> alone;         // columns of the first quantity only
    std::vector<std::vector<Form>> columns; // those that differ; a and b of a + b are one
    for (const std::string& name : names) {
        std::vector<Form> column;
        for (const Form& f : forms) {
            column.push_back(f.holds(name) ? f.derivative(name) : Form(0));
        }
        const bool of_first = !column.front().is_zero();
        const bool of_others = std::any_of(column.begin() + 1, column.end(),
                                           [](const Form& f) { return !f.is_zero(); });
        const bool known = std::ranges::find(columns, column) != columns.end();
        if (of_first && !of_others && !known) {
            alone.push_back(columns.size());
        }
        if ((of_first || of_others) && !known) {
            columns.push_back(std::move(column));
        }
    }
    std::vector<Form> entries;
    for (const auto& column : columns) {
        entries.insert(entries.end(), column.begin(), column.end());
    }
    SampleValues values(entries);
    const std::size_t rows = forms.size();
    for (std::size_t draw = 0; draw < 3 && !columns.empty(); ++draw) {
        Matrix others(rows - 1, columns.size());
        Matrix all(rows, columns.size());
        for (std::size_t i = 0; i < rows; ++i) {
            for (std::size_t j = 0; j < columns.size(); ++j) {
                all.at(i, j) = values.at(draw)[j * rows + i];
                if (i > 0) {
                    others.at(i - 1, j) = all.at(i, j);
                }
            }
        }
        if (std::ranges::any_of(alone, [&](std::size_t j) { return all.at(0, j) != 0; })) {
            ranks.function = false;
        }
        ranks.others = std::max(ranks.others, others.rank());
        ranks.all = std::max(ranks.all, all.rank());
    }
    const bool constant =
        std::ranges::all_of(columns, [](const auto& c) { return c.front().is_zero(); });
    if (!ranks.function && ranks.all == rows) {
        ranks.function = false;
    } else if (!ranks.function && (constant || ranks.others == columns.size())) {
        ranks.function = true;
    }
    return ranks;
}

} // namespace edgeproof::audit
