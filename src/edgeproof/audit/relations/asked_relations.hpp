// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/relations/relations.hpp"

#include <string>
#include <utility>
#include <vector>

namespace edgeproof::audit {

inline constexpr long most_relation_degree = 12;

/// A search for relations, as the user writes it (docs/relations.md).
struct RelationQuestion {
    std::vector<std::string> quantities; ///< "left.c1", "b1", "L", ...
    long degree = 4;
    bool symmetric = false;                                 ///< b = a
    std::vector<std::pair<std::string, std::string>> given; ///< not free: {"P2", "m*P1/a"}
    std::vector<std::string> free;                          ///< additional free names: "m"
};

/// The result of find_relations, and the quantities in which it is written.
struct AskedRelations {
    std::vector<RelatedQuantity> quantities;
    FoundRelations found;
};

/// Searches for relations. Throws InputError for a degree outside 1 ... 12, unknown names and
/// malformed formulas, and as find_relations does; Interrupted.
[[nodiscard]] AskedRelations asked_relations(const RelationQuestion& question);

} // namespace edgeproof::audit
