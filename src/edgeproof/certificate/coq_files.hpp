// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>
#include <vector>

namespace edgeproof::certificate {

/// The Coq files that certificates import, copied from share/edgeproof/coq by CMake.
namespace coq_files {

extern const std::string_view Contact_v; ///< the contact problem; Barber and Mossakovskii
extern const std::string_view
    Coefficients_v; ///< the pressure divided by the root of u, and its derivatives
extern const std::string_view Edges_v;          ///< coefficients at the right and the left edge
extern const std::string_view ClosedForm_v;     ///< lemmas for proofs of closed forms of pressures
extern const std::string_view Symmetric_v;      ///< symmetric punches, piecewise linear
extern const std::string_view TiltedWedge_v;    ///< tilted wedges
extern const std::string_view FlatAndRounded_v; ///< a printed integral of this profile
extern const std::string_view Shear_v;          ///< full stick
extern const std::string_view Unique_v;         ///< pressures and coefficients are unique
extern const std::string_view Scaling_v;        ///< contacts of the same form and another size
extern const std::string_view Tactics_v;        ///< proofs of identities and of inequalities
extern const std::string_view Expansions_v;     ///< Taylor polynomials in a small eps
extern const std::string_view HalfPowers_v;     ///< expansions in half powers of eps
extern const std::string_view PressureExpansions_v; ///< expansions of pressures near an edge

extern const std::string_view Curved_v;  ///< a contact with a curved left edge
extern const std::string_view Sides_v;   ///< the first terms lie on one side of the pressure
extern const std::string_view Uniform_v; ///< an expansion uniform in a variable

extern const std::string_view Limits_v;   ///< left edges and loads in the limit of a parameter
extern const std::string_view Stick_v;    ///< full stick solves its integral equation
extern const std::string_view Orders_v;   ///< the orders of what the first terms leave
extern const std::string_view Gamma_v;    ///< the gamma function, and Wallis' integral by it
extern const std::string_view PowerLaw_v; ///< power laws with any exponent

extern const std::string_view ShearTerms_v;    ///< any number of terms of the shear traction
extern const std::string_view TiltedRounded_v; ///< the slope of a tilted punch
extern const std::string_view Flatness_v;      ///< power laws of a growing exponent
extern const std::string_view Inversion_v;     ///< pressures by the singular integral equation
extern const std::string_view PowerSides_v;    ///< one term lies below the pressure, m < 5/8
extern const std::string_view PowerError_v;    ///< one term divided by the pressure, m > 5/8
extern const std::string_view Similar_v;       ///< shear in proportion to the load

extern const std::string_view Resultant_v;      ///< the integral of a pressure is the load
extern const std::string_view Places_v;         ///< loads as integrals over places
extern const std::string_view LoadOfPressure_v; ///< both for power laws, rounded edges, wedges
extern const std::string_view Forward_v;        ///< the equation of the contact problem, parabola
extern const std::string_view RoundedSides_v;   ///< the first terms of rounded edges lie above
extern const std::string_view Dilogarithm_v;    ///< the dilogarithm, for the next file
extern const std::string_view LogPressure_v;    ///< the pressure of a corner, its principal value
extern const std::string_view ForwardPunches_v; ///< the equation for wedges and rounded edges
extern const std::string_view RoundedShape_v;   ///< the shape of the pressure of rounded edges
extern const std::string_view Consistency_v;    ///< the printed condition of consistency
extern const std::string_view Readings_v;       ///< claims that hold in one reading only

/// The stresses under a parabola. It is no file of its own: certificates of stresses contain it.
extern const std::string_view Stress_v;

} // namespace coq_files

struct TheoryFile {
    std::string_view name; ///< without .v
    std::string_view content;
    std::string_view needs; ///< in Makefile syntax: "Contact.vo Edges.vo"
};
/// Returns the files in the order in which they are compiled.
[[nodiscard]] const std::vector<TheoryFile>& theory_files();

} // namespace edgeproof::certificate
