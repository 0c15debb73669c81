// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <optional>
#include <string_view>

namespace edgeproof::audit {

/// The verdict on a claim; always computed, never written in a ledger.
enum class Verdict {
    proved,         ///< by a symbolic identity: printed minus derived is zero
    confirmed,      ///< agrees to the digits needed at every sample, or rounds to what is quoted
    imprecise,      ///< off by one unit in the last quoted place, or true under one reading only
    refuted,        ///< proved wrong by enclosures
    underspecified, ///< cannot be evaluated as printed
    undecided,      ///< the evidence at the budget given does not decide
    definition,     ///< nothing to check
};

inline constexpr std::array all_verdicts{
    Verdict::proved,         Verdict::confirmed, Verdict::imprecise, Verdict::refuted,
    Verdict::underspecified, Verdict::undecided, Verdict::definition};

[[nodiscard]] std::string_view name_of(Verdict verdict);
[[nodiscard]] std::optional<Verdict> find_verdict(std::string_view name);

/// True if the claim is right as it stands.
[[nodiscard]] constexpr bool holds(Verdict verdict) {
    return verdict == Verdict::proved || verdict == Verdict::confirmed ||
           verdict == Verdict::definition;
}

} // namespace edgeproof::audit
