// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/parts.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <fmt/format.h>

#include <array>

namespace edgeproof::certificate {
namespace {

/// A function of eps whose expansion the Coq files derive.
struct Expanded {
    std::string_view of; ///< in the syntax of ledgers
    std::string_view through;
    std::string_view exact; ///< in Coq
    std::string_view lemma;
    std::size_t order; ///< of the Taylor polynomial of the function (times sqrt(eps), if halves)
    bool symmetric;
    std::string_view variables;
    bool halves = false; ///< the powers are eps^(-1/2), eps^(1/2), ...
    std::string_view conditions = {};
    std::string_view names_of_conditions = {};
    std::string_view pressures = {}; ///< the definition of `p`, if the function contains it
};

constexpr std::array<Expanded, 8> expanded{
    {{"P1of(a-eps*S)/sqrt(1-eps*(X+S)/(2*a))", "2",
      "P1 (a - eps * S) / sqrt (1 - eps * (X + S) / (2 * a))",
      "integrand_through_2 _ _ _ _ _ _ _ S X contact", 2, true, "S X"},
     {"binv(b-eps*X)-a", "3", "alpha ((b a) - eps * X) - a",
      "inverse_through_3 _ _ _ _ _ _ _ _ _ _ _ _ contact left X", 3, false, "X"},
     {"P1of(a+(binv(b-eps*X)-a)*sigma)/Pi", "2",
      "P1 (a + (alpha ((b a) - eps * X) - a) * sigma) / PI",
      "rate_through_2 _ _ _ _ _ _ _ _ _ _ _ _ contact left X sigma", 2, false, "X sigma"},
     {"1/sqrt(-b+eps*X+bof(a+(binv(b-eps*X)-a)*sigma))", "3/2",
      "1 / sqrt (- b a + eps * X + b (a + (alpha ((b a) - eps * X) - a) * sigma))",
      "inverse_root_through_2 _ _ _ _ _ _ _ _ _ _ _ _ contact left X sigma HX Hs", 2, false,
      "X sigma", true, "0 < X -> 0 < sigma < 1 ->", " HX Hs"},
     {"1/sqrt(-b+eps+bof(a+(binv(b-eps)-a)*sigma))", "3/2",
      "1 / sqrt (- b a + eps + b (a + (alpha ((b a) - eps) - a) * sigma))",
      "inverse_root_at_1 _ _ _ _ _ _ _ _ _ _ _ _ contact left sigma Hs", 2, false, "sigma", true,
      "0 < sigma < 1 ->", " Hs"},
     {"p(-b+eps*X)/(a-binv(b-eps*X))", "3/2", "p (- b a + eps * X) / (a - alpha (b a - eps * X))",
      "left_quotient_through_2 _ _ _ _ _ _ _ _ _ _ _ _ X contact left HX", 2, false, "X", true,
      "0 < X ->", " HX", "are_the_pressures_left Es g1 (b a) p"},
     {"p(-b+eps)/(a-binv(b-eps))", "3/2", "p (- b a + eps) / (a - alpha (b a - eps))",
      "left_quotient_at_1 _ _ _ _ _ _ _ _ _ _ _ _ contact left", 2, false, "", true, "", "",
      "are_the_pressures_left Es g1 (b a) p"},
     {"p(a-eps*X)", "5/2", "p (a - eps * X)", "right_pressure_through_3 _ _ _ _ _ _ _ X contact HX",
      3, true, "X", true, "0 < X ->", " HX", "are_the_pressures_right Es g1 a p"}}};

const Expanded& expanded_of(const Claim& claim) {
    for (const Expanded& e : expanded) {
        if (claim.text("of") == e.of && claim.text("through") == e.through) {
            return e;
        }
    }
    throw NotStated(fmt::format("the Coq files derive no expansion of {}", claim.text("of")));
}

/// Returns the exponent of eps whose coefficient has index k.
std::string exponent_text(const Expanded& e, std::size_t k) {
    return e.halves ? fmt::format("{}/2", 2 * static_cast<long>(k) - 1) : fmt::format("{}", k);
}

std::string power_text(std::string_view exponent) {
    const bool whole = exponent.find('/') == std::string_view::npos;
    return whole ? fmt::format("eps^{}", exponent) : fmt::format("eps^({})", exponent);
}

/// The printed and the derived coefficient of each power from 0 on, as the audit found them. Only
/// the choice of the proposed proof depends on them.
struct Coefficients {
    std::vector<std::string> printed;
    std::vector<std::string> derived;
    std::optional<std::size_t> departs;
};

class Words {
public:
    Words(const Claim& claim, const Expanded& e)
        : claim_(claim), in_theorem_(smooth_contact(e.symmetric).names), names_(in_theorem_) {
        for (const char* name : {"eps", "X", "S", "sigma"}) {
            names_.emplace(name, name);
        }
    }
    /// An integral up to X, whose integrand is unbounded there, becomes `(I eps)`.
    [[nodiscard]] std::string operator()(const Expr& e) {
        return coq_text(e, names_, [&](const Expr& part) {
            if (part.kind() != Expr::Kind::integral || !integral_.empty() ||
                part.arg(3) != Expr::symbol("X")) {
                throw NotStated(fmt::format("{} is not stated in Coq", to_text(part)));
            }
            const std::string& variable = part.arg(1).name();
            const std::string in_coq = coq_name(variable);
            if (in_theorem_.contains(variable)) {
                throw NotStated(
                    fmt::format("the variable {} of an integral hides another", variable));
            }
            CoqNames inside = names_;
            inside.insert_or_assign(variable, in_coq);
            integral_ = fmt::format("(fun {} => {}) {} X", in_coq, coq_text(part.arg(0), inside),
                                    coq_text(part.arg(2), names_));
            return std::string("(I eps)");
        });
    }
    [[nodiscard]] std::string operator()(const std::string& text) {
        return (*this)(
            expand_definitions(parse_formula(text, claim_.vocabulary), claim_.vocabulary));
    }
    /// Returns the definition of `I eps`, or an empty text.
    [[nodiscard]] const std::string& integral() const { return integral_; }

private:
    const Claim& claim_;
    CoqNames in_theorem_; ///< of the contact
    CoqNames names_;
    std::string integral_;
};

std::string text_at(const Evidence& term, std::string_view key) {
    const EvidenceItem* const item = term.find(key);
    return item == nullptr ? std::string() : item->text();
}

Coefficients coefficients_of(const Outcome& outcome, const Expanded& e, Words& words) {
    const EvidenceItem* const item = outcome.evidence.find("terms");
    const auto* const terms =
        item == nullptr ? nullptr : std::get_if<std::vector<EvidenceItem>>(&item->value());
    if (terms == nullptr) {
        throw NotStated("the coefficients of the expansion were not found");
    }
    Coefficients all;
    all.printed.assign(e.order + 1, "0");
    all.derived = all.printed;
    for (const EvidenceItem& entry : *terms) {
        const auto& term = std::get<Evidence>(entry.value());
        for (std::size_t k = 0; k < all.printed.size(); ++k) {
            if (text_at(term, "power") != fmt::format("eps^({})", exponent_text(e, k))) {
                continue;
            }
            const std::string both = text_at(term, "both");
            all.printed[k] = words(both.empty() ? text_at(term, "printed") : both);
            all.derived[k] = words(both.empty() ? text_at(term, "derived") : both);
            if (both.empty() && !all.departs) {
                all.departs = k;
            }
        }
    }
    return all;
}

std::string hypotheses(const Expanded& e) {
    const std::string places = e.pressures.empty() ? "" : e.symmetric ? " (y : R)" : " (y z : R)";
    return "(Es : R) (g1 : R -> R) (a : R) " +
           (e.symmetric
                ? "(P P1 P2 P3 : R -> R)" + places +
                      " :\n  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => s) (fun _ => 1) (fun _ "
                      "=> 0) ->\n"
                : "(P P1 P2 P3 b b1 b2 b3 alpha : R -> R)" + places +
                      " :\n  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->\n"
                      "  is_left_edge a b b1 b2 b3 alpha ->\n") +
           (e.pressures.empty() ? "" : convex_hypothesis(e.symmetric));
}

/// The statement of a theorem between its hypotheses and its proof, and how the proof begins.
struct Claimed {
    const Expanded& e;
    std::string polynomial; ///< the printed or the corrected polynomial, a function of eps
    std::string integral;   ///< the definition of `I eps` in it, or empty

    [[nodiscard]] std::string text(const std::string& name, const std::string& differ) const {
        const std::string variables =
            e.variables.empty() ? ""
                                : fmt::format("  forall {} : R,{}{}\n", e.variables,
                                              e.conditions.empty() ? "" : " ", e.conditions);
        const std::string pressures =
            e.pressures.empty() ? "" : fmt::format("exists p, {} /\\\n  ", e.pressures);
        const std::string integrals =
            integral.empty() ? ""
                             : fmt::format("forall I, (forall eps, 0 < eps -> is_integral_up_to "
                                           "{} (I eps)) ->\n  ",
                                           integral);
        return fmt::format(
            "Theorem {} {}{}{}  {}{}{}{} {} (fun eps => {})\n    (fun eps => {})", name,
            hypotheses(e), variables, differ.empty() ? "" : fmt::format("  {} <> 0 ->\n", differ),
            pressures, integrals, differ.empty() ? "" : "~ ",
            e.halves ? "agrees_in_halves" : "agrees_through", e.order, e.exact, polynomial);
    }
    [[nodiscard]] std::string begin_of_proof(std::string_view more) const {
        return fmt::format("  intros contact{}{}{}{}{}{}.\n  {}.\n{}{}", e.symmetric ? "" : " left",
                           e.pressures.empty() ? "" : " convex", e.variables.empty() ? "" : " ",
                           e.variables, e.names_of_conditions, more,
                           e.symmetric ? "symmetric_facts contact" : "edge_facts contact left",
                           e.pressures.empty()
                               ? fmt::format("  pose proof ({}) as derived.\n", e.lemma)
                               : fmt::format("  destruct ({}) as (p & Hp & derived).\n"
                                             "  exists p. split; [apply (the_pressures_{} _ _ {}); "
                                             "[apply convex | apply convex | exact Hp] |].\n",
                                             e.lemma, e.symmetric ? "right" : "left",
                                             e.symmetric ? "y" : "z"),
                           integral.empty() ? "" : "  intros I HI.\n");
    }
};

std::string agrees_theorem(const std::string& name, const Claimed& claimed) {
    return fmt::format(
        "{0}.\nProof.\n{1}  {2}\nQed.\n\n", claimed.text(name, ""), claimed.begin_of_proof(""),
        claimed.e.halves ? "apply (agrees_trans _ _ _ _ derived). in_half_powers."
                         : "apply (agrees_ext _ _ _ _ derived). intros u. field; repeat split; "
                           "lra.");
}

std::string refuted_theorem(const std::string& name, const Claimed& claimed,
                            const Coefficients& all) {
    const Expanded& e = claimed.e;
    std::string polynomial;
    std::string equal;
    for (std::size_t k = 0; k < all.printed.size(); ++k) {
        polynomial += k == 0 ? fmt::format("({})", all.printed[k])
                             : fmt::format(" + ({}) * u{}", all.printed[k],
                                           k == 1 ? "" : fmt::format(" ^ {}", k));
        equal += fmt::format("{}E{}", k == 0 ? "" : " & ", k);
    }
    const std::size_t k = *all.departs;
    std::string unknown;
    for (std::size_t i = 0; i < 2 * all.printed.size() + 1; ++i) {
        unknown += " _";
    }
    const std::string root = e.halves ? "sqrt eps * " : "";
    return fmt::format(
        "{0}.\nProof.\n{1}  intros printed. apply differ, Rminus_diag_eq.\n"
        "  assert (polynomial : agrees_through {2} (fun eps => {3}({4})) (fun u => {5})).\n"
        "  {{ {6} }}\n"
        "  destruct (unique_{2}{7} derived polynomial) as ({8}).\n"
        "  transitivity_of E{9}; {10}.\nQed.\n\n",
        claimed.text(name, fmt::format("({}) - ({})", all.printed[k], all.derived[k])),
        claimed.begin_of_proof(" differ"), e.order, root, e.exact, polynomial,
        !e.halves ? "apply (agrees_ext _ _ _ _ printed). intros u. field; repeat split; lra."
        : claimed.integral.empty()
            ? "apply (agrees_trans _ _ _ _ printed). in_half_powers."
            : "apply (agrees_trans _ _ _ _ printed). with_integral HI. half_powers.",
        unknown, equal, k, e.halves ? "half_powers" : "field; repeat split; lra");
}

/// Returns "exists X sigma : R, 0 < X /\\ 0 < sigma < 1 /\\ ", with the line's indentation.
std::string variables_exist(const Expanded& e) {
    if (e.variables.empty()) {
        return "  ";
    }
    std::string conditions(e.conditions);
    boost::replace_all(conditions, "->", "/\\");
    return fmt::format("  exists {} : R, {}", e.variables,
                       conditions.empty() ? "" : conditions + "\n  ");
}

/// Returns the beginning of a proof that the variables exist, which have these values.
std::string variables_are(const Expanded& e, std::string_view X) {
    std::string values;
    std::string conditions;
    for (const auto& [name, value] : {std::pair<std::string_view, std::string_view>{"S", "1"},
                                      {"X", X},
                                      {"sigma", "(1 / 2)"}}) {
        if (e.variables.find(name) != std::string_view::npos) {
            values += fmt::format("{}{}", values.empty() ? "exists " : ", ", value);
        }
        if (e.conditions.find(fmt::format("< {}", name)) != std::string_view::npos) {
            conditions += " split; [lra |].";
        }
    }
    return values.empty() ? "" : values + "." + conditions + " ";
}

/// States that there is a contact at which the coefficients differ: a wedge, or the contact of
/// Curved.v.
std::string instance_theorem(const std::string& name, const Claimed& claimed,
                             const Coefficients& all) {
    const Expanded& e = claimed.e;
    const std::string differ = fmt::format("{}({}) - ({}) <> 0", variables_exist(e),
                                           all.printed[*all.departs], all.derived[*all.departs]);
    if (!e.symmetric) {
        return fmt::format(
            "Theorem {0} : exists (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R "
            "-> R) (y z : R),\n"
            "  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 /\\\n"
            "  is_left_edge a b b1 b2 b3 alpha /\\\n"
            "  (rises_at g1 y /\\ y < a /\\ rises_at (mirrored g1) z /\\ z < b a) /\\\n"
            "{1}.\nProof.\n  exists_curved_contact. {2}apply apart. curved_numbers.\n"
            "Qed.\n\n",
            name, differ, variables_are(e, "2"));
    }
    return fmt::format(
        "Theorem {0} : exists (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 : R -> R) (y : R),\n"
        "  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => s) (fun _ => 1) (fun _ => 0) /\\\n"
        "  (rises_at g1 y /\\ y < a) /\\\n"
        "{1}.\nProof.\n"
        "  exists 1, (slope wedge), 1, (load 1 wedge), (rate 1 wedge), (rate_2 1 wedge), "
        "(rate_3 1 wedge), (first wedge).\n  split; [apply (smooth_contact 1 wedge (1 / 2) 1); "
        "sides ltac:(unfold wedge) |].\n"
        "  split; [split; [apply punch_rises; convex ltac:(unfold wedge) | before ltac:(unfold "
        "wedge)] |].\n  {2}apply apart. numbers ltac:(unfold wedge).\n"
        "Qed.\n\n",
        name, differ, variables_are(e, "1"));
}

/// States a claim under one reading. `mark` is the end of the theorems' names.
void state(const Claim& claim, const Outcome& outcome, bool refuted, const std::string& mark,
           Certificate& certificate) {
    const Expanded& e = expanded_of(claim);
    Words words(claim, e);
    const std::string name = coq_name(claim.id);
    const std::string polynomial = words(claim.formula("says"));
    const Claimed printed{e, polynomial, words.integral()};
    const auto add = [&](const std::string& theorem, const std::string& text, std::string states) {
        certificate.text += text;
        certificate.theorems.push_back({theorem, std::move(states)});
    };
    const std::string contacts = e.symmetric ? "all symmetric contacts" : "all contacts";
    const std::string rest = fmt::format("o({})", power_text(e.through));
    if (!refuted) {
        add(name + mark, agrees_theorem(name + mark, printed),
            fmt::format("for {}, printed = exact + {}", contacts, rest));
        return;
    }
    const Coefficients all = coefficients_of(outcome, e, words);
    if (!all.departs) {
        throw NotStated("the coefficients agree");
    }
    const std::string fails = name + "_refuted" + mark;
    add(fails, refuted_theorem(fails, printed, all),
        fmt::format("for {} at which the two coefficients of {} differ, printed is not exact + {}",
                    contacts, power_text(exponent_text(e, *all.departs)), rest));
    if (outcome.correct) {
        const std::string right = name + "_corrected" + mark;
        add(right, agrees_theorem(right, {e, words(*outcome.correct), ""}),
            fmt::format("for {}, corrected = exact + {}", contacts, rest));
    }
    const std::string there = name + "_instance" + mark;
    add(there, instance_theorem(there, printed, all),
        "there is a contact at which the two coefficients differ");
}

} // namespace

// The claim is f = T + O(eps^(n+1)). If it is refuted: f - T is not o(eps^n) at any contact at
// which the first pair of different coefficients has different values. If it is proved or
// corrected: f - T is o(eps^n) at every contact. Both are stated under each reading.
void certify_expansion(const ClaimResult& result, const Ledger& ledger, Certificate& certificate) {
    const Claim& claim = result.claim;
    const bool refuted = result.outcome.verdict == Verdict::refuted;
    if (!refuted && result.outcome.verdict != Verdict::proved) {
        throw NotStated("only expansions that are refuted or proved are stated");
    }
    if (expanded_of(claim).symmetric && !is_symmetric(profiles_of(ledger, claim.text("over")))) {
        throw NotStated("the expansion is stated for symmetric contacts only");
    }
    Theory theory;
    theory.imports = {"Contact", "Coefficients", "Edges",      "ClosedForm", "Symmetric",
                      "Unique",  "Tactics",      "Expansions", "HalfPowers", "PressureExpansions",
                      "Curved"};
    certificate.text = file_head(claim, ledger, theory);
    if (claim.readings.empty()) {
        state(claim, result.outcome, refuted, "", certificate);
    }
    for (std::size_t i = 0; i < claim.readings.size(); ++i) {
        state(claim.readings[i], result.readings.at(i).second, refuted, fmt::format("_{}", i + 1),
              certificate);
    }
    certificate.whole_verdict = true;
    certificate.leaves_out = "the load and the left edge are taken to be smooth functions of the "
                             "right edge; the remainder is o(eps^n), not O(eps^(n+1))";
    if (certificate.text.find("rises_at") != std::string::npos) {
        certificate.leaves_out = "the punch is taken to be convex; " + certificate.leaves_out;
    }
}

namespace {

// The bracket for which Uniform.v has a bound for all sigma at once, before its approximation is
// subtracted.
constexpr std::string_view bracket = "(-b+eps+bof(a+(binv(b-eps)-a)*sigma))/(eps*(1-sigma))";
constexpr std::string_view bracket_in_coq =
    "(- b a + eps + b (a + (alpha (b a - eps) - a) * sigma)) / (eps * (1 - sigma))";

} // namespace

// States the refutation of "breaks down as sigma -> 1" at every contact: the remainder divided by
// eps^2 has a bound that is the same for all sigma.
void certify_uniformity(const ClaimResult& result, const Ledger& ledger, Certificate& certificate) {
    const Claim& claim = result.claim;
    if (result.outcome.verdict != Verdict::refuted || claim.text("of") != bracket ||
        claim.text("small") != "eps" || claim.integer("order") != 2 ||
        claim.text("variable") != "sigma" || claim.text("towards") != "1") {
        throw NotStated(
            "the Coq files have no bound of such an expansion for all values of its variable");
    }
    Theory theory = smooth_contact(false);
    theory.imports.insert(theory.imports.end(), {"Expansions", "Uniform"});
    for (const char* name : {"eps", "sigma"}) {
        theory.names.emplace(name, name);
    }
    const std::string name = coq_name(claim.id) + "_refuted";
    certificate.text =
        file_head(claim, ledger, theory) +
        fmt::format(
            "Theorem {0} (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) :\n"
            "  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->\n"
            "  is_left_edge a b b1 b2 b3 alpha ->\n"
            "  exists M d : R, 0 < d /\\ forall eps sigma, 0 < eps < d -> 0 < sigma < 1 ->\n"
            "  Rabs ({1}\n    - ({2})) <= M * eps ^ 2.\nProof.\n"
            "  exact (bracket_uniform Es g1 a P P1 P2 P3 b b1 b2 b3 alpha).\nQed.\n",
            name, bracket_in_coq, coq_text(claim.formula("approximation"), theory.names));
    certificate.theorems = {
        {name, "for all contacts, what is left is at most M eps^2, for all sigma between 0 and 1"}};
    certificate.whole_verdict = true;
    certificate.leaves_out = std::string(smoothness);
}

} // namespace edgeproof::certificate
