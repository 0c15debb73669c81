// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/ball/ball_series.hpp"

#include "edgeproof/precision/error.hpp"

#ifdef EDGEPROOF_ARB_IN_FLINT
#include <flint/arb_poly.h>
#else
#include <arb_poly.h>
#endif

#include <algorithm>
#include <utility>

namespace edgeproof {

struct BallSeries::Poly {
    arb_poly_t p;
    Poly() { arb_poly_init(p); }
    ~Poly() { arb_poly_clear(p); }
    Poly(const Poly&) = delete;
    Poly& operator=(const Poly&) = delete;
};

BallSeries::BallSeries(std::size_t order, long bits)
    : poly_(new Poly), order_(order), bits_(bits) {}

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

BallSeries::BallSeries(const BallSeries& o) : BallSeries(o.order_, o.bits_) {
    arb_poly_set(poly_->p, o.poly_->p);
}
BallSeries::BallSeries(BallSeries&& o) noexcept
    : poly_(std::exchange(o.poly_, nullptr)), order_(o.order_), bits_(o.bits_) {}
BallSeries& BallSeries::operator=(const BallSeries& o) {
    BallSeries copy(o);
    return *this = std::move(copy);
}
BallSeries& BallSeries::operator=(BallSeries&& o) noexcept {
    std::swap(poly_, o.poly_);
    order_ = o.order_;
    bits_ = o.bits_;
    return *this;
}
BallSeries::~BallSeries() { delete poly_; }

Ball BallSeries::operator[](std::size_t k) const {
    Ball c(0, bits_);
    arb_poly_get_coeff_arb(c.data(), poly_->p, static_cast<slong>(k));
    return c;
}

void BallSeries::set(std::size_t k, const Ball& c) {
    arb_poly_set_coeff_arb(poly_->p, static_cast<slong>(k), c.data());
}

BallSeries BallSeries::resized(std::size_t order) const {
    BallSeries r(*this);
    r.order_ = order;
    arb_poly_truncate(r.poly_->p, static_cast<slong>(order));
    return r;
}

namespace {
slong terms(const BallSeries& x, const BallSeries& y) {
    return static_cast<slong>(std::min(x.order(), y.order()));
}
long bits_of(const BallSeries& x, const BallSeries& y) { return std::max(x.bits(), y.bits()); }
} // namespace

BallSeries operator+(const BallSeries& x, const BallSeries& y) {
    BallSeries r(std::min(x.order_, y.order_), bits_of(x, y));
    arb_poly_add_series(r.poly_->p, x.poly_->p, y.poly_->p, terms(x, y), r.bits_);
    return r;
}
BallSeries operator-(const BallSeries& x, const BallSeries& y) {
    BallSeries r(std::min(x.order_, y.order_), bits_of(x, y));
    arb_poly_sub_series(r.poly_->p, x.poly_->p, y.poly_->p, terms(x, y), r.bits_);
    return r;
}
BallSeries operator*(const BallSeries& x, const BallSeries& y) {
    BallSeries r(std::min(x.order_, y.order_), bits_of(x, y));
    arb_poly_mullow(r.poly_->p, x.poly_->p, y.poly_->p, terms(x, y), r.bits_);
    return r;
}
BallSeries operator/(const BallSeries& x, const BallSeries& y) {
    BallSeries r(std::min(x.order_, y.order_), bits_of(x, y));
    arb_poly_div_series(r.poly_->p, x.poly_->p, y.poly_->p, terms(x, y), r.bits_);
    return r;
}
BallSeries operator*(const BallSeries& x, const Ball& c) {
    BallSeries r(x.order_, std::max(x.bits_, c.bits()));
    arb_poly_scalar_mul(r.poly_->p, x.poly_->p, c.data(), r.bits_);
    return r;
}
BallSeries operator+(const BallSeries& x, const Ball& c) {
    BallSeries r(x);
    r.set(0, x[0] + c);
    return r;
}
BallSeries operator-(const BallSeries& x) {
    BallSeries r(x);
    arb_poly_neg(r.poly_->p, r.poly_->p);
    return r;
}
BallSeries sqrt(const BallSeries& x) {
    BallSeries r(x.order_, x.bits_);
    arb_poly_sqrt_series(r.poly_->p, x.poly_->p, static_cast<slong>(x.order_), x.bits_);
    return r;
}
BallSeries atan(const BallSeries& x) {
    BallSeries r(x.order_, x.bits_);
    arb_poly_atan_series(r.poly_->p, x.poly_->p, static_cast<slong>(x.order_), x.bits_);
    return r;
}
BallSeries pow(const BallSeries& x, const Ball& exponent) {
    BallSeries r(x.order_, x.bits_);
    arb_poly_pow_arb_series(r.poly_->p, x.poly_->p, exponent.data(), static_cast<slong>(x.order_),
                            x.bits_);
    return r;
}

} // namespace edgeproof
