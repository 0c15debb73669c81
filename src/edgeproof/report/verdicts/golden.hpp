// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace edgeproof::report {

/// Returns LEDGER.expected.csv in the folder of LEDGER.toml.
[[nodiscard]] std::filesystem::path golden_file(const std::filesystem::path& ledger);

/// Returns the verdicts and corrections of an audit in the format of a golden file. Such a file
/// records results that were checked by a person; it is never an input.
[[nodiscard]] std::string golden_text(const audit::AuditResult& result);

/// Returns the differences of the results from a golden file, one line each; only rows of the file
/// that match `only` count. Throws InputError for a malformed file.
[[nodiscard]] std::vector<std::string> golden_differences(const audit::AuditResult& result,
                                                          const std::filesystem::path& file,
                                                          const std::string& only);

} // namespace edgeproof::report
