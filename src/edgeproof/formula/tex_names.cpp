// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/tex_reader.hpp"

#include "edgeproof/formula/builtin.hpp"

#include <algorithm>

namespace edgeproof::formula {
namespace {

/// True for n and (n), where n is a name or a number: an exponent in brackets.
bool is_order_of_derivative(std::string_view text) {
    return text.size() > 2 && text.front() == '(' && text.back() == ')' &&
           std::ranges::all_of(text.substr(1, text.size() - 2),
                               [](char c) { return is_tex_letter(c) || is_tex_digit(c); });
}

} // namespace

ScriptedName TexReader::bare_name() {
    if (is_tex_letter(peek())) {
        return {std::string(1, tex_[at_++]), {}};
    }
    const std::string name(command());
    at_ += 1 + name.size();
    return {is_in(tex_upright, name) ? raw_group() : name, {}};
}
std::string TexReader::raw_group() {
    const Level level = deeper();
    std::string text;
    const auto token = [&] {
        const char c = peek();
        if (is_tex_letter(c) || is_tex_digit(c) || c == '.' || c == '_') {
            text += c;
            ++at_;
        } else if (command() == "_") {
            text += '_';
            at_ += 2;
        } else if (is_in(tex_upright, command())) {
            at_ += 1 + command().size();
            text += raw_group();
        } else if (is_in(tex_greek, command())) {
            text += command();
            at_ += 1 + command().size();
        } else {
            fail("the name or subscript" + at_column(tex_, at_) + " is not of letters and digits",
                 "write \\mathrm{name}, x_{1}");
        }
    };
    if (take('{')) {
        while (!at_end() && peek() != '}') {
            token();
        }
        expect('}');
    } else {
        token();
    }
    return text;
}

std::optional<PlainPart> TexReader::scripts(ScriptedName& name) {
    std::optional<PlainPart> exponent;
    while (true) {
        if (peek() == '_' && name.subscript.empty()) {
            ++at_;
            name.subscript = raw_group();
        } else if (take('\'')) {
            ++name.primes;
        } else if (peek() == '^' && !exponent) {
            ++at_;
            exponent = superscript(name);
        } else {
            break;
        }
    }
    if (peek() == '^' || peek() == '_') {
        fail("two scripts of one kind" + at_column(tex_, at_), "put one into the other by braces");
    }
    if (exponent && is_order_of_derivative(exponent->text)) {
        refuse("the exponent in brackets", "write P'' for a derivative, P^{2} for a power");
    }
    return exponent;
}
std::optional<PlainPart> TexReader::superscript(ScriptedName& name) {
    const bool braced = take('{');
    bool marked = false;
    while (true) {
        if (take('*') || take("ast")) {
            name.star = true;
        } else if (take("prime") || take('\'')) {
            ++name.primes;
        } else {
            break;
        }
        marked = true;
        if (!braced) {
            return {};
        }
    }
    if (!braced) {
        return argument();
    }
    if (marked && take('}')) {
        return {};
    }
    PlainPart exponent = sum();
    expect('}');
    return exponent;
}

std::vector<std::string> TexReader::candidates(const ScriptedName& name) const {
    std::vector<std::string> letters{name.letter};
    if (name.letter.starts_with("var")) {
        letters.push_back(name.letter.substr(3));
    }
    if (name.letter.ends_with("epsilon")) {
        letters.emplace_back("eps");
    }
    if (name.letter == "ell") {
        letters.emplace_back("l");
    }
    std::vector<std::string> all;
    for (std::string letter : letters) {
        letter += name.star ? "s" : "";
        const bool has_derivatives = is_function(letter + "of"); // P1 is P'(a), not P_1
        letter += name.primes > 0 ? std::to_string(name.primes) : "";
        all.push_back(name.subscript.empty() ? letter : letter + "_" + name.subscript);
        // R1 may be R_1, but it is not R'; g1 is g'.
        if (name.primes > 0 && !has_derivatives && !is_function(letter)) {
            fail("the prime before" + at_column(tex_, at_) + " has no meaning here",
                 "write \\mathrm{name} for a quantity of the ledger");
        }
        if (std::ranges::all_of(name.subscript, is_tex_digit) && !has_derivatives &&
            !is_function(letter + "of") && !is_function(letter + name.subscript)) {
            all.push_back(letter + name.subscript);
        }
    }
    return all;
}
std::string TexReader::looked_up(const ScriptedName& name) const {
    if (name.letter == "pi" && name.subscript.empty() && !name.star && name.primes == 0) {
        return "Pi";
    }
    const std::vector<std::string> all = candidates(name);
    std::string found;
    for (const std::string& one : all) {
        std::string plain = one; // "right.c0" is right_c0 among the symbols
        std::ranges::replace(plain, '.', '_');
        if (allowed_.has(plain) || is_function(plain)) {
            if (!found.empty() && found != one) {
                refuse("the name " + all.front(),
                       "write \\mathrm{" + found + "} or \\mathrm{" + one + "}");
            }
            found = one;
        }
    }
    if (is_pi(all.front())) { // the capital letter, which is not the constant
        fail("the name " + all.front() + at_column(tex_, at_) + " has no meaning here",
             "write \\pi for the constant");
    }
    return found.empty() ? all.front() : found;
}

void TexReader::check_spelled_out() const {
    std::size_t end = at_;
    while (end < tex_.size() && is_tex_letter(tex_[end])) {
        ++end;
    }
    for (std::size_t size = 2; at_ + size <= end; ++size) {
        const std::string name(tex_.substr(at_, size));
        const bool whole = at_ + size == end && (allowed_.has(name) || is_function(name));
        if (whole || is_reserved(name) || name == "ln") {
            refuse("the letters " + name, "write \\" + name + " or \\mathrm{" + name +
                                              "} for the name, and a product with \\cdot");
        }
    }
}

PlainPart TexReader::named() {
    check_spelled_out();
    ScriptedName written = bare_name();
    const std::optional<PlainPart> exponent = scripts(written);
    const std::string name = looked_up(written);
    if (name == "e" && !allowed_.has(name)) { // e^x
        open_end_ = OpenEnd::none;
        if (!exponent && opens_bracket()) {
            refuse("the bracket after e", "write e^{x} or \\exp(x)");
        }
        return {"exp(" + (exponent ? exponent->text : "1") + ")"};
    }
    const PlainPart value{opens_bracket() ? before_bracket(written, name, exponent) : name};
    open_end_ = OpenEnd::none;
    return exponent
               ? PlainPart{value.text + "^" + at_least(*exponent, Binding::atom), Binding::power}
               : with_power(value);
}
std::string TexReader::before_bracket(const ScriptedName& written, const std::string& name,
                                      const std::optional<PlainPart>& exponent) {
    const std::string along = name + "of";
    const bool is_variable = allowed_.has(name);
    const bool round = peek() == '(' || peek() == '[';
    const bool calls = is_function(name) || (!is_variable && find_builtin(name));
    if (round && calls) {
        if (exponent && exponent->text.find('-') != std::string::npos) {
            refuse("the power of the function", "write 1/" + name + "(...)");
        }
        return name + "(" + arguments() + ")";
    }
    if (round && written.primes > 0 && (is_function(along) || is_variable)) { // P'(s)
        const std::string at = arguments();
        if (at == "a" && is_variable) {
            return name;
        }
        if (is_function(along)) {
            return along + "(" + at + ")";
        }
        fail("the derivative " + name + at_column(tex_, at_) + " is known at a only",
             "write it at a, or with \\cdot before the bracket");
    }
    if (calls || is_function(along) || !(exponent || sum_in_bracket())) {
        refuse("the bracket after " + name,
               "write " + name + "\\cdot(...) for a product, or \\mathrm{" +
                   (is_function(along) ? along + "}(...) for the value" : name + "} alone"));
    }
    return name;
}
bool TexReader::sum_in_bracket() const {
    int depth = 0;
    bool term = false; // a term precedes
    for (std::size_t i = at_; i < tex_.size(); ++i) {
        const char c = tex_[i];
        const bool opens = c == '(' || c == '{' || c == '[';
        depth += opens ? 1 : 0;
        depth -= c == ')' || c == '}' || c == ']' ? 1 : 0;
        const bool sign = c == '+' || c == '-';
        if (depth <= 0 || (depth == 1 && sign && term)) {
            return depth > 0;
        }
        term = term || (depth == 1 && !opens && !sign && c != ' ');
    }
    return false;
}

} // namespace edgeproof::formula
