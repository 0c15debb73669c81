// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/part_file.hpp"
#include "edgeproof/conformance/processes.hpp"
#include "edgeproof/conformance/recipe_grid.hpp"
#include "edgeproof/report/table.hpp"

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
    TableInParts(const RecipeGrid& recipe, std::filesystem::path file, TableFormat format,
                 std::string version);
    /// Opens the part file. Throws InputError where it cannot be written or another run holds it.
    void open();
    /// After open(). Throws as references() does, InputError where it cannot be written, Error when
    /// stopped. `processes`: those that make it together, of which this is the first, or null.
    void make(unsigned threads, Processes* processes);
    /// What any but the first of them does.
    void help(unsigned threads, Processes& processes) const;

private:
    [[nodiscard]] std::string sign() const;

    const RecipeGrid& recipe_;
    std::filesystem::path file_;
    TableFormat format_;
    std::string version_;
    std::optional<PartFile> part_;
};

} // namespace edgeproof::cli
