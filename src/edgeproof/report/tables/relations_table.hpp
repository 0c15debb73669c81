// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/relations/asked_relations.hpp"
#include "edgeproof/report/tables/table.hpp"

namespace edgeproof::report {

/// The relations found, one row each, and whether these are all.
[[nodiscard]] Table relations_table(const audit::RelationQuestion& question,
                                    const audit::AskedRelations& asked);

} // namespace edgeproof::report
