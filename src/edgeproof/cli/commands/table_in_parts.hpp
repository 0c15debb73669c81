// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/recipe_grid.hpp"
#include "edgeproof/io/checkpoint_file.hpp"
#include "edgeproof/parallel/processes.hpp"
#include "edgeproof/report/tables/table.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace edgeproof::cli {

/// A table that is written to a file, made piece by piece: what is done stands in FILE.part, from
/// which the same command goes on when it was stopped or killed, or when the disk was full. The
/// table is the same in every byte, however often that happens, on any number of threads and by any
/// number of processes. The memory that a CSV table takes does not grow with its rows.
class TableInParts {
public:
    /// Keeps a reference to the recipe.
    TableInParts(const conformance::RecipeGrid& recipe, std::filesystem::path file,
                 report::TableFormat format);
    /// Opens the part file. Throws InputError where it cannot be written or another run holds it.
    void open();
    /// After open(). Throws as references() does, InputError where it cannot be written, Error when
    /// stopped. `processes`: those that make it together, of which this is the first, or null.
    void make(unsigned threads, parallel::Processes* processes);
    /// What any but the first of them does.
    void help(unsigned threads, parallel::Processes& processes) const;

private:
    [[nodiscard]] std::string sign() const;

    const conformance::RecipeGrid& recipe_;
    std::filesystem::path file_;
    report::TableFormat format_;
    std::optional<io::CheckpointFile> part_;
};

} // namespace edgeproof::cli
