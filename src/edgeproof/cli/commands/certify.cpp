// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/run.hpp"
#include "edgeproof/certificate/certificate.hpp"
#include "edgeproof/certificate/certificate_folder.hpp"
#include "edgeproof/cli/claim_errors.hpp"
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/judged_ledger.hpp"
#include "edgeproof/cli/shipped_file.hpp"
#include "edgeproof/io/staged_folder.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

namespace edgeproof::cli {
namespace {

struct CertifyOptions {
    std::string ledger;
    std::string out;
    std::string only = "*";
    int threads = 0;
};

// What theorems state depends on verdicts and corrections, for which 30 digits suffice.
constexpr unsigned digits_of_verdicts = 30;

int certify(const CertifyOptions& o) {
    const audit::Ledger ledger = read_ledger(o.ledger, audit::ClaimErrors::kept);
    if (ledger.claims.empty() && !ledger.errors.empty()) {
        return report_claim_errors(ledger.errors);
    }
    io::StagedFolder staged(o.out);
    const audit::AuditResult result = judged_ledger(ledger, digits_of_verdicts, o.threads, o.only);
    std::vector<certificate::Certificate> all;
    all.reserve(result.claims.size());
    for (const audit::ClaimResult& claim : result.claims) {
        all.push_back(certificate::certify(claim, ledger));
    }
    try {
        const std::string only = o.only == "*" ? "" : fmt::format(" --only '{}'", o.only);
        write_certificates(all, staged.path(), ledger.name,
                           fmt::format("edgeproof certify {} --out DIR{}",
                                       std::filesystem::path(o.ledger).filename().string(), only),
                           std::string(report::program_version));
    } catch (const InputError& error) {
        throw staged.told(error);
    }
    staged.commit();
    std::size_t theorems = 0;
    std::size_t claims = 0;
    for (const certificate::Certificate& c : all) {
        theorems += c.theorems.size();
        claims += c.theorems.empty() ? 0 : 1;
    }
    std::printf("%zu theorems about %zu of %zu claims; check them with: make -j2 -C %s\n", theorems,
                claims, all.size(), o.out.c_str());
    return result.errors.empty() ? 0 : report_claim_errors(result.errors);
}

} // namespace

void add_certify(CLI::App& app, int& code) {
    CLI::App* sub =
        app.add_subcommand("certify", "state the verdicts on a ledger as theorems that Coq checks");
    auto o = std::make_shared<CertifyOptions>();
    sub->add_option("ledger", o->ledger, "the ledger (TOML)")->required();
    sub->add_option("--out", o->out,
                    "folder for a Coq file a claim, Makefile, index.csv, README.md")
        ->required();
    sub->add_option("--only", o->only, "claims whose id matches, such as 'EQ2*'");
    sub->add_option("--threads", o->threads, "threads (0: as many as the machine has)")
        ->check(CLI::Range(0, 1024));
    sub->callback([o, &code] {
        o->ledger = file_or_shipped(o->ledger, shipped_ledgers);
        code = certify(*o);
    });
}

} // namespace edgeproof::cli
