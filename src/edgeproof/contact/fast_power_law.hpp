// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/fast_pressure.hpp"
#include "edgeproof/contact/real_power.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace edgeproof {

/// The pressure of a power law, P'(a)/pi times I_m(q), q = |x|/a (moore-hills.tex
/// eqn:MossakovskiiPressure): I_m is the integral of s^m/sqrt(s^2 - q^2) over q < s < 1. By
/// w^2 = s^2 - q^2 it is that of (q^2 + w^2)^((m-1)/2) over 0 < w < sqrt(1 - q^2), without a
/// singularity at an end, and far from any while q is not small. Near the apex it is
/// q^n times a constant of the contact, and a smooth function of q^2:
///   1/n - (1/2) integral of t^(-n/2) q^2/(r (1 + r)) over 0 < t < 1,  r = sqrt(1 - q^2 t),
/// 0 < n < 2, from where m I_m = sqrt(1 - q^2) + (m - 1) q^2 I_{m-2} leads up to m. That integral
/// has no power of the point in it: t^(-n/2) is in the weights of the rule.
class FastPowerLaw {
public:
    /// At the thread's working precision; `rate` is P'(a).
    FastPowerLaw(const Exact& m, Real rate, Real a, unsigned digits, FastPressure::Rule rule);
    [[nodiscard]] RoutedPressure<Real> operator()(const Point<Real>& at);
    /// Digits that cancel between the parts near the apex, for m near an even number.
    [[nodiscard]] static unsigned lost_digits(const Exact& m);

private:
    struct Share {
        Real value;
        double ln_error = -1e300; ///< absolute
        std::size_t nodes = 0;
        bool converged = true;
    };
    /// Nodes for w: c = 1 - (w/W)^2, and weights over 0 < w/W < 1.
    struct MiddleNodes {
        std::vector<Real> c;
        std::vector<Real> weight;
    };
    /// Nodes for t, with t^(-n/2) in the weights: exact for polynomials of their number.
    struct ApexNodes {
        std::vector<Real> t;
        std::vector<Real> weight;
        double ln_size; ///< of the sum of |weight|, and of the weight's integral
    };
    [[nodiscard]] Share by_gauss(const Real& root, const Real& y, double q);
    [[nodiscard]] Share by_tanh_sinh(const Real& root, const Real& y);
    [[nodiscard]] Share by_tanh_sinh_far(const Real& q);
    [[nodiscard]] Share near_apex(const Real& root, const Real& q);
    [[nodiscard]] Share base_near_apex(const Real& root, const Real& q, const Real& square);
    [[nodiscard]] double gauss_nodes_needed(double q, double y, double* ln_error,
                                            std::size_t n) const;
    [[nodiscard]] const MiddleNodes& gauss(std::size_t n);
    [[nodiscard]] const MiddleNodes& level(int level);
    [[nodiscard]] const ApexNodes& apex(std::size_t n);
    void add_powers(Real& sum, const MiddleNodes& nodes, const Real& y);

    Exact m_;
    Real m_real_;
    double m_double_;
    Real scale_; ///< P'(a)/pi
    Real a_;
    unsigned digits_;
    FastPressure::Rule rule_;
    RealPower power_;     ///< to (m - 1)/2
    unsigned long steps_; ///< m = n + 2 steps
    std::optional<Rational> n_exact_;
    Real n_;
    double n_double_;
    Real apex_factor_; ///< of q^n
    std::map<std::size_t, MiddleNodes> gauss_;
    std::map<int, MiddleNodes> levels_;
    std::map<std::size_t, ApexNodes> apex_;
    Real below_;
    Real above_;
};

} // namespace edgeproof
