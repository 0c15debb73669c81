// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/real.hpp"
#include "edgeproof/scene/input/units.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::comparison {

enum class ColumnRole { place, pressure, shear, gap, slip, sxx };
/// The roles that are compared if the data have them, in addition to p and q.
inline constexpr std::array surface_roles{ColumnRole::gap, ColumnRole::slip, ColumnRole::sxx};

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

/// A row of a result: the exact written values of place and pressure, in the scene's units.
struct ResultRow {
    std::size_t line = 0;
    Rational x;
    Rational p;
    std::string p_text = {}; ///< the number in the file
    std::optional<Rational> q = {};
    /// Gap, slip and sxx along the surface, in the order of surface_roles; not an exact value. NaN
    /// for a cell that is no number, nothing for an empty one.
    std::array<std::optional<double>, surface_roles.size()> surface = {};
    /// Half a unit of the last digit of x in its column; 0 for an even grid, which is exact.
    double x_rounding = 0;
    double p_rounding = 0;
    double q_rounding = 0;
};

struct ResultTable {
    std::string file;
    std::vector<ResultRow> rows; ///< by x; those with equal x in the order of the file
    /// Notes on the file and how it was read, one sentence each: no assumption is silent.
    std::vector<std::string> findings;
    double p_factor = 1; ///< the factor applied to the pressures of the file
};

struct ResultReading {
    /// The columns that the user chooses for x, p and q, by number from 1 or by name.
    std::map<std::string, std::string, std::less<>> columns;
    std::optional<Rational> x_scale; ///< the factor for the numbers of the file
    std::optional<Rational> p_scale;
    std::optional<scene::Units> units; ///< of the scene; the file's own units are converted
};

/// Reads a table written by a program, with one place per row. Text around the rows (titles, a
/// header, units below it, lines at the end) and comments are recognised; columns are found by name
/// or according to `reading`. Throws InputError, with file and line, for a row that is incomplete
/// or contains anything but numbers (NaN and infinity are not allowed), if x or p are not found or
/// found twice, for a unit of the wrong kind, for load steps at different places, and for fewer
/// than two places.
[[nodiscard]] ResultTable parse_result(std::string_view text, const std::string& file,
                                       const ResultReading& reading = {});
[[nodiscard]] ResultTable read_result(const std::filesystem::path& file,
                                      const ResultReading& reading = {});

/// Reads the options: columns "x=1,p=3" or "x=COORD1,p=CPRESS,q=CSHEAR1", factors "x=1e-3,p=1e6";
/// an empty text is not given. Throws InputError for other forms, and for a factor that is not
/// positive.
[[nodiscard]] ResultReading reading_of(const std::optional<scene::Units>& units,
                                       const std::string& columns, const std::string& scale);

} // namespace edgeproof::comparison
