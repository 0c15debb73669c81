// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace edgeproof::certificate {
namespace {

/// A coefficient of the shear traction: "right_s1".
struct Coefficient {
    bool right = true;
    std::size_t index = 0;
};

Coefficient coefficient(const Expr& e) {
    for (std::size_t k = 0; k < 3; ++k) {
        for (const bool right : {true, false}) {
            if (e == Expr::symbol(fmt::format("{}_s{}", right ? "right" : "left", k))) {
                return {right, k};
            }
        }
    }
    throw NotStated(fmt::format("{} is not one of the first three coefficients of the shear "
                                "traction",
                                to_text(e)));
}

/// Returns the fact that `name`0 to `name`2 are the coefficients at an edge under these loads.
Fact series(bool right, const std::string& name, std::string_view Q, std::string_view sig0) {
    const std::string side = right ? "right" : "left";
    return {{name + "0", name + "1", name + "2"},
            fmt::format("is_the_{0}_shear_series (full_stick {1} {2} a b) {3} {4}0 {4}1 {4}2", side,
                        Q, sig0, right ? "a" : "b", name),
            fmt::format("apply the_{0}_shear_series, {0}_shear; lra", side)};
}

/// Returns "exists" and the facts, and their proofs.
std::pair<std::string, std::string> exist(const std::vector<Fact>& facts) {
    std::string unknowns;
    std::string statements;
    std::string begin;
    std::string proofs;
    for (const Fact& fact : facts) {
        for (const std::string& unknown : fact.unknowns) {
            unknowns += " " + unknown;
            begin += "eexists. ";
        }
        statements += "  " + fact.statement + " /\\\n";
        proofs += "  split. { " + fact.proof + ". }\n";
    }
    return {fmt::format("exists{},\n{}", unknowns, statements),
            fmt::format("  {}\n{}", begin, proofs)};
}

Theory imports() {
    Theory theory;
    theory.imports = {"Contact", "Coefficients", "Edges", "Tactics", "Shear", "Unique"};
    return theory;
}

} // namespace

// The claim is that where one coefficient vanishes, the parts of another that the force and the
// tension make have one sign ("add") or opposite signs ("subtract"). A sign alone would also be
// true of other loads. Therefore the theorem also states that both coefficients consist of these
// parts.
void certify_superposition(const ClaimResult& result, const Ledger& ledger,
                           Certificate& certificate) {
    const Claim& claim = result.claim;
    if (result.outcome.verdict != Verdict::confirmed || !claim.readings.empty() ||
        !claim.has("when_zero")) {
        throw NotStated("of superpositions, only those that are confirmed where another "
                        "coefficient vanishes are stated");
    }
    const Coefficient of = coefficient(claim.formula("of"));
    const Coefficient zero = coefficient(claim.formula("when_zero"));
    const bool same_edge = of.right == zero.right;
    std::vector<Fact> series_of = {series(zero.right, "s", "Q", "sig0"),
                                   series(of.right, "t", "Q", "0"),
                                   series(of.right, "v", "0", "sig0")};
    if (!same_edge) {
        series_of.push_back(series(of.right, "w", "Q", "sig0"));
    }
    const auto [facts, proof] = exist(series_of);
    const bool add = claim.text("says") == "add";
    const std::string product = fmt::format("t{0} * v{0}", of.index);
    const std::string parts =
        fmt::format("{0}{1} = t{1} + v{1} /\\\n  s{2} = t{2} {3} v{2} /\\\n", same_edge ? "s" : "w",
                    of.index, zero.index, same_edge ? "+" : "-");
    const std::string name = coq_name(claim.id);
    certificate.text =
        file_head(claim, ledger, imports()) +
        theorem_text(name + " (a b Q sig0 : R)",
                     fmt::format("0 < a + b /\\ Q <> 0 ->\n  {}  {}  (s{} = 0 -> {})", facts, parts,
                                 zero.index, add ? "0 < " + product : product + " < 0"),
                     "  intros form.\n" + proof +
                         "  do 2 (split; [unfold shear_0, shear_1, shear_2, Rdiv; ring |]).\n"
                         "  intros H. parts_by_sign H a b sig0.\n");
    certificate.theorems = {
        {name,
         fmt::format("for all contacts under full stick, {0} is the sum of its parts by Q "
                     "and by sig0, {1} is the {2}; where {1} = 0, the parts of {0} have {3}",
                     claim.text("of"), claim.text("when_zero"),
                     same_edge ? "sum of its parts" : "difference of such parts at the other edge",
                     add ? "the same sign" : "opposite signs")}};
    certificate.whole_verdict = true;
}

namespace {

/// Returns the corrected ratio sig0 d/Q, read from "sig0*d/Q = -(4/(3*Pi)) for left.s1".
std::optional<Expr> corrected_ratio(const ClaimResult& result) {
    const std::string& ratio = result.claim.text("ratio");
    if (!result.outcome.correct || !result.outcome.correct->starts_with(ratio + " = ")) {
        return std::nullopt;
    }
    const std::string rest = result.outcome.correct->substr(ratio.size() + 3);
    return parse_formula(rest.substr(0, rest.find(" for ")), result.claim.vocabulary);
}

/// A contact whose bulk tension is `ratio` times Q/d.
SampledTheory contact_of_ratio(const Claim& claim, const std::string& name, const Expr& ratio) {
    return sheared_contact(claim.edge(),
                           {name, fmt::format("({}) * Q / ((a + b) / 2)", coq_text(ratio, {})),
                            Exact::parse("(" + to_text(ratio) + ")*2/5")});
}

std::string size_theorem(const std::string& name, const SampledTheory& t, const Expr& e,
                         const std::optional<std::string>& least) {
    Statement statement(t.theory);
    const std::string value = statement(e);
    const std::string conclusion =
        least ? fmt::format("{} <= Rabs ({})", *least, value) : value + " = 0";
    return theorem_text(name, statement.text(conclusion),
                        statement.proof(least ? "numbers constants" : "vanishes constants"));
}

} // namespace

// The claim is that a coefficient of the shear traction vanishes at one ratio of tension to force.
// States that it does not, and that it does at the corrected ratio.
void certify_vanishing(const ClaimResult& result, const Ledger& ledger, Certificate& certificate) {
    const Claim& claim = result.claim;
    if (result.outcome.verdict != Verdict::refuted || !claim.readings.empty() ||
        !is_formula(claim, "ratio", "sig0*((a+b)/2)/Q")) {
        throw NotStated("of what vanishes, only that it does not at a ratio sig0*d/Q, where d is "
                        "(a+b)/2, is stated");
    }
    const Expr of = claim.formula("of");
    const SampledTheory printed = contact_of_ratio(claim, "sig0", claim.formula("says"));
    const auto gap = gap_at(of, Expr(), printed.sample);
    if (!gap || gap->least <= 0) {
        throw NotStated("there is no enclosure of the coefficient");
    }
    const std::string name = coq_name(claim.id);
    const std::string least = fraction_below(gap->least);
    Theory all = printed.theory;
    std::string more;
    const auto ratio = corrected_ratio(result);
    if (ratio) {
        const SampledTheory corrected = contact_of_ratio(claim, "sig0_corrected", *ratio);
        all.constants.push_back(corrected.theory.constants.back());
        more = size_theorem(name + "_corrected", corrected, of, std::nullopt);
    }
    certificate.text = file_head(claim, ledger, all) + constants(all.constants) +
                       size_theorem(name + "_refuted", printed, of, least) + more;
    certificate.theorems = {
        {name + "_refuted",
         fmt::format("at the printed ratio of one contact, |{}| >= {}", claim.text("of"), least)}};
    if (ratio) {
        certificate.theorems.push_back(
            {name + "_corrected",
             fmt::format("at the corrected ratio of the same contact, {} = 0", claim.text("of"))});
    }
    certificate.whole_verdict = true;
    certificate.leaves_out = "that the correction holds for all contacts";
}

} // namespace edgeproof::certificate
