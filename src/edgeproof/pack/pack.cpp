// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/pack/pack.hpp"

#include "edgeproof/io/sha256.hpp"

#include <fmt/format.h>

namespace edgeproof::pack {
namespace {

std::string head_of(const std::string& what) {
    return fmt::format("# Edgeproof conformance pack {}: {}\n", pack_version, what) +
           "# The columns are explained in README.md. Numbers of the contact, and u, are exact "
           "binary64.\n";
}

} // namespace

std::vector<PackFile> make_pack(const PackOptions& options) {
    using namespace pack_template;
    std::vector<PackFile> files;
    const auto add_rows = [&](const char* name, const std::string& what, const PackRows& rows) {
        files.push_back({name, head_of(what) + fmt::format("# rows: {}\n", rows.rows) +
                                   pack_columns() + rows.text});
    };
    add_rows("level-a.csv", "level A, engineering",
             recipe_rows(level_a_toml, "level-a.toml", true, options));
    add_rows("cases.csv", "levels B, C and D", recipe_rows(pack_toml, "pack.toml", false, options));
    add_rows("hard-cases.csv", "levels B, C and D, hard cases, with the reason of each",
             hard_case_rows(hard_cases_toml, "hard-cases.toml", options));
    const auto add = [&](const char* name, std::string_view text) {
        files.push_back({name, std::string(text)});
    };
    add("README.md", README_md);
    add("edgeproof_case.h", edgeproof_case_h);
    add("edgeproof_case.hpp", edgeproof_case_hpp);
    add("edgeproof_case.f90", edgeproof_case_f90);
    add("driver.c", driver_c);
    add("example.c", example_c);
    add("driver.cpp", driver_cpp);
    add("example.cpp", example_cpp);
    add("driver.f90", driver_f90);
    add("example.f90", example_f90);
    add("driver.py", driver_py);
    add("example.py", example_py);
    add("run_pack.m", run_pack_m);
    add("edgeproof_answer.m", edgeproof_answer_m);
    return files;
}

std::string manifest(const std::vector<PackFile>& files, const Origin& origin) {
    std::string text = fmt::format("# pack: {}\n# program: {}\n# commit: {}\n# date: {}\n"
                                   "# command: {}\n# check: sha256sum -c {}\n",
                                   pack_version, origin.program, origin.commit, origin.date,
                                   origin.command, manifest_name);
    for (const PackFile& file : files) {
        text += io::sha256(file.text) + "  " + file.name + "\n";
    }
    return text;
}

} // namespace edgeproof::pack
