// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/exact/exact_ball.hpp"

#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"

namespace edgeproof::formula {

Ball ball_of(const Exact& x, long bits) {
    if (x.is_rational()) {
        return Ball(x.rational(), bits);
    }
    const auto e = enclose(x.expr(), bits);
    if (!e) {
        throw BudgetError("'" + x.text() + "' cannot be enclosed");
    }
    return Ball::from_interval(e->lower, e->upper, bits);
}

long bits_for(unsigned digits) { return static_cast<long>(digits) * 10 / 3 + 16; }

std::optional<Rational> rational_of(const Exact& x) {
    if (x.is_rational()) {
        return x.rational();
    }
    return {};
}

} // namespace edgeproof::formula
