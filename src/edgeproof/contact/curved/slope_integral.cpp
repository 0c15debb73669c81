// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/slope_integral.hpp"

#include "edgeproof/formula/complex_taylor.hpp"

namespace edgeproof::contact {
namespace {

/// (g'(s) - T_k(s))/(s - x)^(k+1).
void taylor_quotient(acb_ptr out, const acb_t theta, const acb_t s, const SlopeIntegrand& f,
                     slong order, slong bits) {
    const auto terms = static_cast<slong>(f.taylor->size());
    acb_t r;
    acb_t power;
    acb_init(r);
    acb_init(power);
    acb_poly_t g;
    acb_poly_init(g);
    const auto taylor = order == 0 ? formula::real_taylor : formula::complex_taylor;
    if (f.from_right_edge) {
        // s - a = -2 d sin^2(theta/2)
        acb_mul_2exp_si(r, theta, -1);
        acb_sin(r, r, bits);
        acb_mul(r, r, r, bits);
        acb_mul_arb(r, r, f.half_length.data(), bits);
        acb_mul_si(r, r, -2, bits);
    } else {
        acb_sub_arb(r, s, f.x->data(), bits);
    }
    if (f.holds_x && acb_contains_zero(r) != 0) {
        // A divided difference is a mean of the derivative over the hull of its points.
        acb_set_arb(power, f.x->data());
        acb_union(power, power, s, bits);
        taylor(g, *f.slope, power, terms + 1, bits);
        acb_poly_get_coeff_acb(out, g, terms);
    } else {
        acb_t sum;
        acb_init(sum);
        for (slong k = terms; k-- > 0;) {
            acb_mul(sum, sum, r, bits);
            acb_add_arb(sum, sum, (*f.taylor)[static_cast<std::size_t>(k)].data(), bits);
        }
        taylor(g, *f.slope, s, 1, bits);
        acb_poly_get_coeff_acb(out, g, 0);
        acb_sub(out, out, sum, bits);
        acb_pow_ui(power, r, static_cast<ulong>(terms), bits);
        acb_div(out, out, power, bits);
        acb_clear(sum);
    }
    acb_poly_clear(g);
    acb_clear(power);
    acb_clear(r);
}

/// order = 0: an enclosure of the values on a piece of the path, which is real, will do.
int evaluate(acb_ptr out, const acb_t theta, void* parameter, slong order, slong bits) {
    const auto& f = *static_cast<const SlopeIntegrand*>(parameter);
    acb_t cosine;
    acb_t s;
    acb_init(cosine);
    acb_init(s);
    acb_poly_t g;
    acb_poly_init(g);
    const auto taylor = order == 0 ? formula::real_taylor : formula::complex_taylor;
    acb_cos(cosine, theta, bits);
    acb_mul_arb(s, cosine, f.half_length.data(), bits);
    acb_add_arb(s, s, f.centre.data(), bits);
    if (f.taylor != nullptr) {
        taylor_quotient(out, theta, s, f, order, bits);
    } else if (f.x == nullptr) {
        taylor(g, *f.slope, s, 1, bits);
        acb_poly_get_coeff_acb(out, g, 0);
        acb_mul_si(cosine, theta, f.harmonic, bits);
        acb_cos(cosine, cosine, bits);
        acb_mul(out, out, cosine, bits);
    } else {
        acb_t gap;
        acb_init(gap);
        acb_sub_arb(gap, s, f.x->data(), bits);
        if (f.holds_x && acb_contains_zero(gap) != 0) {
            // The quotient is a mean of g'' over the way from x to s, which stays in their hull.
            acb_t hull;
            acb_init(hull);
            acb_set_arb(hull, f.x->data());
            acb_union(hull, hull, s, bits);
            taylor(g, *f.slope, hull, 2, bits);
            acb_poly_get_coeff_acb(out, g, 1);
            acb_clear(hull);
        } else {
            taylor(g, *f.slope, s, 1, bits);
            acb_poly_get_coeff_acb(out, g, 0);
            acb_sub_arb(out, out, f.slope_at_x->data(), bits);
            acb_div(out, out, gap, bits);
        }
        acb_clear(gap);
    }
    acb_poly_clear(g);
    acb_clear(s);
    acb_clear(cosine);
    return 0;
}

} // namespace

Ball integrate(const SlopeIntegrand& f, const Ball& lo, const Ball& hi, long bits) {
    acb_t from;
    acb_t to;
    acb_t sum;
    acb_t end;
    acb_init(from);
    acb_init(to);
    acb_init(sum);
    acb_init(end);
    arb_get_mid_arb(acb_realref(from), lo.data());
    arb_get_mid_arb(acb_realref(to), hi.data());
    mag_t tolerance;
    mag_init(tolerance);
    mag_set_ui_2exp_si(tolerance, 1, -bits - 64);
    auto* parameter = const_cast<SlopeIntegrand*>(&f); // NOLINT: Arb's signature; never written to
    acb_calc_integrate(sum, evaluate, parameter, from, to, bits, tolerance, nullptr, bits);
    Ball result(0, bits);
    arb_set(result.data(), acb_realref(sum));
    for (const Ball* limit : {&lo, &hi}) {
        acb_set_arb(from, limit->data());
        evaluate(end, from, parameter, 0, bits);
        Ball rest(0, bits);
        arb_set(rest.data(), acb_realref(end));
        const Ball radius(limit->radius(), bits);
        result += rest * radius * Ball::from_interval(Real(-1), Real(1), bits);
    }
    mag_clear(tolerance);
    acb_clear(from);
    acb_clear(to);
    acb_clear(sum);
    acb_clear(end);
    return result;
}

std::vector<Ball> slope_series(const formula::Expr& slope, const Ball& x, std::size_t terms,
                               long bits) {
    acb_t at;
    acb_t value;
    acb_poly_t g;
    acb_init(at);
    acb_init(value);
    acb_poly_init(g);
    acb_set_arb(at, x.data());
    real_taylor(g, slope, at, static_cast<slong>(terms), bits);
    std::vector<Ball> series;
    for (std::size_t k = 0; k < terms; ++k) {
        acb_poly_get_coeff_acb(value, g, static_cast<slong>(k));
        series.emplace_back(0, bits);
        arb_set(series.back().data(), acb_realref(value));
    }
    acb_poly_clear(g);
    acb_clear(value);
    acb_clear(at);
    return series;
}

} // namespace edgeproof::contact
