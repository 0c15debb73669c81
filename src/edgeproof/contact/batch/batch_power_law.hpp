// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/batch/batch_pressure.hpp"
#include "edgeproof/contact/batch/batch_sums.hpp"
#include "edgeproof/quadrature/gauss_legendre.hpp"

#include <cstddef>
#include <map>
#include <vector>

namespace edgeproof::contact {

/// The pressure of a power law, p = (P'(a)/pi) I_m(q) with q = |x|/a, where I_m is the integral of
/// s^m/sqrt(s^2 - q^2) over q < s < 1 (eqn:MossakovskiiPressure; docs/pressure.md, "Closed form:
/// power laws"). The nodes are shared by all points, and no power is computed at a node except in
/// the last formula. The recurrence
///   m I_m = W + (m - 1) q^2 I_{m-2},  W = sqrt(1 - q^2),
/// reduces m to 0 <= n < 2. Away from the apex, with b = (1 - n)/2, Euler's integral (DLMF 15.6.1)
/// gives
///   I_n/W = 1 + (2b/3) mean of 1/(q^2/W^2 + 1 - t),  weight t^b (1 - t)^(n/2).
/// Near the apex (DLMF 15.8.4, the sum written as an integral)
///   I_n = C q^n + 1/n - (mean of q^2/(r (1 + r)))/(2 - n),  weight t^(-n/2), r = sqrt(1 - q^2 t).
/// The weights of the rules include these weight functions. For exponents above some hundreds
///   I_m = integral of (q^2 + w^2)^((m-1)/2) over 0 < w < W.
class BatchPowerLaw {
public:
    /// At the working precision of the thread.
    /// @param m exponent of the power law
    /// @param rate P'(a) (force/length^2)
    /// @param a half-length of the contact (length)
    /// @param digits relative accuracy wanted, in decimal digits
    /// @param rule quadrature rule
    BatchPowerLaw(const Exact& m, const Real& rate, const Real& a, unsigned digits,
                  BatchPressure::Rule rule);
    /// Returns p (stress) with an estimate of its error.
    /// @param at point inside the contact (length)
    [[nodiscard]] RoutedPressure<Real> operator()(const Point<Real>& at);
    /// Returns the number of digits that cancel near the apex if m is close to an even number.
    [[nodiscard]] static unsigned lost_digits(const Exact& m);

private:
    struct Share {
        Real value;
        double ln_error = -1e300; ///< ln of the absolute error
        std::size_t nodes = 0;
        bool converged = true;
    };
    /// The nodes of a sum of weight/(from + gap), or of weight times a power of 1 - from y.
    struct Nodes {
        std::vector<Real> from;
        std::vector<Real> weight;
    };
    struct Choice {
        std::size_t n;
        double rho;  ///< Bernstein ellipse of the rule
        double ln_M; ///< ln of a bound of the integrand on it
    };
    /// Returns I_m by the recurrence; `base` returns I_n.
    template <class Base> [[nodiscard]] Share lifted(const Base& base);
    /// Returns I_n by Euler's integral with a Gauss rule.
    [[nodiscard]] Share edge_by_rule(const Choice& choice);
    /// Replaces the mean by W (1 + (2b/3) times the mean).
    void close_edge(Share& share);
    /// Returns I_n by Euler's integral with tanh-sinh.
    [[nodiscard]] Share edge_by_levels();
    /// Returns I_n near the apex with a Gauss rule.
    [[nodiscard]] Share apex_by_rule();
    /// Returns I_m as the integral of a power; `q` is |x|/a.
    [[nodiscard]] Share powers_by_rule(double q);
    /// The same with tanh-sinh.
    [[nodiscard]] Share powers_by_levels();
    /// Returns I_m by tanh-sinh over ln s, very close to the apex.
    [[nodiscard]] Share far_by_levels();
    /// Chooses the rule for edge_by_rule; `q` is |x|/a.
    [[nodiscard]] Choice choose_edge(double q) const;
    /// Adds levels of tanh-sinh until the error is below the tolerance; `add_level` adds the terms
    /// of a level to a sum and returns their number.
    template <class AddLevel> [[nodiscard]] Share by_levels(const AddLevel& add_level);
    /// Adds weight (1 - from y)^((m - 1)/2) of the nodes to `sum`.
    void add_powers(Real& sum, const Nodes& nodes);
    /// Returns the nodes of powers_by_rule, of powers_by_levels, and of edge_by_levels.
    [[nodiscard]] const Nodes& power_nodes(std::size_t n);
    [[nodiscard]] const Nodes& power_level(int level);
    [[nodiscard]] const Nodes& edge_level(int level);

    Real m_;
    double m_double_;
    Real scale_; ///< P'(a)/pi
    Real inverse_a_;
    double ln_tolerance_; ///< ln of the relative accuracy
    BatchPressure::Rule rule_;
    RealPower power_;     ///< to the power (m - 1)/2
    unsigned long steps_; ///< m = n + 2 steps
    Real n_;
    Real b_;
    double n_double_;
    Real apex_factor_; ///< C

    Real q_;
    Real square_; ///< q^2
    Real y_;      ///< 1 - q^2
    Real root_;   ///< W
    Real gap_;    ///< q^2/W^2
    Real below_;
    Real above_;
    NodeSums sums_;

    std::map<std::size_t, quadrature::ProductRule> edge_;
    std::map<std::size_t, quadrature::ProductRule> apex_;
    std::map<int, Nodes> edge_levels_;
    std::map<std::size_t, Nodes> powers_;
    std::map<int, Nodes> power_levels_;
};

} // namespace edgeproof::contact
