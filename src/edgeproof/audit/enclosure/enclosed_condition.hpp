// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"

namespace edgeproof::audit {

/// Decides a relation by the enclosures of both sides. Sides that are equal to `digits` digits,
/// relative to the sizes of their terms, satisfy =, <= and >=.
[[nodiscard]] Decision decide(const Relation& relation, const EnclosedSample& sample,
                              double digits);
/// Decides a condition: one relation that fails decides.
[[nodiscard]] Decision decide(const Condition& condition, const EnclosedSample& sample,
                              double digits);
/// Decides with as many bits as needed. Returns nothing if the enclosures do not decide.
[[nodiscard]] Decision decide(const Condition& condition, SampleInBalls& sample, double digits);

} // namespace edgeproof::audit
