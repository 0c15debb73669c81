// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/scene/input/scene_file.hpp"
#include "lab/validation/value_routes.hpp"

/// sxx, szz and sxz in body A below a plane contact, at a depth z > 0, by formulas that share
/// nothing with contact/stress.
namespace edgeproof::validation {

/// The stress as a user would program it in the arithmetic T: for Hertz without shear the formulas
/// of McEwen
/// (`johnson1985`, eq. 4.49), for other profiles the integrals of the pressure (eq. 2.23), divided
/// at x and at the knots, by Boost.Math's tanh-sinh; in partial slip q = f (p - p*), with the same
/// p under P - |Q|/f for p*. Throws as TextbookFormula does.
template <Arithmetic T>
[[nodiscard]] T textbook_stress(const scene::Scene& scene, const scene::AskedValue& asked);

extern template double textbook_stress<double>(const scene::Scene&, const scene::AskedValue&);
extern template long double textbook_stress<long double>(const scene::Scene&,
                                                         const scene::AskedValue&);
extern template Float128 textbook_stress<Float128>(const scene::Scene&, const scene::AskedValue&);
extern template Real textbook_stress<Real>(const scene::Scene&, const scene::AskedValue&);

/// The integrals of the printed pressure (`johnson1985`, eq. 2.23), by tanh-sinh in the distances
/// from x.
[[nodiscard]] SecondRoute by_pressure_integrals(const scene::Scene& scene,
                                                const scene::AskedValue& asked, unsigned digits);
/// The Cauchy integral of p (in partial slip also of p*) as W times integrals of g'(s)/(zeta - s)
/// and g'(s)/(zeta - s)^2 over the angle of s (docs/stress.md, "Curved slopes"), by tanh-sinh in
/// the distances from x; that of q under full stick as an integral of w q over this angle.
[[nodiscard]] SecondRoute by_slope_integrals(const scene::Scene& scene,
                                             const scene::AskedValue& asked, unsigned digits);

} // namespace edgeproof::validation
