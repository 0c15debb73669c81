// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/figures.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"

namespace edgeproof::report {
namespace {

std::optional<std::string> cell_text(const std::optional<Real>& value) {
    return value && isfinite(*value) ? std::optional(to_decimal(*value, figure_digits))
                                     : std::nullopt;
}

} // namespace

std::vector<std::optional<Real>>& Plot::add_row(const Real& first) {
    rows.emplace_back(1 + curves.size()).front() = first;
    return rows.back();
}

void Plot::add_curve(const std::string& column, std::string curve_title, const Pen& pen) {
    curves.push_back({column, std::move(curve_title), pen});
    for (auto& row : rows) {
        row.emplace_back();
    }
}

std::string to_csv(const Plot& plot) {
    std::string csv = "# " + printable(plot.title) + '\n';
    csv += "# " + printable(plot.description) + '\n';
    csv += "# program: " + program_line() + '\n';
    csv += plot.first_column;
    for (const Curve& curve : plot.curves) {
        add_csv_cell(csv += ',', curve.column);
    }
    csv += '\n';
    for (const auto& row : plot.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            csv += (i == 0 ? "" : ",") + cell_text(row[i]).value_or("");
        }
        csv += '\n';
    }
    return csv;
}

} // namespace edgeproof::report
