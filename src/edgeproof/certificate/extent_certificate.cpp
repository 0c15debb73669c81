// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/parts/quoted_figure.hpp"
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/stated_contact.hpp"
#include "edgeproof/formula/exact/identity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace edgeproof::certificate {
namespace {

/// States that the terms are beyond the tolerance at all places of a tilted wedge, seen from its
/// left edge, except up to {1}, between {2} and {3}, and at the apex, where there is no pressure.
/// Near the apex, between {4} and {5}, and beyond {6}, the pressure is compared with that there.
/// {7} and {8} are bounds of the left edge, {9} of the width. The last line is proved by intervals.
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

/// Returns the inequality that a share does not round to the figure that the claim quotes. `lower`
/// and `upper` are bounds of the share, in Coq.
std::string not_rounded_to(const Claim& claim, double share, const std::string& lower,
                           const std::string& upper) {
    const audit::QuotedFigure figure = audit::QuotedFigure::of(claim);
    const Rational half = figure.within_units(Rational(1, 2)).second - figure.value();
    const std::string q = coq_number(figure.value());
    return share < static_cast<double>(figure.value())
               ? fmt::format("{} < {} - {}", upper, q, coq_number(half))
               : fmt::format("{} + {} < {}", q, coq_number(half), lower);
}

/// Adds the theorem `name`: the measure of all places within the tolerance, as a share of the left
/// side of a tilted wedge, does not round to the figure. It states that the terms are beyond the
/// tolerance everywhere except up to the first exit and in one interval on the other side of the
/// apex, whose length is added. Throws NotStated at a right edge, for gam > 2/5, a tolerance above
/// 1/10, or a share above the figure.
void certify_measure(const std::string& name, const Claim& claim, double share,
                     const StatedContact& contact, const ExtentStatement& extent,
                     Certificate& certificate) {
    const StatedEdge& edge = contact.at(claim.edge());
    const double gam = contact.left.distance / contact.right.distance;
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

/// A scene with the share that the audit computed for it. The share only chooses the numbers of the
/// theorem: Coq proves them.
struct JudgedScene {
    SceneSpec scene;
    double share = 0;
    bool similar = false; ///< all other scenes of the family are larger or smaller copies of it
};

/// Whether one contact is a larger or smaller copy of the other: g'(lambda x) of the one is
/// mu g'(x) of the other. The moduli may differ.
bool are_similar(const SceneSpec& one, const SceneSpec& other) {
    if (one.profile != other.profile) {
        return false;
    }
    if (one.profile == "power-law") {
        return one.parameter("m") == other.parameter("m");
    }
    return one.profile == "flat-and-rounded" &&
           formula::proved_zero(one.parameter("t").expr() * other.parameter("a").expr() -
                                other.parameter("t").expr() * one.parameter("a").expr());
}

/// Returns the scene on which the verdict rests: that of the reported figure, or one with the same
/// share and the right edge at 1, because it is easy to read.
JudgedScene judged_scene(const Claim& claim, const Outcome& outcome, const Ledger& ledger) {
    const auto all = draw_scenes(ledger.family(claim.text("over")), ledger.families);
    const Evidence& evidence = outcome.evidence;
    const auto* const judged = std::get_if<Evidence>(&item(evidence, "enclosures").value());
    const auto* const shares =
        std::get_if<std::vector<EvidenceItem>>(&item(evidence, "scenes").value());
    if (judged == nullptr || judged->find("at") == nullptr || shares == nullptr ||
        shares->size() != all.size()) {
        throw NotStated("there is no enclosure of the computed value");
    }
    const std::string at = item(*judged, "at").text();
    std::vector<double> share;
    for (const EvidenceItem& entry : *shares) {
        share.push_back(std::stod(item(std::get<Evidence>(entry.value()), "value").text()));
    }
    const auto reported =
        std::ranges::find_if(all, [&](const auto& scene) { return full_text(scene) == at; });
    if (reported == all.end()) {
        throw NotStated("the scene of the computed value is not in the family");
    }
    auto chosen = static_cast<std::size_t>(reported - all.begin());
    const double computed = share[chosen];
    for (std::size_t i = all.size(); i-- > 0;) {
        const bool same = std::abs(share[i] - computed) <= 1e-14 * computed;
        if (same && all[i].parameter("a").to<double>() == 1) {
            chosen = i;
        }
    }
    return {all[chosen], share[chosen], std::ranges::all_of(all, [&](const auto& scene) {
                return are_similar(scene, all[chosen]);
            })};
}

/// The inequalities between the ends of the interval of the first exit and the quoted figure: the
/// whole interval rounds to the figure, or is one unit off, or farther. They are strict, so that
/// there are no ties.
struct AgainstQuoted {
    std::string text;
    std::string words;
    double margin; ///< the distance of the share from the nearest end of these ranges
};

AgainstQuoted against_quoted(const Claim& claim, Verdict verdict, double share,
                             const std::string& lower, const std::string& upper) {
    const auto figure = audit::QuotedFigure::of(claim);
    const Rational half = figure.within_units(Rational(1, 2)).second - figure.value();
    const auto unit = static_cast<double>(Rational(2 * half));
    const auto quoted = static_cast<double>(figure.value());
    const std::string q = coq_number(figure.value());
    const auto end = [&](int halves) {
        return fmt::format("{} {} {}", q, halves < 0 ? "-" : "+",
                           coq_number(Rational(std::abs(halves) * half)));
    };
    const auto between = [&](int from, int to) {
        return fmt::format("{} < {} /\\ {} < {}", end(from), lower, upper, end(to));
    };
    const double halves = std::abs(share - quoted) / unit * 2;
    const double margin = std::abs(halves - (halves < 2 ? 1 : 3)) * unit / 2;
    const bool above = share > quoted;
    switch (verdict) {
    case Verdict::confirmed:
        return {between(-1, 1),
                "so that the first exit rounds to the quoted " + claim.text("quoted"), margin};
    case Verdict::imprecise:
        return {
            above ? between(1, 3) : between(-3, -1),
            fmt::format("so that the first exit is one unit of the last place off the quoted {}",
                        claim.text("quoted")),
            margin};
    case Verdict::refuted:
        return {
            above ? fmt::format("{} < {}", end(3), lower) : fmt::format("{} < {}", upper, end(-3)),
            fmt::format("so that the first exit is more than one unit of the last place off the "
                        "quoted {}",
                        claim.text("quoted")),
            margin};
    default:
        throw NotStated("the verdict decides nothing about the figure");
    }
}

/// The statement of the first exit near `share`; both ends are `step` away from it. The end of the
/// extent, in shares of the edge's distance, is compared with the figure by `more`.
ExtentStatement around(const Claim& claim, const StatedEdge& edge, double share, double step) {
    return {static_cast<std::size_t>(claim.integer("terms")), Exact::parse(claim.text("tolerance")),
            coq_decimal((share - step) * edge.distance, 9, true),
            coq_decimal((share + step) * edge.distance, 9, false), ""};
}

std::string share_of(const CoqDecimal& u, std::string_view base) {
    return fmt::format("({}) / {}", u.text, base);
}

/// Adds to the theorem of the first reading of a refuted claim, about `scene`, that under no other
/// reading the share rounds to the figure. Returns what belongs to the comparison of the first
/// theorem. Throws NotStated for readings that are not stated.
std::string certify_other_readings(const ClaimResult& result, const Ledger& ledger,
                                   const SceneSpec& scene, const StatedContact& contact,
                                   const ExtentStatement& extent, Certificate& after) {
    const Claim& first = result.claim.readings.front();
    const StatedEdge& edge = contact.at(first.edge());
    std::string shares;
    for (std::size_t i = 1; i < result.readings.size(); ++i) {
        const Claim& claim = result.claim.readings[i];
        const Outcome& outcome = result.readings[i].second;
        const bool fails =
            outcome.verdict == Verdict::refuted || outcome.verdict == Verdict::imprecise;
        if (!fails || !outcome.computed || claim.edge() != first.edge() ||
            claim.integer("terms") != first.integer("terms") ||
            claim.text("tolerance") != first.text("tolerance") ||
            claim.text("quoted") != first.text("quoted")) {
            throw NotStated("a reading is about another extent");
        }
        const std::string name = fmt::format("{}_extent_{}", coq_name(result.claim.id), i + 1);
        const std::string reach = claim.text("reach");
        const bool same_base = claim.text("base") == first.text("base");
        const JudgedScene judged = judged_scene(claim, outcome, ledger);
        if (full_text(judged.scene) == full_text(scene)) {
            if (reach == "first-exit" && claim.text("base") == "a+b" && edge.wedge) {
                shares += " /\\\n   " + not_rounded_to(claim, judged.share,
                                                       share_of(extent.within, "(a + gam * a)"),
                                                       share_of(extent.beyond, "(a + gam * a)"));
                continue;
            }
            if (reach == "measure" && same_base) {
                certify_measure(name, claim, judged.share, contact, extent, after);
                continue;
            }
        } else if (reach == "first-exit" && same_base && judged.scene.parameters.contains("gam")) {
            const Exact gam = judged.scene.parameter("gam");
            const StatedContact own =
                stated_contact(judged.scene.make_profile(), judged.scene.parameter("a"),
                               judged.scene.parameter("Es"), &gam);
            const StatedEdge& own_edge = own.at(claim.edge());
            ExtentStatement statement =
                around(claim, own_edge, judged.share, std::min(4e-5, judged.share * 0.01));
            statement.more =
                "(" +
                not_rounded_to(claim, judged.share, share_of(statement.within, own_edge.edge),
                               share_of(statement.beyond, own_edge.edge)) +
                ")";
            const std::string module = fmt::format("Reading_{}", i + 1);
            after.text += fmt::format("Module {0}.\n{1}{2}End {0}.\n\n", module, own.definitions(),
                                      extent_theorem(name, own_edge, statement));
            after.theorems.push_back(
                {module + "." + name,
                 "the first exit does not round to the figure either: " + claim.reading});
            continue;
        }
        throw NotStated("the reading is not stated");
    }
    return shares;
}

/// States the same for all contacts that are similar to the one of the theorem `name`.
std::string similar_theorem(const std::string& name, const StatedEdge& edge,
                            const ExtentStatement& extent) {
    return fmt::format(
        "(* The same at every scale: for all slopes h1 that are scaled copies, and all moduli. *)\n"
        "Theorem {0}_similar : forall Fs lam mu h1, 0 < Fs -> 0 < lam -> 0 < mu ->\n"
        "  (forall x, h1 (lam * x) = mu * {1} x) ->\n"
        "  is_first_exit Scaling.sum_{2} Fs h1 (lam * {3}) {4} (lam * ({5})) (lam * "
        "({6})).\nProof.\n"
        "  intros Fs lam mu h1 HFs Hlam Hmu Hh.\n"
        "  destruct {0} as (r0 & r1 & r2 & Hr & Hwithin & Hbeyond & _).\n"
        "  apply (first_exit_scaled Scaling.sum_{2} Es Fs {1} h1 lam mu);\n"
        "    [apply homogeneous_{2} | sides constants | assumption | assumption | assumption\n"
        "    | assumption | sides constants | exists r0, r1, r2; exact (conj Hr (conj Hwithin "
        "Hbeyond))].\nQed.\n\n",
        name, edge.slope, extent.terms, edge.edge, in_coq(extent.tolerance), extent.within.text,
        extent.beyond.text);
}

} // namespace

// States that |p - local sum| <= tolerance p up to one distance from the edge, and not at another
// just beyond it: the first exit lies between them. Both, in shares of the contact, are then
// compared with the quoted figure. A second theorem extends this to all contacts of the same form.
void certify_extent(const ClaimResult& result, const Ledger& ledger, Certificate& certificate) {
    // The first of several readings is stated, and all of them if the claim is refuted.
    bool whole = result.claim.readings.empty();
    const Claim& claim = whole ? result.claim : result.claim.readings.front();
    const Outcome& outcome = whole ? result.outcome : result.readings.at(0).second;
    if (claim.text_or("reach", "") != "first-exit" || !outcome.computed) {
        throw NotStated("only first exits of extents are stated");
    }
    const JudgedScene judged = judged_scene(claim, outcome, ledger);
    const SceneSpec& scene = judged.scene;
    const StatedContact contact =
        stated_contact(scene.make_profile(), scene.parameter("a"), scene.parameter("Es"));
    const StatedEdge& edge = contact.at(claim.edge());
    const std::string& base = claim.text("base");
    if (base != (claim.edge() == Edge::right ? "a" : "b")) {
        throw NotStated(fmt::format("extents are stated in shares of the edge's distance from the "
                                    "origin, not of {}",
                                    base));
    }
    const Verdict verdict = outcome.verdict;
    // Both ends are about 1/25000 of the edge's distance away from the exit, or less if the figure
    // requires it.
    const double margin = against_quoted(claim, verdict, judged.share, "", "").margin;
    const double step = std::min({4e-5, margin * 0.4, judged.share * 0.01});
    if (step < 1e-7) {
        throw NotStated("the value is too near to a number half-way between two figures");
    }
    const ExtentStatement extent = around(claim, edge, judged.share, step);
    ExtentStatement shares = extent;
    const AgainstQuoted against =
        against_quoted(claim, verdict, judged.share, share_of(extent.within, edge.edge),
                       share_of(extent.beyond, edge.edge));
    const bool one_is_enough = verdict == Verdict::refuted;
    Certificate others;
    std::string in_other_shares;
    if (!whole && one_is_enough) {
        try {
            in_other_shares =
                certify_other_readings(result, ledger, scene, contact, extent, others);
            whole = true;
        } catch (const NotStated&) {
            others = {};
        }
    }
    shares.more = "(" + against.text + in_other_shares + ")";
    const std::string name = coq_name(result.claim.id) + "_extent";
    certificate.text =
        contact.head(file_comment(result.claim, ledger)) + extent_theorem(name, edge, shares);
    certificate.theorems = {
        {name,
         fmt::format("at one contact {} terms stay within {} up to a distance of {:.6g} {}, and "
                     "not at {:.6g} {}, {}",
                     extent.terms, claim.text("tolerance"), judged.share - step, base,
                     judged.share + step, base,
                     against.words +
                         (in_other_shares.empty()
                              ? ""
                              : "; nor does it round to it as a share of the whole contact"))}};
    certificate.text += others.text;
    certificate.theorems.insert(certificate.theorems.end(), others.theorems.begin(),
                                others.theorems.end());
    const bool every_scale = judged.similar && claim.edge() == Edge::right && !edge.rises.empty();
    if (every_scale) {
        certificate.text += similar_theorem(name, edge, extent);
        certificate.theorems.push_back(
            {name + "_similar",
             "the same shares at every contact that is a larger or smaller copy, "
             "as all of the family are"});
    }
    certificate.whole_verdict = whole && (one_is_enough || every_scale) && !edge.rises.empty();
    certificate.leaves_out =
        one_is_enough || every_scale ? "" : "that the share is the same at every scale";
    if (!whole) {
        certificate.leaves_out += certificate.leaves_out.empty() ? "" : "; ";
        certificate.leaves_out += "what else the words may mean";
    }
}

} // namespace edgeproof::certificate
