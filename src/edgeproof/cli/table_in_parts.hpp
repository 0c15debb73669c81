// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/reference_table.hpp"

#include <filesystem>
#include <string>

namespace edgeproof::cli {

/// A table that is written to a file, made piece by piece: what is done stands in FILE.part, from
/// which the same command goes on when it was stopped or killed, or when the disk was full. The
/// table is the same in every byte, however often that happens and on any number of threads. A CSV
/// table needs memory for its questions only.
class TableInParts {
public:
    TableInParts(const Recipe& recipe, std::filesystem::path file, TableFormat format,
                 std::string version);
    /// Throws as references() does, InputError where it cannot be written, Error when stopped.
    void make(unsigned threads);

private:
    const Recipe& recipe_;
    std::filesystem::path file_;
    TableFormat format_;
    std::string version_;
};

} // namespace edgeproof::cli
