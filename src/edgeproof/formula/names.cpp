// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/names.hpp"

#include "edgeproof/precision/message.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace edgeproof::formula {
namespace {

/// Names that other programs read as a constant or a limit. (E is Young's modulus.)
constexpr std::array taken_for_constants{"e",   "I",    "inf",  "Inf",      "INF",
                                         "nan", "NaN",  "NAN",  "infinity", "Infinity",
                                         "oo",  "true", "false"};

struct Meant {
    std::string_view written;
    std::string_view meant;
};
constexpr std::array other_spellings{Meant{"ln", "log"},
                                     Meant{"arcsin", "asin"},
                                     Meant{"arccos", "acos"},
                                     Meant{"arctan", "atan"},
                                     Meant{"arctan2", "atan2"},
                                     Meant{"arcsinh", "asinh"},
                                     Meant{"arccosh", "acosh"},
                                     Meant{"arctanh", "atanh"},
                                     Meant{"arsinh", "asinh"},
                                     Meant{"arcosh", "acosh"},
                                     Meant{"artanh", "atanh"},
                                     Meant{"sign", "sgn"},
                                     Meant{"signum", "sgn"},
                                     Meant{"Gamma", "gamma"},
                                     Meant{"tgamma", "gamma"},
                                     Meant{"fabs", "abs"},
                                     Meant{"Sqrt", "sqrt"},
                                     Meant{"Heaviside", "step"},
                                     Meant{"heaviside", "step"},
                                     Meant{"integrate", "integral"},
                                     Meant{"Integral", "integral"},
                                     Meant{"Log", "log"},
                                     Meant{"Exp", "exp"},
                                     Meant{"PI", "Pi"}};

/// Units that are not plausible as names in a formula.
constexpr std::array units{"Pa", "kPa", "MPa", "GPa", "kN",  "MN",  "mm", "cm",
                           "um", "nm",  "psi", "ksi", "deg", "rad", "lbf"};

/// Returns "did you mean x? " if a known name is near.
std::string near_hint(std::string_view name, const std::vector<std::string>& names) {
    const std::vector<std::string_view> known(names.begin(), names.end());
    const std::string_view near = near_name(name, known);
    return near.empty() ? "" : "did you mean " + std::string(near) + "? ";
}

bool is_identifier(std::string_view name) {
    const auto letter = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    };
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    return !name.empty() && letter(name.front()) &&
           std::ranges::all_of(name, [&](char c) { return letter(c) || digit(c); });
}

void check_new_name(std::string_view name) {
    if (!is_identifier(name)) {
        throw InputError("'" + std::string(name) + "' cannot be a name",
                         "write a letter, then letters, digits or _");
    }
    if (is_reserved(name)) {
        throw InputError("the name '" + std::string(name) +
                             "' has a meaning of its own in formulas",
                         "choose another, such as " + std::string(name) + "1");
    }
}

std::string joined(const std::vector<std::string>& names) {
    constexpr std::size_t most = 24;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
        text += (i == 0 ? "" : ", ") + names[i];
    }
    return names.size() > most ? text + ", ..." : text;
}

std::string_view other_spelling(std::string_view name) {
    const auto it = std::ranges::find(other_spellings, name, &Meant::written);
    return it == other_spellings.end() ? std::string_view{} : it->meant;
}

} // namespace

bool is_reserved(std::string_view name) {
    return is_pi(name) || binder_arity(name) != 0 || find_builtin(name) ||
           std::ranges::find(taken_for_constants, name) != taken_for_constants.end();
}

Symbols::Symbols(std::initializer_list<std::string_view> variables) {
    for (const std::string_view name : variables) {
        add(name);
    }
}

Symbols::Symbols(const std::set<std::string>& variables) {
    for (const std::string& name : variables) {
        add(name);
    }
}

Symbols& Symbols::add(std::string_view variable) {
    check_new_name(variable);
    variables_.emplace(variable);
    return *this;
}

Symbols& Symbols::add_function(std::string_view name, unsigned arity) {
    check_new_name(name);
    functions_.insert_or_assign(std::string(name), arity);
    return *this;
}

Arity arity_of(std::string_view name, const Symbols& allowed) {
    if (const unsigned arity = binder_arity(name); arity != 0) {
        return {arity, arity};
    }
    if (const auto f = find_builtin(name)) {
        return {f->min_arity, f->max_arity};
    }
    const auto it = allowed.functions().find(name);
    return it == allowed.functions().end() ? Arity() : Arity{it->second, it->second};
}

std::string usage(std::string_view name, const Symbols& allowed) {
    static constexpr std::array letters{"x", "y", "z", "u", "v", "w"};
    std::string text(name);
    if (name == "pv") {
        return text + "(f, s, lower, upper, x)";
    }
    if (binder_arity(name) != 0) {
        return text + (name == "sum" ? "(f, k, lower, upper)" : "(f, s, lower, upper)");
    }
    text += '(';
    const auto [least, most] = arity_of(name, allowed);
    for (std::size_t i = 0; i < least; ++i) {
        text += (i == 0 ? "" : ", ") + std::string(letters[std::min(i, letters.size() - 1)]);
    }
    return text + (most > least ? ", ...)" : ")");
}

std::string instead_of_variable(std::string_view name, const Symbols& allowed,
                                std::span<const std::string_view> bound) {
    if (name == "e" || name == "E") {
        return "write exp(1) for 2.718..., or the name that a modulus has here";
    }
    if (name == "I") {
        return "formulas are real: there is no imaginary unit";
    }
    if (is_reserved(name)) {
        return "write a finite number";
    }
    if (const auto meant = other_spelling(name); !meant.empty()) {
        return "write " + std::string(meant);
    }
    std::vector<std::string> names(bound.begin(), bound.end());
    for (const std::string& v : allowed.variables()) {
        if (std::ranges::find(names, v) == names.end()) {
            names.push_back(v);
        }
    }
    names.emplace_back("Pi");
    if (std::ranges::find(units, name) != units.end()) {
        return "numbers have no units here: " + std::string(without_units);
    }
    return near_hint(name, names) + "use one of: " + joined(names);
}

std::string instead_of_function(std::string_view name, const Symbols& allowed) {
    if (const auto meant = other_spelling(name); !meant.empty()) {
        return "write " + std::string(meant) + "(...)";
    }
    std::vector<std::string> names;
    for (const auto& [f, signature] : allowed.functions()) {
        names.push_back(f);
    }
    for (const BuiltinInfo& f : builtins()) {
        names.emplace_back(f.name);
    }
    return near_hint(name, names) + "use one of: " + joined(names);
}

bool is_unit(std::string_view name, const Symbols& allowed) {
    return allowed.variables().empty() || std::ranges::find(units, name) != units.end();
}

std::string at_column(std::string_view text, std::size_t offset) {
    const auto head = text.substr(0, offset);
    const auto characters = std::ranges::count_if(
        head, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
    return " at column " + std::to_string(characters + 1);
}

std::string quoted_at(std::string_view text, std::size_t offset) {
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
    const auto begin = text.begin() + static_cast<std::ptrdiff_t>(offset);
    const auto end = std::find_if_not(begin + 1, text.end(), continues);
    return "'" + printable(std::string_view(begin, end)) + "'";
}

std::string hint_for_character(std::string_view text, std::size_t offset) {
    switch (text[offset]) {
    case '[':
    case ']':
    case '{':
    case '}':
        return "write round brackets";
    case '*':
    case '/':
    case '^':
        return "write a number, a name or '(' before it";
    case '=':
    case '<':
    case '>':
        return "write one expression, without a comparison";
    case '\\':
        return "write plain text, not TeX: sqrt(x)/y";
    case '\'':
        return "write a derivative by its name, without primes";
    case ';':
        return "separate arguments by commas";
    default:
        return (static_cast<unsigned char>(text[offset]) & 0x80U) != 0
                   ? "write it in ASCII: Pi, *, -, ^, names of letters and digits"
                   : "use numbers, names, + - * / ^ ( ) and commas";
    }
}

} // namespace edgeproof::formula
