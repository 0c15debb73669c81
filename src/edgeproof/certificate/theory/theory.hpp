// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/certificate/theory/coq_text.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::certificate {

/// A fact about the contact: values `unknowns` exist for which `statement` holds, and Coq proves it
/// in this way. In the proof the unknowns are existential variables.
struct Fact {
    std::vector<std::string> unknowns;
    std::string statement;
    std::string proof;
};

/// A definition at the beginning of a theorem's file.
struct Constant {
    std::string name;
    std::string value;
    std::string type = "R";
};

/// The mechanics in which theorems are stated: Coq files (share/edgeproof/coq), the contact, and
/// the fact for each name in a ledger's formulas.
struct Theory {
    std::vector<std::string> imports; ///< "Contact", "TiltedWedge", ...
    CoqNames names;                   ///< of the parameters
    std::vector<Constant> constants;  ///< parameters with their values
    Fact right;                       ///< coefficients r0, r1, r2 at the right edge
    Fact left;                        ///< coefficients l0, l1, l2 at the left edge
    Fact right_shear;     ///< the square-root terms of the shear traction at the right edge
    Fact left_shear;      ///< the same at the left edge
    Fact left_position;   ///< that the left edge is where the formulas have it; no unknowns
    Fact load;            ///< the load P0
    Fact pressure;        ///< the pressure p0 at x
    std::string traction; ///< the shear traction as a function: "full_stick Q sig0 a b"
    /// The theorems assume a contact, which defines all names; they are not about one with numbers.
    bool assumes_contact = false;
    /// For a theory of all contacts of a form: the parameters that a theorem is stated for, the
    /// condition on them, the beginning of a proof, and the tactic that proves identities.
    struct AllOfForm {
        std::string parameters; ///< "a b Q sig0"
        std::string condition;  ///< "0 < a + b"
        std::string begin;      ///< "intros Hab"
        std::string identity;   ///< "identity_of_shear a b"
        std::string place;      ///< of a formula with x: "- b < x < a"
    };
    std::optional<AllOfForm> all_of_form;
    /// An integral in printed formulas for which there is a lemma.
    struct Integral {
        std::string integral; ///< in the syntax of ledgers; a principal value is one, too
        std::string is;       ///< what its value is: "is_improper_integral"
        std::string proof;    ///< that it equals l0
    };
    std::vector<Integral> integrals;
};

/// A theory with numbers: a contact and a place in it for the counterexample or example of a claim.
/// The numbers are small and whole, so that a reader can follow.
struct SampledTheory {
    Theory theory;
    audit::Sample sample; ///< the same contact, for enclosures
};

/// The theory for all contacts of a profile, in its parameters; no value if there is none.
[[nodiscard]] std::optional<Theory> theory_of_form(std::string_view profile);
/// The same for full stick between any edges, whose tension has the given name.
[[nodiscard]] Theory theory_of_shear(contact::Edge edge, const std::string& tension);

/// The theory for all contacts, symmetric (b = a) or not, whose load and left edge are smooth
/// functions of the right edge.
[[nodiscard]] Theory smooth_contact(bool symmetric);

/// Returns the samples of a family's profile; none if the Coq files have no theory of it.
[[nodiscard]] std::vector<SampledTheory> sampled_theories(std::string_view profile);

/// A contact under full stick, whose traction depends only on the edges, Q and sig0. `name` is the
/// name of the tension, `coq` its value in Coq and `exact` the same number. `edge`: the edge from
/// which `u` is measured.
struct Tension {
    std::string name;
    std::string coq;
    formula::Exact exact;
};
[[nodiscard]] SampledTheory sheared_contact(contact::Edge edge, const Tension& tension);

/// A symmetric punch named `punch`, a list of parts (Symmetric.v). All knots are nearer to the
/// middle than `beyond`, and `beyond` is nearer than x. `mark`: the end of its unknowns' names.
[[nodiscard]] Theory symmetric_punch(const std::string& punch, const std::string& parts,
                                     const std::string& beyond, const std::string& mark = "");

/// The contact with Es = C = a = 1 of g'(x) = C sgn(x) |x|^m, for m = 0 or 1, at x > 0 in it. The
/// names of its unknowns end in `mark`, so that one theorem can contain two such contacts.
[[nodiscard]] SampledTheory power_law_contact(long m, const std::string& mark,
                                              const Rational& x = Rational(1, 2));

} // namespace edgeproof::certificate
