// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/text/visible_text.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace edgeproof::report {
namespace {

/// Bytes of the character that begins there, 0 where none does (RFC 3629: no overlong forms, no
/// surrogates) or where it is a control character.
std::size_t bytes_to_show(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80) {
        return first >= 0x20 && first != 0x7F ? 1 : 0;
    }
    const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() < length) {
        return 0;
    }
    std::uint32_t code = first & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) {
            return 0;
        }
        code = (code << 6U) | (byte(i) & 0x3FU);
    }
    const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    const bool control = code < 0xA0; // C1
    const bool none = code > 0x10FFFF || code == 0xFFFE || code == 0xFFFF;
    return overlong || surrogate || control || none ? 0 : length;
}

} // namespace

std::string visible_text(std::string_view text) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string out;
    while (!text.empty()) {
        const std::size_t length = bytes_to_show(text);
        if (length == 0) {
            const auto c = static_cast<unsigned char>(text.front());
            out += "\\x";
            out += digits[c >> 4U];
            out += digits[c & 0xFU];
        } else {
            out += text.substr(0, length);
        }
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return out;
}

} // namespace edgeproof::report
