// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/sample/audit_context.hpp"

#include <vector>

namespace edgeproof::audit {

/// Returns samples that the family of a claim may not contain, to test corrections: a formula with
/// the right value at a few samples may be right by chance, such as P/Pi for 2 P/(Pi a) if a = 2.
/// Of a power law with given a, the constant, a and E* are changed one by one; of other profiles
/// all lengths, and then all moduli and forces, by a common factor. None if the sample has
/// parameters or variables of other kinds.
[[nodiscard]] std::vector<Sample> other_contacts(const Sample& sample);

} // namespace edgeproof::audit
