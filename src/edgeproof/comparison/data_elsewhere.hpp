// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/comparison.hpp"

namespace edgeproof::comparison {

/// Throws InputError, with the file, where fewer than three nodes lie inside the exact contact, or
/// where the edge zones leave none of these: such data say nothing of it. What to write instead
/// goes by where the data press and how wide that is: a finer mesh where fewer than three of the
/// data's own nodes press, another origin for a width of half to twice the contact's, else another
/// unit.
void require_nodes_inside(const FileComparison& file, const ExactContact& exact,
                          const EdgeZone& zone);

} // namespace edgeproof::comparison
