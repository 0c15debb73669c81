// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/message.hpp"

#include <boost/locale/utf.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace edgeproof {
namespace {

constexpr std::size_t longest_compared_name = 64;

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// True for control characters, line separators, characters that change the direction of writing,
/// and the two that XML excludes.
bool steers(std::uint32_t code) {
    return code < 0x20U || (code >= 0x7FU && code < 0xA0U) || code == 0x2028U || code == 0x2029U ||
           (code >= 0x202AU && code <= 0x202EU) || (code >= 0x2066U && code <= 0x2069U) ||
           code == 0x200EU || code == 0x200FU || code == 0xFFFEU || code == 0xFFFFU;
}

bool is_graphic(char c) { return c >= ' ' && c <= '~'; }

std::string escaped(std::string_view text, bool lines) {
    static constexpr std::string_view hex = "0123456789abcdef";
    const auto* const plain = std::find_if_not(text.begin(), text.end(), is_graphic);
    std::string out(text.begin(), plain);
    text.remove_prefix(out.size());
    while (!text.empty()) {
        const char c = text.front();
        const auto* next = text.begin();
        const auto code = boost::locale::utf::utf_traits<char>::decode(next, text.end());
        const bool valid =
            code != boost::locale::utf::illegal && code != boost::locale::utf::incomplete;
        const auto length = valid ? static_cast<std::size_t>(next - text.begin()) : 1;
        if (c == '\n' || c == '\r' || c == '\t') {
            out += lines && c != '\r' ? c : ' ';
        } else if (valid && !steers(code)) {
            out += text.substr(0, length);
        } else {
            for (const char byte : text.substr(0, length)) {
                const auto value = static_cast<unsigned char>(byte);
                out += std::string("\\x") + hex[value >> 4U] + hex[value & 0xFU];
            }
        }
        text.remove_prefix(length);
    }
    return out;
}

/// Returns the Damerau-Levenshtein distance with adjacent swaps (optimal string alignment).
std::size_t edit_distance(std::string_view x, std::string_view y) {
    std::vector<std::size_t> before(y.size() + 1);
    std::vector<std::size_t> last(y.size() + 1);
    std::vector<std::size_t> row(y.size() + 1);
    for (std::size_t j = 0; j <= y.size(); ++j) {
        last[j] = j;
    }
    for (std::size_t i = 1; i <= x.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= y.size(); ++j) {
            const std::size_t changed = last[j - 1] + (x[i - 1] == y[j - 1] ? 0 : 1);
            row[j] = std::min({changed, last[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && x[i - 1] == y[j - 2] && x[i - 2] == y[j - 1]) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
        std::swap(before, last);
        std::swap(last, row);
    }
    return last[y.size()];
}

} // namespace

std::string printable(std::string_view text) { return escaped(text, false); }
std::string printable_lines(std::string_view text) { return escaped(text, true); }

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return lower;
}

std::string shortened(std::string_view text, std::size_t most) {
    static constexpr std::string_view between = " [...] ";
    if (text.size() <= most || most <= between.size()) {
        return std::string(text);
    }
    const std::size_t kept = most - between.size();
    std::size_t head = kept - kept / 3;
    std::size_t tail = text.size() - kept / 3;
    while (head > 0 && is_continuation(text[head])) {
        --head;
    }
    while (tail < text.size() && is_continuation(text[tail])) {
        ++tail;
    }
    return std::string(text.substr(0, head)) + std::string(between) +
           std::string(text.substr(tail));
}

std::string_view near_name(std::string_view name, std::span<const std::string_view> candidates) {
    if (name.empty() || name.size() > longest_compared_name) {
        return {};
    }
    const std::string lower = lower_case(name);
    const auto modulus = std::ranges::find(candidates, "contact_modulus");
    if (modulus != candidates.end() && (lower == "es" || lower == "estar" || lower == "e*")) {
        return *modulus; // the symbol of textbooks
    }
    std::string_view nearest;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (const std::string_view candidate : candidates) {
        if (candidate.size() > longest_compared_name || candidate == name) {
            continue;
        }
        const std::size_t distance = edit_distance(lower, lower_case(candidate));
        if (distance <= std::max(lower.size(), candidate.size()) / 3 && distance < least) {
            least = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

std::string one_of(std::string_view name, std::span<const std::string_view> candidates) {
    std::string list;
    for (const std::string_view candidate : candidates) {
        list += (list.empty() ? "write one of " : ", ") + std::string(candidate);
    }
    const std::string_view near = near_name(name, candidates);
    return near.empty() ? list : "did you mean " + std::string(near) + "? " + list;
}

} // namespace edgeproof
