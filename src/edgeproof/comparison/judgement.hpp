// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/comparison.hpp"

#include <optional>

namespace edgeproof::comparison {

/// The error in one of the norms.
[[nodiscard]] double in_norm(const Errors& errors, Norm norm);

/// Adds the reasons for which measured data fail their tolerances.
void judge(FileComparison& file, const ExactContact& exact, const Tolerances& tolerances);

/// The least zone, of at most ten elements, that leaves most of the nodes inside the contact.
[[nodiscard]] std::optional<SuggestedZone>
suggested_zone(const FileComparison& file, const ExactContact& exact, const Tolerances& tolerances);

/// Throws InputError, with the file, if fewer than three nodes lie inside the exact contact, or if
/// the edge zones leave none of these: such data cannot be compared. The advice depends on the
/// loaded part of the data and its width: a finer mesh if fewer than three nodes are loaded,
/// another origin if the width is half to twice the contact's, otherwise another unit.
void require_nodes_inside(const FileComparison& file, const ExactContact& exact,
                          const EdgeZone& zone);

} // namespace edgeproof::comparison
