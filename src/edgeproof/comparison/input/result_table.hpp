// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/input/column_names.hpp"
#include "edgeproof/precision/rational.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::comparison {

/// A row of a result: place and pressure exactly as they are written, in the scene's units.
struct ResultRow {
    std::size_t line = 0;
    Rational x;
    Rational p;
    std::optional<Rational> q;
    /// Half a unit of the last digit that the column of x has here; 0 of an even grid, which is
    /// exact.
    double x_rounding = 0;
    double p_rounding = 0;
    double q_rounding = 0;
};

/// The digits that the pressures of a file carry, whatever zeros are written behind them.
struct CarriedDigits {
    int significant = 0; ///< the most that any has, zeros at both ends left out
    int decimals = 0;    ///< the most behind the point, where none has an exponent
    bool exponents = false;
    /// Each is a number of binary32 to the digits that it is written with, and eight or more are
    /// written with enough to tell.
    bool binary32 = false;
};

/// What a program wrote, read.
struct ResultTable {
    std::string file;
    std::vector<ResultRow> rows; ///< by x; those of one x in the order of the file
    /// What was found about the file, and how it was read, a sentence each: nothing is assumed in
    /// silence.
    std::vector<std::string> findings;
    CarriedDigits p_digits;
    double p_factor = 1; ///< that the pressures of the file are multiplied with
};

struct ResultReading {
    ColumnChoice columns;
    std::optional<Rational> x_scale; ///< what a number of the file is multiplied with
    std::optional<Rational> p_scale;
    std::optional<scene::Units> units; ///< of the scene, which a file that says its own is put into
};

/// Reads a table that a program wrote: a row a place. Text around the rows (titles, a header, units
/// below it, lines at the end) and comments are told from them; columns are found by name or as
/// `reading` says. Throws InputError, with file and line, for a row that is cut off or holds
/// something else than numbers, NaN and infinity among them, where x or p are not found or found
/// twice, for a unit of the wrong kind, and for fewer than two places.
[[nodiscard]] ResultTable parse_result(std::string_view text, const std::string& file,
                                       const ResultReading& reading = {});
[[nodiscard]] ResultTable read_result(const std::filesystem::path& file,
                                      const ResultReading& reading = {});

/// "x=1e-3,p=1e6". Throws InputError for another form and for a factor that is not positive.
void parse_scale(std::string_view text, ResultReading& reading);

} // namespace edgeproof::comparison
