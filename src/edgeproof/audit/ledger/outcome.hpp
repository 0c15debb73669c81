// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/evidence.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/audit/ledger/verdict.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace edgeproof::audit {

/// Shows how a verdict by samples depends on their number, in the order in which they are drawn.
struct SampleUse {
    std::size_t samples = 0;
    std::size_t refuting = 0;       ///< samples with a difference beyond both error bounds
    std::size_t first_refuting = 0; ///< the first of them, counted from 1; 0: none
    std::size_t worst = 0;          ///< the sample of least agreement, counted from 1
    double digits = 0;              ///< the digits of agreement there; negative: no value there
    double first_half_digits = 0;   ///< the fewest digits of agreement in the first half
};

/// The result of a check.
struct Outcome {
    Judgement verdict;
    std::string note;                    ///< one line for the table
    std::optional<std::string> correct;  ///< the corrected formula, itself confirmed or proved
    std::optional<std::string> computed; ///< the computed figure or formula
    Evidence evidence;
    std::optional<SampleUse> sample_use; ///< for a verdict by agreement at samples
};

/// Confirmed as a rounded formula: right to the printed digits of its decimals.
[[nodiscard]] inline bool is_rounded(const Outcome& outcome) {
    return outcome.verdict == Verdict::confirmed && outcome.evidence.find("rounded") != nullptr;
}

} // namespace edgeproof::audit
