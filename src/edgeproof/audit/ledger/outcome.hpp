// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/evidence.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/audit/ledger/verdict.hpp"

#include <optional>
#include <string>

namespace edgeproof::audit {

/// What a check found.
struct Outcome {
    Judgement verdict;
    std::string note;                    ///< one line for a reader of the table
    std::optional<std::string> correct;  ///< the corrected formula, itself confirmed or proved
    std::optional<std::string> computed; ///< the figure or formula that was computed
    Evidence evidence;
};

/// Confirmed as a rounded formula: right to the printed digits of its decimals, not beyond.
[[nodiscard]] bool is_rounded(const Outcome& outcome);

} // namespace edgeproof::audit
