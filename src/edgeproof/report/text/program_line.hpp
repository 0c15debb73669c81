// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>

/// The identification of the program, included in every file that it writes.
namespace edgeproof::report {

/// For example "0.2.0".
extern const std::string_view program_version;
/// The commit of the source, followed by "-modified" if files differed from it. Empty if neither
/// git nor a release archive gives it. Both are made by cmake/program_version.cmake.
extern const std::string_view program_commit;

/// Returns name and version of each linked library that may affect a number: "MPFR 4.2.0, ...".
[[nodiscard]] std::string libraries_text();

/// Returns "edgeproof 0.2.0 (commit 0123456789ab; MPFR 4.2.0, FLINT 2.9.0, ...)".
[[nodiscard]] std::string program_line();
/// Returns the same on several lines; the first one has only the name and the version.
[[nodiscard]] std::string program_lines();

} // namespace edgeproof::report
