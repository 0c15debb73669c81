// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/input/result_lines.hpp"

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

/// A result of CalculiX as a table with the names COORD1, COORD2, COORD3, CPRESS, CSHEAR1, COPEN,
/// CSLIP1, S11: a row for each node of the slave surface, with its place before the deformation. If
/// the contact does not lie along COORD1, the first column is x, and S11 is the stress along it. Of
/// the two tangential directions, the one with the larger values is taken.
struct CalculixTable {
    ResultText text;                   ///< each row has the number of its line in the file
    std::vector<std::string> findings; ///< of several steps, or planes of nodes
};

/// Reads the contact output of a text of CalculiX: an .frd file (in text, of the last step that has
/// CONTACT, with SXX of STRESS), or a .dat file with CSTR, and CDIS if there is one. The places of
/// the nodes of a .dat file are in the .frd or .inp file of the same name next to it. The contact
/// lies along the coordinate with which the pressures change. Nodes of one plane across it are kept
/// if the surface has several. Contact from surface to surface has rows of
/// zeros for all nodes in no face in contact: the rows of the others are kept, and up to three
/// places further on each side, without a gap. Returns nothing for any other text. Throws
/// InputError, with the line, for a file without contact output, or with that of points inside
/// faces, a binary .frd file, a node without a place, and a row that is not as CalculiX writes it.
[[nodiscard]] std::optional<CalculixTable> calculix_table(std::string_view text,
                                                          const std::string& file);

} // namespace edgeproof::comparison
