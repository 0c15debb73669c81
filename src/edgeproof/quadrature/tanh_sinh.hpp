// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/arithmetic.hpp"

#include <cstddef>
#include <memory>
#include <type_traits>

namespace edgeproof::quadrature {

/// A reference to an integrand f(lo, hi), from two T to R. Rules that take it are compiled once for
/// each T and R, not once for every integrand. The integrand must outlive it.
template <class T, class R> class IntegrandRef {
public:
    template <class F>
    requires(!std::is_same_v<std::remove_cvref_t<F>, IntegrandRef>)
        IntegrandRef(const F& f) // NOLINT(google-explicit-constructor): converts any integrand
        : object_(std::addressof(f)), call_([](const void* object, const T& lo, const T& hi) {
              return R((*static_cast<const F*>(object))(lo, hi));
          }) {}

    R operator()(const T& lo, const T& hi) const { return call_(object_, lo, hi); }

private:
    const void* object_;
    R (*call_)(const void*, const T&, const T&);
};

/// The type of the values of an integrand over T.
template <class T, class F>
using IntegrandResult = std::remove_cvref_t<std::invoke_result_t<const F&, const T&, const T&>>;

/// The operations of a rule on the values that it adds.
template <class R> struct QuadratureValue;

template <Arithmetic T> struct QuadratureValue<T> {
    using Scalar = T;
    static T magnitude(const T& f) {
        using std::abs;
        return abs(f);
    }
    static void add(T& sum, const T& weight, const T& f) { sum += weight * f; }
    static void add_magnitude(T& sum, const T& weight, const T& f) {
        using std::abs;
        sum += abs(T(weight * f));
    }
    /// |x - y| in units of `scale`.
    static T distance(const T& x, const T& y, const T& scale) {
        using std::abs;
        const T d = abs(T(x - y));
        return scale > T(0) ? T(d / scale) : d;
    }
    static bool finite(const T& f) {
        using std::isfinite;
        return isfinite(f);
    }
};

/// The result of a quadrature. `estimate` is the difference of the last two levels relative to the
/// integral of |f|. It is an estimate, not a bound: it does not see a narrow feature between the
/// nodes. Therefore callers split the interval at every knot and apex.
template <class R> struct QuadratureResult {
    R value;
    typename QuadratureValue<R>::Scalar estimate;
    std::size_t evaluations = 0;
    bool converged = false;

    /// Adds the integral over another interval.
    void add(const QuadratureResult& other) {
        value += other.value;
        evaluations += other.evaluations;
        converged = converged && other.converged;
        if (other.estimate > estimate) {
            estimate = other.estimate;
        }
    }
};

struct QuadratureOptions {
    int first_level = 3;
    int last_level = 14;
    /// The quadrature stops when two levels agree to this many digits of the integral of |f|; 0: to
    /// 100 units of roundoff.
    unsigned target_digits = 0;
    /// If true, the quadrature stops, not converged, at a level of 8 or more that has less than
    /// five digits and is hardly nearer than the level two before it. For an integrand that is
    /// analytic except at its ends, the digits double at each level. An integrand whose digits
    /// hardly grow has a kink inside or no finite integral, and no higher level converges.
    bool gives_up = false;
    /// If true, the quadrature stops one level earlier, where the growth of the digits over the
    /// last three levels (growth_of_level) predicts that this level has the required digits;
    /// `estimate` is then the prediction. For integrands whose digits are checked by another route.
    bool foresees = false;
};

/// Tanh-sinh quadrature (`takahasi-mori1974`) of f over the unit interval, at any precision.
///
/// f is called as f(lo, hi) with lo + hi = 1, where *both* distances have all their digits: near an
/// end point the integrand must be written in the small one. End-point singularities up to
/// d^(-1/2), also times a logarithm, cost no digits.
///
/// The working precision is that of the calling thread; node tables are kept for each thread and
/// precision. If the quadrature does not converge by `last_level`, `converged` is false.
template <Arithmetic T, class R>
[[nodiscard]] QuadratureResult<R> tanh_sinh_of(const IntegrandRef<T, R>& f,
                                               const QuadratureOptions& options = {});
template <Arithmetic T, class F>
[[nodiscard]] auto tanh_sinh(const F& f, const QuadratureOptions& options = {}) {
    using R = IntegrandResult<T, F>;
    return tanh_sinh_of<T, R>(IntegrandRef<T, R>(f), options);
}

} // namespace edgeproof::quadrature
