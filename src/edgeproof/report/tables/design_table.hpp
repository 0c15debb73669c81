// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/relations/relations.hpp"
#include "edgeproof/report/tables/table.hpp"
#include "edgeproof/scene/design/design_file.hpp"

namespace edgeproof::report {

/// The best values, one row per parameter: the kind of optimum, whether it is proved and by what
/// gap, and the loss with the printed values.
[[nodiscard]] Table design_table(const scene::DesignScene& design,
                                 const scene::DesignResult& result,
                                 const contact::DesignOptions& search);

/// The relations found, one row each, and whether these are all.
[[nodiscard]] Table relations_table(const audit::RelationQuestion& question,
                                    const audit::AskedRelations& asked);

} // namespace edgeproof::report
