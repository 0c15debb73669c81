// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/symbolic/ginac_bridge.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rational.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <flint/flint.h>
#include <flint/fmpz.h>
#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_mpoly_factor.h>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace edgeproof::audit::ginac {

namespace {

constexpr long screening_bits = 160;

/// Returns a pseudo-random number in (1/2, 3/2) for each name, always the same.
Ball drawn(const std::string& name) {
    std::seed_seq seeds(name.begin(), name.end());
    std::array<std::uint32_t, 1> number{};
    seeds.generate(number.begin(), number.end());
    return Ball(Rational(number[0], 1L << 32), screening_bits) +
           Ball(Rational(1, 2), screening_bits);
}

/// Returns the enclosure of e for the numbers drawn for the symbols; it may be infinite. Returns
/// nullopt if e contains anything except sums, products, powers, rationals with terms that fit a
/// long, and pi.
std::optional<Ball> at_drawn(const ex& e) {
    if (GiNaC::is_a<GiNaC::numeric>(e)) {
        const auto& n = GiNaC::ex_to<GiNaC::numeric>(e);
        const GiNaC::numeric over = n.numer();
        const GiNaC::numeric under = n.denom();
        if (!n.is_rational() || over.int_length() > 60 || under.int_length() > 60) {
            return std::nullopt;
        }
        return Ball(over.to_long(), screening_bits) / under.to_long();
    }
    if (GiNaC::is_a<GiNaC::symbol>(e)) {
        return drawn(GiNaC::ex_to<GiNaC::symbol>(e).get_name());
    }
    if (e.is_equal(GiNaC::Pi)) {
        return Ball::pi(screening_bits);
    }
    if (GiNaC::is_a<GiNaC::power>(e)) {
        const auto base = at_drawn(e.op(0));
        const auto exponent = base ? at_drawn(e.op(1)) : std::nullopt;
        if (!exponent) {
            return std::nullopt;
        }
        const ex& k = e.op(1);
        return GiNaC::is_a<GiNaC::numeric>(k) && GiNaC::ex_to<GiNaC::numeric>(k).is_integer()
                   ? pow_int(*base, GiNaC::ex_to<GiNaC::numeric>(k).to_long())
                   : pow(*base, *exponent);
    }
    const bool sum = GiNaC::is_a<GiNaC::add>(e);
    if (!sum && !GiNaC::is_a<GiNaC::mul>(e)) {
        return std::nullopt;
    }
    Ball all(sum ? 0 : 1, screening_bits);
    for (std::size_t i = 0; i < e.nops(); ++i) {
        const auto part = at_drawn(e.op(i));
        if (!part) {
            return std::nullopt;
        }
        all = sum ? all + *part : all * *part;
    }
    return all;
}

/// True if e is proved not to vanish identically, by its enclosure at one point.
bool is_not_zero_somewhere(const ex& e) {
    const auto value = at_drawn(e);
    return value && value->is_finite() && !contains_zero(*value);
}

} // namespace

bool is_zero(const ex& e) {
    if (e.is_zero()) {
        return true;
    }
    if (is_not_zero_somewhere(e)) {
        return false; // this is the usual case, and it avoids the expensive canonical form
    }
    if (e.expand().is_zero()) {
        return true;
    }
    Roots roots;
    const ex fraction = roots.rational(e).normal();
    return roots.reduced(fraction.numer()).normal().is_zero();
}

std::vector<ex> polynomial_over_root(const ex& e, const ex& s, const ex& hi) {
    Roots roots;
    const ex whole = roots.fraction(e * GiNaC::sqrt(hi - s));
    if (whole.denom().has(s) || roots.involves(whole, s)) {
        throw DomainError("an integrand is not a polynomial over the square root of the distance "
                          "from its upper end");
    }
    const ex under = whole.denom();
    const ex over = whole.numer().expand();
    std::vector<ex> q;
    for (int k = 0; k <= over.degree(s); ++k) {
        q.push_back(roots.restored(over.coeff(s, k) / under));
    }
    return q;
}

namespace {

using GiNaC::is_a;

struct Monomial {
    Rational coefficient{1};
    std::vector<ulong> exponents;
};

/// Returns the variables in the order of their names, which is the same on every run.
std::vector<ex> variables_of(const ex& polynomial) {
    std::vector<ex> all;
    for (auto part = polynomial.preorder_begin(); part != polynomial.preorder_end(); ++part) {
        const auto same = [&](const ex& v) { return v.is_equal(*part); };
        if (is_a<GiNaC::symbol>(*part) && std::ranges::none_of(all, same)) {
            all.push_back(*part);
        }
    }
    std::ranges::sort(all, [](const ex& x, const ex& y) {
        return GiNaC::ex_to<GiNaC::symbol>(x).get_name() <
               GiNaC::ex_to<GiNaC::symbol>(y).get_name();
    });
    return all;
}

void multiply(Monomial& monomial, const ex& factor, const std::vector<ex>& variables) {
    if (is_a<GiNaC::numeric>(factor)) {
        monomial.coefficient *= rational_of(factor);
        return;
    }
    const bool power = is_a<GiNaC::power>(factor);
    const ex base = power ? factor.op(0) : factor;
    for (std::size_t i = 0; i < variables.size(); ++i) {
        if (base.is_equal(variables[i])) {
            const long k = power ? GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_long() : 1;
            monomial.exponents[i] += static_cast<ulong>(k);
            return;
        }
    }
    throw Error("a polynomial was expected");
}

Monomial monomial_of(const ex& term, const std::vector<ex>& variables) {
    Monomial monomial;
    monomial.exponents.resize(variables.size());
    for_each_factor(term, [&](const ex& factor) { multiply(monomial, factor, variables); });
    return monomial;
}

GiNaC::numeric numeric_of(const fmpz_t n) {
    char* const text = fmpz_get_str(nullptr, 10, n);
    GiNaC::numeric value(text);
    flint_free(text);
    return value;
}

class IntegerPolynomial {
public:
    explicit IntegerPolynomial(const std::vector<ex>& variables) : variables_(variables) {
        fmpz_mpoly_ctx_init(context_, static_cast<slong>(variables.size()), ORD_LEX);
        fmpz_mpoly_init(polynomial_, context_);
        fmpz_mpoly_factor_init(factors_, context_);
    }
    IntegerPolynomial(const IntegerPolynomial&) = delete;
    IntegerPolynomial& operator=(const IntegerPolynomial&) = delete;
    ~IntegerPolynomial() {
        fmpz_mpoly_factor_clear(factors_, context_);
        fmpz_mpoly_clear(polynomial_, context_);
        fmpz_mpoly_ctx_clear(context_);
    }

    void add(const Integer& coefficient, const std::vector<ulong>& exponents) {
        fmpz_t c;
        fmpz_init(c);
        fmpz_set_mpz(c, coefficient.backend().data());
        fmpz_mpoly_push_term_fmpz_ui(polynomial_, c, exponents.data(), context_);
        fmpz_clear(c);
    }
    [[nodiscard]] ex factors() {
        fmpz_mpoly_sort_terms(polynomial_, context_);
        fmpz_mpoly_combine_like_terms(polynomial_, context_);
        if (fmpz_mpoly_factor(factors_, polynomial_, context_) == 0) {
            throw Error("a polynomial was not factored");
        }
        ex product = constant();
        fmpz_mpoly_t factor;
        fmpz_mpoly_init(factor, context_);
        for (slong i = 0; i < fmpz_mpoly_factor_length(factors_, context_); ++i) {
            fmpz_mpoly_factor_get_base(factor, factors_, i, context_);
            const slong k = fmpz_mpoly_factor_get_exp_si(factors_, i, context_);
            product *= GiNaC::pow(in_symbols(factor), static_cast<long>(k));
        }
        fmpz_mpoly_clear(factor, context_);
        return product;
    }

private:
    [[nodiscard]] ex constant() const {
        fmpz_t c;
        fmpz_init(c);
        fmpz_mpoly_factor_get_constant_fmpz(c, factors_, context_);
        const GiNaC::numeric value = numeric_of(c);
        fmpz_clear(c);
        return value;
    }
    [[nodiscard]] ex in_symbols(fmpz_mpoly_t factor) const {
        ex sum = 0;
        fmpz_t c;
        fmpz_init(c);
        std::vector<ulong> exponents(variables_.size());
        for (slong i = 0; i < fmpz_mpoly_length(factor, context_); ++i) {
            fmpz_mpoly_get_term_coeff_fmpz(c, factor, i, context_);
            fmpz_mpoly_get_term_exp_ui(exponents.data(), factor, i, context_);
            ex term = numeric_of(c);
            for (std::size_t v = 0; v < variables_.size(); ++v) {
                term *= GiNaC::pow(variables_[v], exponents[v]);
            }
            sum += term;
        }
        fmpz_clear(c);
        return sum;
    }

    const std::vector<ex>& variables_;
    fmpz_mpoly_ctx_t context_;
    fmpz_mpoly_t polynomial_;
    fmpz_mpoly_factor_t factors_;
};

} // namespace

ex polynomial_factors(const ex& polynomial) {
    GiNaC::exmap replaced;
    const ex expanded = polynomial.expand().to_rational(replaced).expand();
    const std::vector<ex> variables = variables_of(expanded);
    if (variables.empty()) {
        return polynomial;
    }
    std::vector<Monomial> terms;
    for_each_term(expanded, [&](const ex& term) { terms.push_back(monomial_of(term, variables)); });
    Integer common = 1;
    for (const Monomial& term : terms) {
        common = lcm(common, Integer(denominator(term.coefficient)));
    }
    IntegerPolynomial whole(variables);
    for (const Monomial& term : terms) {
        whole.add(Integer(numerator(Rational(term.coefficient * common))), term.exponents);
    }
    return (whole.factors() / GiNaC::numeric(common.str().c_str())).subs(replaced);
}

} // namespace edgeproof::audit::ginac
