// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/counterexample.hpp"
#include "edgeproof/precision/rational.hpp"

#include <string>

namespace edgeproof::audit {

/// The claim, or of its readings the last that is refuted: the kindest to what is printed.
struct RefutedReading {
    const Claim* claim = nullptr;
    const Outcome* outcome = nullptr;
};
[[nodiscard]] RefutedReading kindest_refuted(const ClaimResult& result);

/// How hard a number is to work with by hand.
[[nodiscard]] double effort_of(const Rational& value);

/// One counterexample each, of the kinds of claim that they are for.
[[nodiscard]] std::optional<Evidence> formula_counterexample(const RefutedReading& refuted);
[[nodiscard]] std::optional<Evidence> reach_counterexample(const RefutedReading& refuted,
                                                           const AuditContext& context);
[[nodiscard]] std::optional<Evidence> course_counterexample(const RefutedReading& refuted,
                                                            const AuditContext& context);
[[nodiscard]] std::optional<Evidence> vanishing_counterexample(const RefutedReading& refuted);
[[nodiscard]] std::optional<Evidence> integral_counterexample(const RefutedReading& refuted,
                                                              const AuditContext& context);

} // namespace edgeproof::audit
