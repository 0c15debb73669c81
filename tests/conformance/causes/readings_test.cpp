// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/table.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <regex>

// The head of causes.txt describes its rows.
namespace {

using Cells = std::vector<std::string>;

/// The columns of a contact, and u.
struct Columns {
    static constexpr long bits = 128;
    std::map<std::string, Ball, std::less<>> values;
    [[nodiscard]] Ball number(const Rational& q) const { return {q, bits}; }
    [[nodiscard]] Ball pi() const { return Ball::pi(bits); }
    [[nodiscard]] Ball symbol(std::string_view name) const { return values.find(name)->second; }
};

struct Contacts {
    std::string columns;
    Cells cells;      ///< of each contact
    std::string ours; ///< the right answer
};

/// One row of the table: a program, and the causes found in its answers.
struct Mistaken {
    const Contacts& contacts;
    std::string quantity;
    std::string formula;
    std::string format = "%.17g";
    bool binary32 = false;
    int points = 3;
    int parts = 8;

    void take_option(const std::string& option) {
        binary32 = binary32 || option == "binary32";
        format = option.starts_with('%') ? option : format;
        (void)std::sscanf(option.c_str(), "u to %d/%d", &points, &parts);
    }
    [[nodiscard]] std::vector<Convention> causes() const {
        std::string text = "id," + contacts.columns + ",quantity,edge,u,value\n";
        int id = 0;
        for (const std::string& cells : contacts.cells) {
            for (int k = 1; k <= (quantity == "p" ? points : 1); ++k) {
                const double u = static_cast<double>(k) / parts;
                char row[80];
                std::snprintf(row, sizeof row, quantity == "p" ? ",right,%.17g," : ",,,", u);
                text += std::to_string(++id) + ',' + cells + ',' + quantity + row +
                        written(cells, Rational(k, parts)) + '\n';
            }
        }
        const Answers answers = echoed_answers(parse_csv(text, "a.csv"));
        return infer_conventions(answers, compare(answers, {}, {}), {});
    }

private:
    [[nodiscard]] std::string written(const std::string& cells, const Rational& u) const {
        Columns columns;
        columns.values.emplace("u", Ball(u, Columns::bits));
        formula::Symbols symbols{"u"};
        const Cells names = test::parts(contacts.columns, ",");
        const Cells values = test::parts(cells, ",");
        for (std::size_t i = 1; i < names.size(); ++i) { // the first is the kind
            columns.values.emplace(names[i], formula::enclosed_constant(
                                                 formula::Exact::parse(values[i]), Columns::bits));
            symbols.add(names[i]);
        }
        const double value = formula::evaluate<Ball>(formula::parse(formula, symbols), columns)
                                 .midpoint()
                                 .convert_to<double>();
        char text[64];
        std::snprintf(text, sizeof text, format.c_str(),
                      binary32 ? static_cast<double>(static_cast<float>(value)) : value);
        return text;
    }
};

bool is_met(const std::vector<Convention>& found, const std::string& wanted) {
    if (wanted == "none" || found.size() != 1) {
        return wanted == "none" && found.empty();
    }
    if (wanted.starts_with('!')) {
        return !is_met(found, wanted.substr(1));
    }
    const Convention& cause = found.front();
    const std::size_t at = wanted.find(" = ");
    const std::string key = wanted.substr(0, at);
    const std::string value = at == std::string::npos ? "" : wanted.substr(at + 3);
    if (key == "name") {
        return cause.name == value;
    }
    if (key == "also") {
        return cause.equally_likely == (value == "none" ? Cells{} : Cells{value});
    }
    if (key == "among") {
        return cause.name == value || std::ranges::count(cause.equally_likely, value) != 0;
    }
    if (key == "factor" || key == "rows" || key == "failing") {
        const double number = std::stod(value);
        return number == (key == "factor" ? cause.factor
                          : key == "rows" ? static_cast<double>(cause.rows)
                                          : static_cast<double>(cause.failing));
    }
    if (key == "remains") {
        const double most = std::stod(value);
        return cause.remains <= most && (most == 0 || cause.remains > 0.75 * most);
    }
    return key == "leaves" ? cause.also.front() == value
                           : cause.of + ": " + cause.relation == wanted;
}

void check(const std::string& place, const std::vector<Convention>& found, const Cells& expected) {
    std::string said = found.empty() ? "none" : "";
    for (const Convention& c : found) {
        said += c.of + ": " + c.relation + " (" + c.name + "), ";
    }
    for (const std::string& wanted : expected) {
        CHECK_MESSAGE(is_met(found, wanted), place << ": not " << wanted << " but " << said);
    }
}

} // namespace

TEST_CASE("causes: the mistakes of the table are named, and nothing else") {
    std::map<std::string, Contacts> contacts;
    const std::regex ours("\\bours\\b");
    std::size_t rows = 0;
    for (const test::TableLine& row : test::table_lines("conformance/causes/causes.txt")) {
        const auto& line = row.text;
        const std::size_t arrow = line.find(" -> ");
        const Cells cells = test::parts(line.substr(0, arrow), " | ");
        if (line.starts_with("contacts ")) {
            Contacts& all = contacts[cells[0].substr(9)];
            all = {cells[1], Cells(cells.begin() + 2, cells.end()), ""};
            if (all.cells.back().starts_with("ours = ")) {
                all.ours = '(' + all.cells.back().substr(7) + ')';
                all.cells.pop_back();
            }
        } else {
            REQUIRE_MESSAGE(arrow != std::string::npos, row.place);
            for (const std::string& formula : test::parts(cells[2], " // ")) {
                const Contacts& asked = contacts.at(cells[0]);
                Mistaken program{asked, cells[1], std::regex_replace(formula, ours, asked.ours)};
                std::for_each(cells.begin() + 3, cells.end(),
                              [&](const std::string& option) { program.take_option(option); });
                check(row.place, program.causes(), test::parts(line.substr(arrow + 4), " & "));
                ++rows;
            }
        }
    }
    CHECK(rows > 80);
}
