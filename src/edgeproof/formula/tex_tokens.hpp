// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/names.hpp"
#include "edgeproof/formula/typed.hpp"
#include "edgeproof/precision/message.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

/// The tokens of a formula in LaTeX, for plain_from_tex().
namespace edgeproof::formula {

inline constexpr std::size_t longest_tex = 20'000;
inline constexpr std::size_t deepest_tex = 300;

inline bool is_tex_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
inline bool is_tex_digit(char c) { return c >= '0' && c <= '9'; }

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

    [[noreturn]] void fail(std::string problem, std::string instead) const {
        throw FormulaError(std::move(problem), std::move(instead), at_);
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

    class Level {
    public:
        explicit Level(TexTokens& reader) : reader_(reader) {
            if (++reader_.depth_ > deepest_tex) {
                reader_.fail("the formula is nested more than " + std::to_string(deepest_tex) +
                                 " levels deep",
                             "write it with fewer brackets inside one another");
            }
        }
        ~Level() { --reader_.depth_; }
        Level(const Level&) = delete;
        Level& operator=(const Level&) = delete;

    private:
        TexTokens& reader_;
    };

    std::string_view tex_;
    std::size_t at_ = 0;
    std::size_t depth_ = 0;
};

} // namespace edgeproof::formula
