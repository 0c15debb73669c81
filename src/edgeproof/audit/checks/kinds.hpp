// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/claim_kind.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"

/// Every kind of claim, defined in one file of this folder. A new kind is declared here and listed
/// in kinds.cpp.
namespace edgeproof::audit {

/// Nothing to check; with `of` the printed form is compared with the program's definition.
[[nodiscard]] CheckKind definition_kind();
/// Compares a formula with a computed quantity at every sample.
[[nodiscard]] CheckKind value_kind();
/// Compares a formula with a derived quantity by symbols, and at samples.
[[nodiscard]] CheckKind identity_kind();
/// Compares an expansion with a function, by powers, and checks the remainder in real contacts.
[[nodiscard]] CheckKind expansion_kind();
/// A quoted extent without the size of the contact: finds the sizes for which it holds.
[[nodiscard]] CheckKind size_extent_kind();
/// A condition on the coefficients at both edges: finds the sizes for which it holds.
[[nodiscard]] CheckKind size_condition_kind();
/// Checks the ratio of two loads at which a coefficient vanishes.
[[nodiscard]] CheckKind vanishing_kind();
/// Checks if the contributions of two loads to a quantity add or subtract.
[[nodiscard]] CheckKind superposition_kind();
/// Checks that a formula has the same value in all scenes of a family.
[[nodiscard]] CheckKind independence_kind();
/// Checks if a quantity is a function of others, for free derivatives of the contact law.
[[nodiscard]] CheckKind dependence_kind();
/// Checks if an expansion breaks down as a second variable tends to a limit.
[[nodiscard]] CheckKind uniformity_kind();
/// Checks that the terms with the cut cancel between the two parts of an integral.
[[nodiscard]] CheckKind split_kind();
/// Checks a condition in the whole contact, or near the edge only.
[[nodiscard]] CheckKind relation_kind();
/// Checks the order of a quantity at the edge, and its factor.
[[nodiscard]] CheckKind order_kind();
/// Checks the orders of the remainder of the pressure after each term of an expansion.
[[nodiscard]] CheckKind series_kind();
/// Compares a quoted number with a computed one.
[[nodiscard]] CheckKind figure_kind();
/// Compares a quoted extent with the distance within which an approximation is within a tolerance.
[[nodiscard]] CheckKind extent_kind();
/// Checks that a quantity increases, or decreases, with a parameter.
[[nodiscard]] CheckKind monotone_kind();
/// Checks the limit of a quantity along a sweep of a parameter.
[[nodiscard]] CheckKind limit_kind();
/// Checks the value of a parameter for which an approximation reaches farthest.
[[nodiscard]] CheckKind optimum_kind();

} // namespace edgeproof::audit
