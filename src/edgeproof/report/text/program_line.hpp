// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// What made a file: every file that is written says so.
namespace edgeproof::report {

/// "0.2.0".
extern const std::string_view program_version;
/// What the program was built from: the commit, with "-modified" behind it where files differed
/// from it. Empty where neither git nor a release's archive tells. Both are made by
/// cmake/program_version.cmake.
extern const std::string_view program_commit;

/// Name and version of each library that a number may depend on, as linked.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> library_versions();

/// "edgeproof 0.2.0 (commit 0123456789ab; MPFR 4.2.0, FLINT 2.9.0, ...)".
[[nodiscard]] std::string program_line();
/// The same on several lines, the name and the version alone on the first.
[[nodiscard]] std::string program_lines();

} // namespace edgeproof::report
