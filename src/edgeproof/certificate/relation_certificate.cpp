// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/theory/theory.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

namespace edgeproof::certificate {
namespace {

/// The contacts of a theorem, at one edge. The conclusion is about the distance u from the edge,
/// and about unknowns with these names. In Coq, `@` stands for the name of the edge, and `%` for
/// its place.
struct Subject {
    std::string_view name; ///< in `Compared`
    std::string_view parameters;
    std::string_view condition;
    std::string_view series;
    std::string_view end;      ///< the places are 0 < u < end
    std::string_view pressure; ///< at u; empty: the conclusion is about the shear traction
};

constexpr std::string_view low_power_law = "power law, m < 5/8";
constexpr std::string_view high_power_law = "power law, m > 5/8";
constexpr std::string_view rounded_edges = "flat and rounded";

constexpr std::array<Subject, 9> subjects{
    {{"force", "a b Q", "0 < a + b /\\ Q <> 0",
      "exists s0 s1 s2, is_the_@_shear_series (full_stick Q 0 a b) % s0 s1 s2", "a + b", ""},
     {"tension", "a b sig0", "0 < a + b /\\ sig0 <> 0",
      "exists s0 s1 s2, is_the_@_shear_series (full_stick 0 sig0 a b) % s0 s1 s2", "a + b", ""},
     {"wedge", "Es C a", "0 < Es /\\ 0 < C /\\ 0 < a",
      "exists r0 r1 r2, is_the_right_series Es (TiltedWedge.slope C 0) a r0 r1 r2", "a",
      "is_the_pressure Es (TiltedWedge.slope C 0) a (a - u) p0"},
     {"parabola", "Es C a", "0 < Es /\\ 0 < C /\\ 0 < a",
      "exists r0 r1 r2, is_the_right_series Es (Symmetric.slope (parabola C)) a r0 r1 r2", "a",
      "is_the_pressure Es (Symmetric.slope (parabola C)) a (a - u) p0"},
     {low_power_law, "Es C m a", "0 < Es /\\ 0 < C /\\ 0 <= m < 5 / 8 /\\ 0 < a",
      "exists r0 r1 r2, is_the_right_series Es (power_slope C m) a r0 r1 r2", "a",
      "is_the_pressure Es (power_slope C m) a (a - u) p0"},
     {high_power_law, "Es C m a", "0 < Es /\\ 0 < C /\\ 5 / 8 < m /\\ 0 < a",
      "exists r0 r1 r2, is_the_right_series Es (power_slope C m) a r0 r1 r2", "a",
      "is_the_pressure Es (power_slope C m) a (a - u) p0"},
     {rounded_edges, "Es t R0 a", "0 < Es /\\ 0 < t < a /\\ 0 < R0",
      "exists r0 r1 r2, is_the_right_series Es (Symmetric.slope (rounded t R0)) a r0 r1 r2", "a",
      "is_the_pressure Es (Symmetric.slope (rounded t R0)) a (a - u) p0"},
     {"tilted wedge, right", "Es phi gam a", "0 < Es /\\ 0 < phi /\\ 0 < gam /\\ 0 < a",
      "exists r0 r1 r2, is_the_right_series Es (TiltedWedge.slope phi (tilt phi gam)) a r0 r1 r2",
      "a", "is_the_pressure Es (TiltedWedge.slope phi (tilt phi gam)) a (a - u) p0"},
     {"tilted wedge, left", "Es phi gam a", "0 < Es /\\ 0 < phi /\\ 0 < gam /\\ 0 < a",
      "exists r0 r1 r2, is_the_left_series Es (TiltedWedge.slope phi (tilt phi gam)) (gam * a) r0 "
      "r1 r2",
      "gam * a",
      "is_the_pressure Es (mirrored (TiltedWedge.slope phi (tilt phi gam))) (gam * a) (gam * a - "
      "u) p0"}}};

/// A relation for which the Coq files have a lemma. In formulas of ledgers `@` stands for the name
/// of the edge, and in Coq `#` for the shear traction at the place.
struct Compared {
    std::string_view subject;
    std::string_view says;
    std::string_view where;
    std::string_view places; ///< in Coq; empty: those of the subject
    std::string_view conclusion;
    std::string_view lemma;
};

constexpr std::string_view below =
    "@_local(1, x) < p(x) and @_local(2, x) < p(x) and @_local(3, x) < p(x)";
constexpr std::string_view is_below = "r0 * sqrt u < p0 /\\ r0 * sqrt u + r1 * (u * sqrt u) < p0 "
                                      "/\\ r0 * sqrt u + r1 * (u * sqrt u) + "
                                      "r2 * (u ^ 2 * sqrt u) < p0";
constexpr std::string_view above =
    "@_local(1, x) > p(x) and @_local(2, x) > p(x) and @_local(3, x) > p(x)";
constexpr std::string_view is_above = "p0 < r0 * sqrt u /\\ p0 < r0 * sqrt u + r1 * (u * sqrt u) "
                                      "/\\ p0 < r0 * sqrt u + r1 * (u * sqrt "
                                      "u) + r2 * (u ^ 2 * sqrt u)";
constexpr std::string_view nearer = "abs(1 - @_local(2, x)/p(x)) < abs(1 - @_local(1, x)/p(x))";
constexpr std::string_view is_nearer =
    "Rabs (1 - (r0 * sqrt u + r1 * (u * sqrt u)) / p0) < Rabs (1 - r0 * sqrt u / p0)";

constexpr std::array<Compared, 12> compared{
    {{"force", "abs(@.s0)/sqrt(u) < abs(q(x))", "", "", "Rabs s0 / sqrt u < Rabs #", "force_alone"},
     {"tension", "abs(@.s0)/sqrt(u) > abs(q(x))", "u < L/2", "0 < u < (a + b) / 2",
      "Rabs # < Rabs s0 / sqrt u", "tension_alone"},
     {"tension", "abs(@.s0)/sqrt(u) > sgn(@.s0)*q(x)", "", "", "sign s0 * # < Rabs s0 / sqrt u",
      "tension_signed"},
     {"wedge", below, "x > 0", "", is_below, "wedge_symmetric Es C a"},
     {"wedge", nearer, "x > 0", "", is_nearer, "wedge_symmetric Es C a"},
     {"parabola", above, "x > 0", "", is_above, "parabola_right Es C a"},
     {"parabola", nearer, "x > 0", "", is_nearer, "parabola_right Es C a"},
     {low_power_law, "@_local(1, x) < p(x)", "x > 0", "", "r0 * sqrt u < p0",
      "power_one_term_below Es C m a"},
     {high_power_law, "@_local(1, x) > p(x)", "x > 0", "", "p0 < r0 * sqrt u",
      "power_above_near_edge Es C m a"},
     {rounded_edges, above, "", "", is_above, "rounded_right Es t R0 a"},
     {"tilted wedge, right", below, "x > 0", "", is_below, "wedge_right Es phi gam a"},
     {"tilted wedge, left", below, "x < 0", "", is_below, "wedge_left Es phi gam a"}}};

/// States that one term lies below the pressure at a place of a power law with m > 5/8, so that it
/// is not above the pressure everywhere.
constexpr std::string_view below_at_one_place = R"(Theorem {0} : exists p0 r0 r1 r2,
  is_the_pressure 1 (power_slope 1 (13 / 20)) 1 (1 - 9 / 10) p0 /\
  is_the_right_series 1 (power_slope 1 (13 / 20)) 1 r0 r1 r2 /\
  r0 * sqrt (9 / 10) < p0.
Proof.
  destruct (power_ratio (13 / 20) (9 / 10) ltac:(lra) ltac:(lra)) as (p0 & r0 & r1 & r2 & Hp & Hr & H0 & E).
  exists p0, r0, r1, r2. split; [exact Hp |]. split; [exact Hr |].
  apply (below_by_ratio _ _ H0). rewrite E. square_root_integrals. interval with (i_prec 60).
Qed.

)";

/// Returns the name of the subject to which all scenes of the claim belong, or an empty name.
std::string_view subject_of(const Claim& claim, const Ledger& ledger) {
    const auto scenes = draw_scenes(ledger.family(claim.text("over")), ledger.families);
    const auto all = [&](const auto& holds) {
        return !scenes.empty() && std::ranges::all_of(scenes, holds);
    };
    const auto zero = [&](const std::string& parameter) {
        return all([&](const SceneSpec& scene) {
            const auto found = scene.parameters.find(parameter);
            return found != scene.parameters.end() && found->second.sign() == 0;
        });
    };
    const auto profile = [&](std::string_view name) {
        return all([&](const SceneSpec& scene) { return scene.profile == name; });
    };
    const bool right = claim.edge() == Edge::right;
    if (zero("sig0")) {
        return "force";
    }
    if (zero("Q")) {
        return "tension";
    }
    if (profile("tilted-wedge")) {
        return right ? "tilted wedge, right" : "tilted wedge, left";
    }
    if (right && profile("flat-and-rounded") && all([](const SceneSpec& s) {
            return s.parameters.contains("a") && s.parameter("t").sign() > 0 &&
                   Exact(s.parameter("a").expr() - s.parameter("t").expr()).sign() > 0;
        })) {
        return rounded_edges;
    }
    if (!profile("power-law") || !right) {
        return "";
    }
    const Exact one = Exact::parse("1");
    const Exact five_eighths = Exact::parse("5/8");
    const auto exponents = [&](const auto& holds) {
        return all([&](const SceneSpec& s) { return holds(s.parameter("m")); });
    };
    return zero("m")                                             ? "wedge"
           : exponents([&](const Exact& m) { return m == one; }) ? "parabola"
           : exponents([&](const Exact& m) {
                 return m.sign() >= 0 && Exact(five_eighths.expr() - m.expr()).sign() > 0;
             })
               ? low_power_law
           : exponents([&](const Exact& m) {
                 return Exact(m.expr() - five_eighths.expr()).sign() > 0;
             }) && std::ranges::any_of(scenes,
                                       [](const SceneSpec& s) {
                                           const Exact& m = s.parameter("m");
                                           return m.is_rational() &&
                                                  m.rational() == Rational(13, 20);
                                       })
               ? high_power_law
               : "";
}

/// Returns the relation of the claim; `near_edge`: it holds near the edge alone, so that the claim
/// has no places of its own.
const Compared& compared_in(const Claim& claim, std::string_view subject, std::string_view edge,
                            bool near_edge) {
    for (const Compared& c : compared) {
        if (c.subject == subject &&
            is_condition(claim, "says", boost::replace_all_copy(std::string(c.says), "@", edge)) &&
            (near_edge || c.where.empty() ? !claim.has("where")
                                          : is_condition(claim, "where", c.where))) {
            return c;
        }
    }
    throw NotStated("the Coq files have no lemma for the relation");
}

} // namespace

// States a relation that holds, under every reading, for all contacts of a form and at all places.
// Of one term and the pressure of power laws with m > 5/8, it states that a reading holds near the
// edge, and that another one does not hold everywhere.
void certify_relation(const ClaimResult& result, const Ledger& ledger, Certificate& certificate) {
    const Claim& claim = result.claim;
    const std::string_view name_of_subject = subject_of(claim, ledger);
    const bool high = name_of_subject == high_power_law;
    if (result.outcome.verdict != (high ? Verdict::imprecise : Verdict::confirmed)) {
        throw NotStated("only relations that are confirmed, and one that is imprecise, are stated");
    }
    const bool right = claim.edge() == Edge::right;
    const std::string edge = right ? "right" : "left";
    const auto subject =
        std::ranges::find_if(subjects, [&](const Subject& s) { return s.name == name_of_subject; });
    if (subject == subjects.end()) {
        throw NotStated(
            "of relations, those of wedges, parabolas, power laws with m < 5/8 or m > 5/8, flat "
            "punches with rounded edges and full stick under one load are stated");
    }
    Theory theory;
    theory.imports = {"Contact",     "Coefficients", "Edges",  "ClosedForm", "Symmetric",
                      "TiltedWedge", "Shear",        "Unique", "Tactics",    "Sides"};
    const std::map<std::string_view, std::vector<std::string>> more{
        {low_power_law, {"Gamma", "PowerLaw", "PowerSides"}},
        {rounded_edges, {"Limits", "Gamma", "PowerLaw", "PowerSides", "RoundedSides"}},
        {high_power_law, {"Gamma", "PowerLaw", "PowerSides", "PowerError"}}};
    if (const auto files = more.find(name_of_subject); files != more.end()) {
        theory.imports.insert(theory.imports.end(), files->second.begin(), files->second.end());
    }
    certificate.text = file_head(claim, ledger, theory);
    std::vector<Claim> readings = claim.readings;
    if (readings.empty()) {
        readings.push_back(claim);
    }
    const std::string traction =
        fmt::format("(full_stick {} a b {})", name_of_subject == "force" ? "Q 0" : "0 sig0",
                    right ? "(a - u)" : "(- b + u)");
    const auto at_edge = [&](std::string_view text) {
        return boost::replace_all_copy(boost::replace_all_copy(std::string(text), "@", edge), "%",
                                       right ? "a" : "b");
    };
    const bool of_pressure = !subject->pressure.empty();
    const std::string name = coq_name(claim.id);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const Claim& reading = readings[i];
        const std::string holds = reading.text_or("holds", "everywhere");
        const bool near_edge = holds == "near-edge";
        const Verdict verdict = high ? result.readings.at(i).second.verdict : Verdict::confirmed;
        const bool may_be_near_edge =
            high || name_of_subject == low_power_law || name_of_subject == rounded_edges;
        if ((holds != "everywhere" && !(near_edge && may_be_near_edge)) ||
            (name_of_subject == rounded_edges && !near_edge) ||
            (high && verdict != (near_edge ? Verdict::confirmed : Verdict::refuted))) {
            throw NotStated(
                "only relations that hold everywhere, and some near the edge, are stated");
        }
        const Compared& c = compared_in(reading, name_of_subject, edge, near_edge);
        const std::string places = near_edge ? "exists d, 0 < d /\\ forall u, 0 < u < d"
                                   : c.places.empty()
                                       ? fmt::format("forall u, 0 < u < {}", subject->end)
                                       : fmt::format("forall u, {}", c.places);
        const std::string conclusion =
            of_pressure ? fmt::format("exists p0, {} /\\\n  ({})", subject->pressure, c.conclusion)
                        : boost::replace_all_copy(std::string(c.conclusion), "#", traction);
        const std::string proof =
            of_pressure
                ? fmt::format("  intros form. {} ({} form).\n",
                              near_edge ? "near_edge_by" : "by_first_terms", c.lemma)
                : fmt::format("  intros form. eexists. eexists. eexists.\n  split. {{ apply "
                              "the_@_shear_series, @_shear; lra. }}\n  intros u Hu. "
                              "traction_at_edge. rewrite ?no_tension. apply {}; lra.\n",
                              c.lemma);
        names.push_back(readings.size() == 1 ? name : fmt::format("{}_{}", name, names.size() + 1));
        if (verdict == Verdict::refuted) {
            certificate.text += fmt::format(fmt::runtime(below_at_one_place), names.back());
            certificate.theorems.push_back(
                {names.back(), "for m = 13/20, one term is smaller than the pressure at x = a/10"});
            continue;
        }
        certificate.text +=
            theorem_text(fmt::format("{} ({} : R)", names.back(), subject->parameters),
                         fmt::format("{} ->\n  {} /\\\n  {} -> {}", subject->condition,
                                     at_edge(subject->series), places, conclusion),
                         at_edge(proof));
        certificate.theorems.push_back(
            {names.back(), fmt::format("for all contacts of this form, {}{}", reading.text("says"),
                                       near_edge         ? " near the edge"
                                       : c.where.empty() ? ""
                                                         : fmt::format(" where {}", c.where))});
    }
    certificate.whole_verdict = true;
}

} // namespace edgeproof::certificate
