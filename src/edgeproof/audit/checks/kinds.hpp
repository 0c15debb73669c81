// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/claim_kind.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"

/// Every kind of claim, one file each in this folder. A new one is declared here and listed in
/// kinds.cpp.
namespace edgeproof::audit {

/// Nothing to check; with `of` the printed form is held against what the program takes it to be.
[[nodiscard]] CheckKind definition_kind();
/// A formula against a computed quantity, at every sample.
[[nodiscard]] CheckKind value_kind();
/// A formula against a derived quantity, in symbols, and at samples too.
[[nodiscard]] CheckKind identity_kind();
/// An expansion against a function, power by power; what is left, in real contacts.
[[nodiscard]] CheckKind expansion_kind();
/// A quoted extent of which the size of the contact is not given: the sizes for which it holds.
[[nodiscard]] CheckKind size_extent_kind();
/// A condition on the coefficients at both edges: the sizes for which it holds.
[[nodiscard]] CheckKind size_condition_kind();
/// The ratio of two loads at which a coefficient vanishes.
[[nodiscard]] CheckKind vanishing_kind();
/// Whether what two loads make of a quantity adds or subtracts.
[[nodiscard]] CheckKind superposition_kind();
/// A formula that is the same in all scenes of a family.
[[nodiscard]] CheckKind independence_kind();
/// Whether a quantity is a function of others, the derivatives of the contact law being free.
[[nodiscard]] CheckKind dependence_kind();
/// Whether an expansion breaks down where a second variable comes to a limit.
[[nodiscard]] CheckKind uniformity_kind();
/// Whether the terms of a cut cancel between the two parts of an integral.
[[nodiscard]] CheckKind split_kind();
/// A condition, looked at all over the contact, or near the edge only.
[[nodiscard]] CheckKind relation_kind();
/// The order of a quantity at the edge, and the factor that goes with it.
[[nodiscard]] CheckKind order_kind();
/// The orders of what is left of the pressure after each term of an expansion.
[[nodiscard]] CheckKind series_kind();
/// A quoted number against a computed one.
[[nodiscard]] CheckKind figure_kind();
/// A quoted extent against the distance to which an approximation is within a tolerance.
[[nodiscard]] CheckKind extent_kind();
/// A quantity that grows, or falls, with a parameter.
[[nodiscard]] CheckKind monotone_kind();
/// The limit of a quantity as a parameter runs.
[[nodiscard]] CheckKind limit_kind();
/// The value of a parameter at which an approximation reaches farthest.
[[nodiscard]] CheckKind optimum_kind();

} // namespace edgeproof::audit
