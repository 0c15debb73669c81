// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/precision/error.hpp"

#include <string>

namespace edgeproof::formula {

std::optional<Ball> enclose(const Expr& constant, long bits) {
    const Ball ball = enclosed_constant(constant, bits);
    return ball.is_finite() ? std::optional(ball.with_bits(bits + 2)) : std::nullopt;
}

Ball BallConstants::symbol(std::string_view name) {
    throw Error("the constant has a variable " + std::string(name));
}

Ball enclosed_constant(const Expr& e, long bits) { return evaluate<Ball>(e, BallConstants{bits}); }

Ball enclosed_constant(const Exact& x, long bits) { return enclosed_constant(x.expr(), bits); }

Ball ball_of(const Exact& x, long bits) {
    if (x.is_rational()) {
        return Ball(x.rational(), bits);
    }
    const auto e = enclose(x.expr(), bits);
    if (!e) {
        throw BudgetError("'" + x.text() + "' cannot be enclosed");
    }
    return Ball::from_interval(e->lower(), e->upper(), bits);
}

long bits_for(unsigned digits) { return static_cast<long>(digits) * 10 / 3 + 16; }

std::optional<Rational> rational_of(const Exact& x) {
    return x.is_rational() ? std::optional(x.rational()) : std::nullopt;
}

} // namespace edgeproof::formula
