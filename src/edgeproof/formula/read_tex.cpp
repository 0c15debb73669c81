// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/tex_reader.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace edgeproof::formula {
namespace {

bool is_number_text(std::string_view text) {
    return !text.empty() &&
           std::ranges::all_of(text, [](char c) { return is_tex_digit(c) || c == '.'; });
}

/// True for a name or a number without scripts or brackets, or for one expression in brackets.
bool is_printed_alone(const PlainPart& part) {
    const bool bare = std::ranges::all_of(part.text, [](char c) {
        return is_tex_letter(c) || is_tex_digit(c) || c == '.' || c == '_';
    });
    return part.binding == Binding::atom && (bare || part.text.front() == '(');
}

} // namespace

std::string TexReader::read() {
    if (tex_.size() > longest_tex) {
        fail("the formula is " + std::to_string(tex_.size()) + " bytes long",
             "write one of at most " + std::to_string(longest_tex));
    }
    const PlainPart whole = sum();
    if (!at_end()) {
        unexpected();
    }
    return whole.text;
}

PlainPart TexReader::sum(bool integrand) {
    const Level level = deeper();
    PlainPart all;
    if (take('-')) {
        all = {"-" + at_least(product(integrand), Binding::product), Binding::sum};
    } else {
        take('+');
        all = product(integrand);
    }
    while (!(integrand && has_differential())) {
        const char sign = peek();
        if (sign != '+' && sign != '-') {
            break;
        }
        ++at_;
        const PlainPart next = product(integrand);
        all.text += sign + at_least(next, Binding::product);
        all.binding = Binding::sum;
    }
    return all;
}

PlainPart TexReader::product(bool integrand) {
    std::optional<PlainPart> all;
    bool divided = false;
    open_end_ = OpenEnd::none;
    while (true) {
        char operation = '\0';
        if (all) {
            if (integrand && has_differential()) {
                break;
            }
            operation = take('/') ? '/' : take('*') || take("cdot") || take("times") ? '*' : 0;
            if (operation == '\0' && !starts_factor()) {
                break;
            }
        }
        const bool may_end = operation != '/' && !divided && open_end_ != OpenEnd::integral;
        const bool ends = may_end && differential();
        if (all && !ends) {
            check_next(operation, divided);
        }
        open_end_ = OpenEnd::none;
        if (ends) {
            if (!all) {
                all = PlainPart{"1"};
            }
            open_end_ = OpenEnd::integral;
            continue;
        }
        const std::string before = operation == '\0' ? std::exchange(last_, {}) : std::string();
        const std::size_t start = at_;
        const bool marked = peek() == '{' || is_in(tex_upright, command());
        const PlainPart next = factor();
        last_ = next.text;
        if (!all) {
            all = next;
            continue;
        }
        // "2{3}" is printed as 23, and 2\frac{1}{2} is also two and a half.
        const bool digit = marked && is_number_text(next.text.substr(0, 1));
        const bool mixed = is_number_text(before) && next.binding == Binding::product &&
                           std::ranges::none_of(next.text, is_tex_letter);
        if (operation == '\0' && (digit || mixed)) {
            at_ = start;
            refuse("the number after a factor", "write \\cdot");
        }
        all->text = at_least(*all, Binding::product) + (operation == '/' ? '/' : '*') +
                    at_least(next, Binding::power);
        all->binding = Binding::product;
        divided = operation == '/';
    }
    return *all;
}

void TexReader::check_next(char operation, bool divided) {
    const bool is_call = is_function_command(command());
    if (operation != '\0') {
        // \sin x/2, \ln a \cdot b, \int_0^a dx/x
        if (open_end_ == OpenEnd::integral ||
            (open_end_ == OpenEnd::function && !(operation == '*' && is_call))) {
            refuse("the end of the function or integral before the sign",
                   "put the argument of the function, or the integral, in brackets");
        }
        return;
    }
    if (divided) {
        refuse("the product without a sign after a '/'", "write \\frac{a}{bc}");
    }
    if (open_end_ == OpenEnd::integral || (open_end_ == OpenEnd::function && !is_call)) {
        refuse("the end of the function or integral before the factor",
               "put the argument of the function, or the integral, in brackets");
    }
    if (is_tex_digit(peek()) || peek() == '.') {
        fail("a number follows a factor" + at_column(tex_, at_), "write \\cdot");
    }
}

bool TexReader::starts_factor() {
    const char c = peek();
    if (c == '|') {
        return bars_ == 0;
    }
    if (c != '\\') {
        return is_tex_letter(c) || is_tex_digit(c) || c == '(' || c == '[' || c == '{' || c == '.';
    }
    const std::string_view name = command();
    return name == "frac" || name == "dfrac" || name == "tfrac" || name == "sqrt" ||
           name == "int" || name == "{" || name == "lvert" || is_in(tex_greek, name) ||
           is_in(tex_upright, name) || is_function_command(name);
}

PlainPart TexReader::factor() {
    const Level level = deeper();
    const char c = peek();
    if (is_tex_digit(c) || c == '.') {
        return with_power({number()});
    }
    if (c == '(' || c == '[') {
        ++at_;
        PlainPart inside = sum();
        expect(c == '(' ? ')' : ']');
        return with_power({"(" + inside.text + ")"});
    }
    if (c == '{') {
        return braced_factor();
    }
    if (c == '|' || command() == "lvert") {
        return with_power(modulus());
    }
    if (is_tex_letter(c)) {
        return named();
    }
    if (take("{")) {
        PlainPart inside = sum();
        if (!take("}")) {
            expect('}');
        }
        return with_power({"(" + inside.text + ")"});
    }
    if (take("frac") || take("dfrac") || take("tfrac")) {
        return with_power(fraction());
    }
    if (take("sqrt")) {
        return with_power(root());
    }
    if (take("int")) {
        return integral();
    }
    if (is_function_command(command())) {
        return function();
    }
    if (is_in(tex_greek, command()) || is_in(tex_upright, command())) {
        return named();
    }
    unexpected();
}

PlainPart TexReader::group() {
    expect('{');
    PlainPart inside = sum();
    expect('}');
    return inside;
}
/// The braces are not printed: what is in them must have the same meaning without them.
PlainPart TexReader::braced_factor() {
    PlainPart inside = group();
    const char next = peek();
    const bool alone = is_printed_alone(inside);
    if (inside.binding < Binding::power || (next == '^' && !alone)) {
        fail("the braces before" + at_column(tex_, at_) + " are not printed",
             "write round brackets");
    }
    if (alone && inside.text.front() != '(' && opens_bracket()) {
        refuse("the bracket after " + inside.text, "write \\cdot for a product");
    }
    return next == '^' ? with_power(std::move(inside)) : inside;
}
PlainPart TexReader::fraction() {
    const std::size_t start = at_;
    const PlainPart top = argument();
    const bool had_differential = has_differential();
    const PlainPart bottom = argument();
    if (has_differential() != had_differential) {
        fail("the differential in the denominator before" + at_column(tex_, at_),
             "end the integrand by \\,ds");
    }
    const auto is_differential = [](const std::string& text) {
        return text == "d" || text.starts_with("d*") || text.starts_with("d^");
    };
    if (is_differential(top.text) && is_differential(bottom.text)) {
        at_ = start;
        refuse("the derivative or quotient", "write P' for a derivative, and a quotient without d");
    }
    return {at_least(top, Binding::product) + "/" + at_least(bottom, Binding::power),
            Binding::product};
}
PlainPart TexReader::argument() {
    const Level level = deeper();
    const char c = peek();
    if (c == '{') {
        return group();
    }
    if (is_tex_digit(c) || is_tex_letter(c)) {
        ++at_;
        return {is_tex_digit(c) ? std::string(1, c) : looked_up({std::string(1, c), {}})};
    }
    if (is_in(tex_greek, command())) {
        const std::string name(command());
        at_ += 1 + name.size();
        return {looked_up({name, {}})};
    }
    fail("the argument" + at_column(tex_, at_) + " is neither in braces nor one character",
         "put it in braces");
}

std::string TexReader::number() {
    const std::size_t start = at_;
    const auto is_digit_at = [this](std::size_t i) {
        return i < tex_.size() && is_tex_digit(tex_[i]);
    };
    while (is_digit_at(at_) || (at_ < tex_.size() && tex_[at_] == '.')) {
        ++at_;
    }
    const bool exponent = at_ < tex_.size() && (tex_[at_] == 'e' || tex_[at_] == 'E');
    const bool sign =
        exponent && at_ + 1 < tex_.size() && (tex_[at_ + 1] == '-' || tex_[at_ + 1] == '+');
    if (exponent && is_digit_at(at_ + (sign ? 2 : 1))) {
        refuse("the number with an exponent", "write 10^{-3}, or 2\\cdot e - 3");
    }
    return std::string(tex_.substr(start, at_ - start));
}

PlainPart TexReader::modulus() {
    const bool bar = take('|');
    if (!bar) {
        take("lvert");
    }
    const int outer = std::exchange(bars_, bar ? 1 : 0);
    const PlainPart inside = sum();
    bars_ = outer;
    if (bar) {
        expect('|');
    } else if (!take("rvert")) {
        unexpected();
    }
    return {"abs(" + inside.text + ")"};
}

PlainPart TexReader::root() {
    if (!take('[')) {
        return {"sqrt(" + argument().text + ")"};
    }
    const PlainPart degree = sum();
    expect(']');
    const PlainPart inside = argument();
    return {at_least(inside, Binding::atom) + "^(1/" + at_least(degree, Binding::power) + ")",
            Binding::power};
}

PlainPart TexReader::with_power(PlainPart base) {
    open_end_ = OpenEnd::none;
    if (!take('^')) {
        return base;
    }
    const PlainPart exponent = argument();
    if (peek() == '^') {
        fail("two exponents" + at_column(tex_, at_), "put one into the other by braces");
    }
    return {at_least(base, Binding::atom) + "^" + at_least(exponent, Binding::atom),
            Binding::power};
}

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

bool is_tex(std::string_view text) { return text.find_first_of("\\{}") != std::string_view::npos; }

std::string plain_from_tex(std::string_view tex, const Symbols& allowed) {
    return TexReader(tex, allowed).read();
}

} // namespace edgeproof::formula
