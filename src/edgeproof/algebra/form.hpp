// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/algebra/polynomial.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/real.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Exact algebra with formulas.
namespace edgeproof::algebra {

using formula::Builtin;
using formula::Expr;

struct Generator;
using Generators = std::vector<std::shared_ptr<const Generator>>;

/// A formula as a quotient of two polynomials without a common factor, in these generators: names,
/// pi, roots w with w^n = f, powers with a symbolic exponent, and calls of other functions. Roots
/// are taken of irreducible factors, so that sqrt(a), sqrt(2 a) and sqrt(2) have two generators
/// only. Powers of roots are reduced.
///
/// Zero is decided by the numerator: a form that `is_zero()` vanishes wherever it is defined. The
/// converse holds for rational functions and for roots of independent radicands; where generators
/// depend on each other in another way (sqrt(3 + 2 sqrt(2)) = 1 + sqrt(2), sin^2 + cos^2 = 1), a
/// form that vanishes may not be recognised.
///
/// The base of a power that is not an integer is taken to be positive, as it is where the formula
/// is defined. Factors of unknown sign under a root stay together: sqrt(x y) is not split.
///
/// Objects are values; different threads may use copies. Operations throw DomainError for a
/// division by zero, and Error for results too large for a formula of mechanics.
class Form {
public:
    /// Greater exponents, and arguments of gamma, are refused.
    static constexpr long most_power = 1000;

    Form(int n = 0) : Form(Rational(n)) {} // NOLINT: the templates of series/ write T(0), T(1)
    explicit Form(const Rational& q);
    [[nodiscard]] static Form pi();
    /// A variable, the same for all forms. It is positive, or may have either sign.
    [[nodiscard]] static Form name(std::string_view name, bool positive);
    /// A function. Special values are worked out: cos(pi/3), gamma(5/2), log(1), sin(asin(x)); even
    /// and odd functions ignore and pass on the sign of their argument.
    [[nodiscard]] static Form call(Builtin f, std::span<const Form> x);
    [[nodiscard]] static Form call(const std::string& function, std::span<const Form> x);
    /// An expression of which nothing else is known, such as an integral.
    [[nodiscard]] static Form opaque(const Expr& e);

    [[nodiscard]] bool is_zero() const { return over_.is_zero(); }
    [[nodiscard]] std::optional<Rational> rational() const;
    /// Returns 1 or -1 if the signs of all terms show that it has that sign, else 0.
    [[nodiscard]] int sign() const;
    /// True if the name is in it.
    [[nodiscard]] bool holds(std::string_view name) const;
    /// Returns x if it is f(x) for the function f.
    [[nodiscard]] std::optional<Form> argument_of(std::string_view function) const;
    /// The partial derivative. Throws Error if a function that contains the name has none here.
    [[nodiscard]] Form derivative(std::string_view name) const;
    /// Returns c_0, c_1, ... if it is the polynomial c_0 + c_1 x + ... in the name x.
    [[nodiscard]] std::optional<std::vector<Form>> coefficients(std::string_view name) const;
    /// Returns the value modulo a prime for given values of the generators; nothing if the prime
    /// divides the denominator.
    [[nodiscard]] std::optional<ulong>
    modulo(ulong prime, const std::function<ulong(const Generator&)>& value) const;
    /// Returns a formula: one fraction with separate factors. Sums that are linear in P1, P2, ...
    /// are collected by these.
    [[nodiscard]] Expr expr() const;
    /// Returns a form in one name with x in its place.
    [[nodiscard]] Form operator()(const Form& x) const;
    /// A text that is equal for equal numerators and denominators.
    [[nodiscard]] std::string key() const;

    Form& operator+=(const Form& o) { return *this = *this + o; }
    Form& operator-=(const Form& o) { return *this = *this - o; }
    Form& operator*=(const Form& o) { return *this = *this * o; }
    Form& operator/=(const Form& o) { return *this = *this / o; }
    friend Form operator-(Form x);
    friend Form operator+(const Form& x, const Form& y);
    friend Form operator-(const Form& x, const Form& y) { return x + -y; }
    friend Form operator*(const Form& x, const Form& y);
    friend Form operator/(const Form& x, const Form& y);
    friend bool operator==(const Form& x, const Form& y) { return Form(x - y).is_zero(); }
    friend Form pow(const Form& x, const Rational& q);
    friend Form pow(const Form& x, const Form& y);
    friend Form exp(const Form& x);

private:
    friend class Tidy;
    struct Pair;
    struct Part;
    Form(Generators g, Polynomial over, Polynomial under)
        : generators_(std::move(g)), over_(std::move(over)), under_(std::move(under)) {}
    explicit Form(Generator g);
    /// over/under in lowest terms, with powers of roots reduced: the one form of equal quotients.
    [[nodiscard]] static Form canonical(Generators g, Polynomial over, Polynomial under);
    [[nodiscard]] static Form reduced(const Polynomial& p, const Generators& g, std::size_t root);
    [[nodiscard]] static Form pruned(Generators g, const Polynomial& over, const Polynomial& under);
    /// The generator, if the form is one.
    [[nodiscard]] const Generator* generator() const;
    [[nodiscard]] std::vector<Part> parts() const;
    [[nodiscard]] std::vector<std::pair<Rational, Form>> terms() const;
    /// Returns x if it is exp(x).
    [[nodiscard]] std::optional<Form> exponent() const;
    [[nodiscard]] static Form root(const Form& base, const Rational& exponent);
    [[nodiscard]] static Form power(const Form& base, const Form& exponent);
    [[nodiscard]] static std::optional<Form> special(Builtin f, const Form& x);

    Generators generators_;
    Polynomial over_;
    Polynomial under_;
};

[[nodiscard]] Form pow(const Form& x, const Rational& q);
[[nodiscard]] Form pow(const Form& x, const Form& y);
[[nodiscard]] Form exp(const Form& x);
[[nodiscard]] inline Form sqrt(const Form& x) { return pow(x, Rational(1, 2)); }
[[nodiscard]] inline Form log(const Form& x) { return Form::call(Builtin::log, {&x, 1}); }
[[nodiscard]] inline Form sin(const Form& x) { return Form::call(Builtin::sin, {&x, 1}); }
[[nodiscard]] inline Form cos(const Form& x) { return Form::call(Builtin::cos, {&x, 1}); }
[[nodiscard]] inline Form asin(const Form& x) { return Form::call(Builtin::asin, {&x, 1}); }
[[nodiscard]] inline Form acos(const Form& x) { return Form::call(Builtin::acos, {&x, 1}); }
[[nodiscard]] inline Form atan(const Form& x) { return Form::call(Builtin::atan, {&x, 1}); }

/// What a form is written in. Generators with equal keys are equal.
struct Generator {
    enum class Kind { name, pi, root, power, call, opaque };
    Kind kind;
    std::string key;
    std::string name;         ///< of a name or a function
    std::vector<Form> parts;  ///< the radicand; base and exponent (exp: exponent only); arguments
    unsigned long index = 1;  ///< of a root
    bool positive = false;    ///< wherever it is defined
    std::size_t depth = 0;    ///< more than that of the generators of its parts
    std::optional<Expr> expr; ///< if it is opaque
    [[nodiscard]] bool holds(std::string_view of) const;
};

/// Returns the form of a formula; `meaning` gives those of its names. Integrals and sums are
/// opaque.
[[nodiscard]] Form form_of(const Expr& e, const std::function<Form(std::string_view)>& meaning);

} // namespace edgeproof::algebra
