// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/certificate_folder.hpp"

#include "edgeproof/certificate/coq_files.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/text/escape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

namespace edgeproof::certificate {
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
    return fmt::format("# Checks every certificate: make -j2. Needs Coq and Coq-Interval\n"
                       "# (Debian: coq, libcoq-interval).\n"
                       "COQC ?= coqc\nCOQFLAGS = -q -R . Edgeproof -w -ambiguous-paths\n"
                       "SHELL = bash\nTHEORY ={}\nCLAIMS ={}\n\nall: $(CLAIMS)\n\n"
                       "# With the processor time of each, in seconds.\n"
                       "%.vo: %.v\n\t@TIMEFORMAT='$<: %U s'; time $(COQC) $(COQFLAGS) $<\n\n"
                       "{}$(CLAIMS): $(THEORY)\n\n"
                       "clean:\n\trm -f *.vo *.vok *.vos *.glob .*.aux .lia.cache .nia.cache\n\n"
                       ".PHONY: all clean\n",
                       theory, claims, needs);
}

std::string readme(const std::vector<Certificate>& certificates, const FolderTitle& title) {
    const auto with = std::count_if(certificates.begin(), certificates.end(),
                                    [](const Certificate& c) { return !c.theorems.empty(); });
    return fmt::format(R"(# Certificates of {0}

Theorems about {1} of {2} {5}, for Coq to check. Made by edgeproof {3}:

    {4}

Check them with Coq and Coq-Interval (Debian: `coq`, `libcoq-interval`):

    make -j2

`index.csv` says what each theorem states and what it leaves out, and of the other {5} why they
have none.

## What is trusted

- Coq's kernel, and the axioms that `Print Assumptions` names under each theorem: those of Coq's real
  numbers, classical logic and functional extensionality. Coq-Interval adds the primitive integers
  and floating-point numbers of Coq, where it was built to use them.
- The reading of the definitions, which are the mechanics, not a way to compute them: `Contact.v`
  says what the load of a contact, the condition of consistency and the pressure (Barber and
  Mossakovskii's integral) are; `Edges.v` what the coefficients at an edge are; `slope` in a profile's
  file is its g'(x).
- The reading of what is certified: a printed formula's text in the theorem beside the TeX, both in the
  claim's file; the numbers of a scene.

Not trusted: the program that wrote the files. A theorem that is false, whatever is wrong in the
program, is not accepted.

A theorem says that a pressure or coefficient exists which is as defined, and which differs from the
one that is printed, or agrees with it. That there is no other (uniqueness) is not stated.
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
    for (audit::ClaimResult& claim : result.claims) {
        const Certificate today = certify(claim, ledger);
        if (!today.theorems.empty() && holds(today.file, today.text)) {
            claim.certificate = {(std::filesystem::path(shown) / today.file).generic_string(),
                                 today.whole_verdict, (folder / today.file).string()};
        }
    }
}

} // namespace edgeproof::certificate
