// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/input/result_table.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/table.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>

// The head of results.txt describes its rows.
namespace {

std::string unescaped(const std::string& text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\\') {
            out += text[i];
        } else if (text[++i] == 'x') {
            out += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
            i += 2;
        } else {
            out += text[i] == 'n' ? '\n' : text[i] == 't' ? '\t' : text[i] == 'r' ? '\r' : text[i];
        }
    }
    return out;
}

ResultReading reading_with(const std::vector<std::string>& options) {
    std::optional<Units> units;
    std::string scale;
    std::string columns;
    for (const std::string& option : options) {
        if (option == "units") {
            units = Units{unit_named("mm"), unit_named("N"), unit_named("MPa")};
        } else {
            (option.starts_with("scale ") ? scale : columns) = option.substr(option.find(' ') + 1);
        }
    }
    return reading_of(units, columns, scale);
}

bool is_three(const std::vector<ResultRow>& rows) {
    const Rational half(1, 2);
    return rows.size() == 3 && rows[0].x == -half && rows[1].x == 0 && rows[2].x == half &&
           rows[0].p == 1 && rows[1].p == 1 + half && rows[2].p == 1;
}

/// Of "p 1 = 9/8": true if p of row 1 is 9/8.
bool has_value(const std::vector<ResultRow>& rows, const std::string& wanted) {
    std::istringstream words(wanted);
    std::string name;
    std::string equals;
    std::string value;
    std::size_t at = 0;
    words >> name >> at >> equals >> value;
    if (equals != "=" || at >= rows.size()) {
        return false;
    }
    const ResultRow& row = rows[at];
    return parse_decimal(value) == (name == "x"   ? row.x
                                    : name == "p" ? row.p
                                    : name == "q" ? row.q.value()
                                                  : Rational(static_cast<long>(row.line)));
}

/// Checks one result of a text; `wanted` is as in results.txt.
void check_result(const std::string& place, const std::string& text,
                  const std::vector<std::string>& options, const std::string& wanted) {
    ResultTable table;
    std::string refusal;
    try {
        table = parse_result(text, "r.csv", reading_with(options));
    } catch (const InputError& error) {
        refusal = error.what();
    }
    const auto has = [&](const std::string& all, std::size_t from) {
        return all.find(wanted.substr(std::min(from, wanted.size()))) != std::string::npos;
    };
    const bool met = wanted.starts_with("r.csv")     ? refusal.starts_with(wanted)
                     : wanted.starts_with("refused") ? !refusal.empty() && has(refusal, 8)
                     : !refusal.empty()              ? false
                     : wanted == "three"             ? is_three(table.rows)
                     : wanted.ends_with(" rows")     ? table.rows.size() == std::stoul(wanted)
                     : wanted.starts_with("note ")
                         ? std::ranges::any_of(table.findings,
                                               [&](const auto& finding) { return has(finding, 5); })
                         : has_value(table.rows, wanted);
    CHECK_MESSAGE(met, place << ": not " << wanted << " but " << table.rows.size() << " rows, "
                             << refusal);
}

} // namespace

TEST_CASE("results: texts as programs write them") {
    std::size_t results = 0;
    for (const auto& [place, line] : test::table_lines("comparison/input/results.txt")) {
        const std::size_t end = line.rfind('`');
        std::vector<std::string> options;
        for (std::size_t at = end + 1; at < line.size();) {
            const std::size_t next = std::min(line.find(" => ", at + 4), line.size());
            const std::string cell = line.substr(at + 4, next - at - 4);
            at = next;
            if (cell.starts_with("with ")) {
                options.push_back(cell.substr(5));
            } else {
                check_result(place, unescaped(line.substr(1, end - 1)), options, cell);
                ++results;
                if (at < line.size() && line.substr(at + 4).starts_with("with ")) {
                    options.clear();
                }
            }
        }
    }
    CHECK(results > 140);
}
