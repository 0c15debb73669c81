// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/algebra/form.hpp"
#include "edgeproof/audit/diagnosis/diagnosis.hpp"
#include "edgeproof/audit/symbolic/symbolic.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <unordered_set>

namespace edgeproof::audit {
namespace {

using Kind = Expr::Kind;

Expr whole(long n) { return Expr::number(Rational(n)); }
Expr fraction(long n, long d) { return whole(n) / whole(d); }

/// The factors of a product of products, quotients and negatives.
struct Factors {
    Rational number{1}; ///< the product of the integers
    int integers = 0;
    std::vector<Expr> over;
    std::vector<Expr> under;

    void add(const Expr& e, bool inverse) {
        if (e.kind() == Kind::mul || e.kind() == Kind::div) {
            add(e.arg(0), inverse);
            add(e.arg(1), inverse != (e.kind() == Kind::div));
        } else if (e.kind() == Kind::neg) {
            number = -number;
            add(e.arg(0), inverse);
        } else if (e.kind() == Kind::number && denominator(e.number()) == 1 && e.number() != 0) {
            number *= inverse ? Rational(1 / e.number()) : e.number();
            ++integers;
        } else {
            (inverse ? under : over).push_back(e);
        }
    }
};

Expr product_of(const Rational& n, const std::vector<Expr>& factors) {
    Expr product = n == 1 && !factors.empty() ? factors.front() : Expr::number(n);
    for (std::size_t i = n == 1 ? 1 : 0; i < factors.size(); ++i) {
        product = product * factors[i];
    }
    return product;
}

class Editor {
public:
    Editor(const Expr& formula, const EditAlphabet& alphabet)
        : formula_(formula), alphabet_(alphabet) {}

    std::vector<Edit> operator()() {
        for (const formula::Path& path : paths(formula_)) {
            path_ = path;
            node_ = at(formula_, path);
            edit_node();
        }
        path_.clear();
        node_ = formula_;
        throughout();
        std::ranges::stable_sort(edits_,
                                 [](const Edit& x, const Edit& y) { return x.cost < y.cost; });
        std::unordered_set<Expr, formula::ExprHash> seen{formula_};
        std::vector<Edit> unique;
        for (Edit& e : edits_) {
            if (seen.insert(e.formula).second) {
                unique.push_back(std::move(e));
            }
        }
        return unique;
    }

private:
    void put(const Expr& value, const char* what, int cost) {
        // The change is shown with its surroundings, as a bare 3 -> 4 does not show the place.
        formula::Path around = path_;
        Expr before = node_;
        while (!around.empty() && before.height() < 2) {
            around.pop_back();
            before = at(formula_, around);
        }
        Expr edited = replace(formula_, path_, value);
        edits_.push_back(
            {edited, what, to_text(before), to_text(with_one_number(at(edited, around))), cost});
    }

    [[nodiscard]] Kind parent_kind() const {
        if (path_.empty()) {
            return Kind::number;
        }
        const formula::Path up(path_.begin(), path_.end() - 1);
        return at(formula_, up).kind();
    }
    [[nodiscard]] bool is_exponent() const {
        return parent_kind() == Kind::pow && path_.back() == 1;
    }
    /// True for a term of a sum, for the whole formula, and for the argument of a function or
    /// integral.
    [[nodiscard]] bool is_term() const {
        const Kind k = parent_kind();
        return path_.empty() || k == Kind::add || k == Kind::sub || k == Kind::neg ||
               k == Kind::call || k == Kind::integral || k == Kind::pv;
    }

    void edit_node() {
        switch (node_.kind()) {
        case Kind::number:
            number();
            break;
        case Kind::symbol:
            symbol();
            break;
        case Kind::neg:
            put(node_.arg(0), "sign", 1);
            break;
        case Kind::add:
        case Kind::sub:
            sum(node_.arg(0), node_.arg(1), node_.kind() == Kind::add);
            break;
        case Kind::mul:
            put(node_.arg(0), "factor too many", 1);
            put(node_.arg(1), "factor too many", 1);
            put(node_.arg(0) / node_.arg(1), "factor inverted", 1);
            put(node_.arg(1) / node_.arg(0), "factor inverted", 2);
            break;
        case Kind::div:
            put(node_.arg(0), "factor too many", 1);
            put(node_.arg(0) * node_.arg(1), "factor inverted", 1);
            put(node_.arg(1) / node_.arg(0), "factor inverted", 2);
            break;
        case Kind::pow:
            put(node_.arg(0), "exponent", 1);
            break;
        case Kind::call:
            call();
            break;
        default:
            break;
        }
        if (!is_exponent() && node_.kind() != Kind::number) {
            powers();
        }
        if (node_.height() >= 2) {
            exchange_names();
            derivatives();
        }
        if (path_.empty() && alphabet_.of_pressure) {
            put(whole(4) * node_ / Expr::pi(), "mean for greatest pressure", 2);
            put(fraction(3, 2) * node_, "mean for greatest pressure", 2);
        }
        if (is_term()) {
            factors();
            if (node_.kind() != Kind::neg && !is_exponent()) {
                put(-node_, "sign", 1);
            }
        }
    }

    /// Changes the same thing at every place of a part of the formula: two names exchanged, such as
    /// a and b in a kernel, or in the limits of an integral, or everywhere else.
    void exchange_names() {
        std::vector<std::string> written;
        for (const std::string& name : alphabet_.symbols) {
            if (holds_symbol(node_, name)) {
                written.push_back(name);
            }
        }
        const std::string between = "_"; // no name of a ledger
        const std::vector<formula::Path> limits_of_node = limits();
        for (std::size_t i = 0; i < written.size(); ++i) {
            for (std::size_t k = i + 1; k < written.size(); ++k) {
                const auto name = [](const std::string& n) { return Expr::symbol(n); };
                const Expr exchanged =
                    substitute(substitute(substitute(node_, written[i], name(between)), written[k],
                                          name(written[i])),
                               between, name(written[k]));
                put(exchanged, "names exchanged", 4);
                Expr limits_only = node_;
                Expr other_places = exchanged;
                for (const formula::Path& limit : limits_of_node) {
                    limits_only = replace(limits_only, limit, at(exchanged, limit));
                    other_places = replace(other_places, limit, at(node_, limit));
                }
                if (!limits_of_node.empty()) {
                    put(limits_only, "names exchanged", 4);
                    put(other_places, "names exchanged", 4);
                }
            }
        }
    }

    /// The paths of the limits of integrals and sums in the node.
    [[nodiscard]] std::vector<formula::Path> limits() const {
        std::vector<formula::Path> found;
        for (const formula::Path& path : paths(node_)) {
            if (at(node_, path).is_binder()) {
                for (const std::size_t limit : {2U, 3U}) {
                    found.push_back(path);
                    found.back().push_back(limit);
                }
            }
        }
        return found;
    }

    /// A function in place of its derivative, such as the gap g for its slope g'.
    void derivatives() {
        std::vector<std::string> variables{"x"};
        for (std::size_t length = 0; length < path_.size(); ++length) {
            const formula::Path outer(path_.begin(),
                                      path_.begin() + static_cast<std::ptrdiff_t>(length));
            if (const Expr around = at(formula_, outer); around.is_binder()) {
                variables.push_back(around.arg(1).name());
            }
        }
        for (const std::string& name : variables) {
            const auto in_call = [&](const Expr& part) {
                return (part.kind() == Kind::call || part.is_binder()) && holds_symbol(part, name);
            };
            if (!holds_symbol(node_, name) || any_part(node_, in_call)) {
                continue;
            }
            try {
                put(derivative(node_, name), "derivative", 3);
            } catch (const Error&) {
                continue; // no derivative in symbols
            }
        }
    }

    /// E/(1 - nu^2) of one body in place of E*.
    void of_one_body(const std::string& modulus, const std::string& ratio) {
        const Expr stiffness = Expr::symbol("Es") * (whole(1) - pow(Expr::symbol(ratio), whole(2)));
        const auto name = [](std::string_view of) { return algebra::Form::name(of, false); };
        try {
            put(algebra::form_of(substitute(formula_, modulus, stiffness), name).expr(),
                "modulus of one body for E*", 0);
        } catch (const Error&) { // no form
        }
    }

    /// Changes a name everywhere: another name, a lost exponent, a half or a double of it.
    void throughout() {
        for (const std::string& name : alphabet_.symbols) {
            if (!holds_symbol(formula_, name)) {
                continue;
            }
            const auto everywhere = [&](const Expr& value, const char* what) {
                put(substitute(formula_, name, value), what, 4);
            };
            const Expr x = Expr::symbol(name);
            everywhere(pow(x, whole(2)), "exponent throughout");
            everywhere(Expr::call("sqrt", {x}), "root throughout");
            const bool radius = name == "R" || name == "R1" || name == "R2";
            everywhere(whole(2) * x, radius        ? "radius for diameter"
                                     : name == "a" ? "half for full width"
                                                   : "factor missing throughout");
            everywhere(x / whole(2), radius        ? "diameter for radius"
                                     : name == "a" ? "full for half width"
                                                   : "factor missing throughout");
            if (name == "E" || name == "E1" || name == "E2") {
                everywhere(Expr::symbol("Es"), "Young's modulus for E*");
                of_one_body(name, "nu" + name.substr(1));
            }
            for (const std::string& other : alphabet_.symbols) {
                if (other != name) {
                    everywhere(Expr::symbol(other), "symbol throughout");
                }
            }
        }
    }

    void number() {
        const Rational n = node_.number();
        const char* what = is_exponent() ? "exponent" : "coefficient";
        if (is_exponent()) {
            for (const auto& step : {Rational(1), Rational(-1), Rational(1, 2), Rational(-1, 2)}) {
                put(Expr::number(Rational(n + step)), what, 1);
            }
        }
        if (denominator(n) != 1) {
            // Change a decimal by one unit in its last place.
            Rational unit(1);
            while (denominator(Rational(n / unit)) != 1) {
                unit /= 10;
            }
            put(Expr::number(Rational(n + unit)), what, 1);
            put(Expr::number(Rational(n - unit)), what, 1);
        } else {
            put(Expr::number(Rational(n + 1)), what, 1);
            if (n >= 1) {
                put(Expr::number(Rational(n - 1)), what, 1);
            }
            for (const int tens : {10, 100}) {
                if (n >= tens) {
                    put(Expr::number(Rational(n + tens)), what, 1);
                    put(Expr::number(Rational(n - tens)), what, 1);
                }
            }
        }
        for (const int k : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 15, 16, 24, 30, 32, 48, 64}) {
            put(whole(k), what, 2);
        }
        for (const int k : {2, 3, 4, 5, 6, 8, 10, 16}) {
            put(Expr::number(Rational(n * k)), what, 2);
            put(node_ / whole(k), what, 2);
        }
        if (n != 0) {
            put(-node_, "sign", 2);
        }
    }

    void symbol() {
        for (const std::string& name : alphabet_.symbols) {
            if (name != node_.name()) {
                // Adding or removing a prime (P1 for P) is cheaper than exchanging names.
                const bool prime = name.front() == node_.name().front() && name.size() <= 2 &&
                                   node_.name().size() <= 2;
                put(Expr::symbol(name), prime ? "prime" : "symbol", prime ? 1 : 2);
            }
        }
    }

    void sum(const Expr& x, const Expr& y, bool plus) {
        put(plus ? x - y : x + y, "sign", 1);
        put(x, "term too many", 3);
        put(plus ? y : -y, "term too many", 3);
        // -(x + y) for -x + y: the sign applies to the first term only, or to both.
        put(plus ? -x + y : -x - y, "sign", 1);
        if (x.kind() == Kind::symbol && y.kind() == Kind::symbol) {
            const Expr squares[] = {pow(x, whole(2)), pow(y, whole(2))};
            put(plus ? squares[0] + squares[1] : squares[0] - squares[1], "exponents", 3);
        }
    }

    void call() {
        if (node_.builtin() == formula::Builtin::sqrt) {
            put(node_.arg(0), "root", 1);
            put(pow(node_.arg(0), fraction(3, 2)), "exponent", 1);
            put(whole(1) / node_, "factor inverted", 2);
            return;
        }
        using Pair = std::pair<std::string_view, std::string_view>;
        static constexpr std::array<Pair, 9> swaps{{{"sin", "cos"},
                                                    {"asin", "acos"},
                                                    {"atan", "asin"},
                                                    {"sin", "tan"},
                                                    {"right_local", "left_local"},
                                                    {"bof", "binv"},
                                                    {"Pof", "P1of"},
                                                    {"log", "exp"},
                                                    {"tan", "atan"}}};
        const std::string& name = node_.name();
        for (const auto& [one, other] : swaps) {
            if (name == one || name == other) {
                put(Expr::call(name == one ? other : one,
                               std::vector<Expr>(node_.args().begin(), node_.args().end())),
                    "function", 2);
            }
        }
        // Degrees for radians, in an angle or in the argument of a function.
        const Expr degree = Expr::pi() / whole(180);
        if (name == "sin" || name == "cos" || name == "tan") {
            put(Expr::call(name, {node_.arg(0) * degree}), "degrees", 3);
            put(Expr::call(name, {node_.arg(0) / degree}), "degrees", 3);
        }
        if (name == "asin" || name == "acos" || name == "atan") {
            put(node_ * degree, "degrees", 3);
            put(node_ / degree, "degrees", 3);
        }
        if (node_.builtin() == formula::Builtin::abs) {
            put(node_.arg(0), "absolute value", 2);
        }
    }

    void powers() {
        const bool is_power = node_.kind() == Kind::pow;
        if (parent_kind() == Kind::pow || is_power) {
            return; // the exponent is edited at its own node
        }
        const bool product = node_.kind() == Kind::mul && parent_kind() != Kind::mul;
        if (node_.kind() == Kind::pi || product) {
            put(Expr::call("sqrt", {node_}), "root", 1);
        }
        if (node_.kind() == Kind::symbol || node_.kind() == Kind::add ||
            node_.kind() == Kind::sub || node_.kind() == Kind::call) {
            if (node_.builtin() != formula::Builtin::sqrt) {
                put(Expr::call("sqrt", {node_}), "root", 1);
            }
            put(pow(node_, whole(2)), "exponent", 1);
            put(pow(node_, fraction(3, 2)), "exponent", 1);
        }
        const bool ratio = node_.kind() == Kind::div || node_.kind() == Kind::mul;
        if (ratio && (parent_kind() == Kind::add || parent_kind() == Kind::sub)) {
            put(pow(node_, whole(2)), "exponent", 1); // t/a for t^2/a^2
        }
        if (path_.empty() || (is_term() && parent_kind() != Kind::call)) {
            put(Expr::call("abs", {node_}), "absolute value", 3);
        }
    }

    void factors() {
        for (const int k : {2, 3, 4, 5, 6, 7, 8, 10, 12, 15, 16, 20, 32, 64}) {
            put(whole(k) * node_, "factor missing", 2);
            put(node_ / whole(k), "factor missing", 2);
        }
        for (const Expr& f : alphabet_.factors) {
            put(f * node_, "factor missing", 2);
            put(node_ / f, "factor missing", 2);
        }
    }

    const Expr& formula_;
    const EditAlphabet& alphabet_;
    formula::Path path_;
    Expr node_;
    std::vector<Edit> edits_;
};

} // namespace

Expr with_one_number(const Expr& formula) {
    Factors f;
    f.add(formula, false);
    if (f.integers < 2) {
        return formula; // as it is written
    }
    const Rational size = abs(f.number);
    const Expr over = product_of(Rational(numerator(size)), f.over);
    const Rational below(denominator(size));
    const Expr all = below == 1 && f.under.empty() ? over : over / product_of(below, f.under);
    return f.number < 0 ? -all : all;
}

std::vector<Edit> single_edits(const Expr& formula, const EditAlphabet& alphabet) {
    return Editor(formula, alphabet)();
}

} // namespace edgeproof::audit
