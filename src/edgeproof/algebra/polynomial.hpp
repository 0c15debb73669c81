// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <flint/flint.h>
#include <flint/fmpz_mpoly.h>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace edgeproof::algebra {

using Exponents = std::vector<ulong>;

/// A polynomial with integer coefficients in numbered variables: FLINT's fmpz_mpoly as a value.
/// Operands have the same number of variables. Throws Error for more than `most_variables`
/// variables, and for products too large for a formula of mechanics.
class Polynomial {
public:
    static constexpr std::size_t most_variables = 64;

    explicit Polynomial(std::size_t variables, const Integer& constant = 0);
    [[nodiscard]] static Polynomial variable(std::size_t variables, std::size_t i);
    Polynomial(const Polynomial& o);
    Polynomial(Polynomial&& o) noexcept;
    Polynomial& operator=(Polynomial o) noexcept;
    ~Polynomial();

    [[nodiscard]] std::size_t variables() const noexcept { return variables_; }
    [[nodiscard]] std::size_t size() const; ///< the number of terms
    [[nodiscard]] bool is_zero() const { return size() == 0; }
    [[nodiscard]] bool is_constant() const;
    /// The coefficient of the first term in lexicographic order; 0 for the polynomial 0.
    [[nodiscard]] Integer leading() const;
    [[nodiscard]] bool holds(std::size_t variable) const { return degree(variable) > 0; }
    [[nodiscard]] ulong degree(std::size_t variable) const;
    /// The greatest power of the variable that divides the polynomial.
    [[nodiscard]] ulong least_exponent(std::size_t variable) const;
    /// The greatest common divisor of the coefficients; positive.
    [[nodiscard]] Integer content() const;

    /// Calls take(coefficient, exponents) for each term, in lexicographic order.
    void for_each_term(const std::function<void(const Integer&, const Exponents&)>& take) const;
    /// The polynomial in `variables` variables whose terms have the exponents change(exponents).
    [[nodiscard]] Polynomial
    with_exponents(std::size_t variables,
                   const std::function<Exponents(const Exponents&)>& change) const;
    /// The coefficients of the powers of a variable that occur, with these powers.
    [[nodiscard]] std::vector<std::pair<ulong, Polynomial>> coefficients(std::size_t i) const;
    [[nodiscard]] Polynomial derivative(std::size_t i) const;
    /// The sum of the terms, for values of the variables modulo a prime.
    [[nodiscard]] ulong modulo(ulong prime, std::span<const ulong> values) const;

    struct Factors {
        Integer constant;
        std::vector<std::pair<Polynomial, unsigned>> powers;
    };
    /// A number and powers of polynomials that are irreducible over the integers; always in the
    /// same order.
    [[nodiscard]] Factors factors() const;

    friend Polynomial operator-(Polynomial x);
    friend Polynomial operator+(const Polynomial& x, const Polynomial& y);
    friend Polynomial operator*(const Polynomial& x, const Polynomial& y);
    friend bool operator==(const Polynomial& x, const Polynomial& y);
    /// Divides both by their greatest common divisor.
    friend void cancel(Polynomial& x, Polynomial& y);

private:
    void push(const Integer& coefficient, const Exponents& exponents);
    void sort();

    std::size_t variables_;
    fmpz_mpoly_t data_;
};

} // namespace edgeproof::algebra
