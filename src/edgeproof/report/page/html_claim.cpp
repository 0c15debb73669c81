// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/report/page/html.hpp"

#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/formula_tex.hpp"
#include "edgeproof/report/text/tex_math.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace edgeproof::report {
namespace {

using audit::PrintedSource;

/// A wide element that scrolls within the page, also by keyboard.
std::string scroll(const std::string& label, const std::string& content) {
    return fmt::format(
        "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"{}\">{}</div>",
        escape_html(label), content);
}

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
    const auto side = [&](const char* kind, const char* title, const MathNode& formula) {
        return fmt::format("<div class=\"side {}\"><h4>{}</h4>{}</div>", kind, title,
                           scroll(kind, block_math(formula, kind + (", " + claim.id))));
    };
    return (correction.what.empty()
                ? ""
                : "<p class=\"what\">In " + sentence_html(correction.what, source) + ":</p>\n") +
           "<div class=\"sides\">" + side("printed", "Printed", printed) +
           side("corrected", "Corrected", corrected) +
           fmt::format("</div>\n<div class=\"copy\"><code>{}</code><button type=\"button\" "
                       "class=\"copy-button\" hidden>Copy LaTeX<span class=\"away\"> of {}</span>"
                       "</button></div>\n",
                       escape_html(with_left(correction.left, correction.corrected)),
                       escape_html(claim.id));
}

std::string steps_html(const audit::ClaimResult& result, const PrintedSource& source) {
    std::string out;
    for (const std::string& step : counterexample_steps(result, source)) {
        out += "<li>" + sentence_html(step, source) + "</li>\n";
    }
    return out.empty()
               ? out
               : "<div class=\"example\"><h4>To check by hand</h4>\n<ol>\n" + out + "</ol></div>\n";
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

std::string later_html(const Erratum& erratum, const audit::AuditResult& result,
                       const PrintedSource& source) {
    std::string out;
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
            out += fmt::format(
                "<li><a href=\"#{}\">{}</a>, {}: {}", escape_html(later.claim),
                escape_html(claim == nullptr ? later.claim : place_words(claim->claim, source)),
                what, verdict);
            out += result_html(later.comes_to, source) + ".</li>\n";
        }
    }
    return out.empty() ? ""
                       : "<div class=\"rests\"><h4>What rests on it, computed with the line as "
                         "printed</h4>\n<ul>\n" +
                             out + "</ul></div>\n";
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

/// The statements that Coq proved, in the page itself: a page that is mailed has no other files.
std::string theorem_html(const audit::Claim& claim, const PageHead& head) {
    const auto it = head.theorems.find(claim.id);
    if (it == head.theorems.end()) {
        return "";
    }
    const PageTheorem& theorem = it->second;
    return fmt::format(
        "<details class=\"theorem\" id=\"theorem-{}\"><summary>Theorem for "
        "Coq</summary>\n<p class=\"soft\">The statements of the file "
        "<code>{}</code> (SHA-256 <code>{}</code>), without their proofs, which are "
        "in the file. The predicates are defined in the folder "
        "<code>verify/certificates</code> of the program.</p>\n{}</details>\n",
        escape_html(claim.id), escape_html(theorem.path), theorem.sha256,
        scroll("theorem for " + claim.id, "<pre>" + escape_html(theorem.statements) + "</pre>"));
}

} // namespace

std::string verdict_mark(audit::Verdict verdict, const std::string& text) {
    const std::string name(name_of(verdict));
    return "<span class=\"verdict " + name + "\">" + (text.empty() ? name : text) + "</span>";
}

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

std::string erratum_html(const Erratum& erratum, const audit::AuditResult& result,
                         const PageHead& head, const PageFigures& figures) {
    const audit::ClaimResult& first = *erratum.parts.front();
    const std::string id = escape_html(first.claim.id);
    const DrawnFigure::Panel* plot = nullptr;
    for (const audit::ClaimResult* part : erratum.parts) {
        const auto drawn = std::ranges::find(figures.errata, part->claim.id, &DrawnFigure::id);
        if (plot == nullptr && drawn != figures.errata.end() && !drawn->panels.empty()) {
            plot = &drawn->panels.front();
        }
    }
    std::string out = fmt::format(
        "<article class=\"erratum\" id=\"erratum-{0}\" aria-labelledby=\"erratum-{0}-heading\">\n"
        "<h3 id=\"erratum-{0}-heading\">{1} {2} <span class=\"weight\">{3}</span></h3>\n"
        "<p class=\"where\">{4}{5}evidence:",
        id, escape_html(place_words(first.claim, head.source)), verdict_mark(first.outcome.verdict),
        weight_words(erratum.weight), where_html(first.claim, head),
        first.claim.lines.first == 0 ? "" : " · ");
    for (const audit::ClaimResult* part : erratum.parts) {
        out += fmt::format(" <a href=\"#{0}\">{0}</a>", escape_html(part->claim.id));
    }
    out += "</p>\n";
    const bool sentence = is_sentence(first.claim.printed);
    if (sentence) {
        out += "<blockquote><p>" + sentence_html(first.claim.printed, head.source) +
               "</p></blockquote>\n";
    }
    for (const audit::ClaimResult* part : erratum.parts) {
        if (part != &first) {
            out += "<span class=\"anchor\" id=\"erratum-" + escape_html(part->claim.id) +
                   "\"></span>\n";
        }
        if (const auto correction = correction_of(*part, head.source)) {
            out += sides_html(*correction, part->claim, head.source);
        } else {
            out += "<p class=\"instead\"><strong>Found:</strong> " +
                   sentence_html(correction_in_words(*part, head.source), head.source) + "</p>\n";
        }
        const bool repeats = !sentence && part != &first && plot != nullptr;
        out += repeats ? "" : steps_html(*part, head.source);
    }
    out += later_html(erratum, result, head.source);
    if (plot != nullptr) {
        out += "<figure class=\"single\"><div class=\"panel\">" + plot->svg + "</div><figcaption>" +
               escape_html(plot->title) + "</figcaption></figure>\n";
    }
    return out + "</article>\n";
}

std::string claim_html(const audit::ClaimResult& result, const PageHead& head) {
    const audit::Claim& claim = result.claim;
    const PrintedSource& source = head.source;
    const std::string id = escape_html(claim.id);
    std::string out = fmt::format(
        "<details class=\"claim\" id=\"{0}\" data-verdict=\"{1}\" data-section=\"{2}\">\n<summary>"
        "<span class=\"id\">{3}</span> {4} <span class=\"said\">{5}</span></summary>\n"
        "<div class=\"body\">\n<p class=\"where\"><a href=\"#{0}\">{0}</a>",
        id, name_of(result.outcome.verdict), escape_html(source.section_of(claim.lines.first)),
        escape_html(place_words(claim, source)),
        verdict_mark(result.outcome.verdict, verdict_text(result)), printed_html(claim, source));
    for (const std::string& part :
         {where_html(claim, head), "a check of kind " + escape_html(claim.kind)}) {
        out += part.empty() ? "" : " · " + part;
    }
    out += "</p>\n";
    if (!result.outcome.note.empty()) {
        out += "<p>" + note_html(result.outcome.note, claim, source) + "</p>\n";
    }
    if (claim.has("quoted")) {
        out += "<p>Quoted: " + escape_html(claim.text("quoted")) +
               (result.outcome.computed
                    ? "; computed: " + note_html(*result.outcome.computed, claim, source)
                    : "") +
               "</p>\n";
    }
    if (result.outcome.verdict != audit::Verdict::proved &&
        result.outcome.verdict != audit::Verdict::confirmed) {
        if (const auto correction = correction_of(result, source)) {
            out += sides_html(*correction, claim, source);
        }
    }
    if (claim.has("remark")) {
        out += "<p class=\"remark\">" + note_html(claim.text("remark"), claim, source) + "</p>\n";
    }
    if (!claim.printed.empty()) {
        out += "<details class=\"tex\"><summary>TeX of the source</summary><code>" +
               escape_html(claim.printed) + "</code></details>\n";
    }
    out += theorem_html(claim, head);
    if (!result.outcome.evidence.empty()) {
        out += scroll("evidence for " + claim.id,
                      evidence_html(result.outcome.evidence, claim, source));
    }
    return out + "</div>\n</details>\n";
}

} // namespace edgeproof::report
