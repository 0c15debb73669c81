// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>

namespace edgeproof {
namespace {

constexpr unsigned working = 40;

/// Returns -log10 of a relative error given as a ball, limited to 0 ... `most`.
Real digits_of_error(const Ball& relative, const Real& most) {
    if (!relative.is_finite()) {
        return Real(0);
    }
    const Real error = relative.upper();
    if (!(error > 0)) {
        return most;
    }
    return std::clamp(Real(-log10(error)), Real(0), most);
}

/// Returns |x/exact - 1| with `bits` bits.
Ball relative_error(const Real& x, const Ball& exact, long bits) {
    const Ball at = exact.with_bits(bits);
    return abs(Ball((Ball(x, bits) - at) / at));
}

long bits_of_both(const Real& x, const Ball& exact) {
    const long of_x = mpfr_get_prec(x.backend().data());
    return std::max<long>(exact.bits(), of_x) + 64;
}

} // namespace

double digits_reached(const Real& x, const Ball& exact) {
    if (!isfinite(x) || !exact.is_finite()) {
        return 0;
    }
    const PrecisionScope scope(working);
    const long bits = bits_of_both(x, exact);
    constexpr double digits_a_bit = 0.30103;
    const Real most(static_cast<double>(bits) * digits_a_bit);
    return digits_of_error(relative_error(x, exact, bits), most).convert_to<double>();
}

unsigned digits_right(const Real& x, const Ball& exact) {
    if (!isfinite(x) || !exact.is_finite()) {
        return 0;
    }
    const PrecisionScope scope(working);
    const Ball relative = relative_error(x, exact, bits_of_both(x, exact));
    return Real(floor(digits_of_error(relative, Real(most_digits_right)))).convert_to<unsigned>();
}

unsigned digits_proved(const Ball& x) {
    if (!x.is_finite()) {
        return 0;
    }
    const PrecisionScope scope(working);
    const Ball middle(x.midpoint(), x.bits());
    const Ball relative = abs(Ball((x - middle) / middle));
    return Real(floor(digits_of_error(relative, Real(most_digits_right)))).convert_to<unsigned>();
}

} // namespace edgeproof
