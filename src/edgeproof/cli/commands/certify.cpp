// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/certificate.hpp"
#include "edgeproof/cli/ledger_command.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/io/staged_folder.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/report/text/program_line.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::cli {
namespace {

struct CertifyOptions {
    std::string file;
    std::string out;
    std::string only = "*";
    int threads = 0;
    bool record = false;
};

// Statements of theorems depend on verdicts and corrections, for which 30 digits suffice.
constexpr unsigned digits_of_verdicts = 30;

/// Writes the folder of --out, whole or not at all, and prints the number of theorems.
void write_folder(const CertifyOptions& o, io::StagedFolder& staged,
                  const std::vector<certificate::Certificate>& all, std::string of,
                  std::string things) {
    const std::string only = o.only == "*" ? "" : fmt::format(" --only '{}'", o.only);
    staged.fill([&](const std::filesystem::path& folder) {
        write_certificates(all, folder,
                           {std::move(of), things,
                            fmt::format("edgeproof certify {} --out DIR{}",
                                        std::filesystem::path(o.file).filename().string(), only),
                            std::string(report::program_version)});
    });
    staged.commit();
    std::size_t theorems = 0;
    std::size_t with = 0;
    for (const certificate::Certificate& c : all) {
        theorems += c.theorems.size();
        with += c.theorems.empty() ? 0 : 1;
    }
    std::printf("%zu theorems about %zu of %zu %s; check them with: make -j2 -C %s\n", theorems,
                with, all.size(), things.c_str(), o.out.c_str());
}

/// Records which of the theorems in the folder of --out Coq has accepted. Returns 1 if there are
/// others.
int record_folder(const CertifyOptions& o, const std::vector<certificate::Certificate>& all) {
    const certificate::Recording recording = certificate::record_accepted(all, o.out);
    for (const auto& [file, reason] : recording.refused) {
        std::printf("%s is not accepted: %s\n", file.c_str(), reason.c_str());
    }
    std::printf("%zu theorems that Coq%s accepts are recorded in %s\n", recording.theorems,
                recording.coq.empty() ? "" : (" " + recording.coq).c_str(),
                (std::filesystem::path(o.out) / "accepted.csv").string().c_str());
    return recording.refused.empty() ? 0 : 1;
}

/// Throws InputError if --record is given and there is no folder to record.
void require_folder(const CertifyOptions& o) {
    if (o.record && !std::filesystem::is_directory(o.out)) {
        throw InputError(
            fmt::format("--record of {}, which is no folder", o.out),
            fmt::format("write it first: edgeproof certify {} --out {}, then make -C {}", o.file,
                        o.out, o.out));
    }
}

int certify_ledger(const CertifyOptions& o, const std::string& text) {
    const audit::Ledger ledger =
        audit::parse_ledger(text, io::input_name(o.file), audit::ClaimErrors::kept);
    if (ledger.claims.empty() && !ledger.errors.empty()) {
        return report_claim_errors(ledger.errors);
    }
    require_folder(o);
    std::optional<io::StagedFolder> staged; // fails before the work, not after it
    if (!o.record) {
        staged.emplace(o.out);
    }
    const audit::AuditResult result =
        judged_ledger(ledger, {.digits = digits_of_verdicts, .threads = o.threads, .only = o.only});
    std::vector<certificate::Certificate> all;
    all.reserve(result.claims.size());
    for (const audit::ClaimResult& claim : result.claims) {
        all.push_back(certificate::certify(claim, ledger));
    }
    int code = 0;
    if (staged) {
        write_folder(o, *staged, all, "the ledger " + ledger.name, "claims");
    } else {
        code = record_folder(o, all);
    }
    return result.errors.empty() ? code : report_claim_errors(result.errors);
}

/// Writes theorems about all values that a scene asks for, where they can be stated.
int certify_scene(const CertifyOptions& o, const std::string& text) {
    if (o.only != "*") {
        throw InputError("--only chooses claims of a ledger, and " + o.file + " is a scene",
                         "leave it out, and ask in [ask] for what you want");
    }
    scene::Scene scene = scene::parse_scene(text, io::input_name(o.file));
    require_plane(scene, "certify");
    ask_terms(scene);
    scene.ask.digits.rounding = Rounding::nearest;
    scene::Scene stated = scene;
    stated.ask.quantities = {scene::QuantityGroup::contact, scene::QuantityGroup::coefficients};
    if (!scene.ask.u.empty()) {
        stated.ask.quantities.insert(scene::QuantityGroup::pressure);
    }
    if (scene.ask.tolerance) {
        stated.ask.quantities.insert(scene::QuantityGroup::extent);
    }
    if (scene.ask.wants(scene::QuantityGroup::stress) && !scene.shear && !scene.round) {
        stated.ask.quantities.insert(scene::QuantityGroup::stress);
    }
    require_folder(o);
    if (o.record) {
        return record_folder(o, certificate::certify_scene(scene, done(stated)));
    }
    io::StagedFolder staged(o.out);
    const std::vector<certificate::Certificate> all =
        certificate::certify_scene(scene, done(stated));
    write_folder(o, staged, all, "the scene " + title_of(scene), "quantities");
    for (const certificate::Certificate& c : all) {
        if (c.theorems.empty()) {
            std::printf("%s: not stated: %s\n", c.id.c_str(), c.leaves_out.c_str());
        }
    }
    return 0;
}

int certify(CertifyOptions& o) {
    o.file = file_or_shipped(file_or_shipped(o.file, shipped_ledgers), shipped_scenes);
    const std::string text = io::read_text(o.file, "ledger or scene (TOML)", io::most_toml_bytes);
    const io::TomlSection top = io::TomlSection::parse(text, io::input_name(o.file));
    return scene::file_kind(top) == scene::FileKind::scene ? certify_scene(o, text)
                                                           : certify_ledger(o, text);
}

} // namespace

void add_certify(CLI::App& app, int& code) {
    auto [sub, o] = add_command<CertifyOptions>(
        app, code, "certify",
        "state the verdicts on a ledger, or the values of a scene, as theorems that Coq checks",
        certify);
    sub.add_option("file", o.file, "the ledger or the scene (TOML)")->required();
    sub.add_option("--out,--out-dir", o.out,
                   "folder for the Coq files, Makefile, index.csv, README.md")
        ->required();
    sub.add_option("--only", o.only, "claims whose id matches, such as 'EQ2*'");
    add_threads_option(sub, o.threads);
    sub.add_flag("--record", o.record,
                 "after make in the folder: write to accepted.csv which theorems Coq accepts");
}

} // namespace edgeproof::cli
