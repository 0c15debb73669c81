// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/profile/profile.hpp"

namespace edgeproof::contact {
namespace {

using Linear = SlopePiece::Linear;
using Kind = formula::Expr::Kind;

bool is_literal_zero(const formula::Expr& e) {
    const Rational* q = e.rational();
    return q != nullptr && *q == 0;
}
bool is_literal_one(const formula::Expr& e) {
    const Rational* q = e.rational();
    return q != nullptr && *q == 1;
}

// Sums with 0 and products with 0 and 1 are simplified, so that the pieces of the common profiles
// stay readable and constants are recognised.
formula::Expr plus(const formula::Expr& x, const formula::Expr& y) {
    return is_literal_zero(x) ? y : is_literal_zero(y) ? x : x + y;
}
formula::Expr minus(const formula::Expr& x, const formula::Expr& y) {
    return is_literal_zero(y) ? x : is_literal_zero(x) ? -y : x - y;
}
formula::Expr times(const formula::Expr& x, const formula::Expr& y) {
    if (is_literal_zero(x) || is_literal_zero(y)) {
        return formula::Expr::number(0);
    }
    return is_literal_one(x) ? y : is_literal_one(y) ? x : x * y;
}

} // namespace

std::optional<Linear> as_linear(const formula::Expr& e, std::string_view x) {
    const formula::Expr zero = formula::Expr::number(0);
    if (!free_symbols(e).contains(std::string(x))) {
        return Linear{e, zero};
    }
    switch (e.kind()) {
    case Kind::symbol:
        return Linear{zero, formula::Expr::number(1)};
    case Kind::neg: {
        const auto f = as_linear(e.arg(0), x);
        if (!f) {
            return {};
        }
        return Linear{minus(zero, f->at_origin), minus(zero, f->rate)};
    }
    case Kind::add:
    case Kind::sub: {
        const auto f = as_linear(e.arg(0), x);
        const auto g = as_linear(e.arg(1), x);
        if (!f || !g) {
            return {};
        }
        const auto combine = e.kind() == Kind::add ? plus : minus;
        return Linear{combine(f->at_origin, g->at_origin), combine(f->rate, g->rate)};
    }
    case Kind::mul: {
        const auto f = as_linear(e.arg(0), x);
        const auto g = as_linear(e.arg(1), x);
        if (!f || !g || (!is_literal_zero(f->rate) && !is_literal_zero(g->rate))) {
            return {};
        }
        const Linear& form = is_literal_zero(f->rate) ? *g : *f;
        const formula::Expr& factor = is_literal_zero(f->rate) ? f->at_origin : g->at_origin;
        return Linear{times(form.at_origin, factor), times(form.rate, factor)};
    }
    case Kind::div: {
        const auto f = as_linear(e.arg(0), x);
        const auto g = as_linear(e.arg(1), x);
        if (!f || !g || !is_literal_zero(g->rate)) {
            return {};
        }
        const auto over = [&](const formula::Expr& c) {
            return is_literal_zero(c) ? c : c / g->at_origin;
        };
        return Linear{over(f->at_origin), over(f->rate)};
    }
    default:
        return {};
    }
}

} // namespace edgeproof::contact
