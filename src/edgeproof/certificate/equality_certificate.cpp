// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/parts.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace edgeproof::certificate {
namespace {

/// Returns the exponent q of a load given as c a^q, where c does not depend on a.
Rational exponent_of_load(const Claim& claim) {
    const Expr& load = claim.formulas("given").front();
    const bool is_power =
        claim.table("given").size() == 1 && claim.table("given").front().first == "P" &&
        load.kind() == Expr::Kind::mul && load.arg(1).kind() == Expr::Kind::pow &&
        load.arg(1).arg(0) == Expr::symbol("a") && !free_symbols(load.arg(0)).contains("a");
    if (!is_power || load.arg(1).arg(1).rational() == nullptr) {
        throw NotStated(
            "the only assumption that is stated is a load proportional to a power of a");
    }
    return *load.arg(1).arg(1).rational();
}

/// Whether all contacts of the family are of the power law whose load has this exponent.
bool are_of_power_law(const Claim& claim, const Ledger& ledger, const Rational& exponent) {
    const auto scenes = draw_scenes(ledger.family(claim.text("over")), ledger.families);
    return exponent >= 1 && std::ranges::all_of(scenes, [&](const auto& scene) {
               return scene.profile == "power-law" && scene.parameter("m").is_rational() &&
                      scene.parameter("m").rational() == exponent - 1 &&
                      scene.parameter("C").sign() > 0;
           });
}

/// Returns the theorem that the punch of the power law has such a load, and therefore the same.
std::string derived_theorem(const std::string& name, const Rational& exponent,
                            const std::string& statement) {
    return fmt::format(
        "(* The punch |x|^m has such a load. *)\n"
        "Theorem {0}_derived (Es C a : R) : 0 < C /\\ 0 < a ->\n  {1}.\nProof.\n"
        "  intros form. apply ({0} Es (power_slope C {2}) a (PowerLaw.power_load Es C {2}) "
        "(power_load_1 Es C {2})\n    (power_load_2 Es C {2}) (power_load_3 Es C {2}) 0 "
        "(Es * C * wallis ({2} + 1))).\n"
        "  - apply power_smooth_contact; lra.\n"
        "  - intros s Hs. unfold PowerLaw.power_load. do 2 f_equal. field.\n"
        "  - split; [apply power_slope_rises; lra | lra].\nQed.\n",
        name, statement, coq_number(Rational(exponent - 1)));
}

/// Returns the coefficient for which the ledger has the other side of the identity as a formula, in
/// an identity of its own; no value if this claim is about a coefficient itself.
std::optional<Expr> coefficient_meant(const Claim& claim, const Ledger& ledger) {
    for (const Claim& other : ledger.claims) {
        if (other.kind == "identity" && !other.has("given") && other.has("over") &&
            other.text("over") == claim.text("over") &&
            other.formula("says") == claim.formula("of")) {
            for (const char* name : {"right_c0", "right_c1", "right_c2"}) {
                if (other.formula("of") == Expr::symbol(name)) {
                    return other.formula("of");
                }
            }
        }
    }
    return std::nullopt;
}

} // namespace

// States, for all contacts, that the coefficients exist and that the printed formula gives them.
void certify_identity(const ClaimResult& result, const Ledger& ledger, Certificate& certificate) {
    const Claim& claim = result.claim;
    if (result.outcome.verdict != Verdict::proved) {
        throw NotStated("only identities that are proved are stated");
    }
    const bool symmetric = is_symmetric(profiles_of(ledger, claim.text("over")));
    const bool given = claim.has("given");
    if (given && !symmetric) {
        throw NotStated("an assumption on the load is stated for symmetric contacts only");
    }
    if (is_same_for_all(claim.formula("says"), claim.formula("of"), claim.edge())) {
        throw NotStated("both sides are the same, whatever the coefficients are: a theorem would "
                        "contain no mechanics");
    }
    Theory theory = smooth_contact(symmetric);
    if (given) {
        theory.imports.insert(theory.imports.end(), {"Gamma", "PowerLaw"});
    }
    const bool at_x = free_symbols(claim.formula("says")).contains("x");
    if (at_x) {
        theory.names.emplace("x", "x");
    }
    Statement statement(theory);
    const std::string printed = statement(claim.formula("says"));
    std::string exact = statement(claim.formula("of"));
    const auto meant =
        symmetric && !given && !at_x ? coefficient_meant(claim, ledger) : std::nullopt;
    if (meant) {
        exact = fmt::format("{0} /\\\n  {0} =\n  {1}", exact, statement(*meant));
    }
    const std::string name = coq_name(claim.id);
    const std::string load =
        given ? fmt::format("  (forall s, 0 < s -> P s = factor * Rpower s {}) ->\n",
                            coq_number(exponent_of_load(claim)))
              : "";
    const std::string contact = (symmetric ? "(P P1 P2 P3 : R -> R) (y" +
                                                 std::string(given ? " factor" : "") + " : R) :\n" +
                                                 "  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => "
                                                 "s) (fun _ => 1) (fun _ => 0) ->\n"
                                           : "(P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R) :\n"
                                             "  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->\n"
                                             "  is_left_edge a b b1 b2 b3 alpha ->\n") +
                                load + convex_hypothesis(symmetric);
    certificate.text =
        file_head(claim, ledger, theory) +
        fmt::format(
            "Theorem {0} (Es : R) (g1 : R -> R) (a : R) {1}  {2}.\nProof.\n  intros "
            "contact{3}.\n{4}Qed.\n",
            name, contact,
            statement.text((at_x ? "forall x, x < a ->\n  " : "") + printed + " =\n  " + exact),
            given       ? " load convex"
            : symmetric ? " convex"
                        : " left convex",
            statement.proof((at_x    ? "intros x Hx. "
                             : meant ? "split; "
                                     : "") +
                            std::string(given       ? "identity_of_power contact load a P1 P2 P3"
                                        : symmetric ? "identity_symmetric contact a P1 P2 P3"
                                                    : "identity contact left a b b1")));
    certificate.theorems = {
        {name, given
                   ? "for all symmetric contacts of such a load, with any factor, printed = derived"
               : meant     ? "for all symmetric contacts, both formulas are the coefficient"
               : symmetric ? "for all symmetric contacts, printed = derived"
                           : "for all contacts, printed = derived"}};
    if (given && are_of_power_law(claim, ledger, exponent_of_load(claim))) {
        const Rational exponent = exponent_of_load(claim);
        std::string of_punch =
            statement.text((at_x ? "forall x, x < a ->\n  " : "") + printed + " =\n  " + exact);
        boost::replace_all(of_punch, " g1 ",
                           fmt::format(" (power_slope C {}) ", coq_number(Rational(exponent - 1))));
        certificate.text += "\n" + derived_theorem(name, exponent, of_punch);
        certificate.theorems.push_back(
            {name + "_derived", "the same of every punch |x|^(m+1), whose load is derived"});
    }
    certificate.whole_verdict = true;
    certificate.leaves_out = "the punch is taken to be convex; " + std::string(smoothness);
}

namespace {

/// Returns the theorem `least <= Rabs (...)` or `Rabs (...) <= most`, with its proof.
std::string theorem(const std::string& name, const Theory& theory, const Expr& formula,
                    const Expr& exact, const std::optional<std::string>& least) {
    Statement statement(theory);
    const std::string stated = statement(formula);
    const std::string value = statement(exact);
    const std::string difference = fmt::format("Rabs (({}) - ({}))", stated, value);
    const std::string conclusion =
        least ? fmt::format("{} <= {}", *least, difference)
              : fmt::format("{} <= {} * Rabs ({})", difference, agreement, value);
    return theorem_text(
        name, statement.text(conclusion),
        statement.proof(least ? "numbers constants" : "apply Rminus_le. numbers constants"));
}

/// Whether the tactics for all contacts of a form can prove identities with this formula: it is
/// made of fractions, pi, square roots, half powers and powers of a as power laws have them, and of
/// values of functions and of integrals for which there is a lemma.
bool is_algebraic(const Expr& e) {
    using Kind = Expr::Kind;
    switch (e.kind()) {
    case Kind::pow: {
        const std::string text = to_text(e);
        const bool of_power_law = text == "a^m" || text == "a^(m + 1)" || text == "a^(m - 1/2)" ||
                                  text == "a^(m - 3/2)" || text == "a^(m - 5/2)";
        return of_power_law || (e.arg(1).rational() != nullptr &&
                                denominator(*e.arg(1).rational()) <= 2 && is_algebraic(e.arg(0)));
    }
    case Kind::call: {
        const std::string text = to_text(e);
        return text == "asin(t/a)" || text == "sin(Pi*alpha/(2*phi))" || text == "p(x)" ||
               text == "gamma(2 + m/2)" || text == "gamma((3 + m)/2)" ||
               (e.builtin() == formula::Builtin::sqrt && is_algebraic(e.arg(0)));
    }
    case Kind::integral:
    case Kind::pv:
        return true;
    default:
        return std::ranges::all_of(e.args(), is_algebraic);
    }
}

/// Whether the contacts of the family are as the theory of the form assumes: larger than their
/// flat, and the parameter gam, if there is one, is b/a.
bool are_of_the_form(const Claim& claim, const Ledger& ledger) {
    const auto scenes = draw_scenes(ledger.family(claim.text("over")), ledger.families);
    return std::ranges::all_of(scenes, [](const SceneSpec& scene) {
        const auto& given = scene.parameters;
        if (scene.profile == "power-law" &&
            (given.at("m").sign() < 0 || given.at("C").sign() <= 0)) {
            return false;
        }
        if (given.contains("a") && given.contains("t") &&
            Exact(given.at("a").expr() - given.at("t").expr()).sign() <= 0) {
            return false;
        }
        if (!given.contains("gam") || !given.contains("phi") || !given.contains("alpha")) {
            return true;
        }
        const double sine = std::sin(std::numbers::pi / 2 * given.at("alpha").to<double>() /
                                     given.at("phi").to<double>());
        const auto gam = given.at("gam").to<double>();
        return std::abs(sine - (1 - gam) / (1 + gam)) < 1e-9;
    });
}

/// Returns the theorem that the formula is exact for all contacts of the theory's form, with its
/// definitions; no value if the theory does not have all the quantities.
std::optional<std::string> theorem_for_all(const std::string& name, const Theory& theory,
                                           const Expr& formula, const Expr& exact) {
    if (!is_algebraic(formula) || !is_algebraic(exact)) {
        return std::nullopt;
    }
    try {
        Statement statement(theory);
        const std::string conclusion = fmt::format("{} = {}", statement(formula), statement(exact));
        const Theory::AllOfForm& all = theory.all_of_form.value();
        const bool at_x = free_symbols(formula).contains("x") || free_symbols(exact).contains("x");
        const std::string gamma =
            theory.names.contains("gamma") ? "forall Gam, is_gamma Gam ->\n  " : "";
        return constants({}) +
               theorem_text(fmt::format("{} ({}{} : R)", name, all.parameters, at_x ? " x" : ""),
                            fmt::format("{}{}{} ->\n  {}", gamma, all.condition,
                                        at_x ? " /\\ " + all.place : "",
                                        statement.text(conclusion)),
                            fmt::format("  {}.\n{}", all.begin, statement.proof(all.identity)));
    } catch (const NotStated&) {
        return std::nullopt;
    }
}

/// Whether the claim is about places x > 0 only, by its condition.
bool is_right_of_origin(const Claim& claim) {
    return claim.has("where") &&
           std::ranges::any_of(claim.condition("where"), [](const Relation& r) {
               return r.lhs == Expr::symbol("x") && r.op == Relation::Op::greater &&
                      r.rhs == Expr();
           });
}

std::optional<Expr> correction(const ClaimResult& result) {
    if (!result.outcome.correct) {
        return std::nullopt;
    }
    try {
        return expand_definitions(parse_formula(*result.outcome.correct, result.claim.vocabulary),
                                  result.claim.vocabulary);
    } catch (const Error&) {
        return std::nullopt; // the correction is in words
    }
}

/// Replaces the load of a symmetric punch that is written as its integral. `is_load` in Contact.v
/// is this integral.
Expr load_of_integral(const Expr& e) {
    return to_text(e) == "Es/2*integral(s*g1(s)/sqrt(a^2 - s^2), s, -a, a)" ? Expr::symbol("P") : e;
}

bool is_of_shear(const Expr& e) {
    const auto symbols = free_symbols(e);
    return std::ranges::any_of(symbols, [](const std::string& name) {
        return name.starts_with("right_s") || name.starts_with("left_s") || name == "sig0";
    });
}

/// Whether the sample is proved to be one that the condition of the claim admits.
bool admits(const Claim& claim, const Sample& sample) {
    using Op = Relation::Op;
    return !claim.has("where") ||
           std::ranges::all_of(claim.condition("where"), [&](const Relation& r) {
               const bool less = r.op == Op::less || r.op == Op::less_equal;
               const Expr& larger = less ? r.rhs : r.lhs;
               return r.op != Op::equal &&
                      excess(larger, sample, less ? r.lhs : r.rhs, sample).has_value();
           });
}

/// Returns the sample of the claim at which the relative difference of the two is largest.
const SampledTheory* clearest(const Claim& claim, const std::vector<SampledTheory>& theories,
                              const Expr& printed, const Expr& exact, Gap& gap) {
    const SampledTheory* best = nullptr;
    for (const SampledTheory& t : theories) {
        if (!admits(claim, t.sample)) {
            continue;
        }
        const auto here = gap_at(printed, exact, t.sample);
        if (here && here->relative > gap.relative) {
            gap = *here;
            best = &t;
        }
    }
    return best;
}

} // namespace

void certify_value(const ClaimResult& result, const Ledger& ledger, Certificate& certificate) {
    const Claim& claim = result.claim;
    const bool refuted = result.outcome.verdict == Verdict::refuted;
    if (!refuted && result.outcome.verdict != Verdict::confirmed) {
        throw NotStated("only claims that are refuted or confirmed are stated");
    }
    if (claim.has("vary") || !claim.readings.empty()) {
        throw NotStated("variables of its own and several readings are not stated in Coq");
    }
    const Expr printed = claim.formula("says");
    const Expr exact = load_of_integral(claim.formula("of"));
    if (is_same_for_all(printed, exact, claim.edge())) {
        throw NotStated(
            "the formula is the quantity itself, whatever the coefficients are: a theorem "
            "would contain no mechanics");
    }
    std::vector<SampledTheory> theories;
    const auto profiles = profiles_of(ledger, claim.text("over"));
    std::optional<Theory> form;
    if (is_of_shear(printed) || is_of_shear(exact)) {
        theories.push_back(sheared_contact(claim.edge(), {"sig0", "1", Exact::parse("1")}));
        form = theory_of_shear(claim.edge(), "sig0");
    } else if (profiles.size() == 1) {
        if (!are_of_the_form(claim, ledger)) {
            throw NotStated("the Coq files have no theory of these contacts of the profile");
        }
        form = theory_of_form(profiles.front());
    }
    for (const std::string& profile : profiles) {
        for (SampledTheory& t : sampled_theories(profile)) {
            theories.push_back(std::move(t));
        }
    }
    if (theories.empty() && !form) {
        throw NotStated("the Coq files have no theory of the profile");
    }
    const std::string name = coq_name(claim.id);
    const auto for_all = [&](const std::string& theorem, const Expr& formula) {
        return form ? theorem_for_all(theorem, *form, formula, exact) : std::nullopt;
    };
    if (!refuted) {
        if (const auto all = for_all(name, printed)) {
            certificate.text = file_head(claim, ledger, *form) + *all;
            certificate.theorems = {{name, "for all contacts of this form, printed = exact"}};
            const bool at_x =
                free_symbols(printed).contains("x") || free_symbols(exact).contains("x");
            certificate.whole_verdict = !at_x || !form->all_of_form->place.starts_with("0 < x") ||
                                        is_right_of_origin(claim);
            certificate.leaves_out = certificate.whole_verdict ? "" : "places x < 0";
            return;
        }
        if (theories.empty()) {
            throw NotStated("the Coq files have no lemma for all contacts of the profile");
        }
        const Theory& theory = theories.front().theory;
        certificate.text = file_head(claim, ledger, theory) + constants(theory.constants) +
                           theorem(name + "_agrees", theory, printed, exact, std::nullopt);
        certificate.theorems = {
            {name + "_agrees", "at one contact, |printed - exact| <= 1e-12 |exact|"}};
        certificate.leaves_out = "all other contacts";
        return;
    }
    Gap gap;
    const SampledTheory* const sample = clearest(claim, theories, printed, exact, gap);
    if (sample == nullptr) {
        throw NotStated("the formula agrees at the samples that the Coq files have");
    }
    const Theory& theory = sample->theory;
    const std::string least = fraction_below(gap.least);
    const std::string refutation =
        constants(theory.constants) + theorem(name + "_refuted", theory, printed, exact, least);
    certificate.text = file_head(claim, ledger, theory);
    certificate.theorems = {
        {name + "_refuted", fmt::format("at one contact, |printed - exact| >= {}", least)}};
    certificate.whole_verdict = true; // for which one contact suffices
    auto corrected = correction(result);
    if (corrected && is_same_for_all(*corrected, exact, claim.edge())) {
        corrected.reset(); // as above: the theorem would contain no mechanics
    }
    const auto all = corrected ? for_all(name + "_corrected", *corrected) : std::nullopt;
    if (all) {
        // A module, so that the numbers of the refutation can have the names of the parameters.
        certificate.text +=
            fmt::format(
                "Module Correction.\n{0}End Correction.\nDefinition {1} := Correction.{1}.\n\n",
                *all, name + "_corrected") +
            refutation;
        certificate.theorems.push_back(
            {name + "_corrected", "for all contacts of this form, corrected = exact"});
        return;
    }
    certificate.text += refutation;
    if (corrected) {
        certificate.text += theorem(name + "_corrected", theory, *corrected, exact, std::nullopt);
        certificate.theorems.push_back(
            {name + "_corrected", "at the same contact, |corrected - exact| <= 1e-12 |exact|"});
    }
    certificate.leaves_out = "that the correction holds for all contacts";
}

} // namespace edgeproof::certificate
