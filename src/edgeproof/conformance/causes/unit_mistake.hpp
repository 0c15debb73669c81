// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/causes/convention.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof::conformance {

/// Looks whether the answers listed (by index) would be right had the numbers of their questions
/// been read otherwise: degrees for radians, a width for a half-width, a diameter for a radius, x
/// for u, the modulus of one body for that of both, the gap's constant for the slope's, the sign of
/// a force; or a force for a mean pressure given. Quantity by quantity.
[[nodiscard]] std::vector<Convention> infer_unit_mistakes(const Answers& answers,
                                                          const Agreements& agreements,
                                                          const std::vector<std::size_t>& failing,
                                                          ReferenceOptions options);

/// Looks whether answers that miss the target are numbers in single precision, or were cut to a few
/// digits when they were written. Quantity by quantity.
[[nodiscard]] std::vector<Convention> infer_precision_loss(const Answers& answers,
                                                           const Agreements& agreements);

} // namespace edgeproof::conformance
