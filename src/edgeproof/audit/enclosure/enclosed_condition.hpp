// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"

namespace edgeproof::audit {

/// Whether the relation is =, <= or >=.
[[nodiscard]] bool allows_equality(const Relation& relation);

/// How <= and >= are decided where the enclosures of the two sides overlap: more bits may separate
/// them, so that equality is considered only after these were tried.
enum class SidesThatAgree {
    undecided, ///< the relation is not decided
    equal      ///< the relation holds if the sides agree to the digits required
};

/// Whether a relation holds, by the enclosures of both sides. Sides that are equal to `digits`
/// digits, relative to the sizes of their terms, satisfy =.
[[nodiscard]] Decision decide(const Relation& relation, const EnclosedSample& sample, double digits,
                              SidesThatAgree agreeing);
/// The same for all relations of a condition: one that fails decides.
[[nodiscard]] Decision decide(const Condition& condition, const EnclosedSample& sample,
                              double digits, SidesThatAgree agreeing);
/// The same with as many bits as necessary. Nothing where the enclosures do not decide.
[[nodiscard]] Decision decide(const Condition& condition, SampleInBalls& sample, double digits);

} // namespace edgeproof::audit
