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
/// A quoted extent without the size of the contact: finds the sizes for which it holds.
[[nodiscard]] Check check_size_extent;
/// A condition on the coefficients at both edges: finds the sizes for which it holds.
[[nodiscard]] Check check_size_condition;
/// Checks the ratio of two loads at which a coefficient vanishes.
[[nodiscard]] Check check_vanishing;
/// Checks if the contributions of two loads to a quantity add (they have equal signs) or subtract.
/// With `when_zero` the second load is the one for which that formula vanishes.
[[nodiscard]] Check check_superposition;
/// Checks that a formula has the same value in all scenes of a family, at each of several places:
/// then it does not depend on the differences between the scenes.
[[nodiscard]] Check check_independence;
/// Checks if a quantity is a function of others, where P', P'', b', b'', ... are free: it is one
/// near a point if its gradient is a linear combination of theirs.
[[nodiscard]] Check check_dependence;
/// Checks if an expansion breaks down as a second variable tends to a limit: then the remainder
/// divided by the next power must grow.
[[nodiscard]] Check check_uniformity;
/// Checks that the terms with the cut cancel between the two parts of an integral.
[[nodiscard]] Check check_split;
/// Checks a condition in the whole contact, or near the edge only.
[[nodiscard]] Check check_relation;
/// Checks the order of a quantity at the edge, and its factor.
[[nodiscard]] Check check_order;
/// Checks the orders of the remainder of the pressure after each term of an expansion.
[[nodiscard]] Check check_series;
/// Compares a quoted number with a computed one.
[[nodiscard]] Check check_figure;
/// Compares a quoted extent with the distance within which an approximation is within a tolerance.
[[nodiscard]] Check check_extent;
/// Checks that a quantity increases, or decreases, with a parameter.
[[nodiscard]] Check check_monotone;
/// Checks the limit of a quantity along a sweep of a parameter.
[[nodiscard]] Check check_limit;
/// Checks the value of a parameter for which an approximation reaches farthest.
[[nodiscard]] Check check_optimum;

} // namespace edgeproof::audit
