// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/input/result_lines.hpp"
#include "edgeproof/conformance/answers/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

// The digits with which the numbers of a column are written.
namespace edgeproof::comparison {
namespace {

struct DecimalForm {
    bool exact = false; ///< hexadecimal
    bool with_exponent = false;
    bool zero = true;
    int significant = 0; ///< digits from the first that is not 0
    int carried = 0;     ///< digits from there to the last that is not 0
    int leading = 0;     ///< the power of ten of the first digit that is not 0
    int decimals = 0;    ///< after the point, if there is no exponent
    int carried_decimals = 0;
};

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
    int place = static_cast<int>(point) - 1; // power of ten of the current digit
    for (const char c : text) {
        if (c == '.') {
            continue;
        }
        if (form.zero && c != '0') {
            form.zero = false;
            form.leading = place + exponent;
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

} // namespace

std::vector<double> column_rounding(const std::vector<std::string_view>& column) {
    std::vector<DecimalForm> forms;
    forms.reserve(column.size());
    int significant = 0;
    int decimals = 0;
    bool exponents = false;
    for (const std::string_view text : column) {
        forms.push_back(form_of(text));
        significant = std::max(significant, forms.back().significant);
        decimals = std::max(decimals, forms.back().decimals);
        exponents = exponents || forms.back().with_exponent;
    }
    std::vector<double> half;
    half.reserve(forms.size());
    for (const DecimalForm& form : forms) {
        const int last = exponents ? form.leading - significant + 1 : -decimals;
        half.push_back(form.exact || (exponents && form.zero) ? 0 : 0.5 * std::pow(10.0, last));
    }
    return half;
}

CarriedDigits carried_digits(const std::vector<std::string_view>& column) {
    CarriedDigits digits;
    const std::vector<double> half = column_rounding(column);
    // A random decimal is this close to a binary32 number with a probability of one in ten.
    constexpr double decisive_ratio = 20;
    constexpr std::size_t enough = 8;
    std::size_t decisive = 0;
    digits.binary32 = true;
    for (std::size_t i = 0; i < column.size(); ++i) {
        const double value = conformance::written_number(column[i]).value.convert_to<double>();
        DecimalForm form = form_of(column[i]);
        constexpr int digits_of_binary64 = 15; // more digits only show the conversion to binary
        if (form.significant > digits_of_binary64) {
            form = form_of(fmt::format("{:.{}e}", value, digits_of_binary64 - 1));
        }
        digits.significant = std::max(digits.significant, form.carried);
        digits.decimals = std::max(digits.decimals, form.carried_decimals);
        digits.exponents = digits.exponents || form.with_exponent || form.exact;
        const auto single = static_cast<float>(value);
        const double spacing = static_cast<double>(std::nextafter(std::abs(single), INFINITY)) -
                               std::abs(static_cast<double>(single));
        digits.binary32 =
            digits.binary32 && std::abs(value - static_cast<double>(single)) <= half[i] * 1.0001;
        decisive += value != 0 && spacing > decisive_ratio * half[i] ? 1 : 0;
    }
    digits.binary32 = digits.binary32 && decisive >= enough;
    return digits;
}

} // namespace edgeproof::comparison
