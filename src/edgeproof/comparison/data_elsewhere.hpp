// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/comparison.hpp"

namespace edgeproof::comparison {

/// Throws InputError, with the file, where not one node lies inside the exact contact: such data
/// say nothing of it. What to write instead goes by where the data press and how wide that is:
/// another origin for a width of half to twice the contact's, else another unit.
void require_nodes_inside(const FileComparison& file, const ExactContact& exact);

} // namespace edgeproof::comparison
