// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/slope_integral.hpp"

#include "edgeproof/formula/evaluation/complex_taylor.hpp"
#include "edgeproof/precision/ball/acb_values.hpp"
#include "edgeproof/precision/interruption.hpp"

namespace edgeproof::contact {
namespace {

/// Computes (g'(s) - T_k(s))/(s - x)^(k+1).
void taylor_quotient(acb_ptr out, const acb_t theta, const acb_t s, const SlopeIntegrand& f,
                     bool rooted, slong order, slong bits) {
    const auto terms = static_cast<slong>(f.taylor->size());
    AcbValue r;
    AcbValue power;
    AcbPolyValue g;
    const auto taylor = order == 0 ? formula::real_taylor : formula::complex_taylor;
    if (f.from_right_edge && !rooted) {
        // s - a = -2 d sin^2(theta/2).
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
        AcbValue sum;
        for (slong k = terms; k-- > 0;) {
            acb_mul(sum, sum, r, bits);
            acb_add_arb(sum, sum, (*f.taylor)[static_cast<std::size_t>(k)].data(), bits);
        }
        taylor(g, *f.formula, rooted ? theta : s, 1, bits);
        acb_poly_get_coeff_acb(out, g, 0);
        acb_sub(out, out, sum, bits);
        acb_pow_ui(power, r, static_cast<ulong>(terms), bits);
        acb_div(out, out, power, bits);
    }
}

/// For order = 0 an enclosure of the values on a piece of the path, which is real, suffices. No
/// exception may pass through Arb: after an interruption all remaining values are zero, and
/// `integrate` throws.
struct Evaluation {
    const SlopeIntegrand& f;
    const quadrature::ThetaSpan& span;
    bool interrupted = false;
};
/// Computes the integrand at theta for Arb's integrator (docs/curved-slopes.md, "What is
/// integrated").
int evaluate(acb_ptr out, const acb_t theta, void* parameter, slong order, slong bits) {
    auto& evaluation = *static_cast<Evaluation*>(parameter);
    const SlopeIntegrand& f = evaluation.f;
    evaluation.interrupted = evaluation.interrupted || interruption_requested() != 0;
    if (evaluation.interrupted) {
        acb_zero(out);
        return 0;
    }
    AcbValue rate;
    AcbValue s;
    AcbPolyValue g;
    const auto taylor = order == 0 ? formula::real_taylor : formula::complex_taylor;
    const bool rooted = evaluation.span.root != 0;
    evaluation.span.map(s, rate, theta, f.centre, f.half_length, bits);
    if (f.zeta != nullptr) {
        taylor(g, *f.formula, rooted ? theta : s, 1, bits);
        acb_poly_get_coeff_acb(out, g, 0);
        acb_sub_arb(out, out, f.mean->data(), bits);
        acb_sub(s, f.zeta->get(), s, bits);
        acb_pow_ui(s, s, static_cast<ulong>(f.poles), bits);
        acb_div(out, out, s, bits);
    } else if (f.x != nullptr) {
        taylor_quotient(out, theta, s, f, rooted, order, bits);
    } else {
        taylor(g, *f.formula, rooted ? theta : s, 1, bits);
        acb_poly_get_coeff_acb(out, g, 0);
        AcbValue cosine;
        if (rooted) {
            acb_sub_arb(cosine, s, f.centre.data(), bits);
            acb_div_arb(cosine, cosine, f.half_length.data(), bits);
            acb_chebyshev_t_ui(cosine, static_cast<ulong>(f.harmonic), cosine, bits);
        } else {
            acb_mul_si(cosine, theta, f.harmonic, bits);
            acb_cos(cosine, cosine, bits);
        }
        acb_mul(out, out, cosine, bits);
    }
    if (rooted) {
        acb_mul(out, out, rate, bits);
    }
    return 0;
}

} // namespace

// docs/curved-slopes.md, "What is integrated": the ball of a limit
Box integrate_in_plane(const SlopeIntegrand& f, const quadrature::ThetaSpan& span, long bits) {
    AcbValue from;
    AcbValue to;
    AcbValue end;
    Box sum(bits);
    arb_get_mid_arb(acb_realref(from), span.from.data());
    arb_get_mid_arb(acb_realref(to), span.to.data());
    MagValue tolerance;
    mag_set_ui_2exp_si(tolerance, 1, -bits - 64);
    Evaluation evaluation{f, span};
    acb_calc_integrate(sum.get(), evaluate, &evaluation, from, to, f.goal != 0 ? f.goal : bits,
                       tolerance, nullptr, bits);
    for (const Ball* limit : {&span.from, &span.to}) {
        acb_set_arb(from, limit->data());
        evaluate(end, from, &evaluation, 0, bits);
        const Ball radius(limit->radius(), bits);
        sum = sum + Box(end, bits) * (radius * Ball::from_interval(Real(-1), Real(1), bits));
    }
    if (evaluation.interrupted) {
        throw Interrupted();
    }
    return sum;
}

Ball integrate(const SlopeIntegrand& f, const quadrature::ThetaSpan& span, long bits) {
    return integrate_in_plane(f, span, bits).real();
}

std::vector<Ball> slope_series(const formula::Expr& slope, const Ball& x, std::size_t terms,
                               long bits) {
    AcbValue at;
    AcbValue value;
    AcbPolyValue g;
    acb_set_arb(at, x.data());
    real_taylor(g, slope, at, static_cast<slong>(terms), bits);
    std::vector<Ball> series;
    for (std::size_t k = 0; k < terms; ++k) {
        acb_poly_get_coeff_acb(value, g, static_cast<slong>(k));
        series.emplace_back(0, bits);
        arb_set(series.back().data(), acb_realref(value));
    }
    return series;
}

} // namespace edgeproof::contact
