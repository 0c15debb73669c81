// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/ball/arb_values.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <utility>

namespace edgeproof {

/// A rectangle in the complex plane that contains a number, with a ball for each part (Arb's acb).
/// It carries its working precision as a Ball does, and a result has the larger one of its
/// operands.
class Box {
public:
    explicit Box(long bits = 64) : bits_(bits) {}
    explicit Box(const Ball& x) : Box(x.bits()) { acb_set_arb(z_, x.data()); }
    Box(const Ball& re, const Ball& im) : Box(re.bits()) {
        acb_set_arb_arb(z_, re.data(), im.data());
    }
    Box(const acb_t z, long bits) : Box(bits) { acb_set(z_, z); }

    [[nodiscard]] static Box hull(const Box& x, const Box& y) {
        Box r(x.bits_);
        acb_union(r.z_, x.z_, y.z_, r.bits_);
        return r;
    }
    [[nodiscard]] acb_ptr get() { return z_; }
    [[nodiscard]] acb_srcptr get() const { return z_; }
    [[nodiscard]] long bits() const { return bits_; }
    [[nodiscard]] bool is_finite() const { return acb_is_finite(z_) != 0; }
    [[nodiscard]] bool contains_zero() const { return acb_contains_zero(z_) != 0; }
    /// True if it meets the real axis.
    [[nodiscard]] bool may_be_real() const { return arb_contains_zero(acb_imagref(z_)) != 0; }
    [[nodiscard]] Ball real() const {
        Ball x(0, bits_);
        arb_set(x.data(), acb_realref(z_));
        return x;
    }
    [[nodiscard]] Ball imaginary() const {
        Ball x(0, bits_);
        arb_set(x.data(), acb_imagref(z_));
        return x;
    }
    [[nodiscard]] Box middle() const {
        Box r(bits_);
        acb_get_mid(r.z_, z_);
        return r;
    }

    friend Box operator-(Box x) {
        acb_neg(x.z_, x.z_);
        return x;
    }
    friend Box operator+(Box x, const Box& y) {
        acb_add(x.z_, x.z_, y.z_, x.widen(y.bits_));
        return x;
    }
    friend Box operator-(Box x, const Box& y) {
        acb_sub(x.z_, x.z_, y.z_, x.widen(y.bits_));
        return x;
    }
    friend Box operator*(Box x, const Box& y) {
        acb_mul(x.z_, x.z_, y.z_, x.widen(y.bits_));
        return x;
    }
    /// If y may be 0, neither part is finite. (Arb leaves the imaginary part of 1/0 exactly 0.)
    friend Box operator/(Box x, const Box& y) {
        if (acb_contains_zero(y.z_) != 0) {
            acb_indeterminate(x.z_);
            return x;
        }
        acb_div(x.z_, x.z_, y.z_, x.widen(y.bits_));
        return x;
    }
    friend Box operator+(Box x, const Ball& y) {
        acb_add_arb(x.z_, x.z_, y.data(), x.widen(y.bits()));
        return x;
    }
    friend Box operator-(Box x, const Ball& y) {
        acb_sub_arb(x.z_, x.z_, y.data(), x.widen(y.bits()));
        return x;
    }
    friend Box operator*(Box x, const Ball& y) {
        acb_mul_arb(x.z_, x.z_, y.data(), x.widen(y.bits()));
        return x;
    }
    friend Box operator+(Box x, long k) {
        const Ball whole(k, x.bits_);
        return std::move(x) + whole;
    }
    friend Box operator-(const Ball& x, const Box& y) { return -(y - x); }
    friend Box operator/(Box x, const Ball& y) {
        acb_div_arb(x.z_, x.z_, y.data(), x.widen(y.bits()));
        return x;
    }

    /// i x, without rounding.
    friend Box times_i(Box x) {
        acb_mul_onei(x.z_, x.z_);
        return x;
    }
    friend Box conj(Box x) {
        acb_conj(x.z_, x.z_);
        return x;
    }
    /// The principal square root (DLMF 4.2.29); a negative number counts as above the cut.
    friend Box sqrt(Box x) {
        acb_sqrt(x.z_, x.z_, x.bits_);
        return x;
    }
    friend Box cos(Box x) {
        acb_cos(x.z_, x.z_, x.bits_);
        return x;
    }
    /// The principal logarithm of 1 + x (DLMF 4.2.2).
    friend Box log1p(Box x) {
        acb_log1p(x.z_, x.z_, x.bits_);
        return x;
    }
    friend Ball abs(const Box& x) {
        Ball r(0, x.bits_);
        acb_abs(r.data(), x.z_, x.bits_);
        return r;
    }
    /// Gauss's 2F1(a, b; c; z), principal branch (DLMF 15.2.1).
    friend Box hypergeometric_2f1(const Ball& a, const Ball& b, const Ball& c, const Box& z) {
        Box r(z.bits_);
        acb_hypgeom_2f1(r.z_, Box(a).z_, Box(b).z_, Box(c).z_, z.z_, 0, z.bits_);
        return r;
    }

private:
    long widen(long bits) { return bits_ = bits_ < bits ? bits : bits_; }
    AcbValue z_;
    long bits_;
};

} // namespace edgeproof
