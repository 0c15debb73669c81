// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/number_text.hpp"

#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace edgeproof::io {
namespace {

using Kind = WrittenNumber::Kind;

constexpr long most_binary_exponent = 332'192; // 2^332192 < 10^100000
constexpr std::size_t most_hexadecimal_digits = 100'000;

/// Reads the text after 0x. <cctype> depends on the locale.
std::optional<Rational> hexadecimal_value(std::string_view text) {
    const std::size_t letter = std::min(text.find('p'), text.size());
    std::string digits(text.substr(0, letter));
    long exponent = 0;
    if (letter < text.size()) {
        text.remove_prefix(letter + 1);
        text.remove_prefix(text.starts_with('+') && !text.starts_with("+-") ? 1 : 0);
        const auto read = std::from_chars(text.data(), text.data() + text.size(), exponent);
        if (read.ec != std::errc{} || read.ptr != text.data() + text.size() ||
            exponent < -most_binary_exponent || exponent > most_binary_exponent) {
            return {};
        }
    }
    if (const std::size_t point = digits.find('.'); point != std::string::npos) {
        digits.erase(point, 1);
        exponent -= 4 * static_cast<long>(digits.size() - point);
    }
    if (digits.empty() || digits.size() > most_hexadecimal_digits ||
        digits.find_first_not_of("0123456789abcdef") != std::string::npos) {
        return {};
    }
    const Integer whole("0x" + digits);
    const Integer power = Integer(1) << static_cast<unsigned>(std::abs(exponent));
    return exponent < 0 ? Rational(whole, power) : Rational(whole * power);
}

std::optional<Rational> decimal_value(std::string text) {
    std::ranges::replace(text, 'd', 'e');
    if (text.empty() || text.find_first_not_of(".0123456789") == 0 ||
        text.find_first_not_of(".0123456789e+-") != std::string::npos) {
        return {};
    }
    try {
        return parse_decimal(text);
    } catch (const InputError&) { // malformed, too long, or out of range
        return {};
    }
}

/// True for the text after "nan": nothing, or letters, digits and _ in parentheses.
bool is_payload(std::string_view text) {
    return text.empty() ||
           (text.size() > 1 && text.front() == '(' &&
            text.find_first_not_of("0123456789abcdefghijklmnopqrstuvwxyz_", 1) == text.size() - 1 &&
            text.back() == ')');
}

} // namespace

WrittenNumber written_number(std::string_view text) {
    const std::string lower = lower_case(text);
    std::string_view rest = lower;
    const bool negative = rest.starts_with('-');
    rest.remove_prefix(negative || rest.starts_with('+') ? 1 : 0);
    if (rest == "inf" || rest == "infinity") {
        return {Kind::infinite, {}};
    }
    if (rest.starts_with("nan")) {
        return {is_payload(rest.substr(3)) ? Kind::nan : Kind::other, {}};
    }
    const auto value = rest.starts_with("0x") ? hexadecimal_value(rest.substr(2))
                                              : decimal_value(std::string(rest));
    return value ? WrittenNumber{Kind::number, negative ? Rational(-*value) : *value}
                 : WrittenNumber{};
}

std::optional<Rational> read_number(std::string_view text) {
    WrittenNumber written = written_number(text);
    return written.kind == Kind::number ? std::optional(std::move(written.value)) : std::nullopt;
}

DecimalForm form_of(std::string_view text) {
    DecimalForm form;
    if (text.find_first_of("xX") != std::string_view::npos) {
        form.exact = true;
        return form;
    }
    text.remove_prefix(text.starts_with('-') || text.starts_with('+') ? 1 : 0);
    const std::size_t letter = text.find_first_of("eEdD");
    int exponent = 0;
    if (letter != std::string_view::npos) {
        form.with_exponent = true;
        std::string_view digits = text.substr(letter + 1);
        digits.remove_prefix(digits.starts_with('+') ? 1 : 0);
        std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
        text = text.substr(0, letter);
    }
    const std::size_t point = std::min(text.find('.'), text.size());
    int place = static_cast<int>(point) - 1 + exponent; // power of ten of the current digit
    for (const char c : text) {
        if (c == '.') {
            continue;
        }
        if (form.zero && c != '0') {
            form.zero = false;
            form.leading = place;
        }
        form.significant += form.zero ? 0 : 1;
        if (c != '0') {
            form.carried = form.significant;
            form.carried_decimals = std::max(0, -place);
        }
        --place;
    }
    form.decimals = static_cast<int>(point < text.size() ? text.size() - point - 1 : 0);
    return form;
}

std::optional<std::string> with_decimal_point(std::string_view text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos || text.find('.') != std::string_view::npos ||
        text.find_first_of("xX") != std::string_view::npos) {
        return {};
    }
    std::string pointed(text);
    pointed[comma] = '.';
    return read_number(pointed) ? std::optional(pointed) : std::nullopt;
}

} // namespace edgeproof::io
