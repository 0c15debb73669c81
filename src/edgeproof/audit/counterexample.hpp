// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/ledger.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/precision/rational.hpp"

#include <optional>
#include <string>

namespace edgeproof::audit {

/// Returns the clearest numbers that show a refuted claim to be wrong. They are small and whole
/// where possible, so that a reader can check them by hand. (The samples used for a verdict are
/// chosen to find errors, not to show them.) All decimals are rounded from enclosures.
///
/// For a formula, the symbols get small numbers; `printed` and `correct` are the formulas,
/// `printed_value` and `correct_value` their exact values (left out where there is no closed form),
/// and decimals are added. For the reach of an approximation: a distance at which the error is on
/// the other side of the tolerance. For a quantity stated to increase or decrease: two values of
/// the parameter. Returns nothing for other kinds, or if no counterexample is found.
[[nodiscard]] std::optional<Evidence> clearest_counterexample(const ClaimResult& result,
                                                              const AuditContext& context);

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
