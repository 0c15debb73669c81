// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/stress/binary64_stress.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/precision/double_word/double_word.hpp"

#include <cmath>
#include <cstddef>

namespace edgeproof::contact {
namespace {

using Number = Binary64Ball;

struct Complex {
    Number re;
    Number im;

    friend Complex operator+(const Complex& x, const Complex& y) {
        return {x.re + y.re, x.im + y.im};
    }
    friend Complex operator-(const Complex& x, const Complex& y) {
        return {x.re - y.re, x.im - y.im};
    }
    friend Complex operator*(const Complex& x, const Complex& y) {
        return {x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
    }
    friend Complex operator*(const Complex& x, const Number& y) { return {x.re * y, x.im * y}; }
    friend Complex operator/(const Complex& x, const Complex& y) {
        const Number size = y.re * y.re + y.im * y.im;
        return {(x.re * y.re + x.im * y.im) / size, (x.im * y.re - x.re * y.im) / size};
    }
};

Number exactly(double x) { return {x, 0}; }

Number number_of(const Ball& x) {
    const DoubleWord word = to_double_word(x);
    return {word.high, Number::inflated(std::fabs(word.low) + word.radius)};
}

/// x minus a word, accurate also close to it.
Number difference(double x, const DoubleWord& word) {
    const auto sum = double_word::exact_sum(x, -word.high);
    const double rest = sum.error - word.low;
    const double v = sum.sum + rest;
    return {v, Number::inflated(Number::unit * (std::fabs(rest) + std::fabs(v)) + word.radius)};
}

/// sqrt(x + i y) for y >= 0, with both parts >= 0.
Complex root_above(const Complex& c) {
    const Number size = hypot(c.re, c.im);
    const Number half = exactly(0.5);
    const bool real = c.im.middle == 0 && c.im.radius == 0;
    if (real && !(std::fabs(c.re.middle) > c.re.radius)) { // the root may be real or imaginary
        return {sqrt((size + c.re) * half), sqrt((size - c.re) * half)};
    }
    if (c.re.middle >= 0) {
        const Number re = sqrt((size + c.re) * half);
        return {re, real ? exactly(0) : c.im * half / re};
    }
    const Number im = sqrt((size - c.re) * half);
    return {real ? exactly(0) : c.im * half / im, im};
}

} // namespace

Binary64Stress::Binary64Stress(const StressField& field,
                               const std::optional<ShearLoad<Ball>>& stuck)
    : bulk_(number_of(field.bulk)), stuck_(stuck.has_value()) {
    for (const LoadPart& load : field.parts) {
        const BallContact& contact = *load.contact->closed_form();
        const Ball half = contact.length() / 2;
        const Ball modulus = contact.modulus() / 2;
        Part part{to_double_word(contact.a()),
                  to_double_word(-contact.b()),
                  number_of(half),
                  number_of(contact.arc() * half),
                  number_of(load.pressure * modulus),
                  number_of(load.shear * modulus),
                  {}};
        const LinearSlope<Ball>& slope = contact.slope();
        for (const std::size_t i : contact.bends_inside()) {
            const Mark<Ball>& v = contact.knot_marks()[i];
            part.knots.push_back({to_double_word(slope.knots[i]), number_of(v.w),
                                  number_of(v.y / half), number_of(v.w / half),
                                  number_of(slope.jump(i)), number_of(slope.rate_drop(i)),
                                  slope.has_corner(i)});
        }
        parts_.push_back(std::move(part));
    }
    if (stuck) {
        Q_ = number_of(stuck->Q);
        tension_ = number_of(stuck->bulk_tension * Ball::pi(field.bits()) / 4);
    }
}

// docs/stress.md, "Piecewise linear slopes", "The Cauchy integrals of q" and "The Cauchy integrals"
Binary64StressState Binary64Stress::at(double x, double z) const {
    const Number depth = exactly(z);
    const Number one = exactly(1);
    const Number half = exactly(0.5);
    Complex P{}; // P, z P', T and z T'
    Complex P_deep{};
    Complex T{};
    Complex T_deep{};
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const Part& part = parts_[i];
        const Complex right{difference(x, part.right), depth};
        const Complex left{difference(x, part.left), depth};
        const Complex root = root_above(right) * root_above(left);
        const Complex lead = (right + left) * half; // zeta - c
        const Complex omega = Complex{part.half, {}} / (lead + root);
        Complex value = omega * part.arc;
        Complex by_root = Complex{} - value;
        Complex derivative{};
        for (const Knot& v : part.knots) {
            const Complex offset{-difference(x, v.place), -depth}; // v - zeta
            const Complex towards = omega * v.cosine;
            const Complex turned{-(omega.im * v.sine), omega.re * v.sine}; // i omega sin h
            const Complex less = Complex{one, {}} - (towards - turned);
            const Complex more = Complex{one, {}} - (towards + turned);
            // k = -i ln(less/more)
            const Number angle =
                atan2(less.im * more.re - less.re * more.im, less.re * more.re + less.im * more.im);
            const Number sizes =
                (more.re * more.re + more.im * more.im) / (less.re * less.re + less.im * less.im);
            const Complex k{angle, log(sizes) * half};
            if (v.corner) {
                value = value + k * v.jump;
                by_root = by_root + Complex{v.jump * v.w, {}} / offset;
            }
            value = value + (offset * k + Complex{v.w, {}}) * v.drop;
            by_root = by_root + Complex{v.drop * v.w, {}};
            derivative = derivative - k * v.drop;
        }
        P = P + value * part.pressure;
        T = T + value * part.shear;
        if (stuck_ && i == 0) {
            T = T + (omega * (tension_ * part.half) + Complex{Q_, {}}) / root;
        }
        if (z != 0) {
            const Complex deep = (derivative + by_root / root) * depth;
            P_deep = P_deep + deep * part.pressure;
            T_deep = T_deep + deep * part.shear;
            if (stuck_ && i == 0) {
                const Complex moment = lead * Q_ + Complex{tension_ * part.half * part.half, {}};
                T_deep = T_deep - moment * depth / (root * root * root);
            }
        }
    }
    const Number over_pi{0.31830988618379067, 0x1p-54};
    const Number shear = T.re + T.re;
    return {(P.im + P_deep.re - shear + T_deep.im) * over_pi + bulk_,
            (P.im - P_deep.re - T_deep.im) * over_pi, (T.im + T_deep.re - P_deep.im) * over_pi,
            (P_deep.re + T_deep.im - T.re) * over_pi + bulk_ * half};
}

} // namespace edgeproof::contact
