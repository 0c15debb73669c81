// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/parts/quoted_figure.hpp"
#include "edgeproof/certificate/extent_parts.hpp"
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/stated_contact.hpp"
#include "edgeproof/formula/exact/identity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace edgeproof::certificate {
namespace {

/// A scene with the share that the audit computed for it. The share only chooses the numbers of the
/// theorem: Coq proves them.
struct JudgedScene {
    audit::SceneSpec scene;
    double share = 0;
    bool similar = false; ///< all other scenes of the family are larger or smaller copies of it
};

/// Whether one contact is a larger or smaller copy of the other: g'(lambda x) of the one is
/// mu g'(x) of the other. The moduli may differ.
bool are_similar(const audit::SceneSpec& one, const audit::SceneSpec& other) {
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
JudgedScene judged_scene(const audit::Claim& claim, const audit::Outcome& outcome,
                         const audit::Ledger& ledger) {
    const auto all = draw_scenes(ledger.family(claim.text("over")), ledger.families);
    const audit::Evidence& evidence = outcome.evidence;
    const auto* const judged = std::get_if<audit::Evidence>(&item(evidence, "enclosures").value());
    const auto* const shares =
        std::get_if<std::vector<audit::EvidenceItem>>(&item(evidence, "scenes").value());
    if (judged == nullptr || judged->find("at") == nullptr || shares == nullptr ||
        shares->size() != all.size()) {
        throw NotStated("there is no enclosure of the computed value");
    }
    const std::string at = item(*judged, "at").text();
    std::vector<double> share;
    for (const audit::EvidenceItem& entry : *shares) {
        share.push_back(std::stod(item(std::get<audit::Evidence>(entry.value()), "value").text()));
    }
    const auto reported = std::find_if(all.begin(), all.end(),
                                       [&](const auto& scene) { return full_text(scene) == at; });
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
    return {all[chosen], share[chosen], std::all_of(all.begin(), all.end(), [&](const auto& scene) {
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

AgainstQuoted against_quoted(const audit::Claim& claim, audit::Verdict verdict, double share,
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
    case audit::Verdict::confirmed:
        return {between(-1, 1),
                "so that the first exit rounds to the quoted " + claim.text("quoted"), margin};
    case audit::Verdict::imprecise:
        return {
            above ? between(1, 3) : between(-3, -1),
            fmt::format("so that the first exit is one unit of the last place off the quoted {}",
                        claim.text("quoted")),
            margin};
    case audit::Verdict::refuted:
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
ExtentStatement around(const audit::Claim& claim, const StatedEdge& edge, double share,
                       double step) {
    return {static_cast<std::size_t>(claim.integer("terms")),
            formula::Exact::parse(claim.text("tolerance")),
            coq_decimal((share - step) * edge.distance, 9, true),
            coq_decimal((share + step) * edge.distance, 9, false), ""};
}

std::string share_of(const CoqDecimal& u, std::string_view base) {
    return fmt::format("({}) / {}", u.text, base);
}

/// Adds to the theorem of the first reading of a refuted claim, about `scene`, that under no other
/// reading the share rounds to the figure. Returns what belongs to the comparison of the first
/// theorem. Throws NotStated for readings that are not stated.
std::string certify_other_readings(const audit::ClaimResult& result, const audit::Ledger& ledger,
                                   const audit::SceneSpec& scene, const StatedContact& contact,
                                   const ExtentStatement& extent, Certificate& after) {
    const audit::Claim& first = result.claim.readings.front();
    const StatedEdge& edge = contact.at(first.edge());
    std::string shares;
    for (std::size_t i = 1; i < result.readings.size(); ++i) {
        const audit::Claim& claim = result.claim.readings[i];
        const audit::Outcome& outcome = result.readings[i].second;
        const bool fails = outcome.verdict == audit::Verdict::refuted ||
                           outcome.verdict == audit::Verdict::imprecise;
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
                const double gam = contact.left.distance / contact.right.distance;
                certify_measure(name, {claim, judged.share, edge, gam, extent}, after);
                continue;
            }
        } else if (reach == "first-exit" && same_base && judged.scene.parameters.contains("gam")) {
            const formula::Exact gam = judged.scene.parameter("gam");
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
void certify_extent(const audit::ClaimResult& result, const audit::Ledger& ledger,
                    Certificate& certificate) {
    // The first of several readings is stated, and all of them if the claim is refuted.
    bool whole = result.claim.readings.empty();
    const audit::Claim& claim = whole ? result.claim : result.claim.readings.front();
    const audit::Outcome& outcome = whole ? result.outcome : result.readings.at(0).second;
    if (claim.text_or("reach", "") != "first-exit" || !outcome.computed) {
        throw NotStated("only first exits of extents are stated");
    }
    const JudgedScene judged = judged_scene(claim, outcome, ledger);
    const audit::SceneSpec& scene = judged.scene;
    const StatedContact contact =
        stated_contact(scene.make_profile(), scene.parameter("a"), scene.parameter("Es"));
    const StatedEdge& edge = contact.at(claim.edge());
    const std::string& base = claim.text("base");
    if (base != (claim.edge() == contact::Edge::right ? "a" : "b")) {
        throw NotStated(fmt::format("extents are stated in shares of the edge's distance from the "
                                    "origin, not of {}",
                                    base));
    }
    const audit::Verdict verdict = outcome.verdict;
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
    const bool one_is_enough = verdict == audit::Verdict::refuted;
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
    const bool every_scale =
        judged.similar && claim.edge() == contact::Edge::right && !edge.rises.empty();
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
