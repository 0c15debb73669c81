// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/certificate/theory/coq_text.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::certificate {

/// Something that a theorem says of the contact: `statement` of the values `unknowns`, which exist,
/// and how Coq proves it. In the proof the unknowns are existential variables.
struct Fact {
    std::vector<std::string> unknowns;
    std::string statement;
    std::string proof;
};

/// A definition that the file of a theorem begins with.
struct Constant {
    std::string name;
    std::string value;
    std::string type = "R";
};

/// The mechanics that theorems are stated in: Coq files (share/edgeproof/coq), the contact, and
/// which fact stands behind which name of a ledger's formulas.
struct Theory {
    std::vector<std::string> imports; ///< "Contact", "TiltedWedge", ...
    CoqNames names;                   ///< of the parameters
    std::vector<Constant> constants;  ///< parameters with their values
    Fact right;                       ///< coefficients r0, r1, r2 at the right edge
    Fact left;                        ///< coefficients l0, l1, l2 at the left edge
    Fact right_shear; ///< of the shear traction's square root terms at the right edge
    Fact left_shear;  ///< and at the left
    Fact load;        ///< the load P0
    Fact pressure;    ///< the pressure p0 at x
    /// Integrals of printed formulas that there is a lemma for: as a ledger writes them, and the
    /// proof that one is l0.
    std::vector<std::pair<std::string, std::string>> integrals;
};

/// A theory with numbers: a contact and a place in it that serve as the counterexample or example
/// of a claim. Small whole numbers, so that a reader can follow.
struct SampledTheory {
    Theory theory;
    audit::Sample sample; ///< the same contact, for the enclosures that choose what is stated
};

/// For all contacts, symmetric (b = a) or not, whose load and left edge are smooth functions of the
/// right edge.
[[nodiscard]] Theory smooth_contact(bool symmetric);

/// The samples of a family's profile, none if the Coq files have no theory of it.
[[nodiscard]] std::vector<SampledTheory> sampled_theories(std::string_view profile);

/// A contact under full stick, whose traction depends on the edges, Q and sig0 alone. `sig0`: the
/// name of the tension in Coq; `tension`: what it is there, and `exact` the same number. `edge`:
/// from which `u` is measured.
struct Tension {
    std::string name;
    std::string coq;
    formula::Exact exact;
};
[[nodiscard]] SampledTheory sheared_contact(contact::Edge edge, const Tension& tension);

/// A symmetric punch named `punch`, a list of parts (Symmetric.v), whose knots are nearer to the
/// middle than `beyond`, and that than x. `mark`: the end of its unknowns' names.
[[nodiscard]] Theory symmetric_punch(const std::string& punch, const std::string& parts,
                                     const std::string& beyond, const std::string& mark = "");

/// The contact with Es = C = a = 1 of g'(x) = C sgn(x) |x|^m, for m = 0 or 1, and x > 0 in it.
/// The names of its unknowns end in `mark`, so that two of them can stand in one theorem.
[[nodiscard]] SampledTheory power_law_contact(long m, const std::string& mark,
                                              const Rational& x = Rational(1, 2));

} // namespace edgeproof::certificate
