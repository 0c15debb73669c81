// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/page/errata.hpp"

#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/formula_tex.hpp"
#include "edgeproof/report/text/percent.hpp"
#include "edgeproof/report/text/tex_math.hpp"
#include "edgeproof/report/verdicts/verdict_writers.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace edgeproof::report {
namespace {

using audit::Claim;
using Json = nlohmann::ordered_json;
using audit::PrintedSource;

std::string family_of(const Claim& claim) { return claim.text_or("over", ""); }
std::string math(const std::string& tex) { return "$" + tex + "$"; }

/// Typesets the formulas of a claim in the notation of its source.
struct Typeset {
    const Claim& claim;
    const PrintedSource& source;
    using Arrange = formula::Expr (*)(const formula::Expr&);

    [[nodiscard]] std::string tex(const std::string& text, Arrange arrange = nullptr) const {
        const auto e = formula_of(text, claim);
        return !e ? "\\text{" + latex_text(text) + "}"
                  : formula_tex(arrange != nullptr ? arrange(*e) : *e, source, family_of(claim));
    }
    /// The formula of evidence under a key, such as "eps^(3/2)".
    [[nodiscard]] std::string part(const Json& c, const std::string& key,
                                   Arrange arrange = nullptr) const {
        return tex(text_in(c, key), arrange);
    }
    /// "$x = 1$, $y = 2$"
    [[nodiscard]] std::string values(const Json& c) const {
        std::string out;
        for (const auto& [name, value] : c.at("with").items()) {
            out += (out.empty() ? "" : ", ") +
                   math(tex(name) + " = " + tex(text_in(c.at("with"), name)));
        }
        return out;
    }
};

/// A number of the evidence that continues.
std::string digits_in(const Json& c, const std::string& key) {
    return number_tex(text_in(c, key)) + "\\dots";
}

/// Appends "= 0.127..." for a rounded value; nothing if the exact value has the same digits.
std::string decimal_step(const std::string& decimal, const std::string& exact) {
    if (decimal.empty() || decimal == "0") {
        return decimal.empty() || exact == "0" ? "" : " = 0";
    }
    std::string digits = decimal;
    if (digits.find('.') != std::string::npos && digits.find('e') == std::string::npos) {
        digits.erase(digits.find_last_not_of('0') + 1); // "2.0000000" is 2
        if (digits.back() == '.') {
            digits.pop_back();
        }
    }
    return digits == exact || decimal == exact ? "" : " = " + number_tex(decimal) + "\\dots";
}

std::string value_steps(const Json& clearest, const std::string& which, const Typeset& by) {
    const std::string exact = text_in(clearest, which + "_value");
    const std::string decimal = text_in(clearest, which + "_decimal");
    return by.part(clearest, which, which == "correct" ? arranged : nullptr) +
           (exact.empty() ? "" : " = " + by.tex(exact, gathered)) + decimal_step(decimal, exact);
}

std::vector<std::string> reach_steps(const Json& c, const Typeset& by) {
    const std::string p_local = "p_{\\mathrm{local}}";
    const std::string terms = text_in(c, "terms");
    return {"Take " + by.values(c) + ", and the distance " +
                math(number_tex(text_in(c, "distance")) + "\\," + by.part(c, "of")) + " from the " +
                text_in(c, "edge") + "-hand edge.",
            "The pressure there is " + math("p = " + digits_in(c, "pressure")) + ", and " + terms +
                (terms == "1" ? " term gives " : " terms give ") +
                math(p_local + " = " + digits_in(c, "approximation")) + ".",
            "The relative error is " + math("|1 - " + p_local + "/p| = " + digits_in(c, "error")) +
                "; as printed, it would be " + text_in(c, "printed_means") + ", " +
                latex_text(in_percent(formula::Exact::parse(text_in(c, "tolerance")))) + "."};
}

} // namespace

std::string text_in(const Json& evidence, const std::string& key) {
    const auto text = evidence.find(key);
    return text != evidence.end() && text->is_string() ? text->get<std::string>() : "";
}

std::string number_tex(const std::string& number) {
    const std::size_t e = number.find('e');
    if (e == std::string::npos) {
        return number;
    }
    std::string power = number.substr(e + 1); // "+08" is 8
    const bool negative = power[0] == '-';
    power.erase(0, std::min(power.find_first_not_of("+-0"), power.size() - 1));
    return number.substr(0, e) + " \\cdot 10^{" + (negative ? "-" : "") + power + '}';
}

std::optional<Correction> correction_of(const audit::ClaimResult& result,
                                        const PrintedSource& source) {
    const auto [claim, outcome] = spoken_of(result);
    if (!outcome->correct || is_sentence(claim->printed)) {
        return std::nullopt;
    }
    const Typeset by{*claim, source};
    const Json& evidence = outcome->evidence;
    if (evidence.contains("derived_instead")) {
        for (const Json& term : evidence.value("terms", Json::array())) {
            if (!text_in(term, "printed").empty()) {
                return Correction{
                    "the coefficient of " + math(by.part(term, "power")) +
                        (claim->reading.empty() ? "" : ", " + latex_text(claim->reading)),
                    "", by.part(term, "printed", gathered), by.part(term, "derived", gathered)};
            }
        }
    }
    const formula::Expr* says = claim->find_written("says");
    const auto correct = formula_of(*outcome->correct, *claim);
    if (says == nullptr || !correct) {
        return std::nullopt;
    }
    const std::string family = family_of(*claim);
    return Correction{"", left_side(claim->printed), formula_tex(*says, source, family),
                      formula_tex(arranged(*correct), source, family)};
}

std::string correction_in_words(const audit::ClaimResult& result, const PrintedSource& source) {
    const Claim& claim = result.claim;
    const audit::Outcome& outcome = result.outcome;
    if (claim.has("quoted") && outcome.computed) {
        std::string quoted = latex_text(claim.text("quoted"));
        std::string computed = latex_text(*outcome.computed);
        for (std::string* text : {&quoted, &computed}) {
            if (const std::size_t at = text->find(" \\%"); at != std::string::npos) {
                text->replace(at, 3, "\\,\\%");
            }
        }
        // The note "rounds to 49 %: 3 units ..." has the value at the quoted number of digits.
        const std::string before = "rounds to ";
        const std::size_t begin = outcome.note.find(before);
        const std::size_t end = outcome.note.find(" %", begin == std::string::npos ? 0 : begin);
        const bool one = claim.text("quoted").find(',') == std::string::npos; // else a table
        const bool rounded = one && begin != std::string::npos && end != std::string::npos;
        const std::size_t from = begin + before.size();
        return "For " + math(quoted) + " read " +
               (rounded ? math(outcome.note.substr(from, end - from) + "\\,\\%") + " (" +
                              math(computed) + ")."
                        : math(computed) + ".");
    }
    std::string words = note_tex(outcome.note, claim, source) + ".";
    words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    return words;
}

std::vector<std::string> counterexample_steps(const audit::ClaimResult& result,
                                              const PrintedSource& source) {
    const Json c = result.outcome.evidence.value("clearest", Json::object());
    if (!c.contains("with")) {
        return {};
    }
    const Typeset by{*spoken_of(result).claim, source};
    if (c.contains("distance")) {
        return reach_steps(c, by);
    }
    return {"Take " + by.values(c) + "." +
                (text_in(c, "coefficient_of").empty()
                     ? ""
                     : " The coefficient of " + math(by.part(c, "coefficient_of")) + ":"),
            "as printed, " + math(value_steps(c, "printed", by)) + ";",
            "correctly, " + math(value_steps(c, "correct", by)) + "."};
}

std::string note_tex(const std::string& note, const Claim& claim, const PrintedSource& source) {
    const auto name_part = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
    };
    std::string out;
    for (std::size_t i = 0; i < note.size();) {
        std::size_t n = 0;
        while (i + n < note.size() && name_part(note[i + n])) {
            ++n;
        }
        if (note.compare(i, 2, "->") == 0) {
            out += "$\\to$";
            i += 2;
            continue;
        }
        if (n == 0 || std::isdigit(static_cast<unsigned char>(note[i])) != 0) {
            n = std::max<std::size_t>(n, 1);
            while (i + n < note.size() &&
                   (static_cast<unsigned char>(note[i + n]) & 0xC0U) == 0x80U) {
                ++n; // a complete character of UTF-8
            }
            out += latex_text(note.substr(i, n));
            i += n;
            continue;
        }
        while (n > 1 && note[i + n - 1] == '.') {
            --n;
        }
        std::string word = note.substr(i, n);
        // A formula begins with a name and continues over operators without a space.
        const bool name =
            !source.notation_of(word, "").empty() || claim.vocabulary.symbols.has(word);
        const bool letter = word.size() == 1 && word != "a";
        if (name &&
            (word.size() > 1 || letter ||
             (i + n < note.size() && std::string("*^/(").find(note[i + n]) != std::string::npos))) {
            std::size_t end = i + n;
            int depth = 0;
            while (end < note.size() &&
                   (name_part(note[end]) ||
                    std::string("*^/+-()").find(note[end]) != std::string::npos || depth > 0)) {
                depth += note[end] == '(' ? 1 : note[end] == ')' ? -1 : 0;
                ++end;
            }
            std::string text = note.substr(i, end - i);
            while (text.size() > n && (text.back() == '.' || text.back() == '-')) {
                text.pop_back();
            }
            if (const auto e = formula_of(text, claim)) {
                out += math(formula_tex(*e, source, family_of(claim)));
                i += text.size();
                continue;
            }
        }
        out += latex_text(word);
        i += n;
    }
    return out;
}

} // namespace edgeproof::report
