// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/quadrature/integrand_ref.hpp"
#include "edgeproof/quadrature/quadrature_value.hpp"

#include <cstddef>

namespace edgeproof::quadrature {

/// What a quadrature returns: never a value alone. `estimate` is the difference of the last two
/// levels relative to the integral of |f|. It is an estimate, not a bound: a narrow feature that
/// falls between the nodes is invisible to it, which is why callers split at every knot and apex.
template <class R> struct QuadratureResult {
    R value;
    typename QuadratureValue<R>::Scalar estimate;
    std::size_t evaluations = 0;
    bool converged = false;

    /// Takes in the integral over another interval.
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
    /// Stop when two levels agree to so many digits of the integral of |f|; 0: to 100 units of
    /// roundoff.
    unsigned target_digits = 0;
    /// Stop, not converged, at a level from 8 on that has less than five digits and is hardly
    /// nearer than the one two before. The digits of an integrand that is analytic but for its ends
    /// double from level to level; one that gains next to none has a kink inside or no finite
    /// integral, and no finer level converges.
    bool gives_up = false;
    /// Stop where the digits that the last three levels gained say that this one has those asked
    /// for (LevelEstimate's rule), a level before two agree to them; `estimate` is then what is
    /// foreseen. For an integrand whose digits are checked by another route.
    bool foresees = false;
};

/// Tanh-sinh quadrature (Takahasi & Mori 1974) of f over the unit interval, 50 digits or 500.
///
/// f is called as f(lo, hi) with lo + hi = 1, *both* distances exact to the last digit: near an
/// end point the small one is what the integrand must be written in. End-point singularities up
/// to d^(-1/2) (any logarithm times) cost no digits. R is T or series::Series<T>.
///
/// The working precision is that of the calling thread; node tables are per thread and precision.
/// Not converging by `last_level` is said in the result, never silent.
template <Arithmetic T, class R>
[[nodiscard]] QuadratureResult<R> tanh_sinh_of(const IntegrandRef<T, R>& f,
                                               const QuadratureOptions& options = {});
template <Arithmetic T, class F>
[[nodiscard]] auto tanh_sinh(const F& f, const QuadratureOptions& options = {}) {
    using R = IntegrandResult<T, F>;
    return tanh_sinh_of<T, R>(IntegrandRef<T, R>(f), options);
}

} // namespace edgeproof::quadrature
