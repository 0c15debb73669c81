// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/audit/symbolic/symbolic.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

/// Returns the formulas of a list or table of a claim, each with its text in the list or its name
/// in the table; none if the claim has no such field.
[[nodiscard]] std::vector<std::pair<std::string, Expr>> named_formulas(const Claim& claim,
                                                                       std::string_view key);

/// b = a for a family of symmetric contacts; P(a), b(a) if `given` names them.
[[nodiscard]] SymbolicCase symbolic_case(const Claim& claim, const AuditContext& context);
/// The same, in which P is a multiple of a^(m + 1), and b one of a, if g' is a multiple of x^m on
/// each side with the same m in all scenes of a plane family.
[[nodiscard]] SymbolicCase case_of_powers(const Claim& claim, const AuditContext& context);

} // namespace edgeproof::audit
