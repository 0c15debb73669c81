// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/parts/quoted_figure.hpp"
#include "edgeproof/certificate/extent_parts.hpp"
#include "edgeproof/certificate/parts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace edgeproof::certificate {
namespace {

/// States that the terms are beyond the tolerance at all places of a tilted wedge, seen from its
/// left edge, except up to {1}, between {2} and {3}, and at the apex, where there is no pressure.
/// Near the apex, between {4} and {5}, and beyond {6}, the pressure is compared with that at these
/// places. {7} and {8} are bounds of the left edge, {9} of the width. Of the last line, the proof
/// is by intervals.
constexpr std::string_view outside = R"(
Definition K : R := Es * phi * sqrt gam.
Lemma gam_a_near : {7} < gam * a < {8} /\ {6} < a + gam * a < {9}.
Proof. constants. unfold ratio_of. repeat split; apply Rminus_lt; interval with (i_prec 60). Qed.
Lemma positive_factors : 0 < K /\ 0 < K / gam /\ 0 < / gam.
Proof.
  assert (G := proj1 tilted). assert (F : 0 < Es /\ 0 < phi) by sides constants.
  assert (0 < sqrt gam) by (apply sqrt_lt_R0; exact G). assert (0 < / gam) by (apply Rinv_0_lt_compat; exact G).
  assert (0 < K) by (unfold K; apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; apply F | assumption]).
  split; [assumption | split; [apply Rdiv_lt_0_compat; assumption | assumption]].
Qed.
Lemma pressure_on_the_left u : 0 < u < gam * a -> is_the_pressure Es (mirrored (slope phi alpha)) (gam * a) (gam * a - u)
  (proportional_pressure (K / gam) (/ gam) (gam * a) (gam * a - u)).
Proof.
  intros Hu. apply (the_pressure _ _ 0); [apply mirrored_wedge_rises; sides constants | lra |].
  rewrite <- (proj2 tilted). apply pressure_left_of_apex; sides constants.
Qed.
Lemma pressure_on_the_right u : gam * a < u < gam * a + a -> is_the_pressure Es (slope phi alpha) a (u - gam * a)
  (proportional_pressure K gam a (u - gam * a)).
Proof.
  intros Hu. apply (the_pressure _ _ 0); [apply wedge_rises; sides constants | lra |].
  rewrite <- (proj2 tilted). apply pressure_right_of_apex; sides constants.
Qed.
Lemma sum_far_below tol p sum least : 0 < tol <= 1 / 10 -> 0 < least -> least <= p -> sum <= 4 / 5 * least -> tol * p < Rabs (p - sum).
Proof. intros. rewrite Rabs_pos_eq; nra. Qed.
Lemma sum_far_above tol p sum most : 0 < tol <= 1 / 10 -> 0 <= p <= most -> 2 * most < sum -> tol * p < Rabs (p - sum).
Proof. intros. rewrite Rabs_left; nra. Qed.

(* Everywhere else the terms are not within the tolerance. *)
Theorem {0} : exists r0 r1 r2,
  {10} /\
  (forall u, {1} <= u < gam * a -> exists p0, is_the_pressure Es (mirrored (slope phi alpha)) (gam * a) (gam * a - u) p0 /\
    {11} * p0 < Rabs (p0 - ({12}))) /\
  (forall u, gam * a < u <= {2} -> exists p0, is_the_pressure Es (slope phi alpha) a (u - gam * a) p0 /\
    {11} * p0 < Rabs (p0 - ({12}))) /\
  (forall u, {3} <= u < gam * a + a -> exists p0, is_the_pressure Es (slope phi alpha) a (u - gam * a) p0 /\
    {11} * p0 < Rabs (p0 - ({12}))) /\
  {14}.
Proof.
  assert (G := gam_a_near). destruct positive_factors as (K1 & K2 & K3). assert (Hg := proj1 tilted).
  eexists. eexists. eexists. split. {{ {13}. }}
  split; [| split; [| split]].
  - intros u Hu. eexists. split; [apply pressure_on_the_left; lra |].
    destruct (Rle_lt_dec u ({4})) as [H | H].
    + assert (B : {1} <= u <= {4}) by lra. clear - B. unfold K. plain constants. unfold atanh.
      apply Rminus_lt. interval with (i_bisect u, i_taylor u, i_depth 60).
    + destruct (proportional_falls (K / gam) (/ gam) (gam * a) (gam * a - u) (gam * a - {4}) K2 K3 ltac:(lra) ltac:(lra)) as [_ F].
      assert (B : {4} <= u <= {8}) by lra. clear - F B.
      apply (sum_far_below _ _ _ (proportional_pressure (K / gam) (/ gam) (gam * a) (gam * a - {4})));
        [lra | | exact F |]; clear F; unfold K; plain constants; unfold atanh.
      * interval with (i_prec 60).
      * apply Rminus_le. interval with (i_bisect u, i_prec 60).
  - intros u Hu. eexists. split; [apply pressure_on_the_right; lra |].
    destruct (Rle_lt_dec ({5}) u) as [H | H].
    + assert (B : {5} <= u <= {2}) by lra. clear - B. unfold K. plain constants. unfold atanh.
      apply Rminus_lt. interval with (i_bisect u, i_taylor u, i_depth 60).
    + destruct (proportional_falls K gam a (u - gam * a) ({5} - gam * a) K1 ltac:(lra) ltac:(lra) ltac:(lra)) as [_ F].
      assert (B : {7} <= u <= {5}) by lra. clear - F B.
      apply (sum_far_below _ _ _ (proportional_pressure K gam a ({5} - gam * a)));
        [lra | | exact F |]; clear F; unfold K; plain constants; unfold atanh.
      * interval with (i_prec 60).
      * apply Rminus_le. interval with (i_bisect u, i_prec 60).
  - intros u Hu. eexists. split; [apply pressure_on_the_right; lra |].
    destruct (Rle_lt_dec u ({6})) as [H | H].
    + assert (B : {3} <= u <= {6}) by lra. clear - B. unfold K. plain constants. unfold atanh.
      apply Rminus_lt. interval with (i_bisect u, i_taylor u, i_depth 60).
    + assert (F := proportional_falls K gam a ({6} - gam * a) (u - gam * a) K1 Hg ltac:(lra) ltac:(lra)).
      assert (B : {6} <= u <= {9}) by lra. clear - F B.
      apply (sum_far_above _ _ _ (proportional_pressure K gam a ({6} - gam * a)));
        [lra | exact F |]; clear F; unfold K; plain constants; unfold atanh.
      apply Rminus_lt. interval with (i_bisect u, i_prec 60).
  - clear. plain constants. interval with (i_prec 90).
Qed.

)";

/// The relative error of the first terms of a wedge at a place beyond the apex, seen from the left
/// edge b = gam a. These numbers only choose those of the theorem, which Coq proves.
double error_beyond_apex(double gam, double b, std::size_t terms, double u) {
    const double width = b + b / gam;
    const double z = std::sqrt(gam * (width - u) / u);
    const double s = 1 / std::sqrt(gam * width);
    const double c[] = {s, s / (2 * width) + std::pow(s, 3) / 3,
                        3 * s / (8 * width * width) + std::pow(s, 3) / (2 * width) +
                            std::pow(s, 5) / 5};
    double sum = 0;
    for (std::size_t k = 0; k < terms; ++k) {
        sum += c[k] * std::pow(u, static_cast<double>(k) + 0.5);
    }
    return sum / std::atanh(z) - 1;
}

/// Returns the place between the apex and the other edge at which the error, which grows from -1,
/// is `error`.
double place_of_error(double gam, double b, std::size_t terms, double error) {
    double below = b * (1 + 1e-12);
    double above = (b + b / gam) * (1 - 1e-12);
    for (int i = 0; i < 200; ++i) {
        const double middle = (below + above) / 2;
        (error_beyond_apex(gam, b, terms, middle) < error ? below : above) = middle;
    }
    return below;
}

} // namespace

std::string not_rounded_to(const audit::Claim& claim, double share, const std::string& lower,
                           const std::string& upper) {
    const audit::QuotedFigure figure = audit::QuotedFigure::of(claim);
    const Rational half = figure.within_units(Rational(1, 2)).second - figure.value();
    const std::string q = coq_number(figure.value());
    return share < static_cast<double>(figure.value())
               ? fmt::format("{} < {} - {}", upper, q, coq_number(half))
               : fmt::format("{} + {} < {}", q, coq_number(half), lower);
}

void certify_measure(const std::string& name, const WedgeShare& judged, Certificate& certificate) {
    const auto& [claim, share, edge, gam, extent] = judged;
    const double b = edge.distance;
    const auto tolerance = extent.tolerance.to<double>();
    if (!edge.wedge || !edge.mirrored || gam > 0.4 || tolerance > 0.1 ||
        share > static_cast<double>(audit::QuotedFigure::of(claim).value())) {
        throw NotStated("the measure of an extent is stated at the left edge of wedges, if it is "
                        "less than the figure");
    }
    const double step = 5e-4 * b;
    const auto from =
        coq_decimal(place_of_error(gam, b, extent.terms, -tolerance) - step, 6, false);
    const auto to = coq_decimal(place_of_error(gam, b, extent.terms, tolerance) + step, 6, true);
    const auto near = [&](double factor) { return coq_decimal(factor * b, 4, true).text; };
    const std::string all =
        fmt::format("({} + ({} - {})) / (gam * a)", extent.beyond.text, to.text, from.text);
    certificate.text += fmt::format(
        fmt::runtime(outside), name, extent.beyond.text, from.text, to.text, near(0.92), near(1.1),
        near(2), near(0.98), near(1.02), coq_decimal(1.02 * (b + b / gam), 4, true).text,
        edge.series.statement, in_coq(extent.tolerance), sum_of_terms(extent.terms),
        edge.series.proof, not_rounded_to(claim, share, all, all));
    certificate.theorems.push_back(
        {name, fmt::format("the measure of all places within {} does not round to the quoted {}",
                           claim.text("tolerance"), claim.text("quoted"))});
}

} // namespace edgeproof::certificate
