// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/elementary/elementary.hpp"
#include "edgeproof/precision/error.hpp"

#include <cmath>
#include <vector>

namespace edgeproof::series {

/// The values of f at two points, and the quotient (f(s) - f(x))/(s - x) *without* the subtraction:
/// every operation computes the quotient by a formula that has no cancellation as s -> x, where it
/// becomes f'(x). The regularised principal value (docs/pressure.md, "The singular integral, and
/// how its pole is taken out") needs this, since the nodes of the quadrature come very near to x.
/// The units are those of f and of its derivative.
template <class T> class DividedDifference {
public:
    /// The function f(z) = z at x and s = x + delta (delta given exactly).
    static DividedDifference variable(const T& x, const T& delta) {
        return {x, T(x + delta), T(1), delta};
    }
    static DividedDifference constant(const T& c, const T& delta) { return {c, c, T(0), delta}; }
    DividedDifference(T at_x, T at_s, T quotient, T delta)
        : x(at_x), s(at_s), q(quotient), delta_(delta) {}

    T x; ///< f at the first point
    T s; ///< f at the second point
    T q; ///< (f(s) - f(x))/(s - x)

    [[nodiscard]] const T& delta() const noexcept { return delta_; }
    /// f(s) - f(x)
    [[nodiscard]] T difference() const { return T(q * delta_); }

    friend DividedDifference operator-(const DividedDifference& f) {
        return {T(-f.x), T(-f.s), T(-f.q), f.delta_};
    }
    friend DividedDifference operator+(const DividedDifference& f, const DividedDifference& g) {
        return {T(f.x + g.x), T(f.s + g.s), T(f.q + g.q), f.delta_};
    }
    friend DividedDifference operator-(const DividedDifference& f, const DividedDifference& g) {
        return {T(f.x - g.x), T(f.s - g.s), T(f.q - g.q), f.delta_};
    }
    // Leibniz's rule: (f g)[x, s] = f(x) g[x, s] + f[x, s] g(s)
    friend DividedDifference operator*(const DividedDifference& f, const DividedDifference& g) {
        return {T(f.x * g.x), T(f.s * g.s), T(f.x * g.q + f.q * g.s), f.delta_};
    }
    friend DividedDifference operator/(const DividedDifference& f, const DividedDifference& g) {
        if (g.x == T(0) || g.s == T(0)) {
            throw DomainError("division by zero");
        }
        const T quotient = f.x / g.x;
        return {quotient, T(f.s / g.s), T((f.q - quotient * g.q) / g.s), f.delta_};
    }

private:
    T delta_;
};

/// sqrt: (sqrt s - sqrt x)/(s - x) = 1/(sqrt s + sqrt x).
template <class T> [[nodiscard]] DividedDifference<T> sqrt(const DividedDifference<T>& f) {
    using std::sqrt;
    const T rx = sqrt(f.x);
    const T rs = sqrt(f.s);
    const T sum = rx + rs;
    return {rx, rs, sum == T(0) ? T(0) : T(f.q / sum), f.delta()};
}

/// (F(f(s)) - F(f(x)))/(s - x) from the difference of F; from the derivative of F if s = x.
template <class T>
[[nodiscard]] DividedDifference<T> from_difference(const DividedDifference<T>& f, T at_x, T at_s,
                                                   const T& difference, const T& derivative) {
    const bool same = f.delta() == T(0) || f.difference() == T(0);
    return {at_x, at_s, same ? T(derivative * f.q) : T(difference / f.delta()), f.delta()};
}

/// True if f(s)/f(x) - 1 is so large that the subtraction loses no digits.
template <class T> [[nodiscard]] bool far_apart(const T& ratio) {
    return ratio < T(-1) / T(2) || ratio > T(1);
}

template <class T> [[nodiscard]] DividedDifference<T> exp(const DividedDifference<T>& f) {
    using std::exp;
    using std::expm1;
    const T ex = exp(f.x);
    return from_difference<T>(f, ex, exp(f.s), T(ex * expm1(f.difference())), ex);
}

template <class T> [[nodiscard]] DividedDifference<T> log(const DividedDifference<T>& f) {
    using std::log;
    using std::log1p;
    const T lx = log(f.x);
    const T ls = log(f.s);
    const T ratio = f.difference() / f.x;
    // If the values are far apart, the plain difference does not cancel, but 1 + ratio would.
    const T difference = far_apart(ratio) ? T(ls - lx) : T(log1p(ratio));
    return from_difference<T>(f, lx, ls, difference, T(T(1) / f.x));
}

/// f^p for f > 0 and a constant p.
template <class T>
[[nodiscard]] DividedDifference<T> pow(const DividedDifference<T>& f, const T& p) {
    using std::expm1;
    using std::log1p;
    using std::pow;
    const T px = pow(f.x, p);
    const T ratio = f.difference() / f.x;
    const T ps = pow(f.s, p);
    const T difference = far_apart(ratio) ? T(ps - px) : T(px * expm1(T(p * log1p(ratio))));
    return from_difference<T>(f, px, ps, difference, T(p * px / f.x));
}
template <class T>
[[nodiscard]] DividedDifference<T> pow(const DividedDifference<T>& f,
                                       const DividedDifference<T>& p) {
    if (!(p.q == T(0))) {
        return exp(p * log(f));
    }
    return pow(f, p.x);
}

template <class T>
[[nodiscard]] DividedDifference<T> pow_int(const DividedDifference<T>& f, long n) {
    return power_by_squaring(DividedDifference<T>::constant(T(1), f.delta()), f, n);
}

/// sin and cos by the difference as a product (DLMF 4.21(i)).
template <class T> [[nodiscard]] DividedDifference<T> sin(const DividedDifference<T>& f) {
    using std::cos;
    using std::sin;
    const T half = f.difference() / T(2);
    return from_difference<T>(f, sin(f.x), sin(f.s), T(T(2) * cos(T(f.x + half)) * sin(half)),
                              cos(f.x));
}
template <class T> [[nodiscard]] DividedDifference<T> cos(const DividedDifference<T>& f) {
    using std::cos;
    using std::sin;
    const T half = f.difference() / T(2);
    return from_difference<T>(f, cos(f.x), cos(f.s), T(T(-2) * sin(T(f.x + half)) * sin(half)),
                              T(-sin(f.x)));
}
template <class T> [[nodiscard]] DividedDifference<T> tan(const DividedDifference<T>& f) {
    return sin(f) / cos(f);
}
/// atan s - atan x = atan((s - x)/(1 + x s)) if 1 + x s > 0 (DLMF 4.24(iii)).
template <class T> [[nodiscard]] DividedDifference<T> atan(const DividedDifference<T>& f) {
    using std::atan;
    const T product = T(1) + f.x * f.s;
    const T ax = atan(f.x);
    const T as = atan(f.s);
    const T difference = product > T(0) ? T(atan(T(f.difference() / product))) : T(as - ax);
    return from_difference<T>(f, ax, as, difference, T(T(1) / (T(1) + f.x * f.x)));
}
/// asin f = atan(f/sqrt(1 - f^2)).
template <class T> [[nodiscard]] DividedDifference<T> asin(const DividedDifference<T>& f) {
    const auto one = DividedDifference<T>::constant(T(1), f.delta());
    return atan(f / sqrt((one - f) * (one + f)));
}
/// sinh and cosh by exponentials (DLMF 4.28).
template <class T> [[nodiscard]] DividedDifference<T> sinh(const DividedDifference<T>& f) {
    const auto two = DividedDifference<T>::constant(T(2), f.delta());
    return (exp(f) - exp(-f)) / two;
}
template <class T> [[nodiscard]] DividedDifference<T> cosh(const DividedDifference<T>& f) {
    const auto two = DividedDifference<T>::constant(T(2), f.delta());
    return (exp(f) + exp(-f)) / two;
}
template <class T> [[nodiscard]] DividedDifference<T> tanh(const DividedDifference<T>& f) {
    return sinh(f) / cosh(f);
}

/// acos f = pi/2 - asin f.
template <class T> [[nodiscard]] DividedDifference<T> acos(const DividedDifference<T>& f) {
    using std::acos;
    const DividedDifference<T> g = asin(f);
    return {T(acos(f.x)), T(acos(f.s)), T(-g.q), f.delta()};
}
/// asinh s - asinh x = asinh((s - x)(s + x)/(s sqrt(1 + x^2) + x sqrt(1 + s^2))) (DLMF 4.38(iii))
/// for s and x of the same sign; otherwise the difference does not cancel.
template <class T> [[nodiscard]] DividedDifference<T> asinh(const DividedDifference<T>& f) {
    using std::asinh;
    using std::sqrt;
    const T rx = sqrt(T(T(1) + f.x * f.x));
    const T rs = sqrt(T(T(1) + f.s * f.s));
    const T ax = asinh(f.x);
    const T as = asinh(f.s);
    const T sum = f.s * rx + f.x * rs;
    const bool one_sign = f.x * f.s > T(0);
    const T difference = one_sign ? T(asinh(T(f.difference() * (f.s + f.x) / sum))) : T(as - ax);
    return from_difference<T>(f, ax, as, difference, T(T(1) / rx));
}
/// acosh f = log(f + sqrt(f^2 - 1)) (DLMF 4.37(iv)).
template <class T> [[nodiscard]] DividedDifference<T> acosh(const DividedDifference<T>& f) {
    const auto one = DividedDifference<T>::constant(T(1), f.delta());
    return log(f + sqrt((f - one) * (f + one)));
}
/// atanh s - atanh x = atanh((s - x)/(1 - x s)) (DLMF 4.38(iii)).
template <class T> [[nodiscard]] DividedDifference<T> atanh(const DividedDifference<T>& f) {
    using std::atanh;
    const T difference = atanh(T(f.difference() / (T(1) - f.x * f.s)));
    return from_difference<T>(f, T(atanh(f.x)), T(atanh(f.s)), difference,
                              T(T(1) / ((T(1) - f.x) * (T(1) + f.x))));
}
/// For points of opposite signs, |s| - |x| is s + x or -(s + x), with the accuracy of these two.
template <class T> [[nodiscard]] DividedDifference<T> abs(const DividedDifference<T>& f) {
    if (f.x < T(0) && !(f.s > T(0))) {
        return -f;
    }
    if (f.s < T(0)) {
        return {f.x, T(-f.s), T(-(f.x + f.s) / f.delta()), f.delta()};
    }
    if (f.x < T(0)) {
        return {T(-f.x), f.s, T((f.x + f.s) / f.delta()), f.delta()};
    }
    return f;
}
template <Arithmetic T> [[nodiscard]] DividedDifference<T> gamma(const DividedDifference<T>& f) {
    const std::vector<T> at = gamma_taylor_in<T>(f.x, 2);
    const T difference = gamma_difference_in<T>(f.x, f.difference());
    return from_difference<T>(f, at[0], T(at[0] + difference), difference, at[1]);
}

} // namespace edgeproof::series
