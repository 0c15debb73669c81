// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

/// What `edgeproof check` does besides holding answers to the reference. Each gives the exit code.
namespace edgeproof::cli {

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
