// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/ball/ball_series.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof {

BallSeries::BallSeries(std::size_t order, long bits) : order_(order), bits_(bits) {}

BallSeries::BallSeries(const Ball& c, std::size_t order) : BallSeries(order, c.bits()) {
    if (order == 0) {
        throw DomainError("a truncated series needs at least one term");
    }
    set(0, c);
}

BallSeries::BallSeries(const std::vector<Ball>& coefficients)
    : BallSeries(coefficients.empty() ? Ball() : coefficients[0], coefficients.size()) {
    for (std::size_t k = 1; k < coefficients.size(); ++k) {
        set(k, coefficients[k]);
    }
}

BallSeries BallSeries::variable(const Ball& c, std::size_t order) {
    BallSeries s(c, order);
    if (order > 1) {
        s.set(1, Ball(1, c.bits()));
    }
    return s;
}

Ball BallSeries::operator[](std::size_t k) const {
    Ball c(0, bits_);
    arb_poly_get_coeff_arb(c.data(), poly_, static_cast<slong>(k));
    return c;
}

std::vector<Ball> BallSeries::coefficients() const {
    std::vector<Ball> list;
    for (std::size_t k = 0; k < order_; ++k) {
        list.push_back((*this)[k]);
    }
    return list;
}

void BallSeries::set(std::size_t k, const Ball& c) {
    arb_poly_set_coeff_arb(poly_, static_cast<slong>(k), c.data());
}

BallSeries BallSeries::resized(std::size_t order) const {
    BallSeries r(*this);
    r.order_ = order;
    arb_poly_truncate(r.poly_, static_cast<slong>(order));
    return r;
}

/// f(result, x, y, terms, bits), a function of Arb.
template <class F> BallSeries BallSeries::apply(F f, const BallSeries& x, const BallSeries& y) {
    BallSeries r(std::min(x.order_, y.order_), std::max(x.bits_, y.bits_));
    f(r.poly_, x.poly_, y.poly_, static_cast<slong>(r.order_), r.bits_);
    return r;
}
template <class F> BallSeries BallSeries::apply(F f, const BallSeries& x) {
    BallSeries r(x.order_, x.bits_);
    f(r.poly_, x.poly_, static_cast<slong>(x.order_), x.bits_);
    return r;
}

BallSeries operator+(const BallSeries& x, const BallSeries& y) {
    return BallSeries::apply(arb_poly_add_series, x, y);
}
BallSeries operator-(const BallSeries& x, const BallSeries& y) {
    return BallSeries::apply(arb_poly_sub_series, x, y);
}
BallSeries operator*(const BallSeries& x, const BallSeries& y) {
    return BallSeries::apply(arb_poly_mullow, x, y);
}
BallSeries operator/(const BallSeries& x, const BallSeries& y) {
    return BallSeries::apply(arb_poly_div_series, x, y);
}
BallSeries operator*(const BallSeries& x, const Ball& c) {
    BallSeries r(x.order_, std::max(x.bits_, c.bits()));
    arb_poly_scalar_mul(r.poly_, x.poly_, c.data(), r.bits_);
    return r;
}
BallSeries operator+(const BallSeries& x, const Ball& c) {
    BallSeries r(x);
    r.set(0, x[0] + c);
    return r;
}
BallSeries operator-(const BallSeries& x) {
    BallSeries r(x);
    arb_poly_neg(r.poly_, r.poly_);
    return r;
}
BallSeries sqrt(const BallSeries& x) { return BallSeries::apply(arb_poly_sqrt_series, x); }
BallSeries log1p(const BallSeries& x) { return BallSeries::apply(arb_poly_log1p_series, x); }
BallSeries atan(const BallSeries& x) { return BallSeries::apply(arb_poly_atan_series, x); }
BallSeries inverse_function(const BallSeries& x) {
    return BallSeries::apply(arb_poly_revert_series, x);
}
BallSeries pow(const BallSeries& x, const Ball& exponent) {
    BallSeries r(x.order_, x.bits_);
    arb_poly_pow_arb_series(r.poly_, x.poly_, exponent.data(), static_cast<slong>(x.order_),
                            x.bits_);
    return r;
}

} // namespace edgeproof
