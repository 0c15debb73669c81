// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/axisymmetric/abel_integral.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/quadrature/theta_cells.hpp"

#include <utility>
#include <vector>

namespace edgeproof::contact {

namespace {

constexpr int depth_if_wide = 30;
/// The most boxes on which a series is bounded.
constexpr slong bounds_a_bit = 20;
constexpr slong bounds_if_wide = 150;

/// A power series with complex boxes as coefficients, and whether it is holomorphic where it must
/// be.
class BoxSeries {
public:
    BoxSeries(std::size_t order, long bits) : order_(static_cast<slong>(order)), bits_(bits) {}
    BoxSeries(const BallSeries& x, long bits) : BoxSeries(x.order(), bits) {
        AcbValue c;
        for (std::size_t k = 0; k < x.order(); ++k) {
            acb_set_arb(c, x[k].data());
            acb_poly_set_coeff_acb(poly_, static_cast<slong>(k), c);
        }
    }
    [[nodiscard]] BoxSeries constant(const Box& c) const {
        BoxSeries r(static_cast<std::size_t>(order_), bits_);
        acb_poly_set_acb(r.poly_, c.get());
        return r;
    }
    [[nodiscard]] Box operator[](std::size_t k) const {
        Box c(bits_);
        acb_poly_get_coeff_acb(c.get(), poly_, static_cast<slong>(k));
        return c;
    }
    friend BoxSeries operator+(BoxSeries x, const BoxSeries& y) {
        acb_poly_add(x.poly_, x.poly_, y.poly_, x.bits_);
        return x;
    }
    friend BoxSeries operator-(BoxSeries x, const BoxSeries& y) {
        acb_poly_sub(x.poly_, x.poly_, y.poly_, x.bits_);
        return x;
    }
    friend BoxSeries operator*(BoxSeries x, const BoxSeries& y) {
        acb_poly_mullow(x.poly_, x.poly_, y.poly_, x.order_, x.bits_);
        return x;
    }
    friend BoxSeries operator*(BoxSeries x, const Box& c) {
        acb_poly_scalar_mul(x.poly_, x.poly_, c.get(), x.bits_);
        return x;
    }
    friend BoxSeries operator*(BoxSeries x, const Ball& c) { return std::move(x) * Box(c); }
    friend BoxSeries operator/(BoxSeries x, const BoxSeries& y) {
        acb_poly_div_series(x.poly_, x.poly_, y.poly_, x.order_, x.bits_);
        return x;
    }
    /// The principal root; not finite where the constant term meets the cut.
    friend BoxSeries principal_root(BoxSeries x) {
        if (!contact::principal_root(x[0]).is_finite()) {
            acb_poly_set_acb(x.poly_, unknown_box(x.bits_).get());
            return x;
        }
        acb_poly_sqrt_series(x.poly_, x.poly_, x.order_, x.bits_);
        return x;
    }
    /// The principal arctangent; not finite where the constant term may meet a cut.
    friend BoxSeries principal_arctangent(BoxSeries x) {
        if (!contact::principal_arctangent(x[0]).is_finite()) {
            acb_poly_set_acb(x.poly_, unknown_box(x.bits_).get());
            return x;
        }
        acb_poly_atan_series(x.poly_, x.poly_, x.order_, x.bits_);
        return x;
    }

private:
    AcbPolyValue poly_;
    slong order_;
    long bits_;
};

/// The coefficients of a series, integrated over 0 < t < 1 together.
class SeriesIntegrand : public quadrature::ThetaIntegrand {
public:
    SeriesIntegrand(std::function<BoxSeries(const Box& t)> f, std::size_t order, long bits,
                    slong most_bounds)
        : f_(std::move(f)), order_(order), bits_(bits), left_(most_bounds) {}
    [[nodiscard]] std::size_t count() const override { return order_; }
    bool bound(const quadrature::ThetaPlace& at, std::vector<Magnitude>& most) const override {
        if (left_-- <= 0) {
            return false; // the integration ends without a result
        }
        const BoxSeries all = f_(Box(at.t, bits_));
        for (std::size_t k = 0; k < order_; ++k) {
            most[k] = Magnitude(all[k].get());
            if (!most[k].is_finite()) {
                return false;
            }
        }
        return true;
    }
    void value(const quadrature::ThetaPlace& at, std::vector<Ball>& f) const override {
        const BoxSeries all = f_(Box(at.t, bits_));
        for (std::size_t k = 0; k < order_; ++k) {
            f[k] = all[k].real();
        }
    }

private:
    std::function<BoxSeries(const Box& t)> f_;
    std::size_t order_;
    long bits_;
    mutable slong left_;
};

BallSeries integrals_of(const std::function<BoxSeries(const Box& t)>& f, std::size_t order,
                        const IntegralGoal& goal) {
    const BoxSeries middle = f(Box(Ball(Rational(1, 2), goal.bits)));
    quadrature::ThetaGoal wanted;
    wanted.nodes = static_cast<std::size_t>(goal.accuracy / 4 + 8);
    wanted.depth =
        goal.accuracy < narrow_integral_bits ? depth_if_wide : 2 * static_cast<int>(goal.bits);
    // The size of the first coefficient, by the powers of the radius of convergence: a size that is
    // near 0 by chance would take endless work.
    const Magnitude first(middle[0].get());
    if (!first.is_finite()) {
        return unknown_series(order, goal.bits);
    }
    const Magnitude whole = first + Magnitude(goal.scale) * Magnitude(power_of_two(-20, 64));
    Magnitude scale = Magnitude(Ball(1, 64)) / whole;
    for (std::size_t k = 0; k < order; ++k) {
        wanted.scale.push_back(scale);
        scale = scale * Magnitude(goal.radius);
    }
    wanted.tolerance = Magnitude(power_of_two(-goal.accuracy, 64));
    const std::vector<quadrature::ThetaSpan> span{
        {.piece = 0, .from = Ball(0, goal.bits), .to = Ball(1, goal.bits)}};
    const Ball none(1, goal.bits); // s is not used
    const SeriesIntegrand integrand(
        f, order, goal.bits,
        goal.accuracy < narrow_integral_bits ? bounds_if_wide : bounds_a_bit * goal.accuracy);
    return BallSeries(quadrature::integrate_cells(integrand, span, none, none, wanted, goal.bits));
}

// docs/axisymmetric.md, "What is integrated"
/// h'(s)/s for r > v, in boxes or in series of them: `d2` = r^2 - v^2 (exactly 0: `on_the_bend`).
template <class T>
T outside_value(const RingBend& bend, const T& r2, const T& d2, const T& W, const T& v,
                bool on_the_bend, const Box& t) {
    const T w = W * t;
    const T w2 = w * w;
    const T y = on_the_bend ? w : principal_root(d2 + w2);
    const T angle = principal_arctangent(y / v);
    T rate = (y + y - angle * v) * bend.rate;
    if (!contains_zero(bend.jump)) {
        rate = rate + (angle + v / y) * bend.jump;
    }
    return rate / principal_root(r2 + w2);
}

/// h'(s) y/(s sqrt(y^2 + v^2 - r^2)) for r < v.
template <class T> T inside_value(const RingBend& bend, const T& d2, const T& y, const T& v) {
    const T angle = principal_arctangent(y / v);
    const T y2 = y * y;
    const T rate = (y + y - angle * v) * y * bend.rate + (angle * y + v) * bend.jump;
    return rate / (principal_root(v * v + y2) * principal_root(d2 + y2));
}

} // namespace

BallSeries outside_bend(const RingBend& bend, const BallSeries& r2, const BallSeries& d2,
                        const BallSeries& W, const IntegralGoal& goal) {
    const Box v(bend.v.with_bits(goal.bits));
    const auto box = [&](const Ball& x) { return Box(x.with_bits(goal.bits)); };
    if (r2.order() == 1) {
        const Box of_r2 = box(r2[0]);
        const Box of_d2 = box(d2[0]);
        const Box of_W = box(W[0]);
        const bool on_the_bend = d2[0].is_exact() && contains_zero(d2[0]);
        return BallSeries(integral_of(
                              [&](const Box& t) {
                                  return outside_value(bend, of_r2, of_d2, of_W, v, on_the_bend, t);
                              },
                              goal),
                          1);
    }
    const BoxSeries of_r2(r2, goal.bits);
    const BoxSeries of_d2(d2, goal.bits);
    const BoxSeries of_W(W, goal.bits);
    return integrals_of(
        [&](const Box& t) {
            return outside_value(bend, of_r2, of_d2, of_W, of_r2.constant(v), false, t);
        },
        r2.order(), goal);
}

BallSeries inside_bend(const RingBend& bend, const BallSeries& d2, const Ball& Y,
                       const IntegralGoal& goal) {
    const Box v(bend.v.with_bits(goal.bits));
    if (d2.order() == 1) {
        const Box of_d2(d2[0].with_bits(goal.bits));
        return BallSeries(
            integral_of([&](const Box& t) { return inside_value(bend, of_d2, t * Y, v); }, goal),
            1);
    }
    const BoxSeries of_d2(d2, goal.bits);
    return integrals_of(
        [&](const Box& t) {
            return inside_value(bend, of_d2, of_d2.constant(t * Y), of_d2.constant(v));
        },
        d2.order(), goal);
}

} // namespace edgeproof::contact
