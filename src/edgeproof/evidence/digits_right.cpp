// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/evidence/digits_right.hpp"

#include <algorithm>

namespace edgeproof {
namespace {

constexpr unsigned working = 40;

/// -log10 of a relative error given as a ball, rounded down.
unsigned digits_of_error(const Ball& relative) {
    if (!relative.is_finite()) {
        return 0;
    }
    const PrecisionScope scope(working);
    const Real error = relative.upper();
    if (!(error > 0)) {
        return most_digits_right;
    }
    const Real digits = floor(-log10(error));
    if (!(digits > 0)) {
        return 0;
    }
    return digits < most_digits_right ? digits.convert_to<unsigned>() : most_digits_right;
}

} // namespace

unsigned digits_right(const Real& x, const Ball& exact) {
    if (!isfinite(x) || !exact.is_finite()) {
        return 0;
    }
    const long bits =
        std::max<long>(exact.bits(), static_cast<long>(mpfr_get_prec(x.backend().data()))) + 64;
    const Ball at = exact.with_bits(bits);
    return digits_of_error(abs(Ball((Ball(x, bits) - at) / at)));
}

unsigned digits_proved(const Ball& x) {
    if (!x.is_finite()) {
        return 0;
    }
    const Ball middle(x.midpoint(), x.bits());
    return digits_of_error(abs(Ball((x - middle) / middle)));
}

} // namespace edgeproof
