// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"

/// The checks of the kinds of claim, in the files of this folder. A new kind is declared here
/// and has a row in kinds.cpp.
namespace edgeproof::audit {

using Check = Outcome(const Claim& claim, const AuditContext& context);
/// Compares a quoted number with an exact quantity, by rounding.
[[nodiscard]] Check compare_figure;

/// Compares a formula with an exact quantity by symbols and at every sample; or a quoted number.
[[nodiscard]] Check check_compare;
/// Compares an expansion with a function, by powers, and checks the remainder in real contacts.
[[nodiscard]] Check check_expansion;
/// Checks a condition in the whole contact, near the edge only, or from value to value of a sweep.
[[nodiscard]] Check check_condition;
/// Checks if a quantity is a function of others, where P', P'', b', b'', ... are free.
[[nodiscard]] Check check_relations;

} // namespace edgeproof::audit
