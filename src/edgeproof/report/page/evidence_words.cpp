// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/page/html.hpp"

#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/formula_tex.hpp"
#include "edgeproof/report/text/tex_math.hpp"

#include <algorithm>
#include <cctype>
#include <set>

namespace edgeproof::report {
namespace {

using audit::Claim;
using audit::Evidence;
using audit::EvidenceItem;
using audit::PrintedSource;

bool shown_elsewhere(std::string_view key) {
    static const std::set<std::string_view> keys{"clearest", "later_results", "edit",
                                                 "derived_instead"};
    return keys.contains(key);
}

bool all_numbers(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789.-+e %") == std::string_view::npos &&
           std::isdigit(static_cast<unsigned char>(text.back() == '%' ? '0' : text.back())) != 0;
}

/// Rounds "0.172989720236940..." to the digits that a reader compares; verdicts.json has all.
std::string rounded_for_reading(const std::string& number) {
    constexpr std::size_t most = 12;
    const std::size_t e = number.find('e');
    const std::string mantissa = number.substr(0, e);
    const std::string power = e == std::string::npos ? "" : number.substr(e);
    const std::size_t first = mantissa.find_first_of("123456789");
    if (mantissa.find('.') == std::string::npos || first == std::string::npos ||
        mantissa.size() - first <= most + 1) {
        return number;
    }
    return mantissa.substr(0, std::max(first + most, mantissa.find('.') + 2)) + "…" + power;
}

std::string number_html(const std::string& number) {
    const std::string shown = rounded_for_reading(number);
    const std::size_t e = shown.find('e');
    if (e == std::string::npos) {
        return "<span class=\"value\">" + escape_html(shown) + "</span>";
    }
    std::string power = shown.substr(e + 1);
    power = power[0] == '+' ? power.substr(1) : power[0] == '-' ? "−" + power.substr(1) : power;
    return "<span class=\"value\">" + escape_html(shown.substr(0, e)) + "·10<sup>" +
           escape_html(power) + "</sup></span>";
}

/// Typesets "0.17 +- 3.8e-51", a value with its bound.
std::string text_html(const std::string& text, const Claim& claim, const PrintedSource& source) {
    if (const std::size_t at = text.find(" +- ");
        at != std::string::npos && all_numbers(text.substr(0, at))) {
        return number_html(text.substr(0, at)) + " <span class=\"soft\">±&nbsp;" +
               number_html(text.substr(at + 4)) + "</span>";
    }
    if (all_numbers(text)) {
        return number_html(text);
    }
    if (text.find(' ') == std::string::npos || text.find_first_of("*^/") != std::string::npos) {
        if (const auto e = formula_of(text, claim); e && text.size() > 1) {
            return inline_math(
                math_of_tex(formula_tex(gathered(*e), source, claim.text_or("over", "")), source));
        }
    }
    return note_html(text, claim, source);
}

/// Returns a key of evidence in words: those of verdicts.json.
std::string key_words(std::string_view key) {
    std::string text(key);
    std::ranges::replace(text, '_', ' ');
    return escape_html(text);
}

std::string item_html(const EvidenceItem& item, const Claim& claim, const PrintedSource& source);

/// A list of records with the same keys becomes one table with a column for each key.
std::string rows_html(const std::vector<EvidenceItem>& list, const Claim& claim,
                      const PrintedSource& source) {
    std::vector<std::string> keys;
    for (const EvidenceItem& item : list) {
        for (const auto& [key, part] : std::get<Evidence>(item.value()).entries()) {
            if (std::ranges::find(keys, key) == keys.end()) {
                keys.push_back(key);
            }
        }
    }
    std::string out = "<table class=\"columns\"><thead><tr>";
    for (const std::string& key : keys) {
        out += "<th scope=\"col\">" + key_words(key) + "</th>";
    }
    out += "</tr></thead><tbody>";
    for (const EvidenceItem& item : list) {
        const auto& row = std::get<Evidence>(item.value());
        out += "<tr>";
        for (const std::string& key : keys) {
            const EvidenceItem* cell = row.find(key);
            out += "<td>" + (cell == nullptr ? "" : item_html(*cell, claim, source)) + "</td>";
        }
        out += "</tr>";
    }
    return out + "</tbody></table>";
}

std::string item_html(const EvidenceItem& item, const Claim& claim, const PrintedSource& source) {
    struct Visitor {
        const Claim& claim;
        const PrintedSource& source;
        std::string operator()(const std::string& text) const {
            return text_html(text, claim, source);
        }
        std::string operator()(long count) const { return std::to_string(count); }
        std::string operator()(bool yes) const { return yes ? "yes" : "no"; }
        std::string operator()(const std::vector<EvidenceItem>& list) const {
            if (list.empty()) {
                return "none";
            }
            const bool tables = std::ranges::all_of(list, [](const EvidenceItem& part) {
                return std::holds_alternative<Evidence>(part.value());
            });
            if (tables) {
                return rows_html(list, claim, source);
            }
            std::string out;
            for (const EvidenceItem& part : list) {
                out += (out.empty() ? "" : "; ") + item_html(part, claim, source);
            }
            return out;
        }
        std::string operator()(const Evidence& nested) const {
            return evidence_html(nested, claim, source);
        }
    };
    return std::visit(Visitor{claim, source}, item.value());
}

} // namespace

std::string note_html(const std::string& note, const Claim& claim, const PrintedSource& source) {
    return sentence_html(note_tex(note, claim, source), source);
}

std::string evidence_html(const Evidence& evidence, const Claim& claim,
                          const PrintedSource& source) {
    std::string out = "<table class=\"evidence stack\"><tbody>\n";
    for (const auto& [key, item] : evidence.entries()) {
        if (shown_elsewhere(key)) {
            continue;
        }
        out += "<tr><th scope=\"row\">" +
               (key.find_first_of(".=*") != std::string::npos ? note_html(key, claim, source)
                                                              : key_words(key)) +
               "</th><td>" + item_html(item, claim, source) + "</td></tr>\n";
    }
    return out + "</tbody></table>\n";
}

} // namespace edgeproof::report
