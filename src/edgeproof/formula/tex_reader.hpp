// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/tex_tokens.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The reader of plain_from_tex(). The grammar is in read_tex.cpp, functions and integrals are in
/// tex_functions.cpp, names in tex_names.cpp.
namespace edgeproof::formula {

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
        return allowed_.function(name) != nullptr;
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
