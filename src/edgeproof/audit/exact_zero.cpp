// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/exact_zero.hpp"

#include "edgeproof/audit/ginac_bridge.hpp"
#include "edgeproof/precision/error.hpp"

#include <ginac/ginac.h>

#include <algorithm>
#include <optional>

namespace edgeproof {
namespace {

/// e with what is known of b and its inverse put in; nothing where a root, a binder or a built-in
/// function stands: rules that hold for some signs only shall not come in.
std::optional<Expr> as_rational_function(const Expr& e, bool symmetric) {
    using Kind = Expr::Kind;
    if (e.rational() != nullptr || e.kind() == Kind::symbol || e.kind() == Kind::pi) {
        return e;
    }
    if (e.is_binder() || (e.kind() == Kind::call && e.builtin() != Builtin::none)) {
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
        const std::string inverse = e.name() == "bof" ? "binv" : "bof";
        if (args[0].kind() == Kind::call && args[0].name() == inverse) {
            return args[0].arg(0);
        }
    }
    return Expr::with_args(e, std::move(args));
}

} // namespace

bool surely_zero(const Expr& e, bool symmetric) {
    const auto rational = as_rational_function(e, symmetric);
    if (!rational) {
        return false;
    }
    try {
        const auto held = ginac::hold();
        const GiNaC::ex x = ginac::from_expr(*rational);
        return x.is_zero() || x.expand().is_zero() || x.normal().is_zero();
    } catch (const Error&) {
        return false; // no way over
    } catch (const std::exception&) {
        return false; // GiNaC's own, as for a division by zero
    }
}

} // namespace edgeproof
