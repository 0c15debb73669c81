// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>

/// The Coq files that certificates are stated in, as they stand in share/edgeproof/coq: made by
/// CMake.
namespace edgeproof::certificate::coq_files {

extern const std::string_view Contact_v; ///< the contact problem; Barber and Mossakovskii
extern const std::string_view
    Coefficients_v;                    ///< the pressure over the root of u, and its derivatives
extern const std::string_view Edges_v; ///< coefficients at the right and the left edge
extern const std::string_view Expansions_v;     ///< Taylor polynomials in a small eps
extern const std::string_view FlatAndRounded_v; ///< load and pressure of the profiles
extern const std::string_view Hertz_v;          //
extern const std::string_view PowerLaw_v;       //
extern const std::string_view Shear_v;          ///< full stick
extern const std::string_view Tactics_v;        ///< proofs of identities and of inequalities
extern const std::string_view TiltedWedge_v;    //

} // namespace edgeproof::certificate::coq_files
