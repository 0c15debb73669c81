// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::comparison {

/// The contact output of a node, in the order of an .frd file.
enum ContactValue : std::size_t { copen, cslip1, cslip2, cpress, cshear1, cshear2, contact_values };

/// The values of a node, as texts, and the line that has them.
struct NodeValues {
    std::vector<std::string> values;
    std::size_t line = 0;
};
using NodeTable = std::map<std::string, NodeValues, std::less<>>; ///< by the number of the node

/// The values of a file at each node; the last step replaces those before.
struct CalculixContents {
    NodeTable places;
    NodeTable contact; ///< contact_values; empty texts without a value
    NodeTable stress;  ///< SXX, SYY, SZZ
    std::size_t steps = 0;
};

/// Reads an .frd or .dat file of CalculiX (calculix_table()); each node with contact output has a
/// place. Returns nothing for any other text.
[[nodiscard]] std::optional<CalculixContents> calculix_contents(std::string_view text,
                                                                const std::string& file);

} // namespace edgeproof::comparison
