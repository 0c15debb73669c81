// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::comparison {

/// The contact output of a node, in the order of an .frd file.
enum ContactValue : std::size_t { copen, cslip1, cslip2, cpress, cshear1, cshear2, contact_values };

/// A number as it stands in the file; without a text there is none.
struct FrdNumber {
    std::string text;
    double value = 0;
};
struct FrdRow {
    std::vector<FrdNumber> values;
    std::size_t line = 0;
};
using FrdRows = std::map<std::string, FrdRow, std::less<>>; ///< by the number of the node

/// The values of a file at each node; the last step replaces those before.
struct FrdContents {
    FrdRows places;
    FrdRows contact; ///< contact_values
    FrdRows stress;  ///< SXX, SYY, SZZ
    std::size_t steps = 0;
};

/// Reads an .frd file of CalculiX in text: lines of fixed columns, one for a node. Throws
/// InputError, with the line, for a row that is not as CalculiX writes it, a node with two rows and
/// a file that ends inside a block; of a binary file for its first block.
[[nodiscard]] FrdContents read_frd(std::string_view text, const std::string& file);

} // namespace edgeproof::comparison
