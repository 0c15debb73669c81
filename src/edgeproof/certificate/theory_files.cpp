// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/coq_files.hpp"

namespace edgeproof::certificate {

const std::vector<TheoryFile>& theory_files() {
    static const std::vector<TheoryFile> all{
        {"Contact", coq_files::Contact_v, ""},
        {"Coefficients", coq_files::Coefficients_v, "Contact.vo"},
        {"Edges", coq_files::Edges_v, "Coefficients.vo"},
        {"ClosedForm", coq_files::ClosedForm_v, "Contact.vo"},
        {"Symmetric", coq_files::Symmetric_v, "Edges.vo ClosedForm.vo"},
        {"TiltedWedge", coq_files::TiltedWedge_v, "Edges.vo ClosedForm.vo"},
        {"FlatAndRounded", coq_files::FlatAndRounded_v, "Contact.vo"},
        {"Shear", coq_files::Shear_v, ""},
        {"Tactics", coq_files::Tactics_v, "Symmetric.vo TiltedWedge.vo Shear.vo"},
        {"Expansions", coq_files::Expansions_v, "Tactics.vo"},
        {"HalfPowers", coq_files::HalfPowers_v, "Expansions.vo"},
        {"PressureExpansions", coq_files::PressureExpansions_v, "HalfPowers.vo"},
        {"Uniform", coq_files::Uniform_v, "Expansions.vo"}};
    return all;
}

} // namespace edgeproof::certificate
