// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/tables/table.hpp"

#include "edgeproof/report/text/escape.hpp"

#include <algorithm>

namespace edgeproof::report {
namespace {

/// Returns 1.3e-52 as $1.3\times 10^{-52}$; other text is not changed.
std::string latex_number(const std::string& text) {
    if (text.empty()) {
        return text;
    }
    const std::size_t e = text.find('e');
    const bool number = text.find_first_not_of("+-.0123456789e") == std::string::npos;
    if (!number) {
        return latex_text(text);
    }
    if (e == std::string::npos) {
        return "$" + text + "$";
    }
    const std::string power = std::to_string(std::stol(text.substr(e + 1)));
    return "$" + text.substr(0, e) + "\\times 10^{" + power + "}$";
}

// Lengths in LaTeX at 10 pt, in pt. Digits and most letters of Computer Modern are 5 wide; a
// column is surrounded by 2 \tabcolsep = 12.
constexpr std::size_t latex_letter = 5;
constexpr std::size_t latex_gap = 12;
constexpr std::size_t latex_most = 440;     // A4 with margins of 25 mm has 455; the rest is reserve
constexpr std::size_t latex_half = 190;     // of two columns that fit next to a short one
constexpr std::size_t latex_most_rows = 40; // of a table that cannot be divided between pages

/// The width of a cell: in numbers, "\times 10^{-16}" takes the place of e-16.
std::size_t latex_width(const Column& column, const std::string& text) {
    const std::size_t exponent =
        column.kind != Column::Kind::text && text.find('e') != std::string::npos ? 5 : 0;
    return (text_width(text) + exponent) * latex_letter;
}

/// The columns of a LaTeX table, with their widths.
struct LatexColumns {
    std::vector<std::size_t> width;
    std::vector<bool> broken; ///< the cells are paragraphs of this width

    explicit LatexColumns(const Table& table) {
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            std::size_t most = text_width(table.columns[i].name) * latex_letter;
            for (const auto& row : table.rows) {
                most = std::max(most, latex_width(table.columns[i], row[i]));
            }
            // Each part repeats the first two columns, and must have space for one more.
            const std::size_t used = i < 2 ? 0 : width[0] + width[1] + 3 * latex_gap;
            const std::size_t limit =
                i < 2 ? latex_half
                      : std::max(latex_most - std::min(used, latex_most), latex_letter * 8);
            broken.push_back(most > limit);
            width.push_back(std::min(most, limit));
        }
    }
};

/// A number that LaTeX may break after every tenth character.
std::string breakable_number(const std::string& text) {
    constexpr std::size_t group = 10;
    const std::size_t e = text.find('e');
    const std::size_t end = std::min(e, text.size());
    std::string out;
    for (std::size_t at = 0; at < end; at += group) {
        const std::string part = text.substr(at, std::min(group, end - at));
        const bool last = at + group >= end;
        out += (at == 0 ? "" : "\\allowbreak") + (last && e != std::string::npos
                                                      ? latex_number(part + text.substr(e))
                                                      : latex_number(part));
    }
    return out;
}

std::string latex_cell(const Column& column, const std::string& text, bool broken) {
    return column.kind == Column::Kind::text ? latex_text(text)
           : broken                          ? breakable_number(text)
                                             : latex_number(text);
}

/// The table with these columns. A long one is divided between pages.
std::string latex_part(const Table& table, const LatexColumns& all,
                       const std::vector<std::size_t>& columns) {
    const bool divided = table.rows.size() > latex_most_rows;
    const std::string environment = divided ? "longtable" : "tabular";
    std::string out = "\\begin{" + environment + "}{";
    for (const std::size_t i : columns) {
        out += all.broken[i] ? "p{" + std::to_string(all.width[i]) + "pt}"
               : table.columns[i].kind == Column::Kind::text ? "l"
                                                             : "r";
    }
    out += "}\n\\toprule\n";
    const auto line = [&](const auto& cell) {
        for (const std::size_t i : columns) {
            out += (i == columns.front() ? "" : " & ") + cell(i);
        }
        out += " \\\\\n";
    };
    line([&](std::size_t i) { return latex_text(table.columns[i].name); });
    out += std::string("\\midrule\n") + (divided ? "\\endhead\n\\bottomrule\n\\endfoot\n" : "");
    for (const auto& row : table.rows) {
        line([&](std::size_t i) { return latex_cell(table.columns[i], row[i], all.broken[i]); });
    }
    return out + (divided ? "" : "\\bottomrule\n") + "\\end{" + environment + "}\n";
}

} // namespace

std::string latex_tables(const Table& table, bool notes) {
    std::string out = notes ? heading(table, "% ") : "";
    out += "% needs the packages booktabs and longtable; at 10 pt at most 16 cm wide\n";
    const LatexColumns all(table);
    std::vector<std::size_t> width;
    for (const std::size_t w : all.width) {
        width.push_back(w + latex_gap - separator_width);
    }
    bool first = true;
    for (const auto& columns : columns_that_fit(width, latex_most)) {
        out += (first ? "" : "\n\\bigskip\n") + latex_part(table, all, columns);
        first = false;
    }
    return out;
}

} // namespace edgeproof::report
