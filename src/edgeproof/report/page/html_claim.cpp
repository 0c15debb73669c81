// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/page/html_claim.hpp"

#include "edgeproof/report/page/html_mathml.hpp"
#include "edgeproof/report/text/html_markup.hpp"

#include <optional>
#include <variant>

namespace edgeproof::report {
namespace {

std::string code(std::string_view text) { return "<code>" + escape_html(text) + "</code>"; }

/// A wide thing that scrolls within the page; reachable by keyboard.
std::string scroll(const std::string& label, const std::string& content) {
    return "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"" +
           escape_html(label) + "\">" + content + "</div>";
}

std::optional<formula::Expr> parsed(std::string_view text, const audit::Claim& claim) {
    try {
        return parse_formula(text, claim.vocabulary);
    } catch (const Error&) { // words, a list, a relation
        return std::nullopt;
    }
}

/// A field of text: as it was parsed, or else if it can be.
std::optional<formula::Expr> parsed_field(std::string_view key, const audit::Claim& claim) {
    const formula::Expr* e = claim.find_written(key);
    return e != nullptr ? std::optional(*e) : parsed(claim.text(key), claim);
}

/// The formula typeset, with what the claim is of on its left; words in a <code>.
std::string formula(const std::string& text, const std::optional<formula::Expr>& e,
                    const audit::Claim& claim, const std::string& label) {
    if (!e) {
        return "<p>" + code(text) + "</p>";
    }
    std::string content = to_mathml(*e);
    if (claim.has("of")) {
        if (const auto left = parsed_field("of", claim)) {
            content = "<mrow>" + to_mathml(*left) + "<mo>=</mo>" + content + "</mrow>";
        }
    }
    return scroll(label, math_element(content, label + ": " + text));
}

const std::string* text_field(const audit::Claim& claim, std::string_view key) {
    const audit::Field* field = claim.find(key);
    return field == nullptr ? nullptr : std::get_if<std::string>(&field->value);
}

void term(std::string& out, const std::string& name, const std::string& content) {
    out += "<dt>" + name + "</dt><dd>" + content + "</dd>\n";
}

/// printed, said, quoted, computed, corrected: what both the errata and the claims show.
std::string description(const audit::ClaimResult& result) {
    const audit::Claim& claim = result.claim;
    std::string out;
    if (!claim.printed.empty()) {
        term(out, "Printed (TeX)", "<p>" + code(claim.printed) + "</p>");
    }
    if (const std::string* says = text_field(claim, "says")) {
        term(out, "Printed", formula(*says, parsed_field("says", claim), claim, "printed"));
    }
    if (result.outcome.correct) {
        term(out, "Corrected",
             formula(*result.outcome.correct, parsed(*result.outcome.correct, claim), claim,
                     "corrected") +
                 "<p>" + code(*result.outcome.correct) + "</p>");
    }
    if (const std::string* quoted = text_field(claim, "quoted")) {
        term(out, "Quoted", "<p>" + code(*quoted) + "</p>");
    }
    if (result.outcome.computed) {
        term(out, "Computed", "<p>" + code(*result.outcome.computed) + "</p>");
    }
    return out.empty() ? out : "<dl>\n" + out + "</dl>\n";
}

std::string item_html(const audit::EvidenceItem& item) {
    struct Visitor {
        std::string operator()(const std::string& text) const {
            return "<span class=\"value\">" + escape_html(text) + "</span>";
        }
        std::string operator()(long count) const {
            return "<span class=\"value\">" + std::to_string(count) + "</span>";
        }
        std::string operator()(bool yes) const { return yes ? "yes" : "no"; }
        std::string operator()(const std::vector<audit::EvidenceItem>& list) const {
            if (list.empty()) {
                return "none";
            }
            std::string out = "<ul>";
            for (const audit::EvidenceItem& part : list) {
                out += "<li>" + item_html(part) + "</li>";
            }
            return out + "</ul>";
        }
        std::string operator()(const audit::Evidence& nested) const {
            return evidence_html(nested);
        }
    };
    return std::visit(Visitor(), item.value());
}

/// The first item of that key, however deep.
const audit::EvidenceItem* find_deep(const audit::Evidence& evidence, std::string_view key) {
    for (const auto& [name, item] : evidence.entries()) {
        if (name == key) {
            return &item;
        }
        if (const auto* nested = std::get_if<audit::Evidence>(&item.value())) {
            if (const audit::EvidenceItem* found = find_deep(*nested, key)) {
                return found;
            }
        }
    }
    return nullptr;
}

} // namespace

std::string verdict_mark(audit::Verdict verdict) {
    const std::string name(name_of(verdict));
    return "<span class=\"verdict " + name + "\">" + name + "</span>";
}

std::string lines_words(const audit::Claim& claim) {
    const auto& [first, last] = claim.lines;
    if (first == 0) {
        return {}; // somebody's own formulas are of no source
    }
    return first == last ? "line " + std::to_string(first)
                         : "lines " + std::to_string(first) + "–" + std::to_string(last);
}

std::string evidence_html(const audit::Evidence& evidence) {
    std::string out = "<table class=\"evidence stack\"><tbody>\n";
    for (const auto& [key, item] : evidence.entries()) {
        out += "<tr><th scope=\"row\">" + escape_html(key) + "</th><td>" + item_html(item) +
               "</td></tr>\n";
    }
    return out + "</tbody></table>\n";
}

std::string erratum_html(const audit::ClaimResult& result, const std::string& section,
                         const DrawnFigure::Panel* plot) {
    const std::string id = escape_html(result.claim.id);
    const bool drawn = plot != nullptr && !plot->svg.empty();
    std::string out = "<article class=\"erratum" + std::string(drawn ? " with-plot" : "") +
                      "\" id=\"erratum-" + id + "\" aria-labelledby=\"erratum-" + id +
                      "-title\">\n<div>\n<h3 id=\"erratum-" + id + "-title\"><a href=\"#" + id +
                      "\">" + id + "</a> " + verdict_mark(result.outcome.verdict) + "</h3>\n";
    const std::string lines = lines_words(result.claim);
    if (!lines.empty()) {
        out += "<p class=\"where\">" + lines + " of the source" +
               (section.empty() ? "" : " · " + escape_html(section)) + "</p>\n";
    }
    if (!result.outcome.note.empty()) {
        out += "<p>" + escape_html(result.outcome.note) + "</p>\n";
    }
    out += description(result);
    const audit::EvidenceItem* ratio = find_deep(result.outcome.evidence, "ratio");
    const audit::EvidenceItem* range = find_deep(result.outcome.evidence, "ratio_range");
    if (ratio != nullptr || range != nullptr) {
        std::string list;
        if (const auto* text = ratio ? std::get_if<std::string>(&ratio->value()) : nullptr) {
            const auto e = parsed(*text, result.claim);
            term(list, "Printed over exact",
                 e ? scroll("ratio", math_element(to_mathml(*e), "ratio: " + *text))
                   : item_html(*ratio));
        }
        if (range != nullptr) {
            term(list, "Over the family, the ratio runs from and to", item_html(*range));
        }
        out += "<dl>\n" + list + "</dl>\n";
    }
    out += "</div>\n";
    if (drawn) {
        out += "<figure class=\"single\"><div class=\"panel\">" + plot->svg + "</div><figcaption>" +
               escape_html(plot->title) + "</figcaption></figure>\n";
    }
    return out + "</article>\n";
}

std::string claim_html(const audit::ClaimResult& result, const std::string& section,
                       const std::string& section_key) {
    const audit::Claim& claim = result.claim;
    const std::string id = escape_html(claim.id);
    std::string out = "<details class=\"claim\" id=\"" + id + "\" data-verdict=\"" +
                      std::string(name_of(result.outcome.verdict)) + "\" data-section=\"" +
                      section_key + "\">\n<summary><span class=\"id\">" + id + "</span> " +
                      verdict_mark(result.outcome.verdict) + " <span class=\"note\">" +
                      escape_html(result.outcome.note) +
                      "</span></summary>\n<div class=\"body\">\n";
    out += "<p class=\"where\"><a href=\"#" + id + "\">#" + id + "</a>";
    for (const std::string& part :
         {lines_words(claim), escape_html(section), escape_html(claim.kind)}) {
        out += part.empty() ? "" : " · " + part;
    }
    out += "</p>\n";
    out += description(result);
    if (!result.outcome.evidence.empty()) {
        out += scroll("evidence for " + claim.id, evidence_html(result.outcome.evidence));
    }
    return out + "</div>\n</details>\n";
}

} // namespace edgeproof::report
