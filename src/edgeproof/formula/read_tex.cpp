// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/tex_tokens.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace edgeproof::formula {
namespace {

/// The strength with which the operators of a plain text bind.
enum class Binding { sum, product, power, atom };

struct Plain {
    std::string text;
    Binding binding = Binding::atom;
};

std::string at_least(const Plain& part, Binding binding) {
    return part.binding < binding ? "(" + part.text + ")" : part.text;
}

/// A name with its scripts, before it is looked up.
struct ScriptedName {
    std::string letter;
    std::string subscript;
    std::size_t primes = 0;
    bool star = false;
};

class TexReader : TexTokens {
public:
    TexReader(std::string_view tex, const Symbols& allowed) : TexTokens(tex), allowed_(allowed) {}

    std::string read() {
        if (tex_.size() > longest_tex) {
            fail("the formula is " + std::to_string(tex_.size()) + " bytes long",
                 "write one of at most " + std::to_string(longest_tex));
        }
        const Plain whole = sum();
        if (!at_end()) {
            unexpected();
        }
        return whole.text;
    }

private:
    // --- the grammar

    /// `integrand`: ends behind the product that contains the differential.
    Plain sum(bool integrand = false) {
        const Level level(*this);
        Plain all;
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
            const Plain next = product(integrand);
            all.text += sign + at_least(next, Binding::product);
            all.binding = Binding::sum;
        }
        return all;
    }

    Plain product(bool integrand) {
        std::optional<Plain> all;
        bool divided = false;
        open_end_ = false;
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
            const bool is_call = is_function_command(command());
            if (all && operation == '\0') {
                if (divided) {
                    refuse("the product without a sign after a '/'", "write \\frac{a}{bc}");
                }
                if (open_end_ && !is_call) {
                    refuse("the end of the function or integral before the factor",
                           "put the argument in brackets, and write products with \\cdot");
                }
                if (is_tex_digit(peek()) || peek() == '.') {
                    fail("a number follows a factor" + at_column(tex_, at_), "write \\cdot");
                }
            }
            open_end_ = false;
            if (differential()) {
                if (!all) {
                    all = Plain{"1"};
                }
                open_end_ = true;
                continue;
            }
            const Plain next = factor();
            if (!all) {
                all = next;
            } else {
                const bool divides = operation == '/';
                all->text = at_least(*all, Binding::product) + (divides ? '/' : '*') +
                            at_least(next, Binding::power);
                all->binding = Binding::product;
                divided = divides;
            }
        }
        return *all;
    }

    bool starts_factor() {
        const char c = peek();
        if (c == '|') {
            return bars_ == 0;
        }
        if (c != '\\') {
            return is_tex_letter(c) || is_tex_digit(c) || c == '(' || c == '[' || c == '{' ||
                   c == '.';
        }
        const std::string_view name = command();
        return name == "frac" || name == "dfrac" || name == "tfrac" || name == "sqrt" ||
               name == "int" || name == "{" || name == "lvert" || is_in(tex_greek, name) ||
               is_in(tex_upright, name) || is_function_command(name);
    }
    static bool is_function_command(std::string_view name) {
        return std::ranges::find(tex_functions, name, &TexFunction::command) != tex_functions.end();
    }

    Plain factor() {
        const Level level(*this);
        const char c = peek();
        if (is_tex_digit(c) || c == '.') {
            return with_power({number()});
        }
        if (c == '(' || c == '[') {
            ++at_;
            Plain inside = sum();
            expect(c == '(' ? ')' : ']');
            return with_power({"(" + inside.text + ")"});
        }
        if (c == '{') {
            Plain inside = group();
            if (inside.binding < Binding::power) {
                fail("the braces before" + at_column(tex_, at_) + " are not printed",
                     "write round brackets");
            }
            return with_power(std::move(inside));
        }
        if (c == '|' || command() == "lvert") {
            return with_power(modulus());
        }
        if (is_tex_letter(c)) {
            return named();
        }
        if (take("{")) {
            Plain inside = sum();
            if (!take("}")) {
                expect('}');
            }
            return with_power({"(" + inside.text + ")"});
        }
        if (take("frac") || take("dfrac") || take("tfrac")) {
            const Plain top = argument();
            const Plain bottom = argument();
            return with_power(
                {at_least(top, Binding::product) + "/" + at_least(bottom, Binding::power),
                 Binding::product});
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

    Plain group() {
        expect('{');
        Plain inside = sum();
        expect('}');
        return inside;
    }
    /// A group in braces, or one token.
    Plain argument() {
        const Level level(*this);
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

    std::string number() {
        const std::size_t start = at_;
        while (at_ < tex_.size() && (is_tex_digit(tex_[at_]) || tex_[at_] == '.')) {
            ++at_;
        }
        return std::string(tex_.substr(start, at_ - start));
    }

    Plain modulus() {
        const bool bar = take('|');
        if (!bar) {
            take("lvert");
        }
        const int outer = std::exchange(bars_, bar ? 1 : 0);
        const Plain inside = sum();
        bars_ = outer;
        if (bar) {
            expect('|');
        } else if (!take("rvert")) {
            unexpected();
        }
        return {"abs(" + inside.text + ")"};
    }

    Plain root() {
        if (!take('[')) {
            return {"sqrt(" + argument().text + ")"};
        }
        const Plain degree = sum();
        expect(']');
        const Plain inside = argument();
        return {at_least(inside, Binding::atom) + "^(1/" + at_least(degree, Binding::power) + ")",
                Binding::power};
    }

    /// Reads the exponent of a base that is no name.
    Plain with_power(Plain base) {
        open_end_ = false;
        if (!take('^')) {
            return base;
        }
        const Plain exponent = argument();
        if (peek() == '^') {
            fail("two exponents" + at_column(tex_, at_), "put one into the other by braces");
        }
        return {at_least(base, Binding::atom) + "^" + at_least(exponent, Binding::atom),
                Binding::power};
    }

    Plain function() {
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
        std::optional<Plain> exponent;
        if (take('^')) {
            exponent = argument();
            if (exponent->text.front() == '-') {
                refuse("the power of the function", "write \\arcsin x or 1/\\sin x");
            }
        }
        const bool bracketed = peek() == '(' || peek() == '[';
        const Plain value{name + "(" + (bracketed ? arguments() : factor().text) + ")"};
        open_end_ = !bracketed;
        if (peek() == '^' && bracketed) {
            refuse("the power of the function or of its argument",
                   "write \\sin^2(x) or \\sin((x)^2)");
        }
        return exponent
                   ? Plain{value.text + "^" + at_least(*exponent, Binding::atom), Binding::power}
                   : value;
    }
    /// Reads the arguments of a function, in brackets.
    std::string arguments() {
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

    // --- integrals

    [[nodiscard]] bool has_differential() const {
        return !variables_.empty() && !variables_.back().empty();
    }
    /// Reads "ds" inside an integral that has no variable yet.
    bool differential() {
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
    Plain integral() {
        const Level level(*this);
        std::array<std::string, 2> limits;
        for (int k = 0; k < 2; ++k) {
            const bool lower = take('_');
            if (!lower && !take('^')) {
                fail("an integral without limits" + at_column(tex_, at_), "write \\int_{a}^{b}");
            }
            limits.at(lower ? 0 : 1) = argument().text;
        }
        variables_.emplace_back();
        const Plain integrand = sum(true);
        const std::string variable = variables_.back();
        variables_.pop_back();
        if (variable.empty()) {
            fail("an integral without a differential" + at_column(tex_, at_),
                 "end the integrand by \\,ds");
        }
        open_end_ = true;
        return {"integral(" + integrand.text + ", " + variable + ", " + limits[0] + ", " +
                limits[1] + ")"};
    }

    // --- names

    ScriptedName bare_name() {
        if (is_tex_letter(peek())) {
            return {std::string(1, tex_[at_++]), {}};
        }
        const std::string name(command());
        at_ += 1 + name.size();
        return {is_in(tex_upright, name) ? raw_group() : name, {}};
    }
    /// Returns the letters and digits of a group or token; "\\mathrm{I}" is I, "\\sigma" sigma.
    std::string raw_group() {
        const Level level(*this);
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
                fail("the name or subscript" + at_column(tex_, at_) +
                         " is not of letters and digits",
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

    /// Reads subscript, star and primes; returns an exponent that follows.
    std::optional<Plain> scripts(ScriptedName& name) {
        std::optional<Plain> exponent;
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
            fail("two scripts of one kind" + at_column(tex_, at_),
                 "put one into the other by braces");
        }
        return exponent;
    }
    std::optional<Plain> superscript(ScriptedName& name) {
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
        Plain exponent = sum();
        expect('}');
        return exponent;
    }

    [[nodiscard]] bool is_function(std::string_view name) const {
        return allowed_.function(name) != nullptr;
    }
    [[nodiscard]] std::vector<std::string> candidates(const ScriptedName& name) const {
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
            letter += name.primes > 0 ? std::to_string(name.primes) : "";
            all.push_back(name.subscript.empty() ? letter : letter + "_" + name.subscript);
            // P1 is P'(a), not P_1; g1 is g'.
            if (std::ranges::all_of(name.subscript, is_tex_digit) && !is_function(letter + "of") &&
                !is_function(letter + name.subscript)) {
                all.push_back(letter + name.subscript);
            }
        }
        return all;
    }
    /// The name in `allowed`; if there is none, the first candidate, which may be bound.
    [[nodiscard]] std::string looked_up(const ScriptedName& name) const {
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

    Plain named() {
        ScriptedName written = bare_name();
        std::optional<Plain> exponent = scripts(written);
        const std::string name = looked_up(written);
        if (name == "e" && !allowed_.has(name)) { // e^x
            return {"exp(" + (exponent ? exponent->text : "1") + ")"};
        }
        const Plain value{peek() == '(' ? before_bracket(written, name, exponent.has_value())
                                        : name};
        open_end_ = false;
        return exponent
                   ? Plain{value.text + "^" + at_least(*exponent, Binding::atom), Binding::power}
                   : with_power(value);
    }
    /// Returns the text of a name before a bracket: a call, or a factor alone.
    std::string before_bracket(const ScriptedName& written, const std::string& name,
                               bool has_exponent) {
        const std::string along = name + "of";
        const bool is_variable = allowed_.has(name);
        if (!is_variable && (is_function(name) || find_builtin(name))) {
            return name + "(" + arguments() + ")";
        }
        if (written.primes > 0 && (is_function(along) || is_variable)) { // P'(s)
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
        if (is_function(along) || !(has_exponent || sum_in_bracket())) {
            refuse("the bracket after " + name,
                   "write " + name + "\\cdot(...) for a product, or \\mathrm{" +
                       (is_function(along) ? along + "}(...) for the value" : name + "} alone"));
        }
        return name;
    }
    /// True if the bracket at this place contains a + or - outside of inner brackets.
    [[nodiscard]] bool sum_in_bracket() const {
        int depth = 0;
        for (std::size_t i = at_; i < tex_.size(); ++i) {
            const char c = tex_[i];
            depth += c == '(' || c == '{' || c == '[' ? 1 : 0;
            depth -= c == ')' || c == '}' || c == ']' ? 1 : 0;
            if (depth <= 0 || (depth == 1 && (c == '+' || c == '-'))) {
                return depth > 0;
            }
        }
        return false;
    }

    const Symbols& allowed_;
    int bars_ = 0;
    bool open_end_ = false;              ///< the last factor ends with an argument without brackets
    std::vector<std::string> variables_; ///< of the integrals being read; empty until "ds"
};

} // namespace

bool is_tex(std::string_view text) { return text.find_first_of("\\{}") != std::string_view::npos; }

std::string plain_from_tex(std::string_view tex, const Symbols& allowed) {
    return TexReader(tex, allowed).read();
}

} // namespace edgeproof::formula
