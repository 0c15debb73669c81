// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

namespace edgeproof::formula {

/// Returns q as a quotient, 3/2 rather than 1.5.
[[nodiscard]] inline Expr quotient_of(const Rational& q) {
    const Expr top = Expr::number(Rational(numerator(q)));
    return denominator(q) == 1 ? top : top / Expr::number(Rational(denominator(q)));
}

} // namespace edgeproof::formula
