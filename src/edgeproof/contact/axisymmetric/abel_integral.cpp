// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"

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
    struct Hyperbolic;
    [[nodiscard]] Hyperbolic hyperbolic() const;
    friend BoxSeries operator/(BoxSeries x, const BoxSeries& y) {
        acb_poly_div_series(x.poly_, x.poly_, y.poly_, x.order_, x.bits_);
        return x;
    }
    /// The principal root; not finite where the constant term meets the cut.
    friend BoxSeries principal_root(BoxSeries x) {
        const Box constant = contact::principal_root(x[0]);
        if (x.order_ == 1 || !constant.is_finite()) {
            acb_poly_set_acb(x.poly_, constant.get());
            return x;
        }
        acb_poly_sqrt_series(x.poly_, x.poly_, x.order_, x.bits_);
        return x;
    }
    /// The principal arctangent; not finite where the constant term may meet a cut.
    friend BoxSeries principal_arctangent(BoxSeries x) {
        const Box constant = contact::principal_arctangent(x[0]);
        if (x.order_ == 1 || !constant.is_finite()) {
            acb_poly_set_acb(x.poly_, constant.get());
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

struct BoxSeries::Hyperbolic {
    BoxSeries sine;
    BoxSeries cosine;
};

BoxSeries::Hyperbolic BoxSeries::hyperbolic() const {
    Hyperbolic of{*this, *this};
    acb_poly_sinh_cosh_series(of.sine.poly_, of.cosine.poly_, poly_, order_, bits_);
    return of;
}

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
    if (order == 1) {
        return BallSeries(integral_of([&](const Box& t) { return f(t)[0]; }, goal), 1);
    }
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

bool is_narrow(const BallSeries& d2) {
    return certainly_positive(d2[0]) && d2[0].relative_accuracy_bits() >= narrow_integral_bits;
}

/// asinh(z).
BallSeries inverse_sinh(const BallSeries& z) {
    const Ball one(1, z[0].bits());
    const BallSeries z2 = z * z;
    return log1p(z + z2 / (sqrt(z2 + one) + one));
}

} // namespace

// docs/axisymmetric.md, "What is integrated". With x = d sinh(T t) the integrand has no branch
// point near d; a wide d would enter twice.
BallSeries part_of_bend(const RingBend& bend, bool beyond, const BallSeries& d2,
                        const BallSeries& X, const IntegralGoal& goal) {
    const std::size_t order = d2.order();
    const BoxSeries of_d2(d2, goal.bits);
    const BoxSeries v = of_d2.constant(Box(bend.v.with_bits(goal.bits)));
    const BoxSeries v2 = v * v;
    const auto rate = [&](const BoxSeries& y) { // h'
        const BoxSeries angle = principal_arctangent(y / v);
        const BoxSeries bent = (y + y - angle * bend.v) * bend.rate;
        return contains_zero(bend.jump) ? bent : bent + (angle + v / y) * bend.jump;
    };
    const auto moment = [&](const BoxSeries& y, const BoxSeries& y2) { // h' y/s
        const BoxSeries angle = principal_arctangent(y / v);
        return ((y + y - angle * bend.v) * y * bend.rate + (angle * y + v) * bend.jump) /
               principal_root(v2 + y2);
    };
    if (is_narrow(d2)) {
        const BallSeries d = sqrt(d2);
        const BallSeries T = inverse_sinh(X / d);
        const BoxSeries of_d(d, goal.bits);
        const BoxSeries of_T(T, goal.bits);
        const auto f = [&](const Box& t) {
            const auto [sine, cosine] = (of_T * t).hyperbolic();
            const BoxSeries y = of_d * (beyond ? cosine : sine);
            return moment(y, y * y);
        };
        return integrals_of(f, order, goal) * T;
    }
    const BoxSeries of_X(X, goal.bits);
    const bool on_the_bend = order == 1 && d2[0].is_exact() && contains_zero(d2[0]);
    const auto f = [&](const Box& t) {
        const BoxSeries x = of_X * t;
        const BoxSeries x2 = x * x;
        const BoxSeries root = on_the_bend ? x : principal_root(of_d2 + x2);
        return beyond ? rate(root) / principal_root(v2 + of_d2 + x2) : moment(x, x2) / root;
    };
    return integrals_of(f, order, goal) * X;
}

} // namespace edgeproof::contact
