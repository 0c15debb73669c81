// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/units.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::comparison {

/// What a column of a result file holds.
enum class ColumnRole { place, pressure, shear };

/// The name of a column taken apart: "CPRESS [MPa]", "x / mm", "x_mm".
struct ColumnName {
    std::string plain; ///< lower case, letters and digits alone
    std::optional<scene::Unit> unit;
    std::string unread; ///< what stands in brackets and is no unit
};
[[nodiscard]] ColumnName read_column_name(std::string_view written);

/// The role that programs give a column of this plain name, and how plainly: 1 is plainest.
struct NamedRole {
    ColumnRole role;
    int rank;
};
[[nodiscard]] std::optional<NamedRole> role_of(std::string_view plain_name);

/// The words of a header that blanks cut as `count` names, some of them of several words ("Node
/// Label", "x mm"). Nothing where there is more than one way, or a word that is no name known: a
/// title is no header.
[[nodiscard]] std::optional<std::vector<std::string>>
names_of_words(const std::vector<std::string>& words, std::size_t count);

/// What a user says of the columns: "x=1,p=3", "x=COORD1,p=CPRESS,q=CSHEAR1".
struct ColumnChoice {
    std::optional<std::string> x;
    std::optional<std::string> p;
    std::optional<std::string> q;
};
/// Throws InputError for a text of another form.
[[nodiscard]] ColumnChoice parse_columns(std::string_view text);

} // namespace edgeproof::comparison
