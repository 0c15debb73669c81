// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/page/errata.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"
#include "edgeproof/report/text/tex_math.hpp"
#include "edgeproof/report/verdicts/verdict_writers.hpp"

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <boost/regex.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

namespace edgeproof::report {
namespace {

using Json = nlohmann::ordered_json;
using ById = std::map<std::string, const audit::ClaimResult*, std::less<>>;

bool of_sentence(const audit::Claim& claim) { return is_sentence(claim.printed); }

/// True if computing with the line reproduces a wrong sentence or figure of the source.
bool reaches_conclusion(const audit::ClaimResult& result, const ById& all,
                        std::set<std::string>& seen) {
    if (!seen.insert(result.claim.id).second) {
        return false;
    }
    return std::ranges::any_of(later_results_of(result), [&](const LaterWords& later) {
        const auto next = all.find(later.claim);
        if (!later.as_printed || next == all.end() ||
            next->second->outcome.verdict != audit::Verdict::refuted) {
            return false;
        }
        return of_sentence(next->second->claim) || reaches_conclusion(*next->second, all, seen);
    });
}

Weight weight_of(const audit::ClaimResult& result, const ById& all) {
    if (of_sentence(result.claim)) {
        return result.claim.has("quoted") ? Weight::figure : Weight::conclusion;
    }
    if (later_results_of(result).empty()) {
        return Weight::line;
    }
    std::set<std::string> seen;
    return reaches_conclusion(result, all, seen) ? Weight::carried : Weight::slip;
}

} // namespace

std::vector<LaterWords> later_results_of(const audit::ClaimResult& result) {
    std::vector<LaterWords> all;
    for (const auto& one : result.outcome.evidence.value("later_results", Json::array())) {
        if (one.contains("as_printed")) {
            all.push_back({text_in(one, "claim"), text_in(one, "what"), text_in(one, "comes_to"),
                           one["as_printed"].get<bool>()});
        }
    }
    return all;
}

std::vector<Erratum> errata_of(const audit::AuditResult& result,
                               const audit::PrintedSource& source) {
    ById all;
    for (const audit::ClaimResult& r : result.claims) {
        all.emplace(r.claim.id, &r);
    }
    std::vector<Erratum> errata;
    std::map<std::string, std::size_t> places;
    for (const audit::ClaimResult& r : result.claims) {
        if (r.outcome.verdict != audit::Verdict::refuted) {
            continue;
        }
        const bool sentence = of_sentence(r.claim);
        const std::string number = sentence ? "" : source.number_of(r.claim.id);
        const std::string place = !number.empty() ? "(" + number
                                  : sentence      ? r.claim.printed
                                                  : r.claim.id;
        const Weight weight = weight_of(r, all);
        // A sentence that quotes two figures has two errors.
        const auto [at, fresh] =
            places.try_emplace(weight == Weight::figure ? r.claim.id : place, errata.size());
        if (fresh) {
            errata.push_back({{}, number, weight});
        }
        Erratum& erratum = errata[at->second];
        erratum.parts.push_back(&r);
        erratum.weight = std::min(erratum.weight, weight);
    }
    std::ranges::stable_sort(errata, {}, &Erratum::weight);
    return errata;
}

std::string errata_count(const std::vector<Erratum>& errata) {
    const auto count = [&](Weight weight) {
        return static_cast<std::size_t>(std::ranges::count(errata, weight, &Erratum::weight));
    };
    const auto counted = [](std::size_t n, const char* one, const char* many) {
        return fmt::format("{} {}", n, n == 1 ? one : many);
    };
    if (errata.empty()) {
        return "No error was found.";
    }
    const std::string all = counted(errata.size(), "error found.", "errors found.");
    const std::size_t slips = count(Weight::slip);
    const std::size_t lines = count(Weight::line);
    const std::size_t known = errata.size() - slips - lines;
    std::vector<std::string> known_parts;
    const auto part = [&](Weight weight, const char* one, const char* many) {
        if (const std::size_t n = count(weight); n > 0) {
            known_parts.push_back(counted(n, one, many));
        }
    };
    part(Weight::conclusion, "changes a conclusion", "change a conclusion");
    part(Weight::figure, "changes a figure that is quoted", "change a figure that is quoted");
    part(Weight::carried, "is a line on which a wrong conclusion rests",
         "are lines on which a wrong conclusion rests");
    std::vector<std::string> parts;
    if (known > 0) {
        parts.push_back(fmt::format("{} ({})", counted(known, "matters", "matter"),
                                    fmt::join(known_parts, ", ")));
    }
    if (slips > 0) {
        parts.push_back(counted(slips, "is a misprint", "are misprints"));
    }
    if (lines > 0) {
        parts.push_back(fmt::format("what rests on {} is not stated",
                                    lines == 1 ? "the other formula"
                                               : fmt::format("the other {} formulas", lines)));
    }
    return lines == errata.size() ? all : fmt::format("{} {}.", all, fmt::join(parts, "; "));
}

std::string place_words(const audit::Claim& claim, const audit::PrintedSource& source) {
    if (const std::string number = source.number_of(claim.id);
        !number.empty() && !of_sentence(claim)) {
        return "Eq. (" + number + ")";
    }
    const std::string section = section_words(claim, source);
    return section.empty() ? claim.id
                           : fmt::format("{}, line {}", section.substr(0, section.find(' ', 9)),
                                         claim.lines.first);
}

std::string section_words(const audit::Claim& claim, const audit::PrintedSource& source) {
    const std::string section = source.section_of(claim.lines.first);
    const bool appendix = !section.empty() && section[0] >= 'A' && section[0] <= 'Z';
    return section.empty() ? "" : (appendix ? "Appendix " : "Section ") + section;
}

namespace {

/// Replaces \ref and \cite of the source by their text, so that the file is complete.
std::string resolved(const std::string& tex, const audit::PrintedSource& source) {
    static const boost::regex command(R"(\\(ref|cite)\{([^}]*)\})");
    return boost::regex_replace(tex, command, [&](const boost::smatch& found) {
        const auto label = source.labels.find(found[2].str());
        return found[1] == "cite"             ? "[" + latex_text(found[2].str()) + "]"
               : label == source.labels.end() ? "?"
                                              : latex_text(label->second);
    });
}

/// Sets the displays of a sentence within its line. A display of several lines is cut off.
std::string displays_in_line(const std::string& sentence) {
    static const boost::regex display(R"(\\begin\{(equation\*?)\}([\s\S]*?)(\\end\{\1\}|\z))");
    const std::string out = boost::regex_replace(sentence, display, [](const boost::smatch& found) {
        std::string formula = found[2];
        if (formula.find('&') != std::string::npos || formula.find("\\\\") != std::string::npos) {
            return found.str();
        }
        boost::trim_if(formula, boost::is_any_of(" \n,.;"));
        return "$" + formula + "$";
    });
    const std::size_t cut = out.find("\\begin{");
    return cut == std::string::npos ? out : out.substr(0, cut) + "\\,\\dots";
}

/// Returns a sentence, or its beginning if it is long: cut between words, outside formulas, and
/// behind the last place of the figure that is corrected.
std::string quotation(const std::string& printed, const std::string& quoted) {
    constexpr std::size_t enough = 260;
    const std::string sentence = displays_in_line(printed);
    const std::string number = quoted.substr(0, quoted.find(' '));
    const std::size_t figure = number.empty() ? std::string::npos : sentence.rfind(number);
    const std::size_t wanted = figure == std::string::npos ? enough : std::max(enough, figure + 30);
    bool in_math = false;
    int depth = 0;
    for (std::size_t i = 0; i < sentence.size(); ++i) {
        if (sentence[i] == '\\') { // the next character is not a brace or dollar of TeX
            ++i;
            continue;
        }
        in_math = sentence[i] == '$' ? !in_math : in_math;
        depth += sentence[i] == '{' ? 1 : sentence[i] == '}' ? -1 : 0;
        if (i >= wanted && !in_math && depth == 0 && sentence[i] == ' ') {
            return sentence.substr(0, i) + "\\,\\dots";
        }
    }
    return sentence;
}

/// Macros of the source are expanded: a \providecommand would keep LaTeX's own macro of that name.
std::string item_tex(const Erratum& erratum, const audit::PrintedSource& source) {
    const audit::ClaimResult& first = *erratum.parts.front();
    const auto plain = [&](const std::string& tex) {
        return audit::without_macros(tex, source.macros);
    };
    std::string out = "\\item " + latex_text(place_words(first.claim, source)) + ": ";
    if (is_sentence(first.claim.printed)) {
        const std::string quoted = first.claim.text_or("quoted", "");
        const std::string quote = quotation(first.claim.printed, quoted);
        out += "``" + plain(resolved(quote, source)) + (quote.ends_with('.') ? "'' " : "''. ");
    }
    for (const audit::ClaimResult* part : erratum.parts) {
        if (const auto correction = correction_of(*part, source)) {
            out += plain((correction->what.empty() ? "" : "in " + correction->what + ", ") +
                         "for $" + correction->printed + "$ read $" + correction->corrected + "$");
            out += part == erratum.parts.back() ? ". " : "; ";
        } else {
            out += plain(correction_in_words(*part, source)) + ' ';
        }
    }
    return out + '\n';
}

} // namespace

std::string errata_tex(const audit::AuditResult& result, const audit::PrintedSource& source) {
    const std::vector<Erratum> errata = errata_of(result, source);
    std::string out = "% Errata of a paper, made by edgeproof verify. Compile with pdflatex.\n"
                      "\\documentclass[10pt,a4paper]{article}\n"
                      "\\usepackage{amsmath,amssymb}\n"
                      "\\usepackage[margin=17mm]{geometry}\n"
                      "\\pagestyle{empty}\n\\setlength{\\parindent}{0pt}\n"
                      "\\providecommand{\\fint}{-\\!\\!\\!\\!\\!\\!\\int}\n";
    out += "\\begin{document}\n\\textbf{Errata.} " + latex_text(result.source) + ".";
    if (!source.doi.empty()) {
        out += " doi:" + latex_text(source.doi) + '.';
    }
    if (!source.arxiv.empty()) {
        out += " arXiv:" + latex_text(source.arxiv) + '.';
    }
    out += "\n\n" + errata_count(errata) + "\n";
    if (!errata.empty()) {
        out += "\\begin{list}{\\textbullet}{\\setlength{\\leftmargin}{3mm}"
               "\\setlength{\\itemsep}{1.5pt}\\setlength{\\parsep}{0pt}\\setlength{\\topsep}{3pt}}"
               "\n\\raggedright\\footnotesize\n";
        for (const Erratum& erratum : errata) {
            out += item_tex(erratum, source);
        }
        out += "\\end{list}\n";
    }
    return out + "\n{\\footnotesize Found, and each correction proved or confirmed, by " +
           latex_text(program_line()) + ".}\n\\end{document}\n";
}

} // namespace edgeproof::report
