// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/quoted_figure.hpp"
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/stated_contact.hpp"
#include "edgeproof/certificate/theory/theory.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace edgeproof::certificate {
namespace {

/// The place x of the contact with Es = C = a = 1, the figure, half a unit of its last digit.
constexpr std::string_view theorems = R"(Theorem {0} : exists p0 r0 r1 r2,
  is_the_pressure 1 (power_slope 1 {1}) 1 {2} p0 /\
  is_the_right_series 1 (power_slope 1 {1}) 1 r0 r1 r2 /\
  Rabs (Rabs (1 - r0 * ((1 - {2}) ^ 0 * sqrt (1 - {2})) / p0) - {3}) < {4}.
Proof.
  destruct (power_relative_error 1 1 {1} 1 {2} {1} ltac:(lra) ltac:(lra) ltac:(simpl; ring) ltac:(lra))
    as (p0 & r0 & r1 & r2 & Hp & Hr & E).
  exists p0, r0, r1, r2. split; [exact Hp |]. split; [exact Hr |].
  rewrite E. integrals. interval with (i_prec 90).
Qed.

(* The same at every scale: for all slopes h1 that are scaled copies, and all moduli. *)
Theorem {0}_similar : forall Fs lam mu h1, 0 < Fs -> 0 < lam -> 0 < mu ->
  (forall x, h1 (lam * x) = mu * power_slope 1 {1} x) -> exists p0 r0 r1 r2,
  is_the_pressure Fs h1 (lam * 1) (lam * {2}) p0 /\
  is_the_right_series Fs h1 (lam * 1) r0 r1 r2 /\
  Rabs (Rabs (1 - r0 * ((lam * 1 - lam * {2}) ^ 0 * sqrt (lam * 1 - lam * {2})) / p0) - {3}) < {4}.
Proof.
  intros Fs lam mu h1 HFs Hlam Hmu Hh. destruct {0} as (p0 & r0 & r1 & r2 & Hp & Hr & H).
  apply (figure_scaled 1 Fs (power_slope 1 {1}) h1 lam mu 1 {2} p0 r0 r1 r2 {3} {4}); first [assumption | lra].
Qed.
)";

/// The angle of a wedge, its tilt, the figure, half a unit of its last digit.
constexpr std::string_view ratio_of_edges = R"(Theorem {0} (a : R) : 0 < a ->
  exists b, is_the_left_edge (slope {1} {2}) a b /\ Rabs (b / a - {3}) < {4}.
Proof.
  intros Ha. assert (Hpi := PI_RGT_0). exists (ratio_of {1} {2} * a).
  split; [apply left_edge_by_tilt; first [exact Ha | lra | split; interval] |].
  replace (ratio_of {1} {2} * a / a) with (ratio_of {1} {2}) by (field; lra).
  unfold ratio_of. interval with (i_prec 60).
Qed.
)";

/// Whether all scenes have this profile and the same value of each of these parameters.
bool have_one(const std::vector<SceneSpec>& scenes, std::string_view profile,
              const std::vector<std::string>& parameters) {
    return !scenes.empty() && std::ranges::all_of(scenes, [&](const SceneSpec& scene) {
        return scene.profile == profile &&
               std::ranges::all_of(parameters, [&](const std::string& p) {
                   return scene.parameter(p) == scenes.front().parameter(p);
               });
    });
}

} // namespace

// States a confirmed figure that is quoted for b/a of a tilted wedge, at every size, or for the
// relative error of one term, at one place of a power law: the exact value is less than half a unit
// of the last quoted digit away from the figure, so that there is no tie. A second theorem extends
// this to every size, slope and modulus.
void certify_figure(const ClaimResult& result, const Ledger& ledger, Certificate& certificate) {
    const Claim& claim = result.claim;
    if (result.outcome.verdict != Verdict::confirmed) {
        throw NotStated("only confirmed figures are stated");
    }
    const Family& family = ledger.family(claim.text("over"));
    const auto scenes = draw_scenes(family, ledger.families);
    const audit::QuotedFigure figure = audit::QuotedFigure::of(claim);
    const Rational half = figure.within_units(Rational(1, 2)).second - figure.value();
    Theory theory;
    const std::string name = coq_name(claim.id) + "_figure";
    if (claim.readings.empty() && have_one(scenes, "tilted-wedge", {"phi", "alpha"}) &&
        is_formula(claim, "of", "b/a")) {
        theory.imports = {"Contact", "Edges", "TiltedWedge", "Unique", "Tactics", "Limits"};
        certificate.text =
            file_head(claim, ledger, theory) +
            fmt::format(fmt::runtime(ratio_of_edges), name, in_coq(scenes.front().parameter("phi")),
                        in_coq(scenes.front().parameter("alpha")), coq_number(figure.value()),
                        coq_number(half));
        certificate.theorems = {
            {name, "at every size it rounds to what is quoted, " + claim.text("quoted")}};
        certificate.whole_verdict = true; // all scenes are this wedge with this tilt
        return;
    }
    if (!have_one(scenes, "power-law", {"m"}) || claim.edge() != Edge::right ||
        family.u.size() != 1 || !family.u.front().is_rational() ||
        to_text(claim.formula("of")) != "abs(1 - right_local(1, x)/p(x))") {
        throw NotStated("of figures, b/a of a tilted wedge and relative errors of one term at one "
                        "place of power laws are stated");
    }
    const Exact m = scenes.front().parameter("m");
    if (!m.is_rational() || denominator(m.rational()) != 1 || m.rational() < 0 ||
        m.rational() > 100) {
        throw NotStated("of power laws, figures are stated of those with a whole exponent");
    }
    theory.imports = {"Contact", "Unique", "Scaling", "Tactics", "PowerLaw"};
    certificate.text = file_head(claim, ledger, theory) +
                       fmt::format(fmt::runtime(theorems), name, coq_number(m.rational()),
                                   coq_number(Rational(1 - 2 * family.u.front().rational())),
                                   coq_number(figure.value()), coq_number(half));
    certificate.theorems = {
        {name, "at one contact it rounds to what is quoted, " + claim.text("quoted")},
        {name + "_similar", "the same at every contact that is a larger or smaller copy, as all of "
                            "the family are"}};
    certificate.whole_verdict = true; // all scenes have this exponent and this place
}

} // namespace edgeproof::certificate
