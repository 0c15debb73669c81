// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/error.hpp"

#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace edgeproof::formula {

/// A text that is not an expression, or that uses a name that is not allowed. `problem()` contains
/// the column, `instead()` what may stand there.
class FormulaError : public InputError {
public:
    using InputError::InputError;
};

/// The names that a formula may use in addition to the built-in functions and the constant Pi.
class Symbols {
public:
    Symbols() = default;
    Symbols(std::initializer_list<std::string_view> variables);
    explicit Symbols(const std::set<std::string>& variables);

    /// Throws InputError for a name that no formula may use: not an identifier, a built-in
    /// function, or a name that other programs read as a constant (E, e, I, inf, nan).
    Symbols& add(std::string_view variable);
    Symbols& add_function(std::string_view name, unsigned arity);

    [[nodiscard]] bool has(std::string_view variable) const {
        return variables_.contains(variable);
    }
    [[nodiscard]] bool has_function(std::string_view name) const {
        return functions_.contains(name);
    }
    [[nodiscard]] const std::set<std::string, std::less<>>& variables() const { return variables_; }
    /// The functions with the numbers of their arguments.
    [[nodiscard]] const std::map<std::string, unsigned, std::less<>>& functions() const {
        return functions_;
    }

private:
    std::set<std::string, std::less<>> variables_;
    std::map<std::string, unsigned, std::less<>> functions_;
};

/// True for names that no variable may have: E, e, I, inf, nan and similar names, pi, integral, pv,
/// sum and the built-in functions.
[[nodiscard]] bool is_reserved(std::string_view name);

/// Reads an expression. All numbers in it are exact; `pi` and `Pi` are the constant.
///   sum     := term (('+' | '-') term)*          left to right
///   term    := signed (('*' | '/') signed)*      left to right
///   signed  := ('-' | '+') signed | power        so that -2^2 is -4
///   power   := primary ('^' exponent)?           right to left: 2^3^2 is 2^9
///   primary := number | name | name '(' sum, ... ')' | '(' sum ')'
/// with integral(f, s, lo, hi), pv(f, s, lo, hi, x) and sum(f, k, lo, hi), whose second argument
/// is a variable known inside f. ln(x) is log(x), and log10(x) is log(x)/log(10), unless `allowed`
/// has functions of these names. There is no multiplication without `*`.
/// Throws FormulaError, always with one line, for anything else; also for texts longer than 20,000
/// bytes, deeper than 200 levels, with more than `Expr::max_height` operations in a chain, and
/// for numbers with a decimal exponent beyond 100,000 in size.
[[nodiscard]] Expr parse(std::string_view text, const Symbols& allowed);
/// Reads a constant expression: no variables.
[[nodiscard]] Expr parse(std::string_view text);

/// Reads an expression in which `*` may be missing before a name or a bracket (2P, 2 P, a b,
/// (a + b)(a - b)) and returns `written` with every `*`. Such a product binds like `*`. Texts that
/// people read in two ways are refused: a/2b, x^2y, P(a + b). Throws as parse() does.
/// `written`: the same text, with names as the user writes them; it has the same length.
[[nodiscard]] std::string with_products(std::string_view written, std::string_view text,
                                        const Symbols& allowed);

/// True if a text is meant as LaTeX: it contains a backslash or a brace.
[[nodiscard]] bool is_tex(std::string_view text);
/// Reads one side of an equation in LaTeX and returns it as text for parse(): \\frac, \\sqrt[n],
/// \\left( \\right), |x|, \\int_a^b ... ds, functions, \\cdot, \\times and products without a sign,
/// Greek letters, superscripts, and names with subscripts and primes. A name is looked up in
/// `allowed` as x_1, x1 (x_{1}), Es (E^{*}), P1 (P'), P1of(s) (P'(s), or P1 if s is a), g1(x)
/// (g'(x)). \\log is the natural logarithm. Throws FormulaError, always with one line, for other
/// commands, for texts that can be read in two ways (a/2b, \\sin 2x, \\sin x/2, \\sin^{-1}x, P(a),
/// 2\\frac12, exp(x) without a backslash, 1e-3), and within the limits of parse().
[[nodiscard]] std::string plain_from_tex(std::string_view tex, const Symbols& allowed);

} // namespace edgeproof::formula
