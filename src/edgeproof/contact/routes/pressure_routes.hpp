// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/contact_law.hpp"
#include "edgeproof/contact/law/point.hpp"
#include "edgeproof/quadrature/near_singularity.hpp"

/// Three routes to p(x) that share no formula (docs/pressure.md). All use the thread's working
/// precision, and none proves a bound; `estimate` is the relative estimate of the quadrature.
/// `target_digits`: the digits at which the quadrature may stop (0: at roundoff). Lengths in one
/// unit.
namespace edgeproof::contact {

template <class T> struct RoutedPressure {
    T value;    ///< pressure, in the unit of the contact modulus
    T estimate; ///< estimated relative error; 0 for a closed form (roundoff only)
    std::size_t evaluations = 0;
    bool converged = true;
};

/// Barber-Mossakovskii (moore-hills EQ21, first branch; for b = a it is EQ03): superposed flat
/// punches of extent (-b(s), s). For x >= 0; for x < 0 mirror the problem: the second branch is the
/// same integral with b as the parameter. Throws DomainError for x < 0.
template <Arithmetic T>
[[nodiscard]] RoutedPressure<T> barber_mossakovskii(const ContactLaw<T>& law, const Extent<T>& e,
                                                    const Point<T>& at, unsigned target_digits = 0);

/// The singular integral equation (moore-hills EQ01 on -b < x < a). Its principal value is made
/// regular with the fact that the PV of 1/(w(s)(s - x)) is zero.
template <Arithmetic T>
[[nodiscard]] RoutedPressure<T> singular_integral(const ContactLaw<T>& law, const Extent<T>& e,
                                                  const Point<T>& at, unsigned target_digits = 0);

/// For g' piecewise linear: corners and bends contribute G(x, v) = ln |(z_x + z_v)/(z_x - z_v)| and
/// its integral, z_s = sqrt((a - s)/(s + b)) (logarithmic_pressure.hpp). Throws DomainError for
/// other profiles.
template <Arithmetic T>
[[nodiscard]] RoutedPressure<T> logarithmic_closed_form(const ContactLaw<T>& law,
                                                        const Extent<T>& e, const Point<T>& at);
/// The same; `marks` are those of the extent, and shared by all points of a contact.
template <Arithmetic T>
[[nodiscard]] RoutedPressure<T> logarithmic_closed_form(const ContactLaw<T>& law,
                                                        Marks<T, T>& marks, const Point<T>& at);

} // namespace edgeproof::contact
