// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/tex_reader.hpp"

#include <algorithm>
#include <array>

namespace edgeproof::formula {

bool is_function_command(std::string_view name) {
    return std::ranges::find(tex_functions, name, &TexFunction::command) != tex_functions.end();
}

PlainPart TexReader::function() {
    const auto* found = std::ranges::find(tex_functions, command(), &TexFunction::command);
    std::string name(found->function);
    at_ += 1 + found->command.size();
    if (name == "log" && take('_')) {
        if (argument().text != "10") {
            fail("a logarithm of another base than 10" + at_column(tex_, at_),
                 "write \\ln x/\\ln b");
        }
        name = "log10";
    }
    std::optional<PlainPart> exponent;
    if (take('^')) {
        exponent = argument();
        if (exponent->text.find('-') != std::string::npos) {
            refuse("the power of the function", "write \\arcsin x or 1/\\sin x");
        }
    }
    const bool bracketed = peek() == '(' || peek() == '[';
    const PlainPart value{name + "(" + (bracketed ? arguments() : factor().text) + ")"};
    open_end_ = bracketed ? OpenEnd::none : OpenEnd::function;
    if (peek() == '^' && bracketed) {
        refuse("the power of the function or of its argument", "write \\sin^2(x) or \\sin((x)^2)");
    }
    return exponent
               ? PlainPart{value.text + "^" + at_least(*exponent, Binding::atom), Binding::power}
               : value;
}
std::string TexReader::arguments() {
    const char close = take('(') ? ')' : ']';
    if (close == ']') {
        expect('[');
    }
    std::string text = sum().text;
    while (take(',')) {
        text += ", " + sum().text;
    }
    expect(close);
    return text;
}

bool TexReader::differential() {
    if (variables_.empty() || has_differential()) {
        return false;
    }
    const std::size_t start = at_;
    const bool upright_d = take("mathrm") && take('{') && take('d') && take('}');
    if (!upright_d) {
        at_ = start;
    }
    if (upright_d || take('d')) {
        const char c = peek();
        if (is_tex_letter(c) || is_in(tex_greek, command())) {
            ScriptedName name = bare_name();
            scripts(name);
            if (name.primes == 0 && !name.star) {
                variables_.back() = looked_up(name);
                return true;
            }
        }
    }
    at_ = start;
    return false;
}
PlainPart TexReader::integral() {
    const Level level = deeper();
    std::array<std::string, 2> limits;
    for (int k = 0; k < 2; ++k) {
        const bool lower = take('_');
        if (!lower && !take('^')) {
            fail("an integral without limits" + at_column(tex_, at_), "write \\int_{a}^{b}");
        }
        limits.at(lower ? 0 : 1) = argument().text;
    }
    variables_.emplace_back();
    const PlainPart integrand = sum(true);
    const std::string variable = variables_.back();
    variables_.pop_back();
    if (variable.empty()) {
        fail("an integral without a differential" + at_column(tex_, at_),
             "end the integrand by \\,ds");
    }
    open_end_ = OpenEnd::integral;
    return {"integral(" + integrand.text + ", " + variable + ", " + limits[0] + ", " + limits[1] +
            ")"};
}

} // namespace edgeproof::formula
