// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/check.hpp"

/// Every kind of claim, one file each in this folder. A new one is declared here and listed in
/// kinds.cpp.
namespace edgeproof {

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

} // namespace edgeproof
