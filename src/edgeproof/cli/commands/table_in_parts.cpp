// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/commands/table_in_parts.hpp"

#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/conformance/questions/reference.hpp"
#include "edgeproof/io/atomic_file.hpp"
#include "edgeproof/io/process_cleanup.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/parallel/distributed_work.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/report/tables/reference_table.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <fmt/format.h>

#include <sys/stat.h>

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace edgeproof::cli {
namespace {

/// Identifies this executable: another one of the same version may compute different values.
std::string program_mark() {
    struct stat self {};
    if (::stat("/proc/self/exe", &self) != 0) {
        return report::program_line();
    }
    return fmt::format("{} {} {}.{}", report::program_line(), self.st_size, self.st_mtim.tv_sec,
                       self.st_mtim.tv_nsec);
}

/// Makes the rows of a piece in the format of the part file: consecutive rows form one entry.
parallel::MakePiece rows_of(const conformance::RecipeGrid& recipe,
                            const std::function<void()>& one) {
    return [&recipe, one, rows = report::ReferenceRows(recipe)](std::size_t p) {
        const conformance::RecipeGrid::Piece piece = recipe.piece(p);
        std::vector<std::string> lines(piece.rows.size());
        std::vector<bool> estimates(piece.rows.size());
        references_in_turn(piece.questions, recipe.digits(),
                           [&](std::size_t k, const conformance::Reference& reference) {
                               rows.add_line(lines[k], piece.questions, k, reference);
                               estimates[k] = !reference.value.proved;
                               one();
                           });
        std::vector<io::CheckpointFile::Entry> entries;
        for (std::size_t k = 0; k < lines.size(); ++k) {
            if (k == 0 || piece.rows[k] != piece.rows[k - 1] + 1) {
                entries.push_back({piece.rows[k], 0, 0, {}});
            }
            io::CheckpointFile::Entry& entry = entries.back();
            ++entry.items;
            entry.marked += estimates[k] ? 1 : 0;
            entry.text += lines[k];
        }
        return io::CheckpointFile::body(entries);
    };
}

/// Reads rows in order from a part file, as far as they are there. A few pieces are open at a time,
/// since a contact's coefficients and pressures alternate among the rows but are in different
/// pieces.
class RowsInOrder {
public:
    RowsInOrder(const conformance::RecipeGrid& recipe, const io::CheckpointFile& part)
        : recipe_(recipe), part_(part) {}

    /// Calls `take` with the lines that follow those of earlier calls.
    void each(const std::function<void(const std::string&)>& take) {
        while (row_ < recipe_.rows()) {
            const std::size_t p = recipe_.piece_of(row_);
            auto found = open_.find(p);
            if (found == open_.end()) {
                if (!part_.has(p)) {
                    return;
                }
                found = open_.emplace(p, Open{part_.piece(p), 0}).first;
            }
            Open& o = found->second;
            const io::CheckpointFile::Entry& entry = o.entries[o.at];
            if (entry.index != row_ || entry.items == 0) {
                throw Error(fmt::format("{} does not hold row {} where it should; delete it",
                                        part_.path().string(), row_));
            }
            take(entry.text);
            row_ += entry.items;
            if (++o.at == o.entries.size()) {
                open_.erase(found);
            }
        }
    }

private:
    struct Open {
        std::vector<io::CheckpointFile::Entry> entries;
        std::size_t at = 0;
    };
    const conformance::RecipeGrid& recipe_;
    const io::CheckpointFile& part_;
    std::map<std::size_t, Open> open_;
    std::size_t row_ = 0;
};

void write(const report::Table& head, const conformance::RecipeGrid& recipe,
           const io::CheckpointFile& part, report::TableFormat format,
           const report::TableLayout& layout, const std::filesystem::path& file) {
    RowsInOrder rows(recipe, part);
    if (format == report::TableFormat::csv) {
        io::AtomicFile whole(file);
        whole.write(write_table(head, format, layout));
        rows.each([&](const std::string& lines) { whole.write(lines); });
        whole.commit();
        return;
    }
    report::Table table = head;
    const std::string header = report::csv_line({"id"}); // every table has an id column
    rows.each([&](const std::string& lines) {
        for (io::Csv::Row& row : io::parse_csv(header + lines, file.string()).rows) {
            table.rows.push_back(std::move(row.cells));
        }
    });
    io::write_whole(file, write_table(table, format, layout));
}

} // namespace

TableInParts::TableInParts(const conformance::RecipeGrid& recipe, std::filesystem::path file,
                           report::TableFormat format, bool notes)
    : recipe_(recipe), file_(std::move(file)), format_(format), notes_(notes) {}

std::string TableInParts::sign() const {
    return fmt::format("{} {:016x}", report::program_line(), recipe_.fingerprint());
}

void TableInParts::help(unsigned threads, parallel::Processes& processes) const {
    follow_work(processes, sign(), threads, rows_of(recipe_, [] {}));
}

void TableInParts::open() {
    if (file_.has_parent_path()) {
        io::make_folder(file_.parent_path());
    }
    part_.emplace(file_.string() + ".part", io::fnv1a(program_mark(), recipe_.fingerprint()),
                  recipe_.pieces());
}

void TableInParts::make(unsigned threads, parallel::Processes* processes) {
    const std::size_t total = recipe_.rows();
    io::CheckpointFile& part = *part_;
    bool cannot_keep = false;
    const report::ReferenceRows columns(recipe_);
    std::uint64_t checksum = columns.header_checksum();
    const auto add_to_checksum = [&](const std::string& lines) {
        checksum = io::fnv1a(lines, checksum);
    };
    RowsInOrder rows(recipe_, part);
    rows.each(add_to_checksum);
    const io::KeptNote note("what is done is kept in " + part.path().string() +
                            "; the same command goes on from there");
    try {
        Progress progress("rows");
        const auto open =
            [&, p = std::size_t{0},
             asking = std::make_shared<std::mutex>()]() mutable -> std::optional<std::size_t> {
            const std::lock_guard lock(*asking);
            while (p < recipe_.pieces() && part.has(p)) {
                ++p;
            }
            return p < recipe_.pieces() ? std::optional(p++) : std::nullopt;
        };
        std::atomic<std::size_t> done{part.items()};
        progress(done, total);
        const auto keep = [&](std::size_t p, const std::string& body) {
            const std::size_t before = part.items();
            cannot_keep = true;
            part.add(p, body);
            cannot_keep = false;
            rows.each(add_to_checksum); // while the others compute
            if (processes != nullptr) { // otherwise `one` counts each row
                progress(done += part.items() - before, total);
            }
        };
        const auto one = [&] {
            if (processes == nullptr) {
                progress(++done, total);
            }
        };
        const parallel::MakePiece make_rows = rows_of(recipe_, one);
        if (processes == nullptr) {
            parallel::work_alone(open, threads, make_rows, keep);
        } else {
            lead_work(*processes, sign(), open, threads, make_rows, keep);
        }
    } catch (const Interrupted&) {
        throw Interrupted(
            fmt::format("interrupted: {} of {} rows are kept in {}; the same command goes "
                        "on from there",
                        part.items(), total, part.path().string()));
    } catch (const parallel::ProcessFailure&) {
        throw;
    } catch (const Error&) {
        if (!cannot_keep) {
            part.remove(); // the corrected recipe will be a different one
        }
        throw;
    }
    const report::Table head = columns.table(total, part.marked(), checksum);
    write(head, recipe_, part, format_, {.notes = notes_}, file_);
    part.remove();
}

} // namespace edgeproof::cli
