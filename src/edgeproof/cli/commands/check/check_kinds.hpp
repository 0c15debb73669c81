// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/tables/agreement_report.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

/// The ways in which `edgeproof check` goes, but for the usual one.
namespace edgeproof::cli {

/// Answers of a file of any size, which is read as they are held against the references: what is
/// kept of them does not grow with the file, but for 16 bytes an answer. Nothing where the file can
/// be read once only, or holds so few answers that all of them are looked at together.
[[nodiscard]] std::optional<report::ConformanceSummary>
check_in_blocks(const std::filesystem::path& file, const conformance::Target& target,
                std::size_t errors, const conformance::ReferenceOptions& options);

// Each of the others gives the exit code.

/// Somebody's own formulas: 0 where all of them hold, 1 where one does not.
[[nodiscard]] int check_ledger(const std::string& ledger, const std::string& threads);

struct SelfTestOptions {
    std::string seed = "1";
    std::string files = "200";
};
/// Right answers to a recipe must pass, corrupted ones be found: 0 where all are.
[[nodiscard]] int self_test(const std::string& recipe, const SelfTestOptions& options,
                            const std::string& threads);

} // namespace edgeproof::cli
