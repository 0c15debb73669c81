// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/algebra/form.hpp"
#include "edgeproof/audit/enclosure/contact_formulas.hpp"
#include "edgeproof/audit/enclosure/enclosed_integral.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <optional>

namespace edgeproof::audit {

namespace {

using Kind = Expr::Kind;

void collect_cuts_of(const Expr& e, const std::string& variable, const ContactFormulas& contact,
                     std::vector<IntegrandCut>& cuts) {
    if (e.is_binder() || !holds_symbol(e, variable)) {
        return;
    }
    const bool size = is_size_of_slope(e);
    const Expr& f = size ? e.arg(0) : e;
    const bool of_contacts = f.name() == "P1of" || f.name() == "bof";
    const bool called = f.kind() == Kind::call;
    for (const Expr& knot : called ? contact.knots(f.name(), size) : std::vector<Expr>()) {
        const auto line = contact::as_linear(f.arg(0), variable);
        if (f.arg(0) == Expr::symbol(variable)) {
            cuts.push_back({knot, of_contacts});
        } else if (line) {
            cuts.push_back({(knot - line->at_origin) / line->rate, of_contacts});
        }
    }
    for (const Expr& part : (size ? f : e).args()) {
        collect_cuts_of(part, variable, contact, cuts);
    }
}

} // namespace

bool holds_function(const Expr& e) {
    return any_part(e, [](const Expr& part) {
        return part.kind() == Kind::call && part.builtin() == formula::Builtin::none;
    });
}

bool is_size_of_slope(const Expr& e) {
    return e.builtin() == formula::Builtin::abs && e.arg(0).kind() == Kind::call &&
           e.arg(0).name() == "g1";
}

bool holds_pressure(const Expr& e, const std::string& variable) {
    return any_part(e, [&](const Expr& part) {
        return part.kind() == Kind::call && part.name() == "p" && holds_symbol(part, variable);
    });
}

std::optional<int> degree_in_pressure(const Expr& e, const std::string& variable) {
    if (!holds_symbol(e, variable) || e.kind() == Kind::symbol) {
        return 0;
    }
    if (e.kind() == Kind::call && e.name() == "p") {
        return e.arg(0) == Expr::symbol(variable) ? std::optional(1) : std::nullopt;
    }
    const auto of_all_parts_zero = [&] {
        return std::ranges::all_of(
            e.args(), [&](const Expr& part) { return degree_in_pressure(part, variable) == 0; });
    };
    if (e.kind() == Kind::pow) {
        const Rational* n = e.arg(1).rational();
        const bool whole = n != nullptr && *n >= 0 && denominator(*n) == 1;
        return whole && of_all_parts_zero() ? std::optional(0) : std::nullopt;
    }
    if (e.kind() == Kind::call) {
        using formula::Builtin;
        const Builtin f = e.builtin();
        const bool entire = f == Builtin::exp || f == Builtin::sin || f == Builtin::cos;
        return entire && of_all_parts_zero() ? std::optional(0) : std::nullopt;
    }
    const bool quotient = e.kind() == Kind::div;
    const bool product = e.kind() == Kind::mul || quotient;
    if (!product && e.kind() != Kind::add && e.kind() != Kind::sub && e.kind() != Kind::neg) {
        return std::nullopt;
    }
    if (quotient && holds_symbol(e.arg(1), variable)) {
        return std::nullopt;
    }
    int degree = 0;
    for (const Expr& part : e.args()) {
        const auto of_part = degree_in_pressure(part, variable);
        if (!of_part) {
            return std::nullopt;
        }
        degree = product ? degree + *of_part : std::max(degree, *of_part);
    }
    return degree;
}

std::optional<Expr> contact_argument(const Expr& e, const std::string& variable) {
    std::optional<Expr> argument;
    static_cast<void>(any_part(e, [&](const Expr& part) {
        if (part.kind() == Kind::call && (part.name() == "P1of" || part.name() == "bof") &&
            holds_symbol(part, variable)) {
            argument = part.arg(0);
        }
        return argument.has_value();
    }));
    return argument;
}

std::vector<IntegrandCut> integrand_cuts(const Expr& f, const std::string& variable,
                                         const ContactFormulas& contact) {
    std::vector<IntegrandCut> cuts;
    collect_cuts_of(f, variable, contact, cuts);
    return cuts;
}

namespace {

using algebra::Form;

/// The meaning of names and functions in a contact whose law b is known in part.
struct KnownLaw {
    EdgeLaw law;
    [[nodiscard]] static Form number(const Rational& q) { return Form(q); }
    [[nodiscard]] static Form pi() { return Form::pi(); }
    [[nodiscard]] Form symbol(std::string_view name) const {
        if (name == "b" && law == EdgeLaw::symmetric) {
            return symbol("a");
        }
        const auto k = formula::order_behind(name, "b");
        return k && *k >= 2 && law != EdgeLaw::any ? Form() : Form::name(name, false);
    }
    [[nodiscard]] Form call(const Expr& node, std::span<const Form> args) const {
        const std::string& f = node.name();
        if (f == "bof" || f == "binv") {
            if (law == EdgeLaw::symmetric) {
                return args[0];
            }
            if (auto y = args[0].argument_of(f == "bof" ? "binv" : "bof")) {
                return *y;
            }
        }
        return Form::call(f, args);
    }
    [[nodiscard]] static Form binder(const Expr& node) { return Form::opaque(node); }
};

/// True for quotients of polynomials in names and functions of the contact, which have a value
/// wherever their parts have one, except for divisions by zero.
bool is_rational_function(const Expr& e) {
    constexpr long most_exponent = 64;
    if (e.rational() != nullptr) {
        return true;
    }
    if (e.kind() == Kind::pow) {
        const Rational* exponent = e.arg(1).rational();
        if (exponent == nullptr || denominator(*exponent) != 1 || abs(*exponent) > most_exponent) {
            return false;
        }
    }
    return !e.is_binder() && (e.kind() != Kind::call || e.builtin() == formula::Builtin::none) &&
           std::ranges::all_of(e.args(), is_rational_function);
}

} // namespace

bool vanishes_where_defined(const Expr& e, EdgeLaw law) {
    try {
        return formula::evaluate<Form>(e, KnownLaw{law}).is_zero();
    } catch (const Error&) {
        return false; // a division by zero, or too large
    }
}

bool surely_zero(const Expr& e, EdgeLaw law) {
    return is_rational_function(e) && vanishes_where_defined(e, law);
}

} // namespace edgeproof::audit
