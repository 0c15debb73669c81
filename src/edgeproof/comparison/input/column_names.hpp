// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/scene/input/units.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::comparison {

enum class ColumnRole { place, pressure, shear, gap, slip, sxx };
/// The roles that are compared if the data have them, in addition to p and q.
inline constexpr std::array surface_roles{ColumnRole::gap, ColumnRole::slip, ColumnRole::sxx};

using io::lower_case;
using io::trimmed;

/// The parts of a column's name, such as "CPRESS [MPa]", "x / mm", "x_mm".
struct ColumnName {
    std::string plain; ///< lower case, letters and digits only
    std::optional<scene::Unit> unit;
    std::string unread; ///< text in the place of a unit that is none
};
[[nodiscard]] ColumnName read_column_name(std::string_view written);

/// The role of a column with this plain name in usual programs; rank 1 is the most certain.
struct NamedRole {
    ColumnRole role;
    int rank;
};
[[nodiscard]] std::optional<NamedRole> role_of(std::string_view plain_name);

/// The rank of a column that numbers load steps or their parts, or gives their time: the steps come
/// first. Nothing for another name.
[[nodiscard]] std::optional<int> step_rank(std::string_view plain_name);

/// Divides the words of a header into `count` names, some of them of several words ("Node Label",
/// "x mm"). Returns nothing if there is more than one way, or if a word belongs to no known name: a
/// title is not a header.
[[nodiscard]] std::optional<std::vector<std::string>>
names_of_words(const std::vector<std::string>& words, std::size_t count);

/// The user's choice of columns: "x=1,p=3", "x=COORD1,p=CPRESS,q=CSHEAR1".
struct ColumnChoice {
    std::optional<std::string> x;
    std::optional<std::string> p;
    std::optional<std::string> q;
};
/// Throws InputError for a text of another form.
[[nodiscard]] ColumnChoice parse_columns(std::string_view text);

} // namespace edgeproof::comparison
