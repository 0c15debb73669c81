// SPDX-License-Identifier: BSD-3-Clause
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
using audit::PrintedSource;
using Json = nlohmann::ordered_json;

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

std::string item_html(const Json& item, const Claim& claim, const PrintedSource& source);

/// A list of records with the same keys becomes one table with a column for each key.
std::string rows_html(const Json& list, const Claim& claim, const PrintedSource& source) {
    Json keys = Json::object(); // in the order in which they occur
    for (const Json& row : list) {
        keys.update(row);
    }
    std::string out = "<table class=\"columns\"><thead><tr>";
    for (const auto& [key, any] : keys.items()) {
        out += "<th scope=\"col\">" + key_words(key) + "</th>";
    }
    out += "</tr></thead><tbody>";
    for (const Json& row : list) {
        out += "<tr>";
        for (const auto& [key, any] : keys.items()) {
            out += "<td>" + (row.contains(key) ? item_html(row[key], claim, source) : "") + "</td>";
        }
        out += "</tr>";
    }
    return out + "</tbody></table>";
}

std::string item_html(const Json& item, const Claim& claim, const PrintedSource& source) {
    if (item.is_string()) {
        return text_html(item.get<std::string>(), claim, source);
    }
    if (item.is_boolean()) {
        return item.get<bool>() ? "yes" : "no";
    }
    if (item.is_object()) {
        return evidence_html(item, claim, source);
    }
    if (!item.is_array()) {
        return item.dump();
    }
    if (!item.empty() &&
        std::ranges::all_of(item, [](const Json& part) { return part.is_object(); })) {
        return rows_html(item, claim, source);
    }
    std::string out;
    for (const Json& part : item) {
        out += (out.empty() ? "" : "; ") + item_html(part, claim, source);
    }
    return item.empty() ? "none" : out;
}

} // namespace

std::string note_html(const std::string& note, const Claim& claim, const PrintedSource& source) {
    return sentence_html(note_tex(note, claim, source), source);
}

std::string evidence_html(const Json& evidence, const Claim& claim, const PrintedSource& source) {
    std::string out = "<table class=\"evidence stack\"><tbody>\n";
    for (const auto& [key, item] : evidence.items()) {
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
