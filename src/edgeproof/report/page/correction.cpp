// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/page/correction.hpp"

#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/formula_tex.hpp"
#include "edgeproof/report/text/tex_math.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace edgeproof::report {
namespace {

using audit::Claim;
using audit::Evidence;
using audit::PrintedSource;

const Evidence* nested_at(const Evidence& evidence, std::string_view key) {
    const audit::EvidenceItem* item = evidence.find(key);
    return item == nullptr ? nullptr : std::get_if<Evidence>(&item->value());
}
std::string text_in(const Evidence& evidence, std::string_view key) {
    const audit::EvidenceItem* item = evidence.find(key);
    const auto* text = item == nullptr ? nullptr : std::get_if<std::string>(&item->value());
    return text == nullptr ? "" : *text;
}

std::string family_of(const Claim& claim) { return claim.text_or("over", ""); }

std::string tex_of(const std::string& text, const Claim& claim, const PrintedSource& source,
                   formula::Expr (*arrange)(const formula::Expr&) = nullptr) {
    const auto e = formula_of(text, claim);
    if (!e) {
        return "\\text{" + latex_text(text) + "}";
    }
    return formula_tex(arrange != nullptr ? arrange(*e) : *e, source, family_of(claim));
}

std::string math(const std::string& tex) { return "$" + tex + "$"; }

/// Typesets "eps^(3/2)" from the evidence of expansions.
std::string power_tex(const std::string& power, const Claim& claim, const PrintedSource& source) {
    return tex_of(power, claim, source);
}

/// Returns the claim or the reading to which a correction refers: the last that is refuted.
std::pair<const Claim*, const audit::Outcome*> spoken_of(const audit::ClaimResult& result) {
    std::pair<const Claim*, const audit::Outcome*> found{&result.claim, &result.outcome};
    for (std::size_t i = 0; i < result.readings.size() && i < result.claim.readings.size(); ++i) {
        if (result.readings[i].second.verdict == audit::Verdict::refuted) {
            found = {&result.claim.readings[i], &result.readings[i].second};
        }
    }
    return found;
}

std::string values_tex(const Evidence& with, const Claim& claim, const PrintedSource& source) {
    std::string out;
    for (const auto& [name, item] : with.entries()) {
        out += (out.empty() ? "" : ", ") +
               math(tex_of(name, claim, source) + " = " + tex_of(item.text(), claim, source));
    }
    return out;
}

std::string value_steps(const Evidence& clearest, const std::string& which, const Claim& claim,
                        const PrintedSource& source) {
    const std::string exact = text_in(clearest, which + "_value");
    const std::string decimal = text_in(clearest, which + "_decimal");
    std::string out =
        tex_of(text_in(clearest, which), claim, source, which == "correct" ? arranged : nullptr);
    if (!exact.empty()) {
        out += " = " + tex_of(exact, claim, source, gathered);
    }
    if (!decimal.empty() && decimal != exact) {
        out += " = " + number_tex(decimal) + "\\dots";
    }
    return out;
}

/// Names the other coefficients that vanish where the claim states that this one does.
std::string others_in_words(const audit::Outcome& outcome, const Claim& claim,
                            const PrintedSource& source) {
    std::string out;
    if (const Evidence* others = nested_at(outcome.evidence, "elsewhere")) {
        for (const auto& [name, found] : others->entries()) {
            if (found.text() == "vanishes at the printed value") {
                out += " At the printed value " + math(tex_of(name, claim, source)) + " vanishes.";
            }
        }
    }
    return out;
}

std::vector<std::string> reach_steps(const Evidence& c, const Claim& claim,
                                     const PrintedSource& source) {
    const std::string base = tex_of(text_in(c, "of"), claim, source);
    const std::string p_local = "p_{\\mathrm{local}}";
    return {"Take " + values_tex(*nested_at(c, "with"), claim, source) + ", and the distance " +
                math(number_tex(text_in(c, "distance")) + "\\," + base) + " from the " +
                text_in(c, "edge") + "-hand edge.",
            "The pressure there is " +
                math("p = " + number_tex(text_in(c, "pressure")) + "\\dots") + ", and " +
                text_in(c, "terms") +
                (text_in(c, "terms") == "1" ? " term gives " : " terms give ") +
                math(p_local + " = " + number_tex(text_in(c, "approximation")) + "\\dots") + ".",
            "The relative error is " +
                math("|1 - " + p_local + "/p| = " + number_tex(text_in(c, "error")) + "\\dots") +
                "; as printed, it would be " + text_in(c, "printed_means") + ", " +
                math(tex_of(text_in(c, "tolerance"), claim, source)) + "."};
}

std::vector<std::string> course_steps(const Evidence& c, const Claim& claim,
                                      const PrintedSource& source) {
    Evidence fixed;
    const std::string along = text_in(c, "along");
    for (const auto& [name, item] : nested_at(c, "with")->entries()) {
        if (name != along) {
            fixed.add(name, item);
        }
    }
    const std::string what = math(tex_of(text_in(c, "of"), claim, source));
    const auto at = [&](const char* where, const char* value) {
        return math(tex_of(along, claim, source) + " = " +
                    tex_of(text_in(c, where), claim, source)) +
               ": " + what + math("\\; = " + number_tex(text_in(c, value)) + "\\dots");
    };
    const std::string place = text_in(c, "place");
    return {"Take " + values_tex(fixed, claim, source) +
                (place.empty() ? "" : ", at " + note_tex(place, claim, source)) + ".",
            "At " + at("first_at", "first") + ".", "At " + at("second_at", "second") + ".",
            "As printed, it " + text_in(c, "claimed") + " from the one to the other."};
}

} // namespace

std::string number_tex(const std::string& number) {
    const std::size_t e = number.find('e');
    if (e == std::string::npos) {
        return number;
    }
    const std::string power = number.substr(e + 1);
    return number.substr(0, e) + " \\cdot 10^{" + (power[0] == '+' ? power.substr(1) : power) + '}';
}

std::optional<Correction> correction_of(const audit::ClaimResult& result,
                                        const PrintedSource& source) {
    const auto [claim, outcome] = spoken_of(result);
    if (!outcome->correct || is_sentence(claim->printed)) {
        return std::nullopt;
    }
    Correction correction;
    const formula::Expr* says = claim->find_written("says");
    const auto correct = formula_of(*outcome->correct, *claim);
    const std::string family = family_of(*claim);
    const audit::EvidenceItem* instead = outcome->evidence.find("derived_instead");
    const audit::EvidenceItem* terms = outcome->evidence.find("terms");
    if (instead != nullptr && terms != nullptr) {
        for (const auto& item : std::get<std::vector<audit::EvidenceItem>>(terms->value())) {
            const auto& term = std::get<Evidence>(item.value());
            const std::string printed = text_in(term, "printed");
            if (!printed.empty()) {
                correction.what = "the coefficient of " +
                                  math(power_tex(text_in(term, "power"), *claim, source)) +
                                  (claim->reading.empty() ? "" : ", " + latex_text(claim->reading));
                correction.printed = tex_of(printed, *claim, source, gathered);
                correction.corrected = tex_of(text_in(term, "derived"), *claim, source, gathered);
                return correction;
            }
        }
    }
    if (says == nullptr || !correct) {
        return std::nullopt;
    }
    correction.left = left_side(claim->printed);
    correction.printed = formula_tex(*says, source, family);
    correction.corrected = formula_tex(arranged(*correct), source, family);
    return correction;
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
        if (begin != std::string::npos && end != std::string::npos) {
            const std::size_t from = begin + before.size();
            computed = outcome.note.substr(from, end - from) + "\\,\\%$ ($" + computed;
            return "For " + math(quoted) + " read " + math(computed) + ").";
        }
        return "For " + math(quoted) + " read " + math(computed) + ".";
    }
    const Evidence* clearest = nested_at(outcome.evidence, "clearest");
    if (clearest != nullptr && clearest->find("along") != nullptr) {
        const Claim& reading = *spoken_of(result).first;
        const std::string along = tex_of(text_in(*clearest, "along"), reading, source) + " = ";
        const auto at = [&](const char* value, const char* where) {
            return math(number_tex(text_in(*clearest, value))) + " at " +
                   math(along + tex_of(text_in(*clearest, where), reading, source));
        };
        return math(tex_of(text_in(*clearest, "of"), reading, source)) + " is " +
               at("first", "first_at") + ", and " + at("second", "second_at") + ".";
    }
    if (outcome.correct) {
        const std::size_t equals = outcome.correct->find(" = ");
        const std::size_t of = outcome.correct->rfind(" for ");
        if (equals != std::string::npos && of != std::string::npos) {
            return math(tex_of(outcome.correct->substr(of + 5), claim, source)) + " vanishes at " +
                   math(tex_of(outcome.correct->substr(0, equals), claim, source) + " = " +
                        tex_of(outcome.correct->substr(equals + 3, of - equals - 3), claim,
                               source)) +
                   "." + others_in_words(outcome, claim, source);
        }
    }
    std::string words = note_tex(outcome.note, claim, source) + ".";
    words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    return words;
}

std::vector<std::string> counterexample_steps(const audit::ClaimResult& result,
                                              const PrintedSource& source) {
    const Evidence* c = nested_at(result.outcome.evidence, "clearest");
    if (c == nullptr || nested_at(*c, "with") == nullptr) {
        return {};
    }
    const Claim& claim = *spoken_of(result).first;
    if (c->find("distance") != nullptr) {
        return reach_steps(*c, claim, source);
    }
    if (c->find("along") != nullptr) {
        return course_steps(*c, claim, source);
    }
    if (c->find("claimed_value") != nullptr) {
        return {"Take " + values_tex(*nested_at(*c, "with"), claim, source) +
                    ", which is the ratio printed.",
                "Then " +
                    math(tex_of(text_in(*c, "of"), claim, source) + " = " +
                         number_tex(text_in(*c, "value")) + "\\dots") +
                    ", but the printed value is " + math(text_in(*c, "claimed_value")) + "."};
    }
    const std::string power = text_in(*c, "coefficient_of");
    return {"Take " + values_tex(*nested_at(*c, "with"), claim, source) + "." +
                (power.empty()
                     ? ""
                     : " The coefficient of " + math(power_tex(power, claim, source)) + ":"),
            "as printed, " + math(value_steps(*c, "printed", claim, source)) + ";",
            "correctly, " + math(value_steps(*c, "correct", claim, source)) + "."};
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
