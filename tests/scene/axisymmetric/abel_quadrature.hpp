// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/quadrature/gauss_legendre.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace edgeproof::validation {

/// p, P and delta of an axisymmetric contact from g' alone (`sneddon1965`), by Gauss-Legendre rules
/// at the thread's working precision. No closed form of h or h' is used:
///   delta = integral of a g'(r)/sqrt(a^2 - r^2) dr over 0 < r < a,
///   P = 2 E* times the integral of r^2 g'(r)/sqrt(a^2 - r^2) dr,
///   p(r) = E*/pi times the integral of h'(s)/sqrt(s^2 - r^2) ds over r < s < a,
///   h'(s) = integral of (r g')'/sqrt(s^2 - r^2) dr, and v/sqrt(s^2 - v^2) for a unit jump at v.
/// Over r the variable is sqrt(s - r). Over s it is w = sqrt(s^2 - A^2), A = r or a knot: each
/// integrand is analytic in it, and the intervals of w are halved towards 0 until the singularities
/// at w = +-i sqrt(A^2 - v^2) are as far away as the interval is long. The number of nodes follows
/// from the ellipse that excludes them (`trefethen2013`, theorem 19.3); nothing is adapted to the
/// values. Slopes that are not linear are sampled with twice the nodes, and must be analytic near
/// their pieces.
class AbelQuadrature {
public:
    /// @param scene an axisymmetric scene
    /// @param a the radius of the contact (length)
    /// @param digits the digits aimed at; the working precision must have spare ones for the
    /// differences of neighbouring places
    AbelQuadrature(const scene::Scene& scene, Real a, unsigned digits);

    /// Replaces h', for slopes that are not power laws, by polynomials that interpolate the
    /// integrals in sqrt(s^2 - v^2), v the knot below s, between the knots: many pressures take a
    /// tenth of the time. The ellipse that excludes the singularities gives the number of nodes
    /// (`trefethen2013`, theorem 8.2).
    void tabulate();

    [[nodiscard]] Real approach() const; ///< delta (length)
    [[nodiscard]] Real force() const;    ///< P
    /// p (stress) at the distance u (length) from the edge; a power law needs u < a.
    [[nodiscard]] Real pressure(const Real& u) const;

private:
    /// h'(s) beyond the knot below A, s^2 = A^2 + w2; without the jump of the knots from `except`
    /// on.
    [[nodiscard]] Real h_rate(const Real& A, const Real& w2) const;
    [[nodiscard]] Real h_rate_by_integrals(const Real& A, const Real& w2, std::size_t except) const;
    /// h' between two knots: polynomials in the distance from the middle of each part of 0 < y <
    /// end, where the octaves end, end/2, ..., and the rest, have equal parts each.
    struct RateTable {
        Real end;
        int octaves = 0;
        std::vector<std::vector<Real>> parts; ///< from the last octave inwards
    };
    [[nodiscard]] Real nearest_singularity(const Real& A, const Real& from_r2,
                                           const Real& width2) const;
    template <class F>
    [[nodiscard]] Real over_slope(const std::vector<Real>& beyond, const Real& s, const F& f) const;
    [[nodiscard]] Real over_width(const Real& A, const Real& width2, const Real& r2) const;

    contact::SlopeIn<Real> slope_;
    Real a_;
    Real modulus_;
    std::vector<Real> knots_;   ///< from the axis outwards, the first is 0
    std::vector<Real> jump_at_; ///< jump times knot
    std::size_t first_piece_;   ///< the piece that begins at the axis
    std::optional<Real> power_; ///< m of a power law
    Real factor_ = 0;           ///< C of a power law
    Real kappa_ = 0;            ///< h = kappa s^(m + 1)
    quadrature::GaussLegendreRule inner_;
    quadrature::GaussLegendreRule outer_;
    std::size_t table_nodes_;
    std::vector<RateTable> tables_; ///< by knot; empty before tabulate()
};

/// The n-th coefficient of p/sqrt(u) in powers of u, from pressures p(u) at u = delta, 2 delta,
/// ..., where delta is 1e-12 of the radius of convergence, by Newton's divided differences (DLMF
/// 3.3(iv)), expanded about u = 0.
/// @param n the number of the coefficient
/// @param digits the digits aimed at
/// @param radius the radius of convergence (length) at a working precision of `digits`
/// @param pressure p (stress) at u (length); it is called at difference_digits(n, digits) digits
[[nodiscard]] Real coefficient_by_differences(std::size_t n, unsigned digits, const Real& radius,
                                              const std::function<Real(const Real& u)>& pressure);
[[nodiscard]] unsigned difference_digits(std::size_t n, unsigned digits);

} // namespace edgeproof::validation
