// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/certificate.hpp"
#include "edgeproof/audit/symbolic/symbolic.hpp"
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/report/text/escape.hpp"

#include <boost/algorithm/string/replace.hpp>
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
         {std::pair{"(*", "( *"}, std::pair{"*)", "* )"}, std::pair{"\"", "''"}}) {
        boost::replace_all(text, from, to);
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
    return std::ranges::any_of(starts, [&](std::string_view start) {
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
    const bool is_taken = std::ranges::find(words_of_coq, name) != words_of_coq.end() ||
                          std::ranges::any_of(theory_files(), [&](const TheoryFile& f) {
                              return f.name == name || defines(f.content, name);
                          });
    return letter && !is_taken ? name : "claim_" + name;
}

bool is_same_for_all(const Expr& x, const Expr& y, Edge edge) {
    const Expr a = Expr::symbol("a");
    const Expr b = Expr::symbol("b");
    const Expr at = Expr::symbol("x");
    const Expr u = edge == Edge::right ? a - at : b + at;
    const auto free = [&](Expr e) {
        for (const std::string& name : free_symbols(e)) {
            if (name.starts_with("right_") || name.starts_with("left_")) {
                e = substitute(e, name, Expr::symbol("k_" + name));
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

std::vector<std::string> profiles_of(const Ledger& ledger, std::string_view family) {
    const Family& f = ledger.family(family);
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

std::string file_comment(const Claim& claim, const Ledger& ledger) {
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
    return std::ranges::all_of(profiles, [](const std::string& profile) {
        return profile.find("tilted") == std::string::npos && profile != "piecewise";
    });
}

std::string file_head(const Claim& claim, const Ledger& ledger, const Theory& theory) {
    return file_comment(claim, ledger) + imports_text(theory.imports);
}

Certificate certify(const ClaimResult& result, const Ledger& ledger) {
    Certificate certificate;
    certificate.id = result.claim.id;
    certificate.verdict = std::string(name_of(result.outcome.verdict));
    certificate.file = coq_name(result.claim.id) + ".v";
    static const std::map<std::string_view, Certify*> kinds{
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
    const auto with = std::ranges::count_if(
        certificates, [](const Certificate& c) { return !c.theorems.empty(); });
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

void attach_certificates(audit::AuditResult& result, const Ledger& ledger,
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
    for (ClaimResult& claim : result.claims) {
        const Certificate today = certify(claim, ledger);
        if (!today.theorems.empty() && holds(today.file, today.text)) {
            claim.certificate = {(std::filesystem::path(shown) / today.file).generic_string(),
                                 today.whole_verdict, accepted.contain(today),
                                 (folder / today.file).string()};
        }
    }
}

std::string_view theory_text(std::string_view name) {
    return std::ranges::find(coq_files::embedded, fmt::format("{}.v", name),
                             [](const auto& file) { return file.first; })
        ->second;
}

const std::vector<TheoryFile>& theory_files() {
    static const std::vector<TheoryFile> all = [] {
        std::vector<TheoryFile> files;
        for (const auto& [name, needs] : std::initializer_list<std::array<std::string_view, 2>>{
                 {"Contact", ""},
                 {"Coefficients", "Contact.vo"},
                 {"Edges", "Coefficients.vo"},
                 {"ClosedForm", "Contact.vo"},
                 {"Symmetric", "Edges.vo ClosedForm.vo"},
                 {"TiltedWedge", "Edges.vo ClosedForm.vo"},
                 {"FlatAndRounded", "Contact.vo"},
                 {"Shear", "Contact.vo"},
                 {"Unique", "Symmetric.vo TiltedWedge.vo Shear.vo"},
                 {"Scaling", "Unique.vo"},
                 {"Tactics", "Unique.vo"},
                 {"Expansions", "Tactics.vo"},
                 {"HalfPowers", "Expansions.vo"},
                 {"PressureExpansions", "HalfPowers.vo"},
                 {"Uniform", "Expansions.vo"},
                 {"Curved", "Unique.vo"},
                 {"Sides", "Tactics.vo"},
                 {"Limits", "Tactics.vo"},
                 {"Stick", "Unique.vo"},
                 {"Orders", "PressureExpansions.vo Sides.vo"},
                 {"Gamma", "Coefficients.vo"},
                 {"PowerLaw", "Tactics.vo Gamma.vo"},
                 {"ShearTerms", "Shear.vo Coefficients.vo"},
                 {"TiltedRounded", ""},
                 {"Inversion", "Stick.vo"},
                 {"Flatness", "PowerLaw.vo"},
                 {"PowerSides", "Sides.vo PowerLaw.vo"},
                 {"PowerError", "Orders.vo PowerLaw.vo"},
                 {"Similar", "Stick.vo PowerLaw.vo"},
                 {"Resultant", "Coefficients.vo"},
                 {"Places", "Coefficients.vo"},
                 {"LoadOfPressure", "Resultant.vo Places.vo Limits.vo PowerLaw.vo"},
                 {"Forward", "Sides.vo Inversion.vo LoadOfPressure.vo"},
                 {"RoundedSides", "Limits.vo"},
                 {"Dilogarithm", "Resultant.vo"},
                 {"LogPressure", "Stick.vo Dilogarithm.vo"},
                 {"ForwardPunches", "Similar.vo Forward.vo LogPressure.vo"},
                 {"RoundedShape", "ForwardPunches.vo"},
                 {"Consistency", "TiltedRounded.vo LogPressure.vo Places.vo"},
                 {"Readings", "Forward.vo Orders.vo"}}) {
            files.push_back({name, theory_text(name), needs});
        }
        return files;
    }();
    return all;
}

} // namespace edgeproof::certificate
