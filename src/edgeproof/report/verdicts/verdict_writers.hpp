// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/run.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace edgeproof::report {

/// The number of claims with each verdict, in the order of `all_verdicts`.
[[nodiscard]] std::array<std::size_t, audit::all_verdicts.size()>
count_verdicts(const audit::AuditResult& result);
/// Returns "61 proved, 30 confirmed, 12 refuted, ..." without zeros.
[[nodiscard]] std::string counts_line(const audit::AuditResult& result);

/// The results as text, identical in every byte for the same results.
[[nodiscard]] std::string verdicts_json(const audit::AuditResult& result);
[[nodiscard]] std::string verdicts_csv(const audit::AuditResult& result);
[[nodiscard]] std::string verdicts_markdown(const audit::AuditResult& result);
/// Returns a longtable for LaTeX's `\input`, with the packages needed in comments. Every column has
/// a fixed width, and the widths together are those of the text of an article on A4.
[[nodiscard]] std::string verdicts_latex(const audit::AuditResult& result);

/// For a terminal `width` columns wide: the table, the errata, the counts. `colour` adds ANSI
/// codes.
[[nodiscard]] std::string verdicts_terminal(const audit::AuditResult& result, std::size_t width,
                                            bool colour);

/// Returns LEDGER.expected.csv in the folder of LEDGER.toml.
[[nodiscard]] std::filesystem::path golden_file(const std::filesystem::path& ledger);
/// True if there is such a file, or a link with its name, even to nothing: reading it then fails.
[[nodiscard]] bool has_golden_file(const std::filesystem::path& ledger);

/// Returns the verdicts and corrections of an audit in the format of a golden file. Such a file
/// records results that were checked by a person; it is never an input.
[[nodiscard]] std::string golden_text(const audit::AuditResult& result);

/// Returns the differences of the results from a golden file, one line each; only rows of the file
/// that match `only` count. Throws InputError for a malformed file, or two rows of one id.
[[nodiscard]] std::vector<std::string> golden_differences(const audit::AuditResult& result,
                                                          const std::filesystem::path& file,
                                                          const std::string& only);

} // namespace edgeproof::report
