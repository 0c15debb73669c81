// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <cstddef>
#include <string>

namespace edgeproof::report {

/// Returns the number of UTF-8 code points as the number of columns; nearly all texts are ASCII.
[[nodiscard]] inline std::size_t text_width(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    }));
}

} // namespace edgeproof::report
