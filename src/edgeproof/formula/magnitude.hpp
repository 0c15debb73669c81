// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <type_traits>

namespace edgeproof::formula {

/// Returns the sum of the absolute values of the terms of e: the scale of the errors of its value,
/// even if the terms cancel. `value` returns the value of a part, as a Real or a Ball.
template <class Value>
[[nodiscard]] auto magnitude(const Expr& e, const Value& value)
    -> std::decay_t<decltype(value(e))> {
    using Number = std::decay_t<decltype(value(e))>;
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
        return magnitude(e.arg(0), value) / abs(Number(value(e.arg(1))));
    case Kind::call:
        if (e.builtin() == Builtin::abs || e.builtin() == Builtin::max ||
            e.builtin() == Builtin::min) {
            Number sum = magnitude(e.arg(0), value);
            for (std::size_t k = 1; k < e.args().size(); ++k) {
                sum += magnitude(e.arg(k), value);
            }
            return sum;
        }
        [[fallthrough]];
    default:
        return abs(Number(value(e)));
    }
}

} // namespace edgeproof::formula
