// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosure/exact_zero.hpp"

#include "edgeproof/audit/symbolic/ginac_bridge.hpp"
#include "edgeproof/precision/error.hpp"

#include <ginac/ginac.h>

#include <algorithm>
#include <optional>

namespace edgeproof::audit {
namespace {

using Kind = formula::Expr::Kind;

bool is_zero_by_symbols(const formula::Expr& e) {
    try {
        const auto held = ginac::hold();
        const GiNaC::ex x = ginac::from_expr(e);
        return x.is_zero() || x.expand().is_zero() || x.normal().is_zero();
    } catch (const Error&) {
        return false; // no conversion
    } catch (const std::exception&) {
        return false; // from GiNaC, for instance for a division by zero
    }
}

/// Returns y if the whole of e is equal to f(y) for an f(y) in e.
std::optional<formula::Expr> argument_if_all(const formula::Expr& e, const std::string& f,
                                             const formula::Expr& whole) {
    if (e.kind() == formula::Expr::Kind::call && e.name() == f &&
        (e == whole || is_zero_by_symbols(whole - e))) {
        return e.arg(0);
    }
    for (const formula::Expr& part : e.args()) {
        if (auto y = argument_if_all(part, f, whole)) {
            return y;
        }
    }
    return std::nullopt;
}

/// Returns e with the known properties of b and its inverse put in; nothing if e contains a root, a
/// binder or a built-in function, because some of their rules hold only for one sign.
std::optional<formula::Expr> as_rational_function(const formula::Expr& e, bool symmetric) {
    if (e.kind() == Kind::symbol && e.name() == "b" && symmetric) {
        return formula::Expr::symbol("a");
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
    std::vector<formula::Expr> args;
    for (const formula::Expr& part : e.args()) {
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
    return formula::Expr::with_args(e, std::move(args));
}

} // namespace

bool surely_zero(const formula::Expr& e, bool symmetric) {
    const auto rational = as_rational_function(e, symmetric);
    return rational && is_zero_by_symbols(*rational);
}

} // namespace edgeproof::audit
