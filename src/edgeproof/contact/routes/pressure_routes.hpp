// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/contact_law.hpp"
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/formula/exact/exact.hpp"

#include <array>
#include <cstddef>
#include <optional>

/// Three routes to p(x) that share no formula (docs/pressure.md). All use the thread's working
/// precision, and none proves a bound; `estimate` is the relative estimate of the quadrature.
/// `target_digits`: the digits at which the quadrature may stop (0: at roundoff). Lengths in one
/// unit.
namespace edgeproof::contact {

struct RoutedPressure {
    Real value;    ///< pressure, in the unit of the contact modulus
    Real estimate; ///< estimated relative error; 0 for a closed form (roundoff only)
    std::size_t evaluations = 0;
    bool converged = true;
};

/// Barber-Mossakovskii (moore-hills EQ21, first branch; for b = a it is EQ03): superposed flat
/// punches of extent (-b(s), s). For x >= 0; for x < 0 mirror the problem: the second branch is the
/// same integral with b as the parameter. Throws DomainError for x < 0.
[[nodiscard]] RoutedPressure barber_mossakovskii(const ContactLaw<Real>& law, const Extent<Real>& e,
                                                 const Point<Real>& at, unsigned target_digits = 0);

/// The singular integral equation (moore-hills EQ01 on -b < x < a). Its principal value is made
/// regular with the fact that the PV of 1/(w(s)(s - x)) is zero.
[[nodiscard]] RoutedPressure singular_integral(const ContactLaw<Real>& law, const Extent<Real>& e,
                                               const Point<Real>& at, unsigned target_digits = 0);

/// For g' piecewise linear: corners and bends contribute G(x, v) = ln |(z_x + z_v)/(z_x - z_v)| and
/// its integral, z_s = sqrt((a - s)/(s + b)) (linear_measure.hpp). Throws DomainError for
/// other profiles.
[[nodiscard]] RoutedPressure logarithmic_closed_form(const ContactLaw<Real>& law,
                                                     const Extent<Real>& e, const Point<Real>& at);
/// The same; `marks` are those of the extent, and shared by all points of a contact.
[[nodiscard]] RoutedPressure logarithmic_closed_form(const ContactLaw<Real>& law,
                                                     Marks<Real, Real>& marks,
                                                     const Point<Real>& at);

/// I_m(q), the integral of s^m/sqrt(s^2 - q^2) over q < s < 1 (dimensionless), in Real
/// (docs/pressure.md, "Closed form: power laws"). It shares neither a series nor a recurrence with
/// the enclosure of PowerLawIntegral:
///
/// q^2 >= 1/2: I_m = sqrt(y) 2F1(1, (1 - m)/2; 3/2; y), y = 1 - q^2, by Gauss's series in y (DLMF
/// 15.2.1), with additional digits for those that cancel (m > 1). Where these are too many (large
/// m), by Euler's integral of the 2F1 (DLMF 15.6.1): sqrt(y) times the integral of
/// (q^2 + y t^2)^((m-1)/2) over 0 < t < 1, by tanh-sinh.
///
/// q^2 < 1/2: the integral is cut at h with (q/h)^2 = 1/2 or, for q < 1/2, 1/4. The part below h is
/// h^m I_m(q/h). With beta_k = (2k)!/(4^k k!^2), the part above is the sum of
/// beta_k q^(2k) (1 - h^(m-2k))/(m - 2k). No term is negative; the sum converges as (q/h)^(2k), and
/// an even m is no special case.
class PowerLawIntegralInReal {
public:
    /// Takes m > 0 and computes all results at the working precision of the thread. `target_digits`
    /// is that of the quadrature. Throws DomainError for m <= 0, BudgetError for m > 1e12.
    PowerLawIntegralInReal(const Exact& m, unsigned target_digits);

    struct Value {
        Real value;
        Real estimate; ///< relative error of the quadrature; 0 without one
        std::size_t evaluations = 0;
        bool converged = true;
    };
    /// I_m(q) for 0 <= q < 1. `y` is 1 - q^2, an argument of its own so that it keeps its digits
    /// near the edge.
    [[nodiscard]] Value operator()(const Real& q, const Real& y);

private:
    [[nodiscard]] Value near_edge(const Real& y) const;
    [[nodiscard]] Value by_gauss(const Real& y, unsigned more_digits) const;
    [[nodiscard]] Value by_euler(const Real& y) const;

    [[nodiscard]] unsigned digits_of_m() const;
    void times_less_m(Real& x, long k) const;
    void over_m_less(Real& x, long k) const;

    Real m_;
    double about_m_;
    /// m = over/under, if these are small integers.
    struct Words {
        long over;
        long under;
    };
    std::optional<Words> words_;
    unsigned target_digits_;
    std::array<std::optional<Value>, 2> at_cut_; ///< I_m(q/h)
};

/// p = (P'(a)/pi) I_m(|x|/a): moore-hills EQ03 with s/a for s.
class PowerLawPressure {
public:
    /// For a power law of m > 0 that is not piecewise linear.
    PowerLawPressure(const Exact& m, const ContactLaw<Real>& law, const Extent<Real>& e,
                     unsigned target_digits);
    [[nodiscard]] RoutedPressure operator()(const Point<Real>& at);

private:
    Real a_;
    Real factor_; ///< P'(a)/pi
    PowerLawIntegralInReal integral_;
};

} // namespace edgeproof::contact
