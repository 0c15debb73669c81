// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/elementary/elementary.hpp"
#include "edgeproof/precision/ball/acb_values.hpp"
#include "edgeproof/precision/ball/arb_values.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <cstdlib>

namespace edgeproof {
namespace {

using OfArb = void (*)(arb_ptr, arb_srcptr, slong);
using OfMpfr = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

/// Bits in addition to those of the result: with these an enclosure is rarely too wide to be
/// rounded.
constexpr mpfr_prec_t first_guard_bits = 20;
constexpr mpfr_prec_t last_guard_bits = 64;
/// For |x| < 2^this the exponent of e^x is in the range of MPFR and Arb.
constexpr mpfr_exp_t largest_exponent = 20;

/// Returns f(x) rounded to nearest, from an enclosure that rounds to one number, at one of two
/// precisions (Ziv's method). If neither suffices, or if `by_mpfr` requires it for x and the
/// precision, by MPFR.
///
/// x is rational, so that f(x) is transcendental for x other than 0 (Lindemann), and never the
/// midpoint of two numbers. Where 2^-bits <= |x| <= 2^bits it is within 2^(-2 bits) of such a
/// midpoint only by chance.
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

Real exp_less_one(const Real& x) {
    // For x below -bits the result is too close to -1 for both of Arb's precisions.
    return nearest(x, arb_expm1, mpfr_expm1, [](mpfr_srcptr from, mpfr_prec_t bits) {
        return mpfr_get_exp(from) > largest_exponent || mpfr_cmp_si(from, -bits) < 0;
    });
}

std::vector<Real> gamma_taylor(const Real& x, std::size_t n) {
    if (!isfinite(x)) {
        throw DomainError("gamma of a number that is not finite");
    }
    constexpr long guard_bits = 64;
    const long bits = mpfr_get_prec(Real(x).backend().data()) + guard_bits;
    const Ball at(x, bits);
    AcbPolyValue f;
    AcbValue c;
    acb_set_arb(c, at.data());
    acb_poly_set_coeff_acb(f, 0, c);
    acb_poly_set_coeff_si(f, 1, 1);
    acb_poly_gamma_series(f, f, static_cast<slong>(n), bits);
    std::vector<Real> series;
    bool finite = true;
    for (std::size_t k = 0; k < n; ++k) {
        acb_poly_get_coeff_acb(c, f, static_cast<slong>(k));
        Ball coefficient(0, bits);
        arb_set(coefficient.data(), acb_realref(c));
        finite = finite && coefficient.is_finite();
        series.push_back(finite ? at_working_precision(coefficient.midpoint()) : Real(0));
    }
    if (!finite) {
        throw DomainError("gamma at a pole");
    }
    return series;
}

} // namespace edgeproof
