// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/certificate.hpp"
#include "edgeproof/audit/symbolic/symbolic.hpp"
#include "edgeproof/certificate/accepted.hpp"
#include "edgeproof/certificate/coq_files.hpp"
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/report/text/escape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

namespace edgeproof::certificate {
std::string in_comment(std::string text) {
    text = printable_lines(text);
    for (const auto& [from, to] :
         {std::pair<std::string, std::string>{"(*", "( *"}, {"*)", "* )"}, {"\"", "''"}}) {
        for (std::size_t at = text.find(from); at != std::string::npos;
             at = text.find(from, at + to.size())) {
            text.replace(at, from.size(), to);
        }
    }
    return text;
}

namespace {

/// The keywords of Coq's reference manual (chapter "Basic notions", 8.16; `exists`, `exists2`,
/// `IF`, `mod` and `using` of its notations and of earlier versions), words that begin a statement,
/// and the names of the library that theorems use.
constexpr auto words_of_coq = std::to_array<std::string_view>(
    {"_",         "Assumptions", "Axiom", "CoFixpoint", "Definition", "Fixpoint", "Hypothesis",
     "Parameter", "Prop",        "SProp", "Set",        "Theorem",    "Type",     "Variable",
     "as",        "at",          "cofix", "else",       "end",        "fix",      "for",
     "forall",    "fun",         "if",    "in",         "let",        "match",    "return",
     "then",      "where",       "with",  "IF",         "exists",     "exists2",  "mod",
     "using",     "by",          "is",    "of",         "Lemma",      "Proof",    "Qed",
     "Print",     "R",           "PI",    "sqrt",       "exp",        "ln",       "sin",
     "cos",       "tan",         "asin",  "acos",       "atan",       "Rabs",     "Rpower",
     "Rmax",      "Rmin",        "Rplus", "Rmult",      "Rdiv",       "Rinv",     "is_RInt",
     "RInt"});

/// Whether a Coq file defines or states something of that name.
bool defines(std::string_view file, std::string_view name) {
    constexpr auto starts = std::to_array<std::string_view>(
        {"Definition ", "Fixpoint ", "Inductive ", "Record ", "Lemma ", "Theorem ", "Ltac "});
    return std::any_of(starts.begin(), starts.end(), [&](std::string_view start) {
        const std::string sought = std::string(start) + std::string(name);
        for (std::size_t at = file.find(sought); at != std::string_view::npos;
             at = file.find(sought, at + 1)) {
            const std::size_t end = at + sought.size();
            if (end == file.size() ||
                std::string_view(" :\n({.").find(file[end]) != std::string_view::npos) {
                return true;
            }
        }
        return false;
    });
}

} // namespace

std::string coq_name(const std::string& id) {
    std::string name = io::FileStem(id).text();
    for (char& c : name) {
        const bool plain =
            (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        c = plain ? c : '_';
    }
    const bool letter = !name.empty() && (name.front() < '0' || name.front() > '9');
    const bool is_taken =
        std::find(words_of_coq.begin(), words_of_coq.end(), name) != words_of_coq.end() ||
        std::any_of(theory_files().begin(), theory_files().end(), [&](const TheoryFile& f) {
            return f.name == name || defines(f.content, name);
        });
    return letter && !is_taken ? name : "claim_" + name;
}

bool is_same_for_all(const formula::Expr& x, const formula::Expr& y, contact::Edge edge) {
    const formula::Expr a = formula::Expr::symbol("a");
    const formula::Expr b = formula::Expr::symbol("b");
    const formula::Expr at = formula::Expr::symbol("x");
    const formula::Expr u = edge == contact::Edge::right ? a - at : b + at;
    const auto free = [&](formula::Expr e) {
        for (const std::string& name : free_symbols(e)) {
            if (name.starts_with("right_") || name.starts_with("left_")) {
                e = substitute(e, name, formula::Expr::symbol("k_" + name));
            }
        }
        return substitute(e, "u", u);
    };
    try {
        return audit::proved_equal(free(x), free(y), {});
    } catch (const Error&) {
        return false; // a part has no symbolic meaning
    }
}

std::vector<std::string> profiles_of(const audit::Ledger& ledger, std::string_view family) {
    const audit::Family& f = ledger.family(family);
    if (f.union_of.empty()) {
        return {f.profile};
    }
    std::vector<std::string> all;
    for (const std::string& member : f.union_of) {
        for (std::string& profile : profiles_of(ledger, member)) {
            all.push_back(std::move(profile));
        }
    }
    return all;
}

std::string file_comment(const audit::Claim& claim, const audit::Ledger& ledger) {
    return fmt::format(
        "(* Claim {} of the ledger {}, lines {} to {} of its source.\n   Printed: {}\n"
        "   Says: {} *)\n",
        in_comment(claim.id), in_comment(ledger.name), claim.lines.first, claim.lines.second,
        in_comment(claim.printed), claim.has("says") ? in_comment(claim.text("says")) : "in words");
}

std::string convex_hypothesis(bool symmetric) {
    return symmetric ? "  rises_at g1 y /\\ y < a ->\n"
                     : "  rises_at g1 y /\\ y < a /\\ rises_at (mirrored g1) z /\\ z < b a ->\n";
}

std::string imports_text(const std::vector<std::string>& files) {
    std::string text = "From Coq Require Import Reals Lra.\nFrom Coquelicot Require Import "
                       "Coquelicot.\nFrom Interval Require Import Tactic.\nFrom Edgeproof Require "
                       "Import";
    for (const std::string& file : files) {
        text += " " + file;
    }
    return text + ".\nOpen Scope R_scope.\n\n";
}

bool is_symmetric(const std::vector<std::string>& profiles) {
    return std::all_of(profiles.begin(), profiles.end(), [](const std::string& profile) {
        return profile.find("tilted") == std::string::npos && profile != "piecewise";
    });
}

std::string file_head(const audit::Claim& claim, const audit::Ledger& ledger,
                      const Theory& theory) {
    return file_comment(claim, ledger) + imports_text(theory.imports);
}

Certificate certify(const audit::ClaimResult& result, const audit::Ledger& ledger) {
    Certificate certificate;
    certificate.id = result.claim.id;
    certificate.verdict = std::string(name_of(result.outcome.verdict));
    certificate.file = coq_name(result.claim.id) + ".v";
    static const std::map<std::string_view, decltype(&certify_identity)> kinds{
        {"identity", certify_identity},
        {"value", certify_value},
        {"extent", certify_extent},
        {"expansion", certify_expansion},
        {"monotone", certify_monotone},
        {"vanishing", certify_vanishing},
        {"uniformity", certify_uniformity},
        {"figure", certify_figure},
        {"superposition", certify_superposition},
        {"relation", certify_relation}};
    try {
        require_usual_meaning(result.claim, ledger);
        if (certify_listed(result, ledger, certificate)) {
            return certificate;
        }
        const auto kind = kinds.find(result.claim.kind);
        if (kind == kinds.end()) {
            throw NotStated(fmt::format("claims of kind {} are not stated", result.claim.kind));
        }
        kind->second(result, ledger, certificate);
    } catch (const NotStated& reason) {
        certificate.theorems.clear();
        certificate.text.clear();
        certificate.leaves_out = reason.what();
    }
    return certificate;
}

namespace {

std::string index_csv(const std::vector<Certificate>& certificates) {
    std::string text = "claim,verdict,file,theorem,states,leaves_out\n";
    for (const Certificate& c : certificates) {
        const auto row = [&](const std::string& file, const std::string& theorem,
                             const std::string& states) {
            text += fmt::format("{},{},{},{},{},{}\n", report::csv_text_cell(c.id), c.verdict, file,
                                theorem, report::csv_text_cell(states),
                                report::csv_text_cell(c.leaves_out));
        };
        for (const Certificate::Theorem& theorem : c.theorems) {
            row(c.file, theorem.name, theorem.states);
        }
        if (c.theorems.empty()) {
            row("", "", "");
        }
    }
    return text;
}

/// Returns the file that prints the axioms of all theorems at once, because to print those of one
/// theorem takes longer than most proofs.
std::string assumptions(const std::vector<Certificate>& certificates) {
    std::string files;
    std::string theorems;
    for (const Certificate& c : certificates) {
        if (c.theorems.empty()) {
            continue;
        }
        const std::string file = std::filesystem::path(c.file).stem().string();
        files += fmt::format("From Edgeproof Require {}.\n", file);
        for (const Certificate::Theorem& theorem : c.theorems) {
            theorems += fmt::format("  let _ := {}.{} in\n", file, theorem.name);
        }
    }
    return fmt::format("(* Prints the axioms on which the theorems rest. *)\n{}\nDefinition "
                       "all_theorems : True :=\n{}  I.\nPrint Assumptions all_theorems.\n",
                       files, theorems);
}

std::string makefile(const std::vector<Certificate>& certificates) {
    std::string theory;
    std::string needs;
    for (const TheoryFile& file : theory_files()) {
        theory += fmt::format(" {}.vo", file.name);
        if (!file.needs.empty()) {
            needs += fmt::format("{}.vo: {}\n", file.name, file.needs);
        }
    }
    std::string claims;
    for (const Certificate& c : certificates) {
        if (!c.theorems.empty()) {
            claims += fmt::format(" \\\n    {}o", c.file);
        }
    }
    return fmt::format(
        "# Checks every certificate: make -j2. Needs Coq and Coq-Interval\n"
        "# (Debian: coq, libcoq-interval).\n"
        "COQC ?= coqc\nCOQFLAGS = -q -R . Edgeproof -w -ambiguous-paths\n"
        "SHELL = bash\nTHEORY ={}\nCLAIMS ={}\n\nall: Assumptions.vo\n\n"
        "# Prints the processor time of each, in seconds.\n"
        "# NAME.accepted states which files coqc has compiled; certify --record "
        "reads it.\n"
        "%.vo: %.v\n"
        "\t@rm -f $@ $*.accepted; inputs=$$(sha256sum $< $(filter %.vo,$^)) && \\\n"
        "\t{{ TIMEFORMAT='$<: %U s'; time $(COQC) $(COQFLAGS) $<; }} && \\\n"
        "\t[ \"$$inputs\" = \"$$(sha256sum $< $(filter %.vo,$^))\" ] && \\\n"
        "\toutput=$$(sha256sum $@) && version=$$($(COQC) --print-version) && \\\n"
        "\tprintf 'Coq %s\\n%s\\n%s\\n' \"$${{version%% *}}\" \"$$inputs\" \"$$output\" \\\n"
        "\t    > $*.accepted\n\n"
        "{}$(CLAIMS): $(THEORY)\nAssumptions.vo: $(CLAIMS)\n\n"
        "clean:\n"
        "\trm -f *.vo *.vok *.vos *.glob *.accepted .*.aux .lia.cache .nia.cache\n\n"
        ".PHONY: all clean\n",
        theory, claims, needs);
}

std::string readme(const std::vector<Certificate>& certificates, const FolderTitle& title) {
    const auto with = std::count_if(certificates.begin(), certificates.end(),
                                    [](const Certificate& c) { return !c.theorems.empty(); });
    return fmt::format(R"(# Certificates of {0}

Theorems about {1} of {2} {5}, for Coq to check. Made by edgeproof {3}:

    {4}

Check them with Coq and Coq-Interval (Debian: `coq`, `libcoq-interval`), and record which theorems
Coq has accepted in `accepted.csv`:

    make -j2
    {4} --record

`index.csv` says what each theorem states and what it leaves out, and of the other {5} why they
have none.

## What is trusted

- Coq's kernel, and the axioms that `Assumptions.v` prints for all theorems: those of Coq's real
  numbers, classical logic and functional extensionality. Coq-Interval adds the primitive integers
  and floating-point numbers of Coq, where it was built to use them.
- The reading of the definitions, which are the mechanics, not a way to compute them: `Contact.v`
  says what the load of a contact, the condition of consistency and the pressure (Barber and
  Mossakovskii's integral) are; `Edges.v` what the coefficients at an edge are; `slope` in a profile's
  file is its g'(x).
- The reading of what is certified: a printed formula's text in the theorem next to the TeX, both in the
  claim's file; the numbers of a scene.

Not trusted: the program that wrote the files. A theorem that is false, for any error in the
program, is not accepted.

A theorem says that there is one pressure or coefficient as defined, and no other (`is_the_...` in
`Unique.v`), and that it differs from the one that is printed, or agrees with it. Where `index.csv` says
so, this is stated for one contact, and not for all. Theorems about the pressures or coefficients of all
contacts take the punch to be convex.
)",
                       title.of, with, certificates.size(), title.version, title.command,
                       title.things);
}

} // namespace

void write_certificates(const std::vector<Certificate>& certificates,
                        const std::filesystem::path& folder, const FolderTitle& title) {
    std::map<std::string, std::string> ids; // the id for each file name
    for (const Certificate& c : certificates) {
        const auto [known, is_new] = ids.emplace(c.file, c.id);
        if (!is_new) {
            throw InputError(fmt::format("the claims '{}' and '{}' have the same name in Coq",
                                         known->second, c.id),
                             "rename one, or choose by --only");
        }
    }
    for (const TheoryFile& file : theory_files()) {
        io::write_whole(folder / fmt::format("{}.v", file.name), std::string(file.content));
    }
    for (const Certificate& c : certificates) {
        if (!c.theorems.empty()) {
            io::write_whole(folder / c.file, c.text);
        }
    }
    io::write_whole(folder / "Assumptions.v", assumptions(certificates));
    io::write_whole(folder / "index.csv", index_csv(certificates));
    io::write_whole(folder / "Makefile", makefile(certificates));
    io::write_whole(folder / "README.md", readme(certificates, title));
}

void attach_certificates(audit::AuditResult& result, const audit::Ledger& ledger,
                         const std::filesystem::path& folder, const std::string& shown) {
    const auto holds = [&](const std::string& name, std::string_view text) {
        std::error_code none;
        return std::filesystem::is_regular_file(folder / name, none) &&
               io::read_text(folder / name, "certificate") == text;
    };
    for (const TheoryFile& file : theory_files()) {
        if (!holds(fmt::format("{}.v", file.name), file.content)) {
            return;
        }
    }
    const AcceptedTheorems accepted = AcceptedTheorems::read(folder);
    for (audit::ClaimResult& claim : result.claims) {
        const Certificate today = certify(claim, ledger);
        if (!today.theorems.empty() && holds(today.file, today.text)) {
            claim.certificate = {(std::filesystem::path(shown) / today.file).generic_string(),
                                 today.whole_verdict, accepted.contain(today),
                                 (folder / today.file).string()};
        }
    }
}

const std::vector<TheoryFile>& theory_files() {
    static const std::vector<TheoryFile> all{
        {"Contact", coq_files::Contact_v, ""},
        {"Coefficients", coq_files::Coefficients_v, "Contact.vo"},
        {"Edges", coq_files::Edges_v, "Coefficients.vo"},
        {"ClosedForm", coq_files::ClosedForm_v, "Contact.vo"},
        {"Symmetric", coq_files::Symmetric_v, "Edges.vo ClosedForm.vo"},
        {"TiltedWedge", coq_files::TiltedWedge_v, "Edges.vo ClosedForm.vo"},
        {"FlatAndRounded", coq_files::FlatAndRounded_v, "Contact.vo"},
        {"Shear", coq_files::Shear_v, "Contact.vo"},
        {"Unique", coq_files::Unique_v, "Symmetric.vo TiltedWedge.vo Shear.vo"},
        {"Scaling", coq_files::Scaling_v, "Unique.vo"},
        {"Tactics", coq_files::Tactics_v, "Unique.vo"},
        {"Expansions", coq_files::Expansions_v, "Tactics.vo"},
        {"HalfPowers", coq_files::HalfPowers_v, "Expansions.vo"},
        {"PressureExpansions", coq_files::PressureExpansions_v, "HalfPowers.vo"},
        {"Uniform", coq_files::Uniform_v, "Expansions.vo"},
        {"Curved", coq_files::Curved_v, "Unique.vo"},
        {"Sides", coq_files::Sides_v, "Tactics.vo"},
        {"Limits", coq_files::Limits_v, "Tactics.vo"},
        {"Stick", coq_files::Stick_v, "Unique.vo"},
        {"Orders", coq_files::Orders_v, "PressureExpansions.vo Sides.vo"},
        {"Gamma", coq_files::Gamma_v, "Coefficients.vo"},
        {"PowerLaw", coq_files::PowerLaw_v, "Tactics.vo Gamma.vo"},
        {"ShearTerms", coq_files::ShearTerms_v, "Shear.vo Coefficients.vo"},
        {"TiltedRounded", coq_files::TiltedRounded_v, ""},
        {"Inversion", coq_files::Inversion_v, "Stick.vo"},
        {"Flatness", coq_files::Flatness_v, "PowerLaw.vo"},
        {"PowerSides", coq_files::PowerSides_v, "Sides.vo PowerLaw.vo"},
        {"PowerError", coq_files::PowerError_v, "Orders.vo PowerLaw.vo"},
        {"Similar", coq_files::Similar_v, "Stick.vo PowerLaw.vo"},
        {"Resultant", coq_files::Resultant_v, "Coefficients.vo"},
        {"Places", coq_files::Places_v, "Coefficients.vo"},
        {"LoadOfPressure", coq_files::LoadOfPressure_v,
         "Resultant.vo Places.vo Limits.vo PowerLaw.vo"},
        {"Forward", coq_files::Forward_v, "Sides.vo Inversion.vo LoadOfPressure.vo"},
        {"RoundedSides", coq_files::RoundedSides_v, "Limits.vo"},
        {"Dilogarithm", coq_files::Dilogarithm_v, "Resultant.vo"},
        {"LogPressure", coq_files::LogPressure_v, "Stick.vo Dilogarithm.vo"},
        {"ForwardPunches", coq_files::ForwardPunches_v, "Similar.vo Forward.vo LogPressure.vo"},
        {"RoundedShape", coq_files::RoundedShape_v, "ForwardPunches.vo"},
        {"Consistency", coq_files::Consistency_v, "TiltedRounded.vo LogPressure.vo Places.vo"},
        {"Readings", coq_files::Readings_v, "Forward.vo Orders.vo"}};
    return all;
}

} // namespace edgeproof::certificate
