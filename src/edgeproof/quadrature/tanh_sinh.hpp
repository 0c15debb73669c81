// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace edgeproof::quadrature {

/// An integrand over an interval, as f(lo, hi) with the distances from both ends, where *both* have
/// all their digits: near an end the integrand must be written in the small one.
using Integrand = std::function<Real(const Real& lo, const Real& hi)>;

/// The result of a quadrature. `estimate` is the difference of the last two levels relative to the
/// integral of |f|. It is an estimate, not a bound: it does not see a narrow feature between the
/// nodes. Therefore callers split the interval at every knot and apex.
struct QuadratureResult {
    Real value;
    Real estimate;
    std::size_t evaluations = 0;
    bool converged = false;

    /// Adds the integral over another interval.
    void add(const QuadratureResult& other);
};

struct QuadratureOptions {
    int last_level = 14;
    /// The quadrature stops when two levels agree to this many digits of the integral of |f|; 0: to
    /// 100 units of roundoff.
    unsigned target_digits = 0;
};

/// Tanh-sinh quadrature (`takahasi-mori1974`) of f over the unit interval, at any precision.
/// End-point singularities up to d^(-1/2), also times a logarithm, cost no digits.
///
/// The working precision is that of the calling thread; node tables are kept for each thread and
/// precision. If the quadrature does not converge by `last_level`, `converged` is false.
[[nodiscard]] QuadratureResult tanh_sinh(const Integrand& f, const QuadratureOptions& options = {});

/// The integral of f over an interval of length L, where f may have singularities *outside*, at
/// these distances from the ends (0: none known). A near one makes tanh-sinh slow
/// (`trefethen-weideman2014`) and is mapped away; the interval is halved if both are near. The
/// result has the unit of f times that of `length`.
[[nodiscard]] QuadratureResult integrate_near(const Integrand& f, const Real& length,
                                              const Real& beyond_lo, const Real& beyond_hi,
                                              const QuadratureOptions& options = {});

/// The integral over consecutive intervals given by their lengths. The neighbouring cuts count as
/// singularities beyond an interval's ends; `beyond_first` and `beyond_last` are the distances for
/// the outermost ends (0: no singularity there). f is called as f(i, lo, hi) on interval i.
[[nodiscard]] QuadratureResult
integrate_pieces(const std::function<Real(std::size_t, const Real& lo, const Real& hi)>& f,
                 const std::vector<Real>& lengths, const Real& beyond_first,
                 const Real& beyond_last, const QuadratureOptions& options = {});

} // namespace edgeproof::quadrature
