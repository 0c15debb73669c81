// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/formula/names.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/message.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The reader of plain_from_tex(). The grammar is in read_tex.cpp, names are in tex_names.cpp.
namespace edgeproof::formula {

inline constexpr std::size_t longest_tex = 20'000;
inline constexpr std::size_t deepest_tex = 300;

inline bool is_tex_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
inline bool is_tex_digit(char c) { return c >= '0' && c <= '9'; }

// The tokens of a formula in LaTeX, for plain_from_tex().

/// Commands that change only the layout.
inline constexpr std::array tex_layout{
    ",",    ";",     ":",     "!",     " ",     "quad",   "qquad",    "displaystyle", "textstyle",
    "left", "right", "big",   "Big",   "bigg",  "Bigg",   "bigl",     "bigr",         "Bigl",
    "Bigr", "biggl", "biggr", "Biggl", "Biggr", "limits", "thinspace"};
inline constexpr std::array tex_greek{
    "alpha", "beta",     "gamma",   "delta",    "epsilon", "varepsilon", "zeta",   "eta",
    "theta", "vartheta", "kappa",   "lambda",   "mu",      "nu",         "xi",     "pi",
    "rho",   "varrho",   "sigma",   "varsigma", "tau",     "upsilon",    "phi",    "varphi",
    "chi",   "psi",      "omega",   "Gamma",    "Delta",   "Theta",      "Lambda", "Xi",
    "Pi",    "Sigma",    "Upsilon", "Phi",      "Psi",     "Omega",      "ell",    "hbar"};
inline constexpr std::array tex_upright{"mathrm", "mathit", "mathsf",       "mathbf",     "text",
                                        "textrm", "textit", "operatorname", "boldsymbol", "rm"};

struct TexFunction {
    std::string_view command;
    std::string_view function;
};
inline constexpr std::array tex_functions{
    TexFunction{"sin", "sin"},     TexFunction{"cos", "cos"},     TexFunction{"tan", "tan"},
    TexFunction{"arcsin", "asin"}, TexFunction{"arccos", "acos"}, TexFunction{"arctan", "atan"},
    TexFunction{"sinh", "sinh"},   TexFunction{"cosh", "cosh"},   TexFunction{"tanh", "tanh"},
    TexFunction{"exp", "exp"},     TexFunction{"ln", "log"},      TexFunction{"log", "log"},
    TexFunction{"lg", "log10"},    TexFunction{"max", "max"},     TexFunction{"min", "min"}};

template <class List> bool is_in(const List& list, std::string_view name) {
    return std::ranges::find(list, name) != list.end();
}

/// A place in a formula of LaTeX. Throws FormulaError.
class TexTokens {
protected:
    explicit TexTokens(std::string_view tex) : tex_(tex) {}

    [[noreturn]] static void fail(std::string problem, std::string instead) {
        throw FormulaError(std::move(problem), std::move(instead));
    }
    [[noreturn]] void refuse(const std::string& what, std::string instead) const {
        fail(what + at_column(tex_, at_) + " can be read in two ways", std::move(instead));
    }
    [[noreturn]] void unexpected() {
        if (at_end()) {
            fail("the formula ends where a number, a name or a bracket must follow", "complete it");
        }
        if (tex_[at_] == '\\') {
            fail("the command \\" + printable(command()) + at_column(tex_, at_) +
                     " has no meaning in a formula here",
                 "use \\frac, \\sqrt, \\left( \\right), \\int, functions and Greek letters, or "
                 "write plain text");
        }
        fail("unexpected " + quoted_at(tex_, at_) + at_column(tex_, at_),
             tex_[at_] == '=' ? "write one side of the equation" : "close each bracket and brace");
    }

    [[nodiscard]] std::string_view command_at(std::size_t at) const {
        std::size_t end = at + 1;
        while (end < tex_.size() && is_tex_letter(tex_[end])) {
            ++end;
        }
        return tex_.substr(at + 1, std::max<std::size_t>(end - at - 1, 1));
    }
    /// Skips spaces and commands of layout.
    void skip() {
        while (at_ < tex_.size()) {
            if (std::string_view(" \t\r\n~").find(tex_[at_]) != std::string_view::npos) {
                ++at_;
            } else if (tex_[at_] == '\\' && is_in(tex_layout, command_at(at_))) {
                at_ += 1 + command_at(at_).size();
            } else {
                return;
            }
        }
    }
    bool at_end() {
        skip();
        return at_ == tex_.size();
    }
    char peek() { return at_end() ? '\0' : tex_[at_]; }
    /// The command at this place; empty if there is none.
    std::string_view command() { return peek() == '\\' ? command_at(at_) : std::string_view{}; }
    /// True at an opening bracket, also if braces, which are not printed, precede it.
    bool opens_bracket() {
        const std::size_t start = at_;
        while (peek() == '{') {
            ++at_;
        }
        const bool opens = peek() == '(' || peek() == '[' || command() == "{";
        at_ = start;
        return opens;
    }
    bool take(char c) {
        const bool found = peek() == c;
        at_ += found ? 1 : 0;
        return found;
    }
    bool take(std::string_view name) {
        const bool found = peek() == '\\' && command() == name;
        at_ += found ? 1 + name.size() : 0;
        return found;
    }
    void expect(char c) {
        if (!take(c)) {
            fail(std::string("a '") + c + "' is missing" + at_column(tex_, at_),
                 "close each bracket and brace");
        }
    }

    [[nodiscard]] Level deeper() {
        if (depth_ == deepest_tex) {
            fail("the formula is nested more than " + std::to_string(deepest_tex) + " levels deep",
                 "write it with fewer brackets inside one another");
        }
        return Level(depth_);
    }

    std::string_view tex_;
    std::size_t at_ = 0;
    std::size_t depth_ = 0;
};

/// The strength with which the operators of a plain text bind.
enum class Binding { sum, product, power, atom };

/// A part of a formula, as text for parse().
struct PlainPart {
    std::string text;
    Binding binding = Binding::atom;
};

/// The text of a part, in brackets if it binds less than `binding`.
[[nodiscard]] inline std::string at_least(const PlainPart& part, Binding binding) {
    return part.binding < binding ? "(" + part.text + ")" : part.text;
}

/// A name with its scripts, before it is looked up.
struct ScriptedName {
    std::string letter;
    std::string subscript;
    std::size_t primes = 0;
    bool star = false;
};

/// The kind of the last factor, if it has no visible end.
enum class OpenEnd { none, function, integral };

class TexReader : TexTokens {
public:
    TexReader(std::string_view tex, const Symbols& allowed) : TexTokens(tex), allowed_(allowed) {}

    /// Returns the formula as text for parse(). Throws FormulaError.
    std::string read();

private:
    // --- the grammar

    /// `integrand`: ends behind the product that contains the differential.
    PlainPart sum(bool integrand = false);
    PlainPart product(bool integrand);
    /// Refuses a factor that follows others, by `operation` or (0) without a sign, where this can
    /// be read in two ways.
    void check_next(char operation, bool divided);
    bool starts_factor();
    PlainPart factor();
    PlainPart group();
    PlainPart braced_factor();
    PlainPart fraction();
    /// A group in braces, or one token.
    PlainPart argument();
    std::string number();
    PlainPart modulus();
    PlainPart root();
    /// Reads the exponent of a base that is no name.
    PlainPart with_power(PlainPart base);

    // --- functions and integrals

    PlainPart function();
    /// Reads the arguments of a function, in brackets.
    std::string arguments();
    [[nodiscard]] bool has_differential() const {
        return !variables_.empty() && !variables_.back().empty();
    }
    /// Reads "ds" inside an integral that has no variable yet.
    bool differential();
    PlainPart integral();

    // --- names

    ScriptedName bare_name();
    /// Returns the letters and digits of a group or token; "\\mathrm{I}" is I, "\\sigma" sigma.
    std::string raw_group();
    /// Reads subscript, star and primes; returns an exponent that follows.
    std::optional<PlainPart> scripts(ScriptedName& name);
    std::optional<PlainPart> superscript(ScriptedName& name);
    [[nodiscard]] bool is_function(std::string_view name) const {
        return allowed_.has_function(name);
    }
    [[nodiscard]] std::vector<std::string> candidates(const ScriptedName& name) const;
    /// The name in `allowed`; if there is none, the first candidate, which may be bound.
    [[nodiscard]] std::string looked_up(const ScriptedName& name) const;
    /// Refuses letters that are a product in LaTeX, but together a function or another name: exp.
    void check_spelled_out() const;
    PlainPart named();
    /// Returns the text of a name before a bracket: a call, or a factor alone.
    std::string before_bracket(const ScriptedName& written, const std::string& name,
                               const std::optional<PlainPart>& exponent);
    /// True if the bracket at this place contains a + or - between two terms, outside of inner
    /// brackets.
    [[nodiscard]] bool sum_in_bracket() const;

    const Symbols& allowed_;
    int bars_ = 0;
    OpenEnd open_end_ = OpenEnd::none;
    std::string last_;                   ///< the text of the last factor
    std::vector<std::string> variables_; ///< of the integrals being read; empty until "ds"
};

[[nodiscard]] bool is_function_command(std::string_view name);

} // namespace edgeproof::formula
