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

} // namespace edgeproof::formula
