// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/input/result_lines.hpp"
#include "edgeproof/conformance/answers/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

namespace edgeproof::comparison {
namespace {

/// The number of a step: 2 for "2" and "Step-2".
std::optional<Rational> step_number(std::string_view text) {
    const std::size_t digit = std::min(text.find_first_of("0123456789"), text.size());
    for (const std::string_view part : {text, text.substr(digit)}) {
        const auto written = conformance::written_number(part);
        if (written.kind == conformance::WrittenNumber::Kind::number) {
            return written.value;
        }
    }
    return {};
}

} // namespace

std::optional<LastStep> last_step(const ResultText& text, const TableHeader& header,
                                  const std::vector<ResultRow>& rows,
                                  const std::vector<std::vector<std::string>>& steps) {
    std::set<Rational> places;
    std::ranges::for_each(rows, [&](const ResultRow& row) { places.insert(row.x); });
    if (std::ranges::adjacent_find(steps, std::not_equal_to()) == steps.end() ||
        places.size() == rows.size()) {
        return {};
    }
    std::vector<std::vector<Rational>> numbers(rows.size()); // of steps, then of their increments
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (const std::string& step : steps[i]) {
            const auto number = step_number(step);
            if (!number) {
                text.reject(rows[i].line,
                            shown_cell(step) + " is no number of a step, and places are repeated",
                            "number the steps, or give the rows of one step only");
            }
            numbers[i].push_back(*number);
        }
    }
    const std::size_t count = std::set(numbers.begin(), numbers.end()).size();
    if (count == 1) {
        return {};
    }
    const auto greatest = std::ranges::max_element(numbers);
    const std::string shown = shown_cell(fmt::format(
        "{}", fmt::join(steps[static_cast<std::size_t>(greatest - numbers.begin())], ", ")));
    LastStep last;
    places.clear();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        last.has.push_back(numbers[i] == *greatest);
        if (last.has[i]) {
            places.insert(rows[i].x);
        }
    }
    const auto alone =
        std::ranges::find_if(rows, [&](const ResultRow& row) { return !places.contains(row.x); });
    if (alone != rows.end()) {
        text.reject(alone->line,
                    "the steps are mixed: the last one, " + shown + ", has no row at this place",
                    "give the rows of one step only");
    }
    last.finding = fmt::format("column {} has {} steps: the last, {}, is compared",
                               header.steps.front().index + 1, count, shown);
    return last;
}

} // namespace edgeproof::comparison
