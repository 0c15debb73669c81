// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/page/correction.hpp"
#include "edgeproof/report/page/errata.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"
#include "edgeproof/report/text/tex_math.hpp"

namespace edgeproof::report {
namespace {

/// \ref and \cite of the source come out as what they stand for: the file is complete in itself.
std::string resolved(std::string tex, const audit::PrintedSource& source) {
    for (const std::string_view command : {"\\ref{", "\\cite{"}) {
        for (std::size_t at = 0; (at = tex.find(command, at)) != std::string::npos;) {
            const std::size_t close = tex.find('}', at);
            if (close == std::string::npos) {
                break;
            }
            const std::string name = tex.substr(at + command.size(), close - at - command.size());
            const auto label = source.labels.find(name);
            const std::string text = command == "\\cite{"           ? "[" + name + "]"
                                     : label == source.labels.end() ? "?"
                                                                    : label->second;
            tex.replace(at, close - at + 1, text);
            at += text.size();
        }
    }
    return tex;
}

/// As much of a sentence as tells which it is, cut between words and outside formulas.
std::string beginning_of(const std::string& sentence) {
    constexpr std::size_t enough = 110;
    bool in_math = false;
    for (std::size_t i = 0; i < sentence.size(); ++i) {
        if (sentence.compare(i, 16, "\\begin{equation}") == 0) {
            return sentence.substr(0, i) + "\\,\\dots";
        }
        in_math = sentence[i] == '$' ? !in_math : in_math;
        if (i >= enough && !in_math && sentence[i] == ' ') {
            return sentence.substr(0, i) + "\\,\\dots";
        }
    }
    return sentence;
}

std::string item_tex(const Erratum& erratum, const audit::PrintedSource& source) {
    const audit::ClaimResult& first = *erratum.parts.front();
    std::string out = "\\item " + place_words(first.claim, source) + ": ";
    if (is_sentence(first.claim.printed)) {
        out += "``" + resolved(beginning_of(first.claim.printed), source) + "''. ";
    }
    for (const audit::ClaimResult* part : erratum.parts) {
        if (const auto correction = correction_of(*part, source)) {
            out += (correction->what.empty() ? "" : "in " + correction->what + ", ") + "for $" +
                   correction->printed + "$ read $" + correction->corrected + "$";
            out += part == erratum.parts.back() ? ". " : "; ";
        } else {
            out += correction_in_words(*part, source) + ' ';
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
    for (const auto& [name, body] : source.macros) {
        out += "\\providecommand{\\" + name + "}{" + body + "}\n";
    }
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
