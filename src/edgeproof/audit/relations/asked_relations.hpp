// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/relations/relations.hpp"

#include <string>
#include <utility>
#include <vector>

namespace edgeproof::audit {

inline constexpr long most_relation_degree = 12;

/// A question for relations as it is typed (docs/relations.md).
struct RelationQuestion {
    std::vector<std::string> quantities; ///< "left.c1", "b1", "L", ...
    long degree = 4;
    bool symmetric = false;                                 ///< b = a
    std::vector<std::pair<std::string, std::string>> given; ///< {"P2", "m*P1/a"}: not free
    std::vector<std::string> free;                          ///< further free names: "m"
};

/// What find_relations makes of it, and the quantities that its answer is written in.
struct AskedRelations {
    std::vector<RelatedQuantity> quantities;
    FoundRelations found;
};

/// Throws InputError for a degree beyond 1 ... 12, names that are not known, formulas that are
/// malformed, and as find_relations does; Interrupted.
[[nodiscard]] AskedRelations asked_relations(const RelationQuestion& question);

} // namespace edgeproof::audit
