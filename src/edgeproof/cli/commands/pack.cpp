// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/pack/pack.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/io/staged_folder.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <ctime>

namespace edgeproof::cli {
namespace {

struct PackCommandOptions {
    std::string folder;
    std::string commit{report::program_commit};
    std::string date;
    std::string threads;
    bool check = false;
};

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    return fmt::format("{:04}-{:02}-{:02}", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday);
}

/// Checks a text for the head of the manifest.
void check_word(const std::string& option, const std::string& text) {
    if (text.find_first_of("\r\n") != std::string::npos) {
        throw InputError(option + " holds a line break", "give one line");
    }
}

/// Returns the manifest without the lines that depend on the day and the commit.
std::string checksums_of(const std::string& manifest) {
    std::string out;
    for (std::size_t at = 0; at < manifest.size();) {
        const std::size_t end = std::min(manifest.find('\n', at), manifest.size());
        if (manifest[at] != '#') {
            out += manifest.substr(at, end - at) + "\n";
        }
        at = end + 1;
    }
    return out;
}

int check_pack(const std::filesystem::path& folder, const std::vector<pack::PackFile>& files) {
    std::size_t different = 0;
    const auto hold = [&](const std::string& name, const std::string& there,
                          const std::string& made) {
        if (there == made) {
            return;
        }
        ++different;
        std::size_t line = 1;
        for (std::size_t i = 0; i < there.size() && i < made.size() && there[i] == made[i]; ++i) {
            line += there[i] == '\n' ? 1 : 0;
        }
        std::fprintf(stderr, "%s:%zu: differs from the pack made anew\n", (folder / name).c_str(),
                     line);
    };
    for (const pack::PackFile& file : files) {
        hold(file.name, io::read_text(folder / file.name, "file of a pack"), file.text);
    }
    hold(pack::manifest_name,
         checksums_of(io::read_text(folder / pack::manifest_name, "manifest of a pack")),
         checksums_of(manifest(files, {})));
    if (different == 0) {
        std::printf("%s: %zu files made anew, every byte the same\n", folder.c_str(), files.size());
    }
    return different == 0 ? 0 : 1;
}

int make(const PackCommandOptions& o) {
    check_word("--commit", o.commit);
    check_word("--date", o.date);
    pack::PackOptions options;
    options.threads = threads_of(o.threads);
    if (!o.check) {
        io::check_folder(o.folder); // the folder is made when there is something to write
    } else if (!std::filesystem::is_directory(o.folder)) {
        throw InputError(o.folder + " is no folder",
                         "give the folder of a pack, or leave out --check");
    }
    const auto files =
        with_progress("answers", options.progress, [&] { return pack::make_pack(options); });
    if (o.check) {
        return check_pack(o.folder, files);
    }
    io::write_folder(o.folder, [&](const std::filesystem::path& folder) {
        for (const pack::PackFile& file : files) {
            io::write_whole(folder / file.name, file.text);
        }
        io::write_whole(
            folder / pack::manifest_name,
            manifest(files, {fmt::format("edgeproof {}", report::program_version), o.commit,
                             o.date.empty() ? today() : o.date, "edgeproof pack " + o.folder}));
    });
    std::printf("%s: %zu files\n", o.folder.c_str(), files.size() + 1);
    return 0;
}

} // namespace

void add_pack(CLI::App& app, int& code) {
    auto [sub, o] = add_command<PackCommandOptions>(
        app, code, "pack",
        "a frozen set of questions and answers with drivers, for a code's own tests", make);
    sub.add_option("folder", o.folder, "the folder")->required();
    sub.add_flag("--check", o.check,
                 "make it anew and compare it with the folder; exit 1 where a byte differs");
    sub.add_option("--commit", o.commit, "of the source, for the manifest")->capture_default_str();
    sub.add_option("--date", o.date, "for the manifest (default: today)");
    add_threads_option(sub, o.threads);
}

} // namespace edgeproof::cli
