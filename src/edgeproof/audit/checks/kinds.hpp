// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"

/// The checks of the kinds of claim, in the files of this folder. A new kind is declared here
/// and has a row in kinds.cpp.
namespace edgeproof::audit {

using Check = Outcome(const Claim& claim, const AuditContext& context);

/// Compares a formula with a computed quantity at every sample.
[[nodiscard]] Check check_value;
/// Compares a formula with a derived quantity by symbols, and at samples.
[[nodiscard]] Check check_identity;
/// Compares an expansion with a function, by powers, and checks the remainder in real contacts.
[[nodiscard]] Check check_expansion;
/// Checks a condition in the whole contact, near the edge only, or from value to value of a sweep.
[[nodiscard]] Check check_condition;
/// Checks the orders of the remainder of the pressure after each term of an expansion.
[[nodiscard]] Check check_series;
/// Compares a quoted number with a computed one.
[[nodiscard]] Check check_figure;
/// Checks if a quantity is a function of others, where P', P'', b', b'', ... are free.
[[nodiscard]] Check check_relations;

} // namespace edgeproof::audit
