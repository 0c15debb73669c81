// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/curved_slope.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"
#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/formula/evaluation/complex_taylor.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/ball/acb_values.hpp"
#include "edgeproof/precision/ball/interval.hpp"
#include "edgeproof/precision/ball/magnitude.hpp"

#include <vector>

namespace edgeproof::contact {

namespace {

/// Returns the k-th coefficient of the Taylor series of a formula about a place.
Box taylor_coefficient(const Expr& formula, const Box& at, std::size_t k) {
    const bool real = arb_is_zero(acb_imagref(at.get())) != 0;
    const auto order = static_cast<slong>(k);
    AcbPolyValue g;
    Box c(at.bits());
    (real ? formula::real_taylor : formula::complex_taylor)(g, formula, at.get(), order + 1,
                                                            at.bits());
    acb_poly_get_coeff_acb(c.get(), g, order);
    return c;
}

/// 2 sin^2(t/2) = 1 - cos t, or 2 cos^2(t/2) = 1 + cos t.
Box twice_square(decltype(acb_sin)& of_half, const Box& t) {
    Box r(t.bits());
    acb_mul_2exp_si(r.get(), t.get(), -1);
    of_half(r.get(), r.get(), r.bits());
    return r * r * Ball(2, r.bits());
}

/// True if r/d is so small that the quotient by r^terms would lose most of the bits.
bool is_small(const Box& r, const Ball& d, std::size_t terms) {
    const long bits = r.bits() / static_cast<long>(terms + 1);
    return Magnitude(r.get()) <= Magnitude::least(Ball(d * power_of_two(-bits, d.bits())));
}

Box power(Box x, std::size_t n) {
    acb_pow_ui(x.get(), x.get(), n, x.bits());
    return x;
}

} // namespace

Box slope_over(const Expr& slope, const Box& s) { return taylor_coefficient(slope, s, 0); }

Box SlopeOnSpan::value(const Box& t, const Box& s) const {
    return slope_over(formula, span.root != 0 ? t : s);
}

Box SlopeOnSpan::cosine(long n, const Box& t, const Box& s) const {
    Box c(t.bits());
    if (span.root != 0) {
        c = (s - centre) / half_length;
        acb_chebyshev_t_ui(c.get(), static_cast<ulong>(n), c.get(), c.bits());
    } else {
        acb_mul_si(c.get(), t.get(), n, c.bits());
        c = cos(c);
    }
    return c;
}

Box SlopeOnSpan::quotient(const Ball& x, const std::vector<Ball>& taylor, bool holds_x,
                          bool from_right_edge, const Box& t, const Box& s) const {
    const std::size_t terms = taylor.size();
    const Box r =
        from_right_edge && span.root == 0 ? -(twice_square(acb_sin, t) * half_length) : s - x;
    if (holds_x && (r.contains_zero() || (span.root == 0 && is_small(r, half_length, terms)))) {
        // A divided difference is a mean of the derivative over the hull of its points. Next to x
        // the mean loses less than the difference.
        return taylor_coefficient(slope, Box::hull(Box(x.with_bits(s.bits())), s), terms);
    }
    Box sum(s.bits());
    for (std::size_t k = terms; k-- > 0;) {
        sum = sum * r + taylor[k];
    }
    return (value(t, s) - sum) / power(r, terms);
}

// Over a wide t the cosine itself is known only to the width of t, so that near an edge very narrow
// pieces of the path would be needed.
Box SlopeOnSpan::over_distance(const Box& zeta, const Ball& mean, std::size_t poles, const Box& t,
                               const Box& s) const {
    const bool right = arf_cmp_d(arb_midref(acb_realref(t.get())), 1.5) < 0;
    const Box distance =
        span.root != 0 ? zeta - s
        : right        ? zeta - (centre + half_length) + twice_square(acb_sin, t) * half_length
                       : zeta - (centre - half_length) - twice_square(acb_cos, t) * half_length;
    return (value(t, s) - mean) / power(distance, poles);
}

// docs/curved-slopes.md, "What is integrated"
Box SlopeOnSpan::integral(const Integrand& f, long accuracy, long bits) const {
    return integral_between(
        [&](const Box& t) {
            Box s(bits);
            Box rate(bits);
            span.map(s.get(), rate.get(), t.get(), centre, half_length, bits);
            return span.root != 0 ? f(*this, t, s) * rate : f(*this, t, s);
        },
        span.from, span.to, accuracy, bits);
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

/// Half of a curved piece in the contact: a slope in the distance from `origin`, where a knot is,
/// between two exact distances, one of which is 0.
struct HalfPiece {
    Expr slope;
    Ball origin;
    Ball lo;
    Ball hi;
};

/// The halves of all pieces between the edges that are not linear.
std::vector<HalfPiece> half_pieces(const Profile& profile, const Ball& a, const Ball& b) {
    const Ball left = lower_end((-b).with_bits(Interval::bits));
    const Ball right = upper_end(a.with_bits(Interval::bits));
    const Ball zero(0, Interval::bits);
    std::vector<HalfPiece> halves;
    const auto& knots = profile.knots();
    for (std::size_t i = 0; i <= knots.size(); ++i) {
        const SlopePiece& piece = profile.pieces()[i];
        const Ball from = i > 0 ? enclosed_constant(knots[i - 1], Interval::bits) : left;
        const Ball to = i < knots.size() ? enclosed_constant(knots[i], Interval::bits) : right;
        // The origin is a knot, so that no piece holds both edges.
        const bool ends_left = !certainly_less(left, from);
        const bool ends_right = !certainly_less(to, right);
        if (piece.linear || certainly_less(to, left) || certainly_less(right, from)) {
            continue;
        }
        const Ball half = middle((from + to) / 2).with_bits(Interval::bits);
        if (!ends_left) {
            const Ball end =
                upper_end(((ends_right ? right : half) - from).with_bits(Interval::bits));
            if (certainly_positive(end)) { // else the piece has no part in the contact
                halves.push_back(
                    {slope_from_knot(piece.slope, knots[i - 1].expr()), from, zero, end});
            }
        }
        if (ends_left || !ends_right) {
            const Ball end = lower_end(((ends_left ? left : half) - to).with_bits(Interval::bits));
            if (certainly_negative(end)) {
                halves.push_back({slope_from_knot(piece.slope, knots[i].expr()), to, end, zero});
            }
        }
    }
    return halves;
}

} // namespace

SlopeMonotonicity monotonicity_of_slope(const Profile& profile, const Ball& a, const Ball& b) {
    for (const HalfPiece& half : half_pieces(profile, a, b)) {
        SlopeMonotonicity found = monotonicity_between(half.slope, half.origin, half.lo, half.hi);
        if (found.kind != Sign::rises) {
            return found;
        }
    }
    return {Sign::rises, {}};
}

Ball steepest_rise(const Profile& profile, const Ball& a, const Ball& b) {
    constexpr long parts = 32;
    Ball most(0, Interval::bits);
    for (std::size_t i = 0; i < profile.knots().size(); ++i) {
        const Ball knot = enclosed_constant(profile.knots()[i], Interval::bits);
        if (profile.has_corner(i) && !certainly_less(knot, -b) && !certainly_less(a, knot)) {
            return unknown_ball(Interval::bits);
        }
    }
    for (const SlopePiece& piece : profile.pieces()) {
        if (piece.linear) {
            most = max(most, enclosed_constant(Exact(piece.linear->rate), Interval::bits));
        }
    }
    for (const HalfPiece& half : half_pieces(profile, a, b)) {
        for (long k = 0; k < parts; ++k) {
            // the ends are exact, so that a distance of 0 remains 0
            const auto at = [&](long i) {
                return middle(half.lo + (half.hi - half.lo) * i / parts);
            };
            const Interval x(k == 0 ? half.lo : at(k), k + 1 == parts ? half.hi : at(k + 1));
            most = max(most, evaluate<Rate>(half.slope, RateEnvironment{x}).rate.upper());
        }
    }
    return upper_end(most);
}

bool curvature_falls(const Profile& profile, const Ball& a) {
    constexpr int most_parts = 256;
    const auto& knots = profile.knots();
    const Ball edge = upper_end(a.with_bits(Interval::bits));
    std::optional<Ball> least; // g'' at the end of the piece before
    for (std::size_t i = profile.origin(); i < knots.size(); ++i) {
        const Ball from = enclosed_constant(knots[i], Interval::bits);
        const Ball to = i + 1 < knots.size()
                            ? min(enclosed_constant(knots[i + 1], Interval::bits), edge)
                            : edge;
        if (!certainly_less(from, edge)) {
            break;
        }
        const Expr& slope = profile.pieces()[i + 1].slope;
        const auto bend = [&](const Ball& x) {
            return slope_series(slope, x, 2, Interval::bits)[1];
        };
        if (profile.has_corner(i) || (least && !certainly_less(bend(from), *least))) {
            return false;
        }
        least = bend(to);
        for (int parts = 1, k = 0; k < parts; ++k) {
            const Ball x =
                Ball::hull(from + (to - from) * k / parts, from + (to - from) * (k + 1) / parts);
            const Ball third = slope_series(slope, x, 3, Interval::bits)[2];
            if (arb_is_nonpositive(third.data()) == 0) {
                if (parts == most_parts) {
                    return false;
                }
                parts *= 2; // the parts before k are proved
                k = 2 * k - 1;
            }
        }
    }
    return true;
}

} // namespace edgeproof::contact
