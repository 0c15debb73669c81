// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/tables/agreement_report.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

/// The variants of `edgeproof check` other than the usual one.
namespace edgeproof::cli {

/// Checks answers in a file of any size while it is read: the memory does not grow with the file
/// except for 16 bytes for each answer. Returns no value if the file can be read only once, or
/// holds so few answers that all of them are checked together.
[[nodiscard]] std::optional<report::ConformanceSummary>
check_in_blocks(const std::filesystem::path& file, const conformance::Target& target,
                std::size_t errors, const conformance::ReferenceOptions& options);

} // namespace edgeproof::cli
