// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/formula/tex_reader.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace edgeproof::formula {
namespace {

using Kind = Expr::Kind;

enum TexPrecedence { tex_sum = 1, tex_product = 2, tex_power = 3, tex_atom = 4 };

bool tall(const std::string& tex) {
    return tex.find("\\frac") != std::string::npos || tex.find("\\int") != std::string::npos;
}

class FormulaWriter {
public:
    explicit FormulaWriter(const std::function<std::string(std::string_view)>& symbol)
        : symbol_(symbol) {}

    std::string operator()(const Expr& e) const {
        switch (e.kind()) {
        case Kind::number:
            return number(e);
        case Kind::pi:
            return "\\pi";
        case Kind::symbol:
            return name(e.name());
        case Kind::neg:
            return "-" + wrapped(e.arg(0), tex_product);
        case Kind::add:
            return wrapped(e.arg(0), tex_sum) + " + " + wrapped(e.arg(1), tex_product);
        case Kind::sub:
            return wrapped(e.arg(0), tex_sum) + " - " + wrapped(e.arg(1), tex_product);
        case Kind::mul:
            return product(e);
        case Kind::div:
            return quotient(e);
        case Kind::pow:
            return e.arg(1).kind() == Kind::number && e.arg(1).number() == 1
                       ? base(e.arg(0))
                       : base(e.arg(0)) + "^{" + exponent(e.arg(1)) + '}';
        case Kind::call:
            return call(e);
        case Kind::integral:
            return integral("\\int", e);
        case Kind::pv:
            return integral("\\fint", e);
        case Kind::sum:
            return "\\sum_{" + name(e.arg(1).name()) + " = " + (*this)(e.arg(2)) + "}^{" +
                   (*this)(e.arg(3)) + "} " + wrapped(e.arg(0), tex_power);
        }
        return {};
    }

private:
    static TexPrecedence precedence(const Expr& e) {
        switch (e.kind()) {
        case Kind::add:
        case Kind::sub:
        case Kind::neg:
            return tex_sum;
        case Kind::mul:
        case Kind::integral:
        case Kind::pv:
        case Kind::sum:
            return tex_product;
        case Kind::div: // set as one block
        case Kind::pow:
            return tex_power;
        default:
            return tex_atom;
        }
    }
    static std::string in_parentheses(const std::string& tex) {
        return tall(tex) ? "\\left(" + tex + "\\right)" : '(' + tex + ')';
    }
    std::string wrapped(const Expr& e, TexPrecedence least) const {
        const std::string tex = (*this)(e);
        const bool sign = tex.starts_with('-') && least > tex_sum;
        return precedence(e) < least || sign ? in_parentheses(tex) : tex;
    }
    std::string name(const std::string& n) const {
        std::string tex = symbol_ ? symbol_(n) : std::string();
        return tex.empty() ? default_name(n) : tex;
    }
    static std::string default_name(const std::string& n) {
        std::size_t stem = n.find('_');
        std::string subscript;
        if (stem != std::string::npos && stem > 0) {
            subscript = n.substr(stem + 1);
            std::erase(subscript, '_');
        } else {
            stem = n.size();
            while (stem > 1 && std::isdigit(static_cast<unsigned char>(n[stem - 1])) != 0) {
                --stem;
            }
            subscript = n.substr(stem);
        }
        const bool derivative = stem == 1 && (n[0] == 'P' || n[0] == 'b') &&
                                subscript.size() == 1 && subscript[0] >= '1' && subscript[0] <= '3';
        if (derivative) { // P1, b2: derivatives along the family of contacts, at a
            return n.substr(0, 1) +
                   std::string(static_cast<std::size_t>(subscript[0] - '0'), '\'') + "(a)";
        }
        const std::string letter = n.substr(0, stem);
        const std::string tex = letter == "Es"             ? "E^{*}"
                                : letter == "eps"          ? "\\varepsilon"
                                : letter == "gam"          ? "\\gamma"
                                : letter == "sig"          ? "\\sigma"
                                : letter.size() < 2        ? letter
                                : is_in(tex_greek, letter) ? '\\' + letter
                                                           : "\\mathrm{" + letter + '}';
        return subscript.empty()
                   ? tex
                   : tex + "_{" +
                         (subscript.size() > 2 ? "\\mathrm{" + subscript + '}' : subscript) + '}';
    }
    static std::string number(const Expr& e) {
        const std::string text = to_text(e);
        const std::size_t at = text.find('e');
        if (at == std::string::npos) {
            return text;
        }
        const std::string power = "10^{" + text.substr(at + 1) + '}';
        return text.substr(0, at) == "1" ? power : text.substr(0, at) + " \\cdot " + power;
    }
    /// Two adjacent numbers would look like one number, and a number before a numerical fraction
    /// like a mixed number.
    std::string product(const Expr& e) const {
        if (e.arg(0).kind() == Kind::neg) { // -a b, not (-a) b
            return "-" + product(e.arg(0).arg(0) * e.arg(1));
        }
        if (e.arg(1).kind() == Kind::number && e.arg(0).kind() != Kind::number &&
            e.arg(0).kind() != Kind::div) { // 9 a, not a 9
            return product(e.arg(1) * e.arg(0));
        }
        const std::string left = wrapped(e.arg(0), e.arg(0).is_binder() ? tex_power : tex_product);
        const std::string right = wrapped(e.arg(1), tex_product);
        const bool numbers = std::isdigit(static_cast<unsigned char>(left.back())) != 0 &&
                             (std::isdigit(static_cast<unsigned char>(right.front())) != 0 ||
                              right.starts_with("\\frac"));
        return left + (numbers ? " \\cdot " : " ") + right;
    }
    /// A numerator that is a sum with fractions is set before the fraction bar, not above it.
    std::string quotient(const Expr& e) const {
        const Expr& above = e.arg(0);
        if (above.kind() == Kind::neg) {
            return "-" + quotient(above.arg(0) / e.arg(1));
        }
        if (above.kind() == Kind::mul && above.arg(0).kind() == Kind::neg) {
            return "-" + quotient(above.arg(0).arg(0) * above.arg(1) / e.arg(1));
        }
        if (above.kind() == Kind::mul) {
            for (const std::size_t side : {0U, 1U}) {
                const Expr& part = above.arg(side);
                const Expr& other = above.arg(1 - side);
                if (precedence(part) == tex_sum && tall((*this)(part))) {
                    const std::string rest =
                        "\\frac{" + (*this)(other) + "}{" + (*this)(e.arg(1)) + '}';
                    const std::string sum = in_parentheses((*this)(part));
                    return side == 0 ? sum + rest : rest + sum;
                }
            }
        }
        return "\\frac{" + (*this)(above) + "}{" + (*this)(e.arg(1)) + '}';
    }
    std::string base(const Expr& e) const {
        const std::string tex = (*this)(e);
        if (precedence(e) < tex_atom) {
            return in_parentheses(tex);
        }
        // b'(a)^2 is written without parentheses; E^* needs them.
        const bool scripted = tex.find('^') != std::string::npos;
        return scripted                                                 ? '(' + tex + ')'
               : e.kind() == Kind::call && e.builtin() != Builtin::none ? '(' + tex + ')'
                                                                        : tex;
    }
    std::string exponent(const Expr& e) const {
        if (e.kind() == Kind::div) { // on one line
            return wrapped(e.arg(0), tex_product) + '/' + wrapped(e.arg(1), tex_power);
        }
        return (*this)(e);
    }
    std::string call(const Expr& e) const {
        const auto argument = [&] {
            const std::string tex = (*this)(e.arg(0));
            const bool fenced = e.arg(0).kind() == Kind::call && e.arg(0).builtin() == Builtin::abs;
            return fenced ? tex : in_parentheses(tex);
        };
        switch (e.builtin()) {
        case Builtin::sqrt:
            return "\\sqrt{" + (*this)(e.arg(0)) + '}';
        case Builtin::abs:
            return "\\left|" + (*this)(e.arg(0)) + "\\right|";
        case Builtin::log:
            return "\\log" + argument();
        case Builtin::gamma:
            return "\\Gamma" + argument();
        case Builtin::asin:
        case Builtin::acos:
        case Builtin::atan:
            return "\\arc" + e.name().substr(1) + argument();
        default:
            break;
        }
        static constexpr std::array known{"exp",  "sin",  "cos", "tan", "sinh",
                                          "cosh", "tanh", "max", "min"};
        const std::string head = e.builtin() == Builtin::none ? name(e.name())
                                 : std::ranges::find(known, e.name()) != known.end()
                                     ? '\\' + e.name()
                                     : "\\operatorname{" + e.name() + '}';
        std::string list;
        // p_local(n, x): the text around the formula states the number of terms.
        const bool local = e.name() == "right_local" || e.name() == "left_local";
        for (std::size_t i = local ? 1 : 0; i < e.args().size(); ++i) {
            list += (list.empty() ? "" : ", ") + (*this)(e.args()[i]);
        }
        return head + in_parentheses(list);
    }
    std::string integral(const std::string& sign, const Expr& e) const {
        return sign + "_{" + (*this)(e.arg(2)) + "}^{" + (*this)(e.arg(3)) + "} " +
               wrapped(e.arg(0), tex_product) + " \\,\\mathrm{d}" + name(e.arg(1).name());
    }

    const std::function<std::string(std::string_view)>& symbol_;
};

} // namespace

std::string to_tex(const Expr& e, const std::function<std::string(std::string_view)>& symbol) {
    return FormulaWriter(symbol)(e);
}

} // namespace edgeproof::formula
