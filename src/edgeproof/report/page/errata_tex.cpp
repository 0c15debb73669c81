// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/page/correction.hpp"
#include "edgeproof/report/page/errata.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"
#include "edgeproof/report/text/tex_math.hpp"

namespace edgeproof::report {
namespace {

/// Replaces \ref and \cite of the source by their text, so that the file is complete.
std::string resolved(std::string tex, const audit::PrintedSource& source) {
    for (const std::string_view command : {"\\ref{", "\\cite{"}) {
        for (std::size_t at = 0; (at = tex.find(command, at)) != std::string::npos;) {
            const std::size_t close = tex.find('}', at);
            if (close == std::string::npos) {
                break;
            }
            const std::string name = tex.substr(at + command.size(), close - at - command.size());
            const auto label = source.labels.find(name);
            const std::string text = command == "\\cite{"           ? "[" + latex_text(name) + "]"
                                     : label == source.labels.end() ? "?"
                                                                    : latex_text(label->second);
            tex.replace(at, close - at + 1, text);
            at += text.size();
        }
    }
    return tex;
}

/// Returns the beginning of a sentence, cut between words and outside formulas.
std::string beginning_of(const std::string& sentence) {
    constexpr std::size_t enough = 110;
    bool in_math = false;
    int depth = 0;
    for (std::size_t i = 0; i < sentence.size(); ++i) {
        if (sentence.compare(i, 7, "\\begin{") == 0) {
            return sentence.substr(0, i) + "\\,\\dots";
        }
        if (sentence[i] == '\\') { // the next character is not a brace or dollar of TeX
            ++i;
            continue;
        }
        in_math = sentence[i] == '$' ? !in_math : in_math;
        depth += sentence[i] == '{' ? 1 : sentence[i] == '}' ? -1 : 0;
        if (i >= enough && !in_math && depth == 0 && sentence[i] == ' ') {
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
        out += "``" + plain(resolved(beginning_of(first.claim.printed), source)) + "''. ";
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
