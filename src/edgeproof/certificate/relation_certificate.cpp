// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/theory/statement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::certificate {
namespace {

/// The contacts of a theorem, at one edge, and the beginning of its statement and of its proof. The
/// conclusion is about the distance u from the edge, and about unknowns with these names.
struct Subject {
    std::string_view name; ///< in `Compared`
    std::string_view parameters;
    std::string_view condition;
    std::string_view statement; ///< up to the conclusion
    std::string_view places;    ///< for `Compared` without places of its own
    std::string_view proof;     ///< with {} for the lemma of a relation
};

constexpr std::string_view pressure_proof = "  intros form. by_first_terms ({} form).\n";
constexpr std::string_view shear_proof =
    "  intros form. eexists. eexists. eexists.\n  split. {{ apply the_@_shear_series, @_shear; "
    "lra. "
    "}}\n  intros u Hu. traction_at_edge. rewrite ?no_tension. apply {}; lra.\n";

constexpr std::array<Subject, 6> subjects{
    {{"force", "a b Q", "0 < a + b /\\ Q <> 0",
      "exists s0 s1 s2, is_the_@_shear_series (full_stick Q 0 a b) % s0 s1 s2 /\\\n  forall u, ",
      "0 < u < a + b", shear_proof},
     {"tension", "a b sig0", "0 < a + b /\\ sig0 <> 0",
      "exists s0 s1 s2, is_the_@_shear_series (full_stick 0 sig0 a b) % s0 s1 s2 /\\\n  forall u, ",
      "0 < u < a + b", shear_proof},
     {"wedge", "Es C a", "0 < Es /\\ 0 < C /\\ 0 < a",
      "exists r0 r1 r2, is_the_right_series Es (TiltedWedge.slope C 0) a r0 r1 r2 /\\\n  forall "
      "u, ",
      "0 < u < a -> exists p0, is_the_pressure Es (TiltedWedge.slope C 0) a (a - u) p0 /\\\n  (",
      pressure_proof},
     {"parabola", "Es C a", "0 < Es /\\ 0 < C /\\ 0 < a",
      "exists r0 r1 r2, is_the_right_series Es (Symmetric.slope (parabola C)) a r0 r1 r2 /\\\n  "
      "forall u, ",
      "0 < u < a -> exists p0, is_the_pressure Es (Symmetric.slope (parabola C)) a (a - u) p0 "
      "/\\\n  (",
      pressure_proof},
     {"tilted wedge, right", "Es phi gam a", "0 < Es /\\ 0 < phi /\\ 0 < gam /\\ 0 < a",
      "exists r0 r1 r2, is_the_right_series Es (TiltedWedge.slope phi (tilt phi gam)) a r0 r1 r2 "
      "/\\\n  forall u, ",
      "0 < u < a -> exists p0, is_the_pressure Es (TiltedWedge.slope phi (tilt phi gam)) a (a - u) "
      "p0 /\\\n  (",
      pressure_proof},
     {"tilted wedge, left", "Es phi gam a", "0 < Es /\\ 0 < phi /\\ 0 < gam /\\ 0 < a",
      "exists r0 r1 r2, is_the_left_series Es (TiltedWedge.slope phi (tilt phi gam)) (gam * a) r0 "
      "r1 r2 /\\\n  forall u, ",
      "0 < u < gam * a -> exists p0, is_the_pressure Es (mirrored (TiltedWedge.slope phi (tilt phi "
      "gam))) (gam * a) (gam * a - u) p0 /\\\n  (",
      pressure_proof}}};

/// A relation for which the Coq files have a lemma. In formulas of ledgers, and in Coq, `@` stands
/// for the name of the edge, and `#` in Coq for the shear traction at the place.
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

constexpr std::array<Compared, 9> compared{
    {{"force", "abs(@.s0)/sqrt(u) < abs(q(x))", "", "", "Rabs s0 / sqrt u < Rabs #", "force_alone"},
     {"tension", "abs(@.s0)/sqrt(u) > abs(q(x))", "u < L/2", "0 < u < (a + b) / 2",
      "Rabs # < Rabs s0 / sqrt u", "tension_alone"},
     {"tension", "abs(@.s0)/sqrt(u) > sgn(@.s0)*q(x)", "", "", "sign s0 * # < Rabs s0 / sqrt u",
      "tension_signed"},
     {"wedge", below, "x > 0", "", is_below, "wedge_symmetric Es C a"},
     {"wedge", nearer, "x > 0", "", is_nearer, "wedge_symmetric Es C a"},
     {"parabola", above, "x > 0", "", is_above, "parabola_right Es C a"},
     {"parabola", nearer, "x > 0", "", is_nearer, "parabola_right Es C a"},
     {"tilted wedge, right", below, "x > 0", "", is_below, "wedge_right Es phi gam a"},
     {"tilted wedge, left", below, "x < 0", "", is_below, "wedge_left Es phi gam a"}}};

std::string replaced(std::string text, char sign, std::string_view by) {
    for (std::size_t at = text.find(sign); at != std::string::npos;
         at = text.find(sign, at + by.size())) {
        text.replace(at, 1, by);
    }
    return text;
}

/// Returns the name of the subject to which all scenes of the claim belong, or an empty name.
std::string_view subject_of(const audit::Claim& claim, const audit::Ledger& ledger) {
    const auto scenes = draw_scenes(ledger.family(claim.text("over")), ledger.families);
    const auto all = [&](const auto& holds) {
        return !scenes.empty() && std::all_of(scenes.begin(), scenes.end(), holds);
    };
    const auto zero = [&](const std::string& parameter) {
        return all([&](const audit::SceneSpec& scene) {
            const auto found = scene.parameters.find(parameter);
            return found != scene.parameters.end() && found->second.sign() == 0;
        });
    };
    const auto profile = [&](std::string_view name) {
        return all([&](const audit::SceneSpec& scene) { return scene.profile == name; });
    };
    const formula::Exact one = formula::Exact::parse("1");
    return zero("sig0")                        ? "force"
           : zero("Q")                         ? "tension"
           : profile("power-law") && zero("m") ? "wedge"
           : profile("power-law") &&
                   all([&](const audit::SceneSpec& s) { return s.parameter("m") == one; })
               ? "parabola"
           : profile("tilted-wedge")
               ? claim.edge() == contact::Edge::right ? "tilted wedge, right" : "tilted wedge, left"
               : "";
}

const Compared& compared_in(const audit::Claim& claim, std::string_view subject,
                            std::string_view edge) {
    for (const Compared& c : compared) {
        if (c.subject == subject &&
            is_condition(claim, "says", replaced(std::string(c.says), '@', edge)) &&
            (c.where.empty() ? !claim.has("where") : is_condition(claim, "where", c.where))) {
            return c;
        }
    }
    throw NotStated("the Coq files have no lemma for the relation");
}

} // namespace

// States a relation that holds, under every reading, for all contacts of a form and at all places.
void certify_relation(const audit::ClaimResult& result, const audit::Ledger& ledger,
                      Certificate& certificate) {
    const audit::Claim& claim = result.claim;
    if (result.outcome.verdict != audit::Verdict::confirmed) {
        throw NotStated("only relations that are confirmed are stated");
    }
    const std::string_view name_of_subject = subject_of(claim, ledger);
    const bool right = claim.edge() == contact::Edge::right;
    const std::string edge = right ? "right" : "left";
    const auto subject = std::find_if(subjects.begin(), subjects.end(),
                                      [&](const Subject& s) { return s.name == name_of_subject; });
    if (subject == subjects.end()) {
        throw NotStated(
            "of relations, those of wedges, parabolas and full stick under one load are "
            "stated");
    }
    Theory theory;
    theory.imports = {"Contact",     "Coefficients", "Edges",  "ClosedForm", "Symmetric",
                      "TiltedWedge", "Shear",        "Unique", "Tactics",    "Sides"};
    certificate.text = file_head(claim, ledger, theory);
    std::vector<audit::Claim> readings = claim.readings;
    if (readings.empty()) {
        readings.push_back(claim);
    }
    const std::string traction =
        fmt::format("(full_stick {} a b {})", name_of_subject == "force" ? "Q 0" : "0 sig0",
                    right ? "(a - u)" : "(- b + u)");
    const auto at_edge = [&](std::string_view text) {
        return replaced(replaced(std::string(text), '@', edge), '%', right ? "a" : "b");
    };
    const bool of_pressure = subject->proof == pressure_proof;
    const std::string name = coq_name(claim.id);
    std::vector<std::string> names;
    for (const audit::Claim& reading : readings) {
        if (reading.text_or("holds", "everywhere") != "everywhere") {
            throw NotStated("only relations that hold everywhere are stated");
        }
        const Compared& c = compared_in(reading, name_of_subject, edge);
        const std::string conclusion =
            of_pressure ? std::string(c.conclusion) + ")"
                        : " -> " + replaced(std::string(c.conclusion), '#', traction);
        names.push_back(readings.size() == 1 ? name : fmt::format("{}_{}", name, names.size() + 1));
        certificate.text += theorem_text(
            fmt::format("{} ({} : R)", names.back(), subject->parameters),
            fmt::format("{} ->\n  {}{}{}", subject->condition, at_edge(subject->statement),
                        c.places.empty() ? subject->places : c.places, conclusion),
            fmt::format(fmt::runtime(at_edge(subject->proof)), c.lemma));
        certificate.theorems.push_back(
            {names.back(), fmt::format("for all contacts of this form, {}{}", reading.text("says"),
                                       c.where.empty() ? "" : fmt::format(" where {}", c.where))});
    }
    certificate.whole_verdict = true;
}

} // namespace edgeproof::certificate
