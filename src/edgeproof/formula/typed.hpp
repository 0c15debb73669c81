// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/formula/parse.hpp"

/// Formulas as people type them, converted to text for parse().
namespace edgeproof::formula {

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
