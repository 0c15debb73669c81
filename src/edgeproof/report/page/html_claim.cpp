// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/report/page/html.hpp"

#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/filled_template.hpp"
#include "edgeproof/report/text/formula_tex.hpp"
#include "edgeproof/report/text/tex_math.hpp"
#include "edgeproof/report/verdicts/verdict_writers.hpp"

#include <algorithm>
#include <optional>

namespace edgeproof::report {
namespace {

using audit::PrintedSource;
using Json = nlohmann::ordered_json;

const audit::ClaimResult* claim_named(const audit::AuditResult& result, const std::string& id) {
    const auto it = std::ranges::find(result.claims, id, [](const auto& r) { return r.claim.id; });
    return it == result.claims.end() ? nullptr : &*it;
}

std::string with_left(const std::string& left, const std::string& right) {
    return left.empty() ? right : left + " = " + right;
}

/// The printed and the corrected formula with their differences marked, and LaTeX code to copy
/// below.
std::string sides_html(const Correction& correction, const audit::Claim& claim,
                       const PrintedSource& source) {
    MathNode printed = math_of_tex(with_left(correction.left, correction.printed), source);
    MathNode corrected = math_of_tex(with_left(correction.left, correction.corrected), source);
    mark_changes(printed, corrected);
    return filled(report_template::sides_html,
                  {{"what", sentence_html(correction.what, source)},
                   {"printed", block_math(printed, "printed, " + claim.id)},
                   {"corrected", block_math(corrected, "corrected, " + claim.id)},
                   {"tex", with_left(correction.left, correction.corrected)},
                   {"id", claim.id}});
}

/// The steps of the clearest counterexample; null if there are none.
Json example_values(const audit::ClaimResult& result, const PrintedSource& source) {
    Json steps = Json::array();
    for (const std::string& step : counterexample_steps(result, source)) {
        steps.push_back(sentence_html(step, source));
    }
    return steps.empty() ? Json() : Json{{"steps", steps}};
}

/// Words for the result of a computation with a wrong line, behind the verdict; a bare number gets
/// its meaning.
std::string result_html(const std::string& comes_to, const PrintedSource& source) {
    if (comes_to.find("printed") != std::string::npos) {
        return "";
    }
    const std::string result = comes_to.substr(0, comes_to.find(", "));
    const std::string number = result.substr(0, result.find(" %"));
    if (number.find_first_not_of("0123456789.+-e") != std::string::npos) {
        return " (" + escape_html(result) + ")";
    }
    const std::string percent = number == result ? "" : "\\,\\%";
    return " (the value is " + sentence_html("$" + number_tex(number) + percent + "$", source) +
           ")";
}

/// The results that were computed with the line; null if there are none.
Json later_values(const Erratum& erratum, const audit::AuditResult& result,
                  const PrintedSource& source) {
    Json results = Json::array();
    for (const audit::ClaimResult* part : erratum.parts) {
        for (const LaterWords& later : later_results_of(*part)) {
            const audit::ClaimResult* const claim = claim_named(result, later.claim);
            const bool right = claim != nullptr && holds(claim->outcome.verdict);
            const char* verdict =
                later.as_printed && right
                    ? "is as printed there, and that is right: the error has no effect on it"
                : later.as_printed
                    ? "is as printed there, and that is not right: the error was carried over"
                : right ? "would differ from what is printed there, which is right: it was not "
                          "computed with this line"
                        : "would differ from what is printed there: this line does not explain "
                          "that error";
            std::string what = sentence_html(later.what, source);
            for (const audit::ClaimResult& r : result.claims) { // "EQ44" becomes its printed number
                const std::string number = source.number_of(r.claim.id);
                const std::string row = r.claim.id.substr(0, r.claim.id.find('.'));
                const std::size_t at = number.empty() ? std::string::npos : what.find(row + ' ');
                if (at != std::string::npos) {
                    what.replace(at, row.size(), "Eq. (" + number + ")");
                }
            }
            results.push_back(
                {{"claim", later.claim},
                 {"place", claim == nullptr ? later.claim : place_words(claim->claim, source)},
                 {"what", what},
                 {"verdict", verdict},
                 {"value", result_html(later.comes_to, source)}});
        }
    }
    return results.empty() ? Json() : Json{{"results", results}};
}

const char* weight_words(Weight weight) {
    switch (weight) {
    case Weight::conclusion:
        return "changes a conclusion";
    case Weight::figure:
        return "changes a figure quoted";
    case Weight::carried:
        return "a wrong conclusion rests on it";
    case Weight::slip:
        return "misprint";
    case Weight::line:
        break;
    }
    return "what rests on it is not stated";
}

/// Returns "lines 126–129"; nothing for a formula without a source.
std::string lines_words(const audit::Claim& claim) {
    const auto& [first, last] = claim.lines;
    if (first == 0) {
        return {}; // formulas of the user have no source
    }
    return first == last ? "line " + std::to_string(first)
                         : "lines " + std::to_string(first) + "–" + std::to_string(last);
}

std::string where_html(const audit::Claim& claim, const PageHead& head) {
    std::string out = escape_html(section_words(claim, head.source));
    const std::string lines = lines_words(claim);
    if (!lines.empty()) {
        out += (out.empty() ? "" : ", ") + lines + " of the source";
    }
    if (head.theorems.contains(claim.id)) {
        out += (out.empty() ? "" : " · ") + std::string("<a href=\"#theorem-") +
               escape_html(claim.id) + "\">theorem</a>";
    }
    return out;
}

} // namespace

std::string printed_html(const audit::Claim& claim, const PrintedSource& source) {
    if (claim.printed.empty()) {
        const formula::Expr* says = claim.find_written("says");
        return says == nullptr
                   ? ""
                   : inline_math(math_of_tex(formula_tex(*says, source, claim.text_or("over", "")),
                                             source));
    }
    return is_sentence(claim.printed) ? "<q>" + sentence_html(claim.printed, source) + "</q>"
                                      : inline_math(math_of_tex(claim.printed, source));
}

Json erratum_values(const Erratum& erratum, const audit::AuditResult& result, const PageHead& head,
                    const PageFigures& figures) {
    const audit::Claim& first = erratum.parts.front()->claim;
    const bool sentence = is_sentence(first.printed);
    Json claims = Json::array();
    Json plot;
    for (const audit::ClaimResult* part : erratum.parts) {
        claims.push_back(part->claim.id);
        for (const Json& drawn : figures.errata) {
            if (plot.is_null() && drawn["id"] == part->claim.id && !drawn["panels"].empty()) {
                plot = drawn["panels"].front();
            }
        }
    }
    Json parts = Json::array();
    for (const audit::ClaimResult* part : erratum.parts) {
        const auto correction = correction_of(*part, head.source);
        const bool other = part != erratum.parts.front();
        const bool repeats = !sentence && other && !plot.is_null();
        parts.push_back(
            {{"anchor", other ? part->claim.id : ""},
             {"correction", correction ? sides_html(*correction, part->claim, head.source) : ""},
             {"found", correction
                           ? ""
                           : sentence_html(correction_in_words(*part, head.source), head.source)},
             {"example", repeats ? Json() : example_values(*part, head.source)}});
    }
    return {{"id", first.id},
            {"place", place_words(first, head.source)},
            {"weight", weight_words(erratum.weight)},
            {"where", where_html(first, head)},
            {"has_source", first.lines.first != 0},
            {"claims", claims},
            {"quote", sentence ? sentence_html(first.printed, head.source) : ""},
            {"parts", parts},
            {"later", later_values(erratum, result, head.source)},
            {"plot", plot}};
}

Json claim_values(const audit::ClaimResult& result, const PageHead& head) {
    const audit::Claim& claim = result.claim;
    const audit::Outcome& outcome = result.outcome;
    const PrintedSource& source = head.source;
    const auto note = [&](const std::string& text) { return note_html(text, claim, source); };
    const bool right =
        outcome.verdict == audit::Verdict::proved || outcome.verdict == audit::Verdict::confirmed;
    const auto correction = right ? std::nullopt : correction_of(result, source);
    const auto theorem = head.theorems.find(claim.id);
    return {{"id", claim.id},
            {"verdict", name_of(outcome.verdict)},
            {"section", source.section_of(claim.lines.first)},
            {"place", place_words(claim, source)},
            {"verdict_text", verdict_text(result)},
            {"printed", printed_html(claim, source)},
            {"where", where_html(claim, head)},
            {"kind", claim.kind},
            {"note", note(outcome.note)},
            {"quoted", claim.text_or("quoted", "")},
            {"computed", note(outcome.computed.value_or(""))},
            {"correction", correction ? sides_html(*correction, claim, source) : ""},
            {"remark", note(claim.text_or("remark", ""))},
            {"tex", claim.printed},
            {"theorem", theorem == head.theorems.end()
                            ? Json()
                            : Json{{"path", theorem->second.path},
                                   {"sha256", theorem->second.sha256},
                                   {"statements", theorem->second.statements}}},
            {"evidence",
             outcome.evidence.empty() ? "" : evidence_html(outcome.evidence, claim, source)}};
}

} // namespace edgeproof::report
