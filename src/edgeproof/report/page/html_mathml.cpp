// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/page/html_mathml.hpp"

#include "edgeproof/report/text/html_markup.hpp"

#include <array>
#include <cctype>
#include <map>
#include <string_view>

namespace edgeproof::report {
namespace {

using Kind = formula::Expr::Kind;

enum Precedence { additive = 1, multiplicative = 2, power = 3, atom = 4 };

Precedence precedence(const formula::Expr& e) {
    switch (e.kind()) {
    case Kind::add:
    case Kind::sub:
    case Kind::neg:
        return additive;
    case Kind::mul:
    case Kind::integral:
    case Kind::pv:
    case Kind::sum:
        return multiplicative;
    case Kind::div: // set as one block
        return power;
    case Kind::pow:
        return power;
    default:
        return atom;
    }
}

std::string row(const std::string& content) { return "<mrow>" + content + "</mrow>"; }
std::string op(std::string_view text) { return "<mo>" + std::string(text) + "</mo>"; }
std::string identifier(std::string_view text) { return "<mi>" + escape_html(text) + "</mi>"; }
std::string literal(std::string_view text) { return "<mn>" + escape_html(text) + "</mn>"; }
std::string words(std::string_view text) { return "<mtext>" + escape_html(text) + "</mtext>"; }
std::string parentheses(const std::string& content) { return row(op("(") + content + op(")")); }
constexpr std::string_view invisible_times = "&#x2062;";
constexpr std::string_view apply = "&#x2061;";

std::string greek(std::string_view name) {
    static const std::map<std::string_view, std::string_view> letters{
        {"alpha", "α"},  {"beta", "β"},    {"gam", "γ"},  {"gamma", "γ"}, {"delta", "δ"},
        {"eps", "ε"},    {"epsilon", "ε"}, {"zeta", "ζ"}, {"eta", "η"},   {"theta", "θ"},
        {"kappa", "κ"},  {"lambda", "λ"},  {"mu", "μ"},   {"nu", "ν"},    {"xi", "ξ"},
        {"rho", "ρ"},    {"sigma", "σ"},   {"sig", "σ"},  {"tau", "τ"},   {"phi", "φ"},
        {"varphi", "φ"}, {"chi", "χ"},     {"psi", "ψ"},  {"omega", "ω"}, {"Gamma", "Γ"},
        {"Delta", "Δ"},  {"Sigma", "Σ"},   {"Phi", "Φ"},  {"Psi", "Ψ"},   {"Omega", "Ω"}};
    const auto found = letters.find(name);
    return std::string(found == letters.end() ? name : found->second);
}

bool all_digits(std::string_view text) {
    for (const char c : text) {
        if (std::isdigit(static_cast<unsigned char>(c)) == 0) {
            return false;
        }
    }
    return !text.empty();
}

std::string primes(std::string_view of, unsigned long k) {
    if (k <= 3) {
        static constexpr std::array marks{"", "′", "″", "‴"};
        return "<msup>" + identifier(of) + op(marks[k]) + "</msup>";
    }
    return "<msup>" + identifier(of) + row(op("(") + literal(std::to_string(k)) + op(")")) +
           "</msup>";
}

std::string symbol(std::string_view name) {
    if (name == "calP") {
        return identifier("𝒫");
    }
    if (name == "Es") {
        return "<msup>" + identifier("E") + op("*") + "</msup>";
    }
    // P1, b2: derivatives along the family of contacts, at a.
    if (name.size() == 2 && (name[0] == 'P' || name[0] == 'b') && all_digits(name.substr(1)) &&
        name[1] != '0') {
        return row(primes(name.substr(0, 1), static_cast<unsigned long>(name[1] - '0')) +
                   op(apply) + parentheses(identifier("a")));
    }
    for (const std::string_view side : {"right", "left"}) {
        if (name.starts_with(side) && name.size() > side.size() + 2 && name[side.size()] == '_') {
            const std::string_view rest = name.substr(side.size() + 1);
            if (all_digits(rest.substr(1))) {
                return "<msubsup>" + identifier(rest.substr(0, 1)) + literal(rest.substr(1)) +
                       words(side) + "</msubsup>";
            }
        }
    }
    std::size_t stem = name.find('_');
    if (stem == std::string_view::npos || stem == 0) {
        stem = name.size();
        while (stem > 1 && std::isdigit(static_cast<unsigned char>(name[stem - 1])) != 0) {
            --stem;
        }
    }
    const std::string base = identifier(greek(name.substr(0, stem)));
    std::string_view subscript = name.substr(stem);
    if (subscript.starts_with('_')) {
        subscript.remove_prefix(1);
    }
    if (subscript.empty()) {
        return base;
    }
    return "<msub>" + base +
           (all_digits(subscript)   ? literal(subscript)
            : subscript.size() == 1 ? identifier(subscript)
                                    : words(subscript)) +
           "</msub>";
}

class MathmlPrinter {
public:
    std::string operator()(const formula::Expr& e) const {
        switch (e.kind()) {
        case Kind::number:
            return number(e);
        case Kind::pi:
            return identifier("π");
        case Kind::symbol:
            return symbol(e.name());
        case Kind::neg:
            return row(op("−") + wrapped(e.arg(0), multiplicative));
        case Kind::add:
            return row(wrapped(e.arg(0), additive) + op("+") + wrapped(e.arg(1), multiplicative));
        case Kind::sub:
            return row(wrapped(e.arg(0), additive) + op("−") + wrapped(e.arg(1), multiplicative));
        case Kind::mul:
            return row(factor(e.arg(0), false) + op(product_sign(e)) + factor(e.arg(1), true));
        case Kind::div:
            return "<mfrac>" + row((*this)(e.arg(0))) + row((*this)(e.arg(1))) + "</mfrac>";
        case Kind::pow:
            return "<msup>" + base(e.arg(0)) + row((*this)(e.arg(1))) + "</msup>";
        case Kind::call:
            return call(e);
        case Kind::integral:
            return integral(e, "∫");
        case Kind::pv:
            return integral(e, "⨍");
        case Kind::sum:
            return row("<munderover>" + op("∑") +
                       row(symbol(e.arg(1).name()) + op("=") + (*this)(e.arg(2))) +
                       row((*this)(e.arg(3))) + "</munderover>" + wrapped(e.arg(0), power));
        }
        return {};
    }

private:
    std::string wrapped(const formula::Expr& e, Precedence least) const {
        const std::string content = (*this)(e);
        return precedence(e) < least ? parentheses(content) : content;
    }
    /// A factor: a product on the right keeps its parentheses, and so does an integral before
    /// something that would seem to be part of it.
    std::string factor(const formula::Expr& e, bool last) const {
        return wrapped(e, last || e.is_binder() ? power : multiplicative);
    }
    /// What a power is raised on: only a plain letter or number stands bare.
    std::string base(const formula::Expr& e) const {
        const std::string content = (*this)(e);
        const bool bare = content.starts_with("<mi>") || content.starts_with("<mn>") ||
                          content.starts_with("<msub>");
        return bare && precedence(e) == atom && e.kind() != Kind::call ? content
                                                                       : parentheses(content);
    }
    static std::string number(const formula::Expr& e) {
        const std::string text = to_text(e);
        const std::size_t exponent = text.find('e');
        if (exponent == std::string::npos) {
            return literal(text);
        }
        std::string ten = text.substr(exponent + 1);
        const bool negative = ten.starts_with('-');
        ten = (negative ? op("−") : "") + literal(negative ? ten.substr(1) : ten);
        const std::string power_of_ten = "<msup>" + literal("10") + row(ten) + "</msup>";
        const std::string mantissa = text.substr(0, exponent);
        return mantissa == "1" ? power_of_ten : row(literal(mantissa) + op("·") + power_of_ten);
    }
    /// Two numbers side by side would read as one.
    static std::string_view product_sign(const formula::Expr& e) {
        const formula::Expr* right = &e.arg(1);
        while (right->kind() == Kind::pow || right->kind() == Kind::mul) {
            right = &right->arg(0);
        }
        const bool dot = right->kind() == Kind::number || right->kind() == Kind::div;
        return dot ? std::string_view("·") : invisible_times;
    }
    std::string list(const formula::Expr& e) const {
        std::string content;
        for (std::size_t i = 0; i < e.args().size(); ++i) {
            content += (i == 0 ? "" : op(",")) + (*this)(e.args()[i]);
        }
        return content;
    }
    std::string call(const formula::Expr& e) const {
        switch (e.builtin()) {
        case formula::Builtin::sqrt:
            return "<msqrt>" + (*this)(e.arg(0)) + "</msqrt>";
        case formula::Builtin::abs:
            return row(op("|") + (*this)(e.arg(0)) + op("|"));
        case formula::Builtin::log:
            return row(identifier("ln") + op(apply) + parentheses((*this)(e.arg(0))));
        case formula::Builtin::gamma:
            return row(identifier("Γ") + op(apply) + parentheses((*this)(e.arg(0))));
        case formula::Builtin::asin:
        case formula::Builtin::acos:
        case formula::Builtin::atan:
            return row(identifier("arc" + e.name().substr(1)) + op(apply) +
                       parentheses((*this)(e.arg(0))));
        case formula::Builtin::none:
            return row(function_name(e.name()) + op(apply) + parentheses(list(e)));
        default:
            return row(identifier(e.name()) + op(apply) + parentheses(list(e)));
        }
    }
    static std::string function_name(std::string_view name) {
        if (name == "g1") {
            return primes("g", 1);
        }
        if (name == "P1of") {
            return primes("P", 1);
        }
        if (name == "Pof" || name == "bof") {
            return identifier(name.substr(0, 1));
        }
        if (name == "binv") {
            return "<msup>" + identifier("b") + row(op("−") + literal("1")) + "</msup>";
        }
        if (name == "right_local" || name == "left_local") {
            return "<msubsup>" + identifier("p") + words("local") +
                   words(name.substr(0, name.find('_'))) + "</msubsup>";
        }
        return symbol(name);
    }
    std::string integral(const formula::Expr& e, std::string_view sign) const {
        return row("<msubsup>" + op(sign) + row((*this)(e.arg(2))) + row((*this)(e.arg(3))) +
                   "</msubsup>" + wrapped(e.arg(0), multiplicative) +
                   "<mspace width=\"0.17em\"></mspace>" + identifier("d") +
                   symbol(e.arg(1).name()));
    }
};

} // namespace

std::string to_mathml(const formula::Expr& e) { return row(MathmlPrinter()(e)); }

std::string math_element(const std::string& content, const std::string& label) {
    return "<math display=\"block\" xmlns=\"http://www.w3.org/1998/Math/MathML\" aria-label=\"" +
           escape_html(label) + "\">" + content + "</math>";
}

} // namespace edgeproof::report
