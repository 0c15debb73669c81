// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/input/result_lines.hpp"
#include "edgeproof/conformance/answers/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

// The digits with which the numbers of a column are written.
namespace edgeproof::comparison {
using conformance::DecimalForm;
using conformance::form_of;

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
