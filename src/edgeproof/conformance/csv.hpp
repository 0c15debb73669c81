// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof {

/// Comma-separated values as RFC 4180 has them (quoted cells, "" for a quote, either line end),
/// with notes: lines that begin with #. Blanks around a cell that is not quoted do not count.
struct Csv {
    struct Row {
        std::size_t line = 0;
        std::vector<std::string> cells;
    };
    std::string file;
    std::vector<std::string> notes; ///< without the #
    Row header;
    std::vector<Row> rows; ///< as many cells as they happen to have

    [[nodiscard]] std::optional<std::size_t> column(std::string_view name) const;
};

/// Throws InputError for a text without a header line and for a quote that does not end.
[[nodiscard]] Csv parse_csv(std::string_view text, const std::string& file);

} // namespace edgeproof
