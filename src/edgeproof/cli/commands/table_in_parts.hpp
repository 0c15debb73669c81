// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/recipe_grid.hpp"
#include "edgeproof/io/checkpoint_file.hpp"
#include "edgeproof/parallel/distributed_work.hpp"
#include "edgeproof/report/tables/table.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace edgeproof::cli {

/// A table that is written to a file piece by piece. Finished pieces are kept in FILE.part; the
/// same command continues from there if it was stopped or killed, or if the disk was full. The
/// table is the same in every byte, regardless of interruptions and of the number of threads and
/// processes. The memory for a CSV table does not grow with its rows.
class TableInParts {
public:
    /// Keeps a reference to the recipe.
    TableInParts(const conformance::RecipeGrid& recipe, std::filesystem::path file,
                 report::TableFormat format, bool notes);
    /// Opens the part file. Throws InputError if it cannot be written or another run uses it.
    void open();
    /// Makes the table after open(). Throws the errors of references(), InputError if a file cannot
    /// be written, and Error when stopped. `processes`: the processes that share the work, of which
    /// this is the first, or null.
    void make(unsigned threads, parallel::Processes* processes);
    /// The work of all processes other than the first.
    void help(unsigned threads, parallel::Processes& processes) const;

private:
    [[nodiscard]] std::string sign() const;

    const conformance::RecipeGrid& recipe_;
    std::filesystem::path file_;
    report::TableFormat format_;
    bool notes_;
    std::optional<io::CheckpointFile> part_;
};

} // namespace edgeproof::cli
