// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace edgeproof::report {

/// Beside LEDGER.toml: LEDGER.expected.csv.
[[nodiscard]] std::filesystem::path golden_file(const std::filesystem::path& ledger);

/// The verdicts and corrections of an audit, as a golden file holds them. It records what was
/// computed and was then understood; nothing in it is an input.
[[nodiscard]] std::string golden_text(const audit::AuditResult& result);

/// How the results differ from a golden file, a line each; of the file's rows only those that
/// match `only` count. Throws InputError for a malformed file.
[[nodiscard]] std::vector<std::string> golden_differences(const audit::AuditResult& result,
                                                          const std::filesystem::path& file,
                                                          const std::string& only);

} // namespace edgeproof::report
