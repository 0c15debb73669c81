// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/evidence.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/audit/ledger/verdict.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace edgeproof::audit {

/// What a verdict by samples owes to how many they are, in the order in which they are drawn.
struct SampleUse {
    std::size_t samples = 0;
    std::size_t refuting = 0;       ///< at which the values differ by more than both may be off by
    std::size_t first_refuting = 0; ///< which of them is the first, from 1; 0: none
    std::size_t worst = 0;          ///< at which they agree to the fewest digits, from 1
    double digits = 0;              ///< to which they agree there; below 0: no value there
    double first_half_digits = 0;   ///< the fewest among the first half
};

/// What a check found.
struct Outcome {
    Judgement verdict;
    std::string note;                    ///< one line for a reader of the table
    std::optional<std::string> correct;  ///< the corrected formula, itself confirmed or proved
    std::optional<std::string> computed; ///< the figure or formula that was computed
    Evidence evidence;
    std::optional<SampleUse> sample_use; ///< of a verdict by agreement at samples
};

/// Confirmed as a rounded formula: right to the printed digits of its decimals, not beyond.
[[nodiscard]] inline bool is_rounded(const Outcome& outcome) {
    return outcome.verdict == Verdict::confirmed && outcome.evidence.find("rounded") != nullptr;
}

} // namespace edgeproof::audit
