// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/real.hpp"

namespace edgeproof::formula {

/// The sum of the sizes of the terms that e is made of: what its value cancels from. `value` gives
/// the value of a part.
template <class Value> [[nodiscard]] Real magnitude(const Expr& e, const Value& value) {
    using Kind = Expr::Kind;
    switch (e.kind()) {
    case Kind::neg:
        return magnitude(e.arg(0), value);
    case Kind::add:
    case Kind::sub:
        return magnitude(e.arg(0), value) + magnitude(e.arg(1), value);
    case Kind::mul:
        return magnitude(e.arg(0), value) * magnitude(e.arg(1), value);
    case Kind::div:
        return magnitude(e.arg(0), value) / abs(Real(value(e.arg(1))));
    default:
        return abs(Real(value(e)));
    }
}

} // namespace edgeproof::formula
