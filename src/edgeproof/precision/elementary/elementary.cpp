// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/elementary/elementary.hpp"

#include "edgeproof/precision/ball/arb_values.hpp"

#include <algorithm>
#include <cstdlib>

namespace edgeproof {
namespace {

using OfArb = void (*)(arb_ptr, arb_srcptr, slong);
using OfMpfr = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

/// Bits beyond the result's: an enclosure with so many is rarely too wide to be rounded.
constexpr mpfr_prec_t first_guard_bits = 20;
constexpr mpfr_prec_t last_guard_bits = 64;
/// e^x has an exponent that MPFR and Arb both bear for |x| < 2^this.
constexpr mpfr_exp_t largest_exponent = 20;

/// f(x), rounded to nearest: from an enclosure that rounds to one number, of two precisions at most
/// (Ziv's method). Else, and where `by_mpfr` says so of x and the precision, by MPFR.
///
/// For x other than 0, f(x) is transcendental (Lindemann), so no midpoint of two numbers. Where
/// 2^-bits <= |x| <= 2^bits it differs from one by less than 2^(-2 bits) only by chance.
template <class ByMpfr> Real nearest(const Real& x, OfArb f, OfMpfr mpfr, ByMpfr by_mpfr) {
    Real result;
    mpfr_ptr to = result.backend().data();
    mpfr_srcptr from = x.backend().data();
    const mpfr_prec_t bits = std::max(mpfr_get_prec(to), mpfr_get_prec(from));
    mpfr_set_prec(to, bits);
    if (mpfr_regular_p(from) != 0 && std::abs(mpfr_get_exp(from)) <= bits && !by_mpfr(from, bits)) {
        ArbValue argument;
        ArbValue value;
        arf_set_mpfr(arb_midref(argument), from);
        for (const mpfr_prec_t tried : {bits + first_guard_bits, 2 * bits + last_guard_bits}) {
            f(value, argument, tried);
            if (arb_can_round_mpfr(value, bits, MPFR_RNDN) != 0) {
                arf_get_mpfr(to, arb_midref(value), MPFR_RNDN);
                return result;
            }
        }
    }
    mpfr(to, from, MPFR_RNDN);
    return result;
}

} // namespace

Real arc_tangent(const Real& x) {
    return nearest(x, arb_atan, mpfr_atan, [](mpfr_srcptr, mpfr_prec_t) { return false; });
}

Real hyperbolic_sine(const Real& x) {
    return nearest(x, arb_sinh, mpfr_sinh, [](mpfr_srcptr from, mpfr_prec_t) {
        return mpfr_get_exp(from) > largest_exponent;
    });
}

Real exp_less_one(const Real& x) {
    // Below -bits the result is -1 but for less than Arb's two precisions show.
    return nearest(x, arb_expm1, mpfr_expm1, [](mpfr_srcptr from, mpfr_prec_t bits) {
        return mpfr_get_exp(from) > largest_exponent || mpfr_cmp_si(from, -bits) < 0;
    });
}

} // namespace edgeproof
