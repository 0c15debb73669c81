// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cfenv>
#include <cfloat>
#include <cmath>

namespace edgeproof {

/// A binary64 with a bound of its error: the exact number is within `radius` of `middle`. A radius
/// that is infinite or NaN means that nothing is known.
///
/// The operations suppose rounding to nearest. An operation with the result v then has an error of
/// at most 2^-53 |v|, or 2^-1075 where it underflows. A radius is a sum of at most eight terms
/// without a sign, whose own roundings `inflated` covers.
struct Binary64Ball {
    double middle = 0;
    double radius = 0;

    static constexpr double unit = 0x1p-53;
    static constexpr double tiny = 0x1p-1000;
    static double inflated(double radius) { return radius * (1 + 0x1p-48); }

    friend Binary64Ball operator-(const Binary64Ball& x) { return {-x.middle, x.radius}; }
    friend Binary64Ball operator+(const Binary64Ball& x, const Binary64Ball& y) {
        const double v = x.middle + y.middle;
        return {v, inflated(x.radius + y.radius + unit * std::fabs(v))};
    }
    friend Binary64Ball operator-(const Binary64Ball& x, const Binary64Ball& y) { return x + -y; }
    friend Binary64Ball operator*(const Binary64Ball& x, const Binary64Ball& y) {
        const double v = x.middle * y.middle;
        return {v,
                inflated(std::fabs(x.middle) * y.radius +
                         (std::fabs(y.middle) + y.radius) * x.radius + unit * std::fabs(v) + tiny)};
    }
    friend Binary64Ball operator/(const Binary64Ball& x, const Binary64Ball& y) {
        const double v = x.middle / y.middle;
        const double least = std::fabs(y.middle) - y.radius;
        return {v, least > 0 ? inflated((x.radius + std::fabs(v) * y.radius) / least +
                                        unit * std::fabs(v) + tiny)
                             : HUGE_VAL};
    }
};

/// True if the thread rounds to nearest, without extended precision of intermediate results.
[[nodiscard]] inline bool has_binary64_balls() {
    return FLT_EVAL_METHOD == 0 && std::fegetround() == FE_TONEAREST;
}

/// The root of a number that is known not to be negative:
/// |sqrt(X) - sqrt(x)| <= min(|X - x|/sqrt(x), sqrt|X - x|).
[[nodiscard]] inline Binary64Ball sqrt(const Binary64Ball& x) {
    if (!(x.middle > 0)) {
        return {0, Binary64Ball::inflated(std::sqrt(x.radius)) + Binary64Ball::tiny};
    }
    const double v = std::sqrt(x.middle);
    return {v, Binary64Ball::inflated(std::fmin(x.radius / v, std::sqrt(x.radius)) +
                                      Binary64Ball::unit * v + Binary64Ball::tiny)};
}

[[nodiscard]] inline Binary64Ball hypot(const Binary64Ball& x, const Binary64Ball& y) {
    return sqrt(x * x + y * y);
}

/// ln x for x > 0.
[[nodiscard]] inline Binary64Ball log(const Binary64Ball& x) {
    constexpr double root_half = 0.70710678118654752;
    constexpr double log_two = 0.69314718055994531;
    const double least = x.middle - x.radius;
    if (!(least > 0) || !std::isfinite(x.middle)) {
        return {0, HUGE_VAL};
    }
    int exponent = 0;
    double m = std::frexp(x.middle, &exponent);
    if (m < root_half) {
        m *= 2;
        --exponent;
    }
    // ln m = 2 s (1 + s^2/3 + s^4/5 + ...), s = (m - 1)/(m + 1), |s| < 0.1716. The terms from
    // s^22/23 on are less than 2^-60 of the sum; m - 1 is exact, and the relative error of the sum
    // is at most 2^-49: that of s is below 2^-51, and each further operation has one of 2^-53, but
    // those of the inner terms are multiplied by s^2 < 0.03.
    const double s = (m - 1) / (m + 1);
    const double z = s * s;
    double sum = 1.0 / 21;
    for (int k = 19; k >= 1; k -= 2) {
        sum = 1.0 / k + z * sum;
    }
    const double of_m = 2 * s * sum;
    const double of_power = exponent * log_two;
    const double v = of_m + of_power;
    return {v, Binary64Ball::inflated(0x1p-49 * (std::fabs(of_m) + std::fabs(of_power)) +
                                      Binary64Ball::unit * std::fabs(v) + x.radius / least)};
}

/// The angle of x + i y, between -pi and pi; unknown if the sign of y decides which of both it is
/// near, or at 0.
[[nodiscard]] inline Binary64Ball atan2(const Binary64Ball& y, const Binary64Ball& x) {
    constexpr double pi = 3.1415926535897932;
    const double across = std::fabs(y.middle);
    const double along = std::fabs(x.middle);
    const double size = std::fmax(across, along);
    const double error = x.radius + y.radius;
    if (!(error < size / 2) || !std::isfinite(size) || (x.middle < 0 && across <= y.radius)) {
        return {0, HUGE_VAL};
    }
    const bool steep = across > along;
    const double least = steep ? along : across;
    // The angle from the nearer axis is arctan t, or pi/4 + arctan((t - 1)/(t + 1)).
    const bool turned = least > 0.4142135623730950 * size;
    const double t = turned ? (least - size) / (least + size) : least / size;
    // arctan t = t (1 - t^2/3 + t^4/5 - ...), t^2 < 0.1716. The terms from t^48/49 on are less than
    // 2^-64 of the sum, and its relative error is at most 2^-49, as in log().
    const double z = t * t;
    double sum = -1.0 / 47;
    double sign = 1;
    for (int k = 45; k >= 1; k -= 2) {
        sum = sign / k + z * sum;
        sign = -sign;
    }
    double v = t * sum;
    // Each of at most three sums with a multiple of pi/4 has an error below 2^-50.
    double rounding = 0x1p-49 * std::fabs(v) + Binary64Ball::tiny;
    if (turned || steep || x.middle < 0) {
        v = turned ? pi / 4 + v : v;
        v = steep ? pi / 2 - v : v;
        v = x.middle < 0 ? pi - v : v;
        rounding += 0x1p-47;
    }
    // The angle changes by at most arcsin(error/size) <= pi/2 error/size.
    return {y.middle < 0 ? -v : v,
            Binary64Ball::inflated(rounding + 1.5707963267948968 * (error / size))};
}

} // namespace edgeproof
