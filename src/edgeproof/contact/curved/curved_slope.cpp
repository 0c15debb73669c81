// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/curved/curved_slope.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"
#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/formula/evaluation/complex_taylor.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/ball/arb_values.hpp"
#include "edgeproof/precision/ball/magnitude.hpp"

#include <algorithm>
#include <array>
#include <optional>
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

std::vector<Ball> series_by(decltype(formula::real_taylor)& taylor, const Expr& slope,
                            const Ball& x, std::size_t terms, long bits) {
    AcbValue at;
    AcbPolyValue g;
    acb_set_arb(at, x.data());
    taylor(g, slope, at, static_cast<slong>(terms), bits);
    std::vector<Ball> series;
    for (std::size_t k = 0; k < terms; ++k) {
        Box c(bits);
        acb_poly_get_coeff_acb(c.get(), g, static_cast<slong>(k));
        series.push_back(c.real());
    }
    return series;
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
    return series_by(formula::real_taylor, slope, x, terms, bits);
}

namespace {

constexpr int most_halvings = 40;
constexpr std::size_t most_cells = 4000;
constexpr std::size_t taylor_terms = 6; ///< in the place; in its root (HalfPiece) more

using Sign = SlopeMonotonicity::Kind;

Sign sign_of(const Ball& x) {
    return arb_is_nonnegative(x.data()) != 0 ? Sign::rises
           : certainly_negative(x)           ? Sign::falls
                                             : Sign::open;
}

/// The Taylor coefficients of g over a ball of places; not finite if g has no value at one of them.
std::vector<Ball> analytic_series(const Expr& g, const Ball& x, std::size_t terms) {
    return series_by(formula::complex_taylor, g, x, terms, slope_bits);
}

/// True if the form of g shows that it has values over a cell that do not decrease, also where it
/// is not analytic at the lower end, as sqrt(2*x + x^2) at 0.
bool rises_by_form(const Expr& g, const Ball& lo, const Ball& hi) {
    if (sign_of(analytic_series(g, Ball::hull(lo, hi), 2)[1]) == Sign::rises) {
        return true;
    }
    const auto rises_from_zero = [&](const Expr& part) {
        return rises_by_form(part, lo, hi) &&
               sign_of(slope_series(part, lo, 1, slope_bits)[0]) == Sign::rises;
    };
    switch (g.kind()) {
    case Expr::Kind::add:
        return rises_by_form(g.arg(0), lo, hi) && rises_by_form(g.arg(1), lo, hi);
    case Expr::Kind::mul:
        return rises_from_zero(g.arg(0)) && rises_from_zero(g.arg(1));
    default:
        return g.builtin() == formula::Builtin::sqrt && rises_from_zero(g.arg(0));
    }
}

/// Decides whether g rises between two numbers: by Taylor's formula at the lower one, where g' may
/// be 0, with the last coefficient over the cell, by the form of g, or by the mean value theorem
/// from the middle.
Sign sign_on(const Expr& g, const Ball& lo, const Ball& hi, std::size_t terms = taylor_terms) {
    const std::vector<Ball> all = analytic_series(g, Ball::hull(lo, hi), terms);
    const std::vector<Ball> start = analytic_series(g, lo, terms);
    for (std::size_t k = 1; k < terms; ++k) {
        if (sign_of(all[k]) == Sign::rises) {
            return Sign::rises;
        }
        if (sign_of(start[k]) != Sign::rises) {
            break;
        }
    }
    const Ball between = middle((lo + hi) / 2);
    const std::vector<Ball> at = analytic_series(g, between, 3);
    const Ball half = Ball::hull(lo - between, hi - between);
    const Ball least = at[1] + half * (2 * at[2] + 3 * half * all[3]);
    return sign_of(least) == Sign::rises || rises_by_form(g, lo, hi) ? Sign::rises
           : sign_of(at[1]) == Sign::falls                           ? Sign::falls
                                                                     : Sign::open;
}

/// A curved piece in the contact next to a knot: the place is knot + side w^root with
/// 0 <= w <= end, and g = side g' is a function of w without a branch point at 0 (slope_at_root).
struct HalfPiece {
    Expr g;
    long root;
    int side;
    Ball knot;
    Ball end;
};
HalfPiece half_piece(const Expr& slope, const Expr& knot, int side, const Ball& length) {
    const auto found = slope_at_root(slope, knot, side > 0);
    const Expr x = Expr::symbol("x");
    const SlopeAtRoot form =
        found ? *found
              : SlopeAtRoot{substitute(slope_from_knot(slope, knot), "x", side > 0 ? x : -x)};
    const bool negated = form.slope.kind() == Expr::Kind::neg;
    return {side > 0  ? form.slope
            : negated ? form.slope.arg(0)
                      : -form.slope,
            form.root, side, enclosed_constant(Exact(knot), slope_bits),
            upper_end(form.root == 1 ? length : pow(length, Rational(1, form.root)))};
}

/// True if g rises over a small cell although its rate is 0 at a rational number in it, or nearer
/// to it than its width.
bool rises_across(const Expr& g, const Ball& lo, const Ball& hi) {
    const Ball from = lo * 2 - hi;
    const Ball to = hi * 2 - lo;
    const Rational zero = simplest_between(exact_value(from.lower()), exact_value(to.upper()));
    const Ball at(zero, slope_bits);
    return std::ranges::all_of(std::array{-1, 1}, [&](int side) {
        const Ball length = upper_end(side < 0 ? at - from : to - at);
        const HalfPiece half = half_piece(g, Expr::number(zero), side, length);
        return sign_on(half.g, Ball(0, slope_bits), half.end) == Sign::rises;
    });
}

SlopeMonotonicity monotonicity_on(const HalfPiece& half) {
    struct Cell {
        Ball lo;
        Ball hi;
        int halvings;
    };
    std::vector<Cell> cells{{Ball(0, slope_bits), half.end, 0}};
    std::optional<Ball> undecided; // g' may decrease near this point
    for (std::size_t done = 0; !cells.empty(); ++done) {
        const Cell cell = cells.back();
        cells.pop_back();
        const Ball between = middle((cell.lo + cell.hi) / 2);
        const Ball place = half.knot + pow_int(between, half.root) * half.side;
        const Sign sign =
            sign_on(half.g, cell.lo, cell.hi, taylor_terms * static_cast<std::size_t>(half.root));
        if (sign == Sign::falls || done >= most_cells) {
            return {sign == Sign::falls ? sign : Sign::open, place};
        }
        if (sign == Sign::open && cell.halvings < most_halvings) {
            cells.push_back({between, cell.hi, cell.halvings + 1});
            cells.push_back({cell.lo, between, cell.halvings + 1});
        } else if (sign == Sign::open && !rises_across(half.g, cell.lo, cell.hi)) {
            undecided = place;
        }
    }
    return {undecided ? Sign::open : Sign::rises, undecided};
}

/// The halves of all pieces between the edges that are not linear.
std::vector<HalfPiece> half_pieces(const Profile& profile, const Ball& a, const Ball& b) {
    const Ball left = lower_end((-b).with_bits(slope_bits));
    const Ball right = upper_end(a.with_bits(slope_bits));
    std::vector<HalfPiece> halves;
    const auto& knots = profile.knots();
    for (std::size_t i = 0; i <= knots.size(); ++i) {
        const SlopePiece& piece = profile.pieces()[i];
        const Ball from = i > 0 ? enclosed_constant(knots[i - 1], slope_bits) : left;
        const Ball to = i < knots.size() ? enclosed_constant(knots[i], slope_bits) : right;
        // A stick zone may lie within one piece; the origin is a knot, so that a piece has one.
        const bool ends_left = !certainly_less(left, from);
        const bool ends_right = !certainly_less(to, right);
        if (piece.linear || certainly_less(to, left) || certainly_less(right, from)) {
            continue;
        }
        const Ball half = middle((from + to) / 2);
        const auto add = [&](std::size_t knot, int side, const Ball& length) {
            if (certainly_positive(upper_end(length))) { // else no part is in the contact
                halves.push_back(
                    half_piece(piece.slope, knots[knot].expr(), side, upper_end(length)));
            }
        };
        const bool last = i == knots.size();
        if (!ends_left || last) {
            add(i - 1, 1, (ends_right ? right : half) - from);
        }
        if (!last && (ends_left || !ends_right)) {
            add(i, -1, to - (ends_left ? left : half));
        }
    }
    return halves;
}

} // namespace

SlopeMonotonicity monotonicity_of_slope(const Profile& profile, const Ball& a, const Ball& b) {
    for (const HalfPiece& half : half_pieces(profile, a, b)) {
        SlopeMonotonicity found = monotonicity_on(half);
        if (found.kind != Sign::rises) {
            return found;
        }
    }
    return {Sign::rises, {}};
}

Ball steepest_rise(const Profile& profile, const Ball& a, const Ball& b) {
    constexpr long parts = 32;
    Ball most(0, slope_bits);
    for (std::size_t i = 0; i < profile.knots().size(); ++i) {
        const Ball knot = enclosed_constant(profile.knots()[i], slope_bits);
        if (profile.has_corner(i) && !certainly_less(knot, -b) && !certainly_less(a, knot)) {
            return unknown_ball(slope_bits);
        }
    }
    for (const SlopePiece& piece : profile.pieces()) {
        if (piece.linear) {
            most = max(most, enclosed_constant(Exact(piece.linear->rate), slope_bits));
        }
    }
    for (const HalfPiece& half : half_pieces(profile, a, b)) {
        // g'' = (dg/dw)/(root w^(root - 1)); next to the knot, if that is finite, by the mean value
        // theorem it is the coefficient of w^root at a place between.
        const auto n = static_cast<std::size_t>(half.root);
        const std::vector<Ball> start = analytic_series(half.g, Ball(0, slope_bits), n);
        const bool finite = std::all_of(start.begin() + 1, start.end(), [](const Ball& c) {
            return c.is_exact() && contains_zero(c);
        });
        most = finite ? most : unknown_ball(slope_bits);
        for (long k = 0; k < parts; ++k) {
            const Ball from = half.end * k / parts;
            const Ball w = Ball::hull(from, half.end * (k + 1) / parts);
            const Ball bend = k == 0 ? analytic_series(half.g, w, n + 1)[n]
                                     : upper_end(analytic_series(half.g, w, 2)[1]) /
                                           (pow_int(from, half.root - 1) * half.root);
            most = max(most, bend);
        }
    }
    return upper_end(most);
}

namespace {

/// K and K'/x over x, where K is g'' or, of a body of revolution, g'/x + g''.
struct Bend {
    Ball K;
    Ball rise; ///< not finite if it may have no bound
    bool falls;
};

Bend bend_over(const SlopePiece& piece, const Ball& x, bool axisymmetric) {
    const std::vector<Ball> g = slope_series(piece.slope, x, 3, slope_bits);
    const Ball third = g[2] * 2;
    const Ball rise = (axisymmetric ? Ball(third - (g[0] / x - g[1]) / x) : third) / x;
    return {axisymmetric ? Ball(g[0] / x + g[1]) : g[1], rise,
            arb_is_nonpositive(rise.data()) != 0};
}

// Over 0 < r < x by the mean value theorem. With N = r K of a body of revolution, K'/r is the
// integral of t N''(t) over 0 < t < r, divided by r^3; N''/t is a value of the next derivative.
Bend bend_from_axis(const SlopePiece& piece, const Ball& x, bool axisymmetric) {
    const Ball all = Ball::hull(Ball(0, slope_bits), x);
    const std::vector<Ball> g = slope_series(piece.slope, all, 5, slope_bits);
    const Ball on_axis = slope_series(piece.slope, Ball(0, slope_bits), 3, slope_bits)[2];
    const bool odd = on_axis.is_exact() && contains_zero(on_axis);
    const Ball rise = axisymmetric ? Ball((g[3] + all * g[4]) * 8) : Ball(g[3] * 6);
    const Ball falls = axisymmetric ? Ball(g[2] + all * g[3]) : g[2];
    return {axisymmetric ? Ball((g[1] + all * g[2]) * 2) : g[1],
            odd ? rise : unknown_ball(slope_bits), arb_is_nonpositive(falls.data()) != 0};
}

} // namespace

bool greatest_in_the_middle(const Profile& profile, const Ball& a) {
    constexpr int most_parts = 1024;
    const bool axisymmetric = profile.axisymmetric();
    const auto& knots = profile.knots();
    const Ball edge = upper_end(a.with_bits(slope_bits));
    std::optional<Ball> least; // K at the end of the piece before
    for (std::size_t i = profile.origin(); i < knots.size(); ++i) {
        const Ball from = enclosed_constant(knots[i], slope_bits);
        const Ball to =
            i + 1 < knots.size() ? min(enclosed_constant(knots[i + 1], slope_bits), edge) : edge;
        if (!certainly_less(from, edge)) {
            break;
        }
        const SlopePiece& piece = profile.pieces()[i + 1];
        if (profile.has_corner(i) ||
            (least && !certainly_less(bend_over(piece, from, axisymmetric).K, *least))) {
            return false;
        }
        least = bend_over(piece, to, axisymmetric).K;
        for (int parts = 1, k = 0; k < parts; ++k) {
            const Ball x =
                Ball::hull(from + (to - from) * k / parts, from + (to - from) * (k + 1) / parts);
            const auto suffices = [&](const Bend& bend) {
                return bend.falls || certainly_less(bend.rise * (edge - x) * (edge + x), bend.K);
            };
            if (!suffices(bend_over(piece, x, axisymmetric)) &&
                !(i == profile.origin() && suffices(bend_from_axis(piece, x, axisymmetric)))) {
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
