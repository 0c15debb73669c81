// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/curved_slope.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/formula/evaluation/complex_taylor.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/ball/acb_values.hpp"
#include "edgeproof/precision/ball/interval.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <vector>

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

/// Computes zeta - s from the nearer edge e, zeta - e +- 2 d sin^2(theta/2) or cos^2: over a wide
/// theta the cosine itself is known only to the width of theta, so that near an edge very narrow
/// pieces of the path would be needed.
void distance_from_zeta(acb_ptr out, const acb_t theta, const SlopeIntegrand& f, slong bits) {
    const bool right = arf_cmp_d(arb_midref(acb_realref(theta)), 1.5) < 0;
    const Ball edge = right ? f.centre + f.half_length : f.centre - f.half_length;
    AcbValue r;
    acb_mul_2exp_si(r, theta, -1);
    (right ? acb_sin : acb_cos)(r, r, bits);
    acb_mul(r, r, r, bits);
    acb_mul_arb(r, r, f.half_length.data(), bits);
    acb_mul_si(r, r, right ? 2 : -2, bits);
    acb_sub_arb(out, f.zeta->get(), edge.data(), bits);
    acb_add(out, out, r, bits);
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
        if (rooted) {
            acb_sub(s, f.zeta->get(), s, bits);
        } else {
            distance_from_zeta(s, theta, f, bits);
        }
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

std::vector<Ball> slope_series(const Expr& slope, const Ball& x, std::size_t terms, long bits) {
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

namespace {

constexpr int most_halvings = 40;
constexpr std::size_t most_cells = 4000;
constexpr std::size_t taylor_terms = 6;

/// A function of x and its derivative over an interval of x, by the rules of differentiation in
/// interval arithmetic (moore-kearfott-cloud2009; DLMF 4.7, 4.20, 4.24, 4.34, 4.38).
struct Rate {
    Interval value;
    Interval rate;
};

Interval interval_of(long n) { return Interval(Ball(n, Interval::bits)); }
Interval squared(const Interval& x) { return pow_int(x, 2); }

/// If a part of f may have no value, or if f is not bounded (a pole), then f may jump. Nothing is
/// known of such a function, even after a bounded function has been applied to it.
Rate continuous(bool defined, const Interval& value, const Interval& rate) {
    return defined && value.is_finite() ? Rate{value, rate}
                                        : Rate{Interval::everything(), Interval::everything()};
}
/// True if x lies between -1 and 1.
bool in_unit(const Interval& x) {
    return (interval_of(1) - x).nowhere_negative() && (interval_of(1) + x).nowhere_negative();
}

Rate operator-(const Rate& f) { return {-f.value, -f.rate}; }
Rate operator+(const Rate& f, const Rate& g) { return {f.value + g.value, f.rate + g.rate}; }
Rate operator-(const Rate& f, const Rate& g) { return {f.value - g.value, f.rate - g.rate}; }
Rate operator*(const Rate& f, const Rate& g) {
    return continuous(true, f.value * g.value, f.rate * g.value + f.value * g.rate);
}
Rate operator/(const Rate& f, const Rate& g) {
    return continuous(true, f.value / g.value,
                      (f.rate * g.value - f.value * g.rate) / squared(g.value));
}
Rate sqrt(const Rate& f) {
    const Interval root = sqrt(f.value);
    return continuous(f.value.nowhere_negative(), root, f.rate / (interval_of(2) * root));
}
Rate exp(const Rate& f) {
    const Interval e = exp(f.value);
    return continuous(true, e, e * f.rate);
}
Rate log(const Rate& f) {
    return continuous(f.value.nowhere_negative(), log(f.value), f.rate / f.value);
}
Rate sin(const Rate& f) { return {sin(f.value), cos(f.value) * f.rate}; }
Rate cos(const Rate& f) { return {cos(f.value), -sin(f.value) * f.rate}; }
Rate tan(const Rate& f) {
    const Interval t = tan(f.value);
    return continuous(true, t, (interval_of(1) + squared(t)) * f.rate);
}
Rate asin(const Rate& f) {
    return continuous(in_unit(f.value), asin(f.value),
                      f.rate / sqrt(interval_of(1) - squared(f.value)));
}
Rate acos(const Rate& f) {
    return continuous(in_unit(f.value), acos(f.value),
                      -f.rate / sqrt(interval_of(1) - squared(f.value)));
}
Rate atan(const Rate& f) { return {atan(f.value), f.rate / (interval_of(1) + squared(f.value))}; }
Rate sinh(const Rate& f) { return continuous(true, sinh(f.value), cosh(f.value) * f.rate); }
Rate cosh(const Rate& f) { return continuous(true, cosh(f.value), sinh(f.value) * f.rate); }
Rate tanh(const Rate& f) { return {tanh(f.value), f.rate / squared(cosh(f.value))}; }
Rate asinh(const Rate& f) {
    return {asinh(f.value), f.rate / sqrt(interval_of(1) + squared(f.value))};
}
Rate acosh(const Rate& f) {
    return continuous((f.value - interval_of(1)).nowhere_negative(), acosh(f.value),
                      f.rate / sqrt(squared(f.value) - interval_of(1)));
}
Rate atanh(const Rate& f) {
    return continuous(in_unit(f.value), atanh(f.value),
                      f.rate / (interval_of(1) - squared(f.value)));
}
Rate gamma(const Rate& f) {
    if (!f.value.is_finite()) {
        return continuous(false, f.value, f.rate);
    }
    const Ball at = Ball::hull(f.value.lower(), f.value.upper());
    const std::vector<Ball> series =
        slope_series(Expr::call("gamma", {Expr::symbol("x")}), at, 2, Interval::bits);
    return continuous(series[0].is_finite() && series[1].is_finite(), Interval(series[0]),
                      Interval(series[1]) * f.rate);
}
Rate pow(const Rate& f, const Rational& q) {
    const Interval factor(Ball(q, Interval::bits));
    return continuous(denominator(q) == 1 || f.value.nowhere_negative(), pow(f.value, q),
                      factor * pow(f.value, Rational(q - 1)) * f.rate);
}
Rate pow(const Rate& f, const Rate& g) { return exp(g * log(f)); }

struct RateEnvironment {
    Interval x;
    [[nodiscard]] Rate number(const Rational& q) const {
        return {Interval(Ball(q, Interval::bits)), interval_of(0)};
    }
    [[nodiscard]] Rate pi() const { return {Interval(Ball::pi(Interval::bits)), interval_of(0)}; }
    [[nodiscard]] Rate symbol(std::string_view) const { return {x, interval_of(1)}; }
};

struct SlopeCell {
    Ball lo;
    Ball hi;
    int halvings;
    [[nodiscard]] Ball middle() const {
        return contact::middle((lo + hi).with_bits(Interval::bits) / 2);
    }
};

using Sign = SlopeMonotonicity::Kind;

Sign sign_of(const Ball& x) {
    return arb_is_nonnegative(x.data()) != 0 ? Sign::rises
           : certainly_negative(x)           ? Sign::falls
                                             : Sign::open;
}

/// Decides the sign by the Taylor series of g'' at both ends of the cell and at its middle; the
/// last coefficient of each series is an enclosure over the whole cell.
Sign sign_by_series(const Expr& slope, const SlopeCell& cell) {
    const std::vector<Ball> all =
        slope_series(slope, Ball::hull(cell.lo, cell.hi), taylor_terms, Interval::bits);
    for (const bool from_left : {true, false}) {
        const std::vector<Ball> end =
            slope_series(slope, from_left ? cell.lo : cell.hi, taylor_terms, Interval::bits);
        for (std::size_t k = 1; k < taylor_terms; ++k) {
            const bool mirrored = !from_left && k % 2 == 0;
            if (sign_of(mirrored ? -all[k] : all[k]) == Sign::rises) {
                return Sign::rises;
            }
            if (sign_of(mirrored ? -end[k] : end[k]) != Sign::rises) {
                break;
            }
        }
    }
    const Ball middle = cell.middle();
    const std::vector<Ball> at = slope_series(slope, middle, 3, Interval::bits);
    const Ball half = Ball::hull(cell.lo - middle, cell.hi - middle);
    const Ball least = at[1] + half * (2 * at[2] + 3 * half * all[3]);
    return sign_of(least) == Sign::rises   ? Sign::rises
           : sign_of(at[1]) == Sign::falls ? Sign::falls
                                           : Sign::open;
}

Sign sign_on(const Expr& slope, const SlopeCell& cell) {
    const RateEnvironment at{Interval(cell.lo, cell.hi)};
    const Interval rate = evaluate<Rate>(slope, at).rate;
    if (rate.nowhere_negative()) {
        return Sign::rises;
    }
    // The series is valid only at points where g' has a value.
    const bool unknown = !rate.lower().is_finite() && !rate.upper().is_finite();
    return unknown ? Sign::open : sign_by_series(slope, cell);
}

/// Decides on the interval between two exact numbers, for a slope in the distance from `origin`.
SlopeMonotonicity monotonicity_between(const Expr& slope, const Ball& origin, const Ball& lo,
                                       const Ball& hi) {
    std::vector<SlopeCell> cells{{lo, hi, 0}};
    std::optional<Ball> undecided; // g' may decrease near this point
    for (std::size_t done = 0; !cells.empty(); ++done) {
        const SlopeCell cell = cells.back();
        cells.pop_back();
        const Ball middle = cell.middle();
        const Sign sign = sign_on(slope, cell);
        if (sign == Sign::falls || done >= most_cells) {
            return {sign == Sign::falls ? sign : Sign::open, origin + middle};
        }
        if (sign == Sign::open && cell.halvings >= most_halvings) {
            undecided = origin + middle;
        } else if (sign == Sign::open) {
            cells.push_back({middle, cell.hi, cell.halvings + 1});
            cells.push_back({cell.lo, middle, cell.halvings + 1});
        }
    }
    return {undecided ? Sign::open : Sign::rises, undecided};
}

/// Decides on half of a piece: from a knot, which is 0 in the variable of the slope, to `end`,
/// which lies on one side of it.
SlopeMonotonicity monotonicity_from(const Expr& slope, const Exact& knot, bool right,
                                    const Ball& end) {
    const Ball origin = enclosed_constant(knot, Interval::bits);
    const Ball distance = (end - origin).with_bits(Interval::bits);
    const Ball zero(0, Interval::bits);
    const Ball limit = right ? upper_end(distance) : lower_end(distance);
    if (right ? !certainly_positive(limit) : !certainly_negative(limit)) {
        return {Sign::rises, {}}; // the piece has no part in the contact
    }
    return monotonicity_between(slope_from_knot(slope, knot.expr()), origin, right ? zero : limit,
                                right ? limit : zero);
}

} // namespace

SlopeMonotonicity monotonicity_of_slope(const Profile& profile, const Ball& a, const Ball& b) {
    const Ball left = lower_end((-b).with_bits(Interval::bits));
    const Ball right = upper_end(a.with_bits(Interval::bits));
    const auto& knots = profile.knots();
    for (std::size_t i = 0; i <= knots.size(); ++i) {
        const SlopePiece& piece = profile.pieces()[i];
        const Ball from = i > 0 ? enclosed_constant(knots[i - 1], Interval::bits) : left;
        const Ball to = i < knots.size() ? enclosed_constant(knots[i], Interval::bits) : right;
        // The origin is a knot, so that no piece holds both edges.
        const bool ends_left = !certainly_less(left, from);
        const bool ends_right = !certainly_less(to, right);
        if (piece.linear || certainly_less(to, left) || certainly_less(right, from)) {
            continue; // the rate of a linear piece was decided exactly
        }
        const Ball half = middle((from + to) / 2).with_bits(Interval::bits);
        SlopeMonotonicity found = ends_left ? monotonicity_from(piece.slope, knots[i], false, left)
                                  : ends_right
                                      ? monotonicity_from(piece.slope, knots[i - 1], true, right)
                                      : monotonicity_from(piece.slope, knots[i - 1], true, half);
        if (found.kind == Sign::rises && !ends_left && !ends_right) {
            found = monotonicity_from(piece.slope, knots[i], false, half);
        }
        if (found.kind != Sign::rises) {
            return found;
        }
    }
    return {Sign::rises, {}};
}

} // namespace edgeproof::contact
