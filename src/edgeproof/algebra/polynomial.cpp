// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/algebra/polynomial.hpp"

#include "edgeproof/precision/ball/arb_values.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <array>
#include <flint/fmpz_mpoly_factor.h>
#include <flint/fmpz_vec.h>
#include <flint/ulong_extras.h>

namespace edgeproof::algebra {
namespace {

/// The size of a product, in products of terms times bits of the coefficients, beyond which it is
/// not computed.
constexpr double most_work = 1e10;

/// FLINT's description of the variables, which is only read after this.
const fmpz_mpoly_ctx_struct* context(std::size_t variables) {
    struct All {
        std::array<fmpz_mpoly_ctx_struct, Polynomial::most_variables + 1> of;
        All() {
            for (std::size_t n = 0; n < of.size(); ++n) {
                fmpz_mpoly_ctx_init(&of.at(n), std::max<slong>(static_cast<slong>(n), 1), ORD_LEX);
            }
        }
    };
    static const All all;
    if (variables > Polynomial::most_variables) {
        throw Error("a formula with more than " + std::to_string(Polynomial::most_variables) +
                    " names and functions is not worked out by symbols");
    }
    return &all.of.at(variables);
}

FmpzValue number(const Integer& n) {
    FmpzValue x;
    fmpz_set_mpz(x, n.backend().data());
    return x;
}

Integer integer(const FmpzValue& x) {
    Integer n;
    fmpz_get_mpz(n.backend().data(), x);
    return n;
}

double bits_of(const fmpz_mpoly_t p, std::size_t n) {
    return 64 + std::abs(static_cast<double>(fmpz_mpoly_max_bits(p))) + static_cast<double>(n);
}

} // namespace

Polynomial::Polynomial(std::size_t variables, const Integer& constant) : variables_(variables) {
    fmpz_mpoly_init(data_, context(variables));
    fmpz_mpoly_set_fmpz(data_, number(constant), context(variables));
}

Polynomial Polynomial::variable(std::size_t variables, std::size_t i) {
    Polynomial p(variables);
    fmpz_mpoly_gen(p.data_, static_cast<slong>(i), context(variables));
    return p;
}

Polynomial::Polynomial(const Polynomial& o) : variables_(o.variables_) {
    fmpz_mpoly_init(data_, context(variables_));
    fmpz_mpoly_set(data_, o.data_, context(variables_));
}

Polynomial::Polynomial(Polynomial&& o) noexcept : variables_(o.variables_) {
    fmpz_mpoly_init(data_, context(variables_));
    fmpz_mpoly_swap(data_, o.data_, context(variables_));
}

Polynomial& Polynomial::operator=(Polynomial o) noexcept {
    std::swap(variables_, o.variables_);
    std::swap(*data_, *o.data_);
    return *this;
}

Polynomial::~Polynomial() { fmpz_mpoly_clear(data_, context(variables_)); }

std::size_t Polynomial::size() const {
    return static_cast<std::size_t>(fmpz_mpoly_length(data_, context(variables_)));
}

bool Polynomial::is_constant() const { return fmpz_mpoly_is_fmpz(data_, context(variables_)) != 0; }

Integer Polynomial::leading() const {
    if (is_zero()) {
        return 0;
    }
    FmpzValue c;
    fmpz_mpoly_get_term_coeff_fmpz(c, data_, 0, context(variables_));
    return integer(c);
}

ulong Polynomial::degree(std::size_t variable) const {
    return static_cast<ulong>(std::max<slong>(
        fmpz_mpoly_degree_si(data_, static_cast<slong>(variable), context(variables_)), 0));
}

ulong Polynomial::least_exponent(std::size_t variable) const {
    ulong least = degree(variable);
    for (std::size_t i = 0; i < size() && least > 0; ++i) {
        least = std::min(least, fmpz_mpoly_get_term_var_exp_ui(data_, static_cast<slong>(i),
                                                               static_cast<slong>(variable),
                                                               context(variables_)));
    }
    return least;
}

Integer Polynomial::content() const {
    FmpzValue c;
    _fmpz_vec_content(c, data_->coeffs, static_cast<slong>(size()));
    return integer(c);
}

void Polynomial::for_each_term(
    const std::function<void(const Integer&, const Exponents&)>& take) const {
    Exponents exponents(std::max<std::size_t>(variables_, 1));
    FmpzValue c;
    for (std::size_t i = 0; i < size(); ++i) {
        fmpz_mpoly_get_term_coeff_fmpz(c, data_, static_cast<slong>(i), context(variables_));
        fmpz_mpoly_get_term_exp_ui(exponents.data(), data_, static_cast<slong>(i),
                                   context(variables_));
        take(integer(c), exponents);
    }
}

void Polynomial::push(const Integer& coefficient, const Exponents& exponents) {
    fmpz_mpoly_push_term_fmpz_ui(data_, number(coefficient), exponents.data(), context(variables_));
}

void Polynomial::sort() {
    fmpz_mpoly_sort_terms(data_, context(variables_));
    fmpz_mpoly_combine_like_terms(data_, context(variables_));
}

Polynomial
Polynomial::with_exponents(std::size_t variables,
                           const std::function<Exponents(const Exponents&)>& change) const {
    Polynomial p(variables);
    for_each_term([&](const Integer& c, const Exponents& e) { p.push(c, change(e)); });
    p.sort();
    return p;
}

std::vector<std::pair<ulong, Polynomial>> Polynomial::coefficients(std::size_t i) const {
    std::vector<std::pair<ulong, Polynomial>> all;
    for_each_term([&](const Integer& c, Exponents e) {
        const ulong k = std::exchange(e[i], 0);
        auto at = std::ranges::find(all, k, &std::pair<ulong, Polynomial>::first);
        if (at == all.end()) {
            at = all.emplace(at, k, Polynomial(variables_));
        }
        at->second.push(c, e);
    });
    for (auto& [k, p] : all) {
        p.sort();
    }
    return all;
}

Polynomial Polynomial::derivative(std::size_t i) const {
    Polynomial p(variables_);
    fmpz_mpoly_derivative(p.data_, data_, static_cast<slong>(i), context(variables_));
    return p;
}

ulong Polynomial::modulo(ulong prime, std::span<const ulong> values) const {
    ulong sum = 0;
    const Integer p(prime);
    for_each_term([&](const Integer& c, const Exponents& e) {
        ulong product = Integer(((c % p) + p) % p).convert_to<ulong>();
        for (std::size_t i = 0; i < values.size(); ++i) {
            product =
                n_mulmod2(product, n_powmod2(values[i], static_cast<slong>(e[i]), prime), prime);
        }
        sum = n_addmod(sum, product, prime);
    });
    return sum;
}

Polynomial::Factors Polynomial::factors() const {
    const fmpz_mpoly_ctx_struct* const in = context(variables_);
    struct Found {
        const fmpz_mpoly_ctx_struct* in;
        fmpz_mpoly_factor_t all;
        ~Found() { fmpz_mpoly_factor_clear(all, in); }
    } found{in, {}};
    fmpz_mpoly_factor_init(found.all, in);
    if (fmpz_mpoly_factor(found.all, data_, in) == 0) {
        throw Error("a polynomial was not factored");
    }
    fmpz_mpoly_factor_sort(found.all, in);
    FmpzValue c;
    fmpz_mpoly_factor_get_constant_fmpz(c, found.all, in);
    Factors result{integer(c), {}};
    for (slong i = 0; i < fmpz_mpoly_factor_length(found.all, in); ++i) {
        Polynomial p(variables_);
        fmpz_mpoly_factor_get_base(p.data_, found.all, i, in);
        result.powers.emplace_back(
            std::move(p), static_cast<unsigned>(fmpz_mpoly_factor_get_exp_si(found.all, i, in)));
    }
    return result;
}

Polynomial operator-(Polynomial x) {
    fmpz_mpoly_neg(x.data_, x.data_, context(x.variables_));
    return x;
}

Polynomial operator+(const Polynomial& x, const Polynomial& y) {
    Polynomial z(x.variables_);
    fmpz_mpoly_add(z.data_, x.data_, y.data_, context(x.variables_));
    return z;
}

Polynomial operator*(const Polynomial& x, const Polynomial& y) {
    if (static_cast<double>(x.size()) * static_cast<double>(y.size()) *
            (bits_of(x.data_, x.variables_) + bits_of(y.data_, y.variables_)) >
        most_work) {
        throw Error("a product is too large to be worked out by symbols");
    }
    Polynomial z(x.variables_);
    fmpz_mpoly_mul(z.data_, x.data_, y.data_, context(x.variables_));
    return z;
}

bool operator==(const Polynomial& x, const Polynomial& y) {
    return x.variables_ == y.variables_ &&
           fmpz_mpoly_equal(x.data_, y.data_, context(x.variables_)) != 0;
}

void cancel(Polynomial& x, Polynomial& y) {
    const fmpz_mpoly_ctx_struct* const in = context(x.variables_);
    Polynomial common(x.variables_);
    if (fmpz_mpoly_gcd_cofactors(common.data_, x.data_, y.data_, x.data_, y.data_, in) == 0) {
        throw Error("the greatest common divisor of two polynomials was not found");
    }
}

} // namespace edgeproof::algebra
