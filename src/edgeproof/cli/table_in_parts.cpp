// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/table_in_parts.hpp"

#include "edgeproof/cli/cli.hpp"
#include "edgeproof/conformance/part_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/files.hpp"

#include <fmt/format.h>

#include <sys/stat.h>

#include <utility>

namespace edgeproof::cli {
namespace {

/// This very program: another may compute otherwise under the same version.
std::string program_mark(const std::string& version) {
    struct stat self {};
    if (::stat("/proc/self/exe", &self) != 0) {
        return version;
    }
    return fmt::format("{} {} {}.{}", version, self.st_size, self.st_mtim.tv_sec,
                       self.st_mtim.tv_nsec);
}

void write(const Table& head, const PartFile& part, TableFormat format,
           const std::filesystem::path& file) {
    if (format == TableFormat::csv) {
        WholeFile whole(file);
        whole.write(write_table(head, format));
        for (std::size_t i = 0; i < part.entries(); ++i) {
            whole.write(part.text(i));
        }
        whole.commit();
        return;
    }
    Table table = head;
    for (std::size_t i = 0; i < part.entries(); ++i) {
        table.rows.push_back(parse_csv(part.text(i), file.string()).header.cells);
    }
    write_whole(file, write_table(table, format));
}

} // namespace

TableInParts::TableInParts(const Recipe& recipe, std::filesystem::path file, TableFormat format,
                           std::string version)
    : recipe_(recipe), file_(std::move(file)), format_(format), version_(std::move(version)) {}

void TableInParts::make(unsigned threads) {
    const ReferenceRows rows(recipe_);
    const std::vector<Piece> pieces = pieces_of(recipe_.questions);
    const std::size_t total = recipe_.questions.list.size();
    PartFile part(file_.string() + ".part", rows.fingerprint(program_mark(version_)), total,
                  pieces.size());
    std::vector<std::size_t> open;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        if (!part.has(p)) {
            open.push_back(p);
        }
    }
    const std::size_t before = part.entries();
    bool cannot_keep = false;
    const auto keep = [&](std::size_t p, const std::vector<Reference>& values) {
        std::vector<PartFile::Entry> entries;
        for (std::size_t k = 0; k < values.size(); ++k) {
            const std::size_t i = pieces[p][k];
            entries.push_back({i, !values[k].value.proved, csv_line(rows.row(i, values[k]))});
        }
        cannot_keep = true;
        part.add(p, entries);
        cannot_keep = false;
    };
    try {
        Progress progress("rows");
        ReferenceOptions options;
        options.digits = recipe_.digits;
        options.threads = threads;
        options.stop = &interrupted();
        options.progress = [&](std::size_t done, std::size_t) { progress(before + done, total); };
        answer_pieces(recipe_.questions, pieces, open, options, keep);
    } catch (const Stopped&) {
        throw Error(fmt::format("interrupted: {} of {} rows are kept in {}; the same command goes "
                                "on from there",
                                part.entries(), total, part.path().string()));
    } catch (const Error&) {
        if (!cannot_keep) {
            part.remove(); // the recipe must be mended, and is another one then
        }
        throw;
    }
    const Table head =
        rows.table(version_, total, part.marked(), [&](std::size_t i) { return part.text(i); });
    write(head, part, format_, file_);
    part.remove();
}

} // namespace edgeproof::cli
