// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/counterexample.hpp"
#include "edgeproof/precision/rational.hpp"

#include <string>

namespace edgeproof::audit {

/// The claim, or its last refuted reading (the most favourable to the source).
struct RefutedReading {
    const Claim* claim = nullptr;
    const Outcome* outcome = nullptr;
};
[[nodiscard]] RefutedReading kindest_refuted(const ClaimResult& result);

/// Returns a measure of the effort to calculate with a number by hand.
[[nodiscard]] double effort_of(const Rational& value);

/// Each function finds a counterexample for one kind of claim.
[[nodiscard]] std::optional<Evidence> formula_counterexample(const RefutedReading& refuted);
[[nodiscard]] std::optional<Evidence> reach_counterexample(const RefutedReading& refuted,
                                                           const AuditContext& context);
[[nodiscard]] std::optional<Evidence> course_counterexample(const RefutedReading& refuted,
                                                            const AuditContext& context);
[[nodiscard]] std::optional<Evidence> vanishing_counterexample(const RefutedReading& refuted);
[[nodiscard]] std::optional<Evidence> integral_counterexample(const RefutedReading& refuted,
                                                              const AuditContext& context);

} // namespace edgeproof::audit
