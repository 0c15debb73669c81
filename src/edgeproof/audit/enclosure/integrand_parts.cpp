// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/algebra/identity.hpp"
#include "edgeproof/audit/enclosure/enclosed_integral.hpp"

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
    if (e.kind() == Kind::call && (e.name() == "P1of" || e.name() == "bof") &&
        holds_symbol(e, variable)) {
        return e.arg(0);
    }
    for (const Expr& part : e.args()) {
        if (auto found = contact_argument(part, variable)) {
            return found;
        }
    }
    return std::nullopt;
}

std::vector<IntegrandCut> integrand_cuts(const Expr& f, const std::string& variable,
                                         const ContactFormulas& contact) {
    std::vector<IntegrandCut> cuts;
    collect_cuts_of(f, variable, contact, cuts);
    return cuts;
}

namespace {

/// Returns y if the whole of e is equal to f(y) for an f(y) in e.
std::optional<Expr> argument_if_all(const Expr& e, const std::string& f, const Expr& whole) {
    if (e.kind() == Expr::Kind::call && e.name() == f &&
        (e == whole || algebra::proved_zero(whole - e))) {
        return e.arg(0);
    }
    for (const Expr& part : e.args()) {
        if (auto y = argument_if_all(part, f, whole)) {
            return y;
        }
    }
    return std::nullopt;
}

/// Returns e with the known properties of b and its inverse put in; nothing if e contains a root, a
/// binder or a built-in function, because some of their rules hold only for one sign.
std::optional<Expr> as_rational_function(const Expr& e, bool symmetric) {
    if (e.kind() == Kind::symbol && e.name() == "b" && symmetric) {
        return Expr::symbol("a");
    }
    if (e.rational() != nullptr || e.kind() == Kind::symbol || e.kind() == Kind::pi) {
        return e;
    }
    if (e.is_binder() || (e.kind() == Kind::call && e.builtin() != formula::Builtin::none)) {
        return std::nullopt;
    }
    if (e.kind() == Kind::pow) {
        const Rational* exponent = e.arg(1).rational();
        if (exponent == nullptr || denominator(*exponent) != 1 || abs(*exponent) > 64) {
            return std::nullopt;
        }
    }
    std::vector<Expr> args;
    for (const Expr& part : e.args()) {
        auto rational = as_rational_function(part, symmetric);
        if (!rational) {
            return std::nullopt;
        }
        args.push_back(std::move(*rational));
    }
    if (e.kind() == Kind::call && (e.name() == "bof" || e.name() == "binv")) {
        if (symmetric) {
            return args[0];
        }
        if (auto y = argument_if_all(args[0], e.name() == "bof" ? "binv" : "bof", args[0])) {
            return y;
        }
    }
    return Expr::with_args(e, std::move(args));
}

} // namespace

bool surely_zero(const Expr& e, bool symmetric) {
    const auto rational = as_rational_function(e, symmetric);
    return rational && algebra::proved_zero(*rational);
}

} // namespace edgeproof::audit
