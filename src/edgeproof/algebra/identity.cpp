// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/algebra/identity.hpp"

#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"

#include <utility>

namespace edgeproof::algebra {

bool proved_zero(const Expr& e) {
    constexpr long bits_of_finiteness = 256;
    const auto of_either_sign = [](std::string_view name) { return Form::name(name, false); };
    try {
        return form_of(e, of_either_sign).is_zero() &&
               (!free_symbols(e).empty() || formula::enclose(e, bits_of_finiteness));
    } catch (const Error&) {
        return false; // no value, or too large
    }
}

std::optional<int> decided_sign(const Expr& e, long bits) {
    if (const Rational* q = e.rational()) {
        return q->sign();
    }
    bool tried = false;
    for (long k = 128; k <= bits; k *= 4) {
        try {
            if (const auto x = formula::enclose(e, k)) {
                if (certainly_positive(*x) || certainly_negative(*x)) {
                    return x->midpoint().sign();
                }
            }
        } catch (const Error&) {
            return std::nullopt;
        }
        if (!std::exchange(tried, true) && proved_zero(e)) {
            return 0;
        }
    }
    return std::nullopt;
}

Form abs(const Form& x) {
    const auto sign = decided_sign(x.expr());
    return !sign ? throw Error("the sign of a constant is not decided") : *sign < 0 ? -x : x;
}

} // namespace edgeproof::algebra
