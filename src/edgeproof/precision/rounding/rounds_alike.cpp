// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/rounding/text.hpp"

#include <cmath>
#include <cstdlib>

namespace edgeproof {
namespace {

/// As near to a power of ten as this, relatively, the first digit is not told at a glance.
constexpr double too_near = 1e-9;
constexpr long most_exponent = 1L << 20; // of two: its logarithm still has its digits in binary64
constexpr long least_accuracy = 40;      // bits, so that no ball reaches as far

/// k with 10^k <= |x| < 10^(k+1) for every x in a ball that is narrower than 2^-least_accuracy;
/// false where it is not plain.
bool leading_place(const Ball& x, long& k) {
    if (x.relative_accuracy_bits() < least_accuracy) {
        return false;
    }
    arf_srcptr middle = arb_midref(x.data());
    if (arf_cmpabs_2exp_si(middle, most_exponent) >= 0 ||
        arf_cmpabs_2exp_si(middle, -most_exponent) <= 0) {
        return false;
    }
    ArfValue mantissa;
    FmpzValue exponent;
    arf_frexp(mantissa, exponent, middle);
    const double m = std::abs(arf_get_d(mantissa, ARF_RND_NEAR));
    const double decades =
        (std::log2(m) + static_cast<double>(fmpz_get_si(exponent))) * std::log10(2.0);
    k = static_cast<long>(std::floor(decades));
    return std::abs(decades - std::round(decades)) > too_near;
}

} // namespace

bool rounds_alike(const Ball& x, unsigned digits, Rounding mode) {
    long place = 0;
    if (mode == Rounding::enclosure || !leading_place(x, place)) {
        return false;
    }
    // In units of the last digit: where all round alike, no number in the ball is a whole one, or,
    // to nearest, half of an odd one. A ball that is too wide holds one.
    const long k = static_cast<long>(digits) - 1 - place;
    const auto scale = static_cast<ulong>(std::abs(k));
    ArbValue units;
    ArbValue ten;
    arb_ui_pow_ui(ten, 10, scale, x.bits());
    if (k < 0) {
        arb_div(units, x.data(), ten, x.bits());
    } else {
        arb_mul(units, x.data(), ten, x.bits());
    }
    if (mode == Rounding::nearest) {
        arb_set_d(ten, 0.5);
        arb_add(units, units, ten, x.bits());
    }
    // Farther from the whole numbers on both sides of its middle than its radius.
    ArfValue above;
    arf_floor(above, arb_midref(units));
    arf_sub(above, arb_midref(units), above, ARF_PREC_EXACT, ARF_RND_DOWN);
    const bool alike = arf_cmpabs_mag(above, arb_radref(units)) > 0;
    arf_sub_ui(above, above, 1, ARF_PREC_EXACT, ARF_RND_DOWN);
    return alike && arf_cmpabs_mag(above, arb_radref(units)) > 0;
}

} // namespace edgeproof
