// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rational.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::certificate {

using audit::Sample;
using contact::Edge;
using formula::Exact;
using formula::Expr;

/// Thrown for a formula that this program cannot state in Coq. The message names the part.
class NotStated : public Error {
public:
    using Error::Error;
};

/// The names in a formula, and the Coq terms for them (atoms, or terms in parentheses).
using CoqNames = std::map<std::string, std::string, std::less<>>;

/// Returns the Coq term for a call or an integral that is not an elementary function; throws
/// NotStated.
using CoqCall = std::function<std::string(const Expr&)>;

/// Returns a formula as a term of Coq's real numbers (R_scope), operation by operation. Powers are
/// x ^ n for whole n and Rpower, which needs a positive base, for other exponents. The gamma
/// function has the name that `names` give it. Throws NotStated for a name that is not in `names`,
/// for a function that Coq's library of real numbers does not have, and for integrals that `call`
/// does not translate.
[[nodiscard]] std::string coq_text(const Expr& e, const CoqNames& names, const CoqCall& call = {});
/// Returns "3", "(1 / 2)" or "(- (1 / 2))".
[[nodiscard]] std::string coq_number(const Rational& q);

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
    Sample sample; ///< the same contact, for enclosures
};

/// The theory for all contacts of a profile, in its parameters; no value if there is none.
[[nodiscard]] std::optional<Theory> theory_of_form(std::string_view profile);
/// The same for full stick between any edges, whose tension has the given name.
[[nodiscard]] Theory theory_of_shear(Edge edge, const std::string& tension);

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
    Exact exact;
};
[[nodiscard]] SampledTheory sheared_contact(Edge edge, const Tension& tension);

/// A symmetric punch named `punch`, a list of parts (Symmetric.v). All knots are nearer to the
/// middle than `beyond`, and `beyond` is nearer than x. `mark`: the end of its unknowns' names.
[[nodiscard]] Theory symmetric_punch(const std::string& punch, const std::string& parts,
                                     const std::string& beyond, const std::string& mark = "");

/// The contact with Es = C = a = 1 of g'(x) = C sgn(x) |x|^m, for m = 0 or 1, at x > 0 in it. The
/// names of its unknowns end in `mark`, so that one theorem can contain two such contacts.
[[nodiscard]] SampledTheory power_law_contact(long m, const std::string& mark,
                                              const Rational& x = Rational(1, 2));

/// A theorem about formulas of a ledger: the facts of a theory that they need, and their text in
/// Coq.
class Statement {
public:
    explicit Statement(const Theory& theory) : theory_(theory) {}

    /// Returns the formula in Coq. Coefficients, the load and the pressure become unknowns of their
    /// facts. Throws NotStated.
    [[nodiscard]] std::string operator()(const Expr& e);
    /// Returns `conclusion` after the facts: "exists r0 r1 r2, is_the_right_series ... /\ ". Throws
    /// NotStated if there are no facts: such a theorem is not about a contact.
    [[nodiscard]] std::string text(const std::string& conclusion) const;
    /// Returns the proof of the facts, then `last`, the proof of the conclusion.
    [[nodiscard]] std::string proof(const std::string& last) const;

private:
    void need(const Fact& fact, const std::string& what);
    std::string call(const Expr& e, const CoqNames& names);
    std::string local_sum(const Expr& e);
    std::string integral(const Expr& e, CoqNames names);

    const Theory& theory_;
    std::vector<Fact> facts_;
};

/// Common parts of theorems about one contact with given numbers.
/// The tolerance for statements of agreement, relative to the exact value.
inline constexpr std::string_view agreement = "1 / 10 ^ 12";

/// A lower bound of |first - second| at a sample, and the same relative to the larger of both.
struct Gap {
    double least = 0;
    double relative = 0;
};
/// Returns no value if there are no enclosures.
[[nodiscard]] std::optional<Gap> gap_at(const Expr& first, const Expr& second,
                                        const Sample& sample);
/// Returns a lower bound of first at one sample minus second at another; no value if it is not
/// positive.
[[nodiscard]] std::optional<double> excess(const Expr& first, const Sample& at, const Expr& second,
                                           const Sample& other);

/// Returns a fraction of three digits slightly below `gap`: "253 / 10 ^ 3".
[[nodiscard]] std::string fraction_below(double gap);

/// Returns the definitions of the numbers, and the tactics that use them.
[[nodiscard]] std::string constants(const std::vector<Constant>& all);

/// Returns a theorem and its proof.
[[nodiscard]] std::string theorem_text(const std::string& name, const std::string& statement,
                                       const std::string& proof);

} // namespace edgeproof::certificate
