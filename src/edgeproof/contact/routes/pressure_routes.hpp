// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/contact_law.hpp"
#include "edgeproof/contact/law/point.hpp"
#include "edgeproof/quadrature/near_singularity.hpp"

/// Three routes to p(x) that share no formula. All are at the thread's working precision and none
/// proves a bound; `estimate` is the quadrature's own, relative. `target_digits`: where the
/// quadrature may stop (0: at roundoff).
namespace edgeproof::contact {

template <class T> struct RoutedPressure {
    T value;    ///< pressure, units of the contact modulus
    T estimate; ///< estimated relative error; 0 for a closed form (roundoff only)
    std::size_t evaluations = 0;
    bool converged = true;
};

/// Barber-Mossakovskii (moore-hills.tex eqn:ContactPressure_NonSym, first branch; for b = a it is
/// eqn:MossakovskiiPressure): flat punches of extent (-b(s), s) laid over each other. For x >= 0;
/// the branch x < 0 is the same integral with b as the parameter: mirror the problem.
/// Throws DomainError for x < 0.
template <Arithmetic T>
[[nodiscard]] RoutedPressure<T> barber_mossakovskii(const ContactLaw<T>& law, const Extent<T>& e,
                                                    const Point<T>& at, unsigned target_digits = 0);

/// The singular integral equation (eqn:SIEPressure on -b < x < a), its principal value made
/// regular by the zero PV of 1/(w(s)(s - x)).
template <Arithmetic T>
[[nodiscard]] RoutedPressure<T> singular_integral(const ContactLaw<T>& law, const Extent<T>& e,
                                                  const Point<T>& at, unsigned target_digits = 0);

/// For g' piecewise linear: corners and bends carry G(x, v) = 2 artanh(z_x/z_v) and its integral,
/// z = sqrt((a - v)/(v + b)). Throws DomainError for other profiles.
template <Arithmetic T>
[[nodiscard]] RoutedPressure<T> logarithmic_closed_form(const ContactLaw<T>& law,
                                                        const Extent<T>& e, const Point<T>& at);
/// The same; `marks` are those of the extent, which all points of a contact share.
template <Arithmetic T>
[[nodiscard]] RoutedPressure<T> logarithmic_closed_form(const ContactLaw<T>& law,
                                                        Marks<T, T>& marks, const Point<T>& at);

} // namespace edgeproof::contact
