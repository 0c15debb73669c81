// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/diagnose/diagnose.hpp"
#include "edgeproof/io/foreign_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace edgeproof::diagnose {
namespace {

constexpr double half_unit = 0.51; ///< of the last digit, with a little for binary64
constexpr double whole_unit = 2;   ///< the same, over half a unit
constexpr int full_digits = 15;
constexpr double of_binary32 = 0x1p-18;
constexpr double least_evidence = 6; ///< the power of ten of a chance

/// The digits of a number; those of more than a double has only show a conversion to binary.
io::DecimalForm form_of(const Written& number) {
    const io::DecimalForm form = io::form_of(number.text);
    return form.significant > full_digits ? io::form_of(fmt::format("{}", number.value)) : form;
}

/// Half a unit of the last digit as it is written; 0 for a hexadecimal number.
double half_of_last(const std::string& text) {
    const io::DecimalForm form = io::form_of(text);
    return form.exact ? 0 : std::pow(10.0, form.leading - form.significant + 1) / 2;
}

std::optional<FewDigits> in_binary32(const std::vector<Written>& numbers) {
    FewDigits found{"binary32", {}, {}};
    std::size_t right = 0;
    double evidence = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const Written& number = numbers[i];
        if (std::abs(number.error) > of_binary32 * number.size ||
            (number.value == 0 && number.error != 0)) {
            continue;
        }
        ++right;
        if (number.value == 0) { // no evidence
            found.rows.push_back(i);
            continue;
        }
        const auto single = static_cast<float>(number.value);
        const double half = half_of_last(number.text) + 0x1p-52 * std::abs(number.value);
        if (std::abs(number.value - static_cast<double>(single)) <= half) {
            const float next = std::nextafter(std::abs(single), INFINITY);
            const double spacing =
                static_cast<double>(next) - std::abs(static_cast<double>(single));
            evidence += std::max(0.0, std::log10(spacing / half / 2));
            found.rows.push_back(i);
        }
    }
    return enough(found.rows.size(), right) && evidence >= least_evidence
               ? std::optional(std::move(found))
               : std::nullopt;
}

} // namespace

std::optional<FewDigits> few_digits(const std::vector<Written>& numbers) {
    std::vector<io::DecimalForm> forms;
    std::ranges::transform(numbers, std::back_inserter(forms), form_of);
    /// `unit`: of the last digit of a number.
    const auto rounded = [&](int io::DecimalForm::*carried, const char* suffix, const char* words,
                             const auto& unit) -> std::optional<FewDigits> {
        std::vector<double> counts;
        for (const io::DecimalForm& form : forms) {
            counts.push_back(form.exact ? full_digits : form.*carried);
        }
        const int digits = static_cast<int>(sorted_at(std::move(counts), least_share));
        const auto within = [&](double units) {
            std::vector<std::size_t> rows;
            for (std::size_t i = 0; i < numbers.size(); ++i) {
                const double allowed = half_unit * unit(forms[i], digits);
                if (forms[i].*carried <= digits &&
                    std::abs(numbers[i].error) <= units * std::max(allowed, numbers[i].explained)) {
                    rows.push_back(i);
                }
            }
            return rows;
        };
        if (digits <= 0 || digits >= full_digits || !enough(within(1).size(), numbers.size())) {
            return {};
        }
        return FewDigits{fmt::format("rounded-to-{}{}", digits, suffix),
                         fmt::format("{} {}", digits, words), within(whole_unit)};
    };
    if (numbers.size() < least_rows) {
        return {};
    }
    if (auto found = rounded(&io::DecimalForm::carried, "", "digits", [](const auto& form, int n) {
            return form.zero ? 0.0 : std::pow(10.0, form.leading - n + 1);
        })) {
        return found;
    }
    if (auto found = rounded(&io::DecimalForm::carried_decimals, "-decimals", "decimals",
                             [](const auto&, int n) { return std::pow(10.0, -n); })) {
        return found;
    }
    return in_binary32(numbers);
}

} // namespace edgeproof::diagnose
