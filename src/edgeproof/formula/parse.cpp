// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/parse.hpp"

#include "edgeproof/formula/fold.hpp"
#include "edgeproof/formula/names.hpp"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace edgeproof::formula {
namespace {

constexpr std::size_t max_length = 20'000;
constexpr std::size_t max_depth = 200;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_name_start(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_name(char c) { return is_name_start(c) || is_digit(c); }

/// A product without a `*`, between the bytes `left` and `right` of the text.
struct ImpliedProduct {
    std::size_t left;
    std::size_t right;
};

class Parser {
public:
    /// `products`: receives the products without a `*`; if null, these are refused.
    Parser(std::string_view text, const Symbols& allowed,
           std::vector<ImpliedProduct>* products = nullptr)
        : text_(text), allowed_(allowed), products_(products) {}

    Expr operator()() {
        if (text_.size() > max_length) {
            fail("the expression is " + std::to_string(text_.size()) + " bytes long",
                 "write one of at most " + std::to_string(max_length));
        }
        skip_space();
        if (pos_ == text_.size()) {
            fail("the expression is empty", "write a number or a formula");
        }
        const Expr e = sum();
        if (pos_ < text_.size()) {
            unexpected_after_operand();
        }
        std::vector<std::string_view> bound;
        check_names(e, bound);
        return e;
    }

private:
    [[noreturn]] static void fail(std::string problem, std::string instead) {
        throw FormulaError(std::move(problem), std::move(instead));
    }
    [[nodiscard]] std::string column(std::size_t offset) const { return at_column(text_, offset); }

    // --- characters

    void skip_space() {
        while (pos_ < text_.size() && is_space(text_[pos_])) {
            ++pos_;
        }
    }
    [[nodiscard]] char peek() const { return pos_ < text_.size() ? text_[pos_] : '\0'; }
    [[nodiscard]] bool at_end() const { return pos_ == text_.size(); }
    /// Consumes a character of the grammar and the space after it.
    bool take(char c) {
        if (at_end() || text_[pos_] != c) {
            return false;
        }
        ++pos_;
        consumed_ = pos_;
        skip_space();
        return true;
    }

    [[nodiscard]] Level deeper() {
        if (depth_ == max_depth) {
            fail("the expression is nested more than " + std::to_string(max_depth) +
                     " levels deep" + column(pos_),
                 "write it with fewer brackets, signs or powers inside one another");
        }
        return Level(depth_);
    }

    // --- the grammar

    Expr located(const Expr& e, std::size_t start) { return e.located(start, consumed_ - start); }

    Expr sum() {
        const std::size_t start = pos_;
        Expr left = term();
        for (;;) {
            if (take('+')) {
                left = combine(left, term(), start, std::plus<>());
            } else if (take('-')) {
                left = combine(left, term(), start, std::minus<>());
            } else {
                return left;
            }
        }
    }

    Expr term() {
        const std::size_t start = pos_;
        Expr left = signed_factor();
        bool divided = false;
        for (;;) {
            if (take('*')) {
                if (peek() == '*') {
                    fail("'**'" + column(pos_ - 1), "write a power as x^y");
                }
                left = combine(left, signed_factor(), start, std::multiplies<>());
                divided = false;
            } else if (take('/')) {
                left = combine(left, signed_factor(), start, std::divides<>());
                divided = true;
            } else if (implies_product()) {
                check_implied_product(divided);
                products_->push_back({consumed_, pos_});
                left = combine(left, power(), start, std::multiplies<>());
            } else {
                return left;
            }
        }
    }

    [[nodiscard]] bool implies_product() const {
        return products_ != nullptr && (peek() == '(' || is_name_start(peek())) && !at_unit();
    }
    void check_implied_product(bool divided) const {
        const std::string where = column(pos_) + " can be read in two ways";
        if (divided) {
            fail("the product without '*' after a '/'" + where,
                 "write a/(b*c) or (a/b)*c with '*' and brackets");
        }
        if (is_power_) {
            fail("the product without '*' after a power" + where, "write x^2*y or x^(2*y)");
        }
    }

    template <class Operation>
    Expr combine(const Expr& left, const Expr& right, std::size_t start, Operation operation) {
        check_height(left, start);
        check_height(right, start);
        return located(operation(left, right), start);
    }

    /// Called for every child before its parent is built.
    void check_height(const Expr& child, std::size_t start) const {
        if (child.height() >= Expr::max_height) {
            fail("more than " + std::to_string(Expr::max_height) + " operations in a chain" +
                     column(start),
                 "group the terms by brackets");
        }
    }

    Expr signed_factor() {
        const std::size_t start = pos_;
        if (take('-')) {
            const Level level = deeper();
            const Expr operand = signed_factor();
            check_height(operand, start);
            return located(-operand, start);
        }
        if (take('+')) {
            const Level level = deeper();
            return signed_factor();
        }
        return power();
    }

    Expr power() {
        const std::size_t start = pos_;
        const Expr base = primary();
        if (take('^')) {
            const Level level = deeper();
            const Expr exponent = signed_factor();
            check_height(base, start);
            check_height(exponent, start);
            is_power_ = true;
            return located(pow(base, exponent), start);
        }
        is_power_ = false;
        return base;
    }

    Expr primary() {
        const std::size_t start = pos_;
        if (take('(')) {
            const Level level = deeper();
            const Expr inside = sum();
            close(start);
            return inside;
        }
        if (is_digit(peek()) || peek() == '.') {
            const Expr value = number();
            number_end_ = consumed_;
            return value;
        }
        if (is_name_start(peek())) {
            return name_or_call();
        }
        expected_operand();
    }

    void close(std::size_t opened_at) {
        if (take(')')) {
            return;
        }
        if (at_end()) {
            fail("the '('" + column(opened_at) + " is never closed", "add a ')'");
        }
        unexpected_after_operand();
    }

    Expr number() {
        const std::size_t start = pos_;
        const DecimalToken token = decimal_token(text_, start, number_bits_);
        pos_ = token.end;
        consumed_ = pos_;
        skip_space();
        return located(Expr::number(token.value), start);
    }

    [[nodiscard]] std::string_view name_at(std::size_t start) const {
        std::size_t end = start;
        while (end < text_.size() && is_name(text_[end])) {
            ++end;
        }
        return text_.substr(start, end - start);
    }
    [[nodiscard]] bool is_function(std::string_view name) const {
        return arity_of(name, allowed_).most != 0 || allowed_.has_function(name);
    }
    [[nodiscard]] bool is_known(std::string_view name) const {
        return is_pi(name) || allowed_.has(name) || is_function(name);
    }

    Expr name_or_call() {
        const std::size_t start = pos_;
        while (is_name(peek())) {
            ++pos_;
        }
        const std::string name(text_.substr(start, pos_ - start));
        consumed_ = pos_;
        skip_space();
        if (peek() == '(') {
            return call(name, start);
        }
        if (is_pi(name)) {
            return located(Expr::pi(), start);
        }
        if (is_function(name) && !allowed_.has(name)) {
            fail("the function '" + name + "'" + column(start) + " has no arguments",
                 "write " + usage(name, allowed_));
        }
        return located(Expr::symbol(name), start);
    }

    Expr call(const std::string& name, std::size_t start) {
        if (!is_function(name) && (name == "ln" || name == "log10")) {
            const Expr natural = call("log", start);
            return name == "ln" ? natural
                                : located(natural / Expr::call("log", {Expr::number(10)}), start);
        }
        if (!is_function(name)) {
            if (allowed_.has(name) || is_pi(name)) {
                fail("'" + name + "'" + column(start) + " is not a function",
                     "write a product as " + name + "*(...)");
            }
            fail("unknown function '" + name + "'" + column(start),
                 instead_of_function(name, allowed_));
        }
        const std::size_t opened_at = pos_;
        take('(');
        const Level level = deeper();
        std::vector<Expr> args;
        if (peek() != ')') {
            do {
                args.push_back(sum());
            } while (take(',') || (name == "given" && take('=')));
        }
        close(opened_at);
        check_arguments(name, args, start);
        for (const Expr& x : args) {
            check_height(x, start);
        }
        return located(Expr::call(name, std::move(args)), start);
    }

    void check_arguments(const std::string& name, const std::vector<Expr>& args,
                         std::size_t start) const {
        const auto [least, most] = arity_of(name, allowed_);
        if (args.size() < least || args.size() > most) {
            fail("'" + name + "'" + column(start) + " is given " + std::to_string(args.size()) +
                     (args.size() == 1 ? " argument" : " arguments"),
                 "write " + usage(name, allowed_));
        }
        if (binder_arity(name) != 0) {
            const Expr& variable = args[1];
            if (variable.kind() != Expr::Kind::symbol || is_reserved(variable.name())) {
                fail("the second argument of '" + name + "'" + column(variable.offset()) +
                         " is not a variable",
                     "write " + usage(name, allowed_));
            }
        }
    }

    // --- messages

    /// The character at `pos_`, quoted so that it can be printed.
    [[nodiscard]] std::string quoted_character() const { return quoted_at(text_, pos_); }

    [[noreturn]] void expected_operand() const {
        if (at_end()) {
            fail("the expression ends where a number, a name or '(' must follow",
                 "complete it or take off the last operator");
        }
        const std::string what = quoted_character() + column(pos_);
        if (peek() == ')' || peek() == ',') {
            fail("nothing before the " + what, "write a number, a name or '(' there");
        }
        fail("unexpected " + what, hint_for_character(text_, pos_));
    }

    /// True if a name that can only be a unit follows a number.
    [[nodiscard]] bool at_unit() const {
        return consumed_ == number_end_ && is_name_start(peek()) && !is_known(name_at(pos_)) &&
               is_unit(name_at(pos_), allowed_);
    }

    [[noreturn]] void unexpected_after_operand() const {
        const char c = peek();
        const std::string what = quoted_character() + column(pos_);
        if (c == ')') {
            fail("the " + what + " closes nothing", "take it off or add a '('");
        }
        if (c == ',') {
            fail("unexpected " + what, "commas stand only between the arguments of a function");
        }
        if (at_unit()) {
            fail("numbers have no units here: '" + std::string(name_at(pos_)) + "'" + column(pos_),
                 std::string(without_units));
        }
        if (is_name(c) || c == '(' || c == '.') {
            fail("a '*' is missing" + column(pos_), "write every product with *");
        }
        fail("unexpected " + what, hint_for_character(text_, pos_));
    }

    void check_names(const Expr& e, std::vector<std::string_view>& bound) const {
        if (e.kind() == Expr::Kind::symbol) {
            const bool known =
                allowed_.has(e.name()) || std::ranges::find(bound, e.name()) != bound.end();
            if (!known) {
                fail("unknown name '" + e.name() + "'" + column(e.offset()),
                     instead_of_variable(e.name(), allowed_, bound));
            }
        }
        for (std::size_t i = 0; i < e.args().size(); ++i) {
            if (e.is_binder() && i == 0) {
                bound.push_back(e.arg(1).name());
                check_names(e.arg(0), bound);
                bound.pop_back();
            } else if (!(e.is_binder() && i == 1)) {
                check_names(e.args()[i], bound);
            }
        }
    }

    std::string_view text_;
    const Symbols& allowed_;
    std::vector<ImpliedProduct>* products_;
    bool is_power_ = false; // the last operand is a power without brackets
    std::size_t pos_ = 0;
    std::size_t consumed_ = 0; // end of the last token, without the space after it
    std::size_t number_end_ = std::string_view::npos; // end of the last number, like consumed_
    std::size_t depth_ = 0;
    std::size_t number_bits_ = 0;
};

} // namespace

Expr parse(std::string_view text, const Symbols& allowed) { return Parser(text, allowed)(); }

Expr parse(std::string_view text) { return parse(text, Symbols{}); }

std::string with_products(std::string_view written, std::string_view text, const Symbols& allowed) {
    std::vector<ImpliedProduct> products;
    Parser(text, allowed, &products)();
    std::ranges::sort(products, {}, &ImpliedProduct::left);
    std::string plain;
    std::size_t at = 0;
    for (const ImpliedProduct& product : products) {
        plain.append(written.substr(at, product.left - at)).append("*");
        at = product.right;
    }
    return plain.append(written.substr(at));
}

} // namespace edgeproof::formula
