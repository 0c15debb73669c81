// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/complex_box.hpp"
#include "edgeproof/precision/ball/magnitude.hpp"

#include <cstddef>
#include <functional>
#include <vector>

/// Integrals over 0 < t < 1 by Arb's rigorous integration (`johansson2018`), and the functions with
/// which their integrands are written.
namespace edgeproof::contact {

/// The precision and the accuracy of an integral over 0 < t < 1.
struct IntegralGoal {
    long bits;     ///< working precision
    long accuracy; ///< wanted, in bits
    Ball scale;  ///< the size of the integrand, or 0: that in the middle; the absolute tolerance is
                 ///< 2^-(accuracy + 64) of it
    Ball radius; ///< of convergence of the series (length); only its size matters
};

/// With a smaller accuracy (bits) the parameters of an integral are wide balls.
constexpr long narrow_integral_bits = 64;

/// The principal root and arctangent (DLMF 4.2.29, 4.23.26); not finite where the box may meet a
/// cut, so that they are holomorphic where they are finite.
[[nodiscard]] Box principal_root(const Box& x);
[[nodiscard]] Box principal_arctangent(const Box& x);
/// A box that is not finite.
[[nodiscard]] Box unknown_box(long bits);

/// The integral of a function that is holomorphic near 0 < t < 1, or whose value is not finite
/// where it is not. `integral_of` is the real part of it.
[[nodiscard]] Ball integral_of(const std::function<Box(const Box& t)>& f, const IntegralGoal& goal);
/// The same for complex values, inside the integrand of another integral: after an interruption the
/// result is not finite, and nothing is thrown, because no exception may pass through Arb.
[[nodiscard]] Box inner_integral_of(const std::function<Box(const Box& t)>& f,
                                    const IntegralGoal& goal);

/// True for a parameter that is not a range.
[[nodiscard]] bool is_narrow(const Box& x);
/// The same with the full accuracy, if the parameters of f are narrow; else the enclosures of f
/// over eight parts of 0 < t < 1.
[[nodiscard]] Box integral_or_range(const std::function<Box(const Box& t)>& f, bool narrow,
                                    long bits);

/// The integral along the real axis between two places that may be wide balls: Arb integrates
/// between their midpoints, and the radius of each adds the values over that ball. f encloses its
/// values over real boxes; over other ones it is holomorphic, or not finite.
[[nodiscard]] Box integral_between(const std::function<Box(const Box& t)>& f, const Ball& from,
                                   const Ball& to, long accuracy, long bits);

/// The first Taylor coefficients at 0 of a function that is real on the real axis and at most
/// `most` in size for |z| <= rho, by the trapezoidal rule on the circle |z| = q rho: with n points
/// the error of a_k is at most most/rho^k q^n/(1 - q^n) (`trefethen-weideman2014`, theorem 2.1).
[[nodiscard]] std::vector<Ball> taylor_on_circle(const std::function<Box(const Box& z)>& f,
                                                 const Ball& most, const Ball& rho,
                                                 const Rational& q, std::size_t terms);

/// f(x + z + t) in powers of t, `order` coefficients, for every z of a box, from the first Taylor
/// coefficients c of f about x. Each omitted one, of (z + t)^j, is at most bound/radius^j, by
/// Cauchy's estimate for example (docs/curved-slopes.md, "Intervals and disks"). Not finite if z
/// reaches too far.
[[nodiscard]] std::vector<Box> taylor_at(std::vector<Box> c, const Ball& radius,
                                         const Magnitude& bound, const Box& z, std::size_t order);

/// Returns the bits of accuracy that are useful in an integral whose parameters have `known` bits;
/// exact parameters have more than any other number.
[[nodiscard]] long useful_accuracy(long known, long bits);

} // namespace edgeproof::contact
