// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/tables/reference_table.hpp"

#include "edgeproof/io/text_file.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <map>
#include <utility>

namespace edgeproof::report {
namespace {

/// This format identifies x.
std::string seventeen_digits(double x) { return fmt::format("{:.17g}", x); }

std::vector<std::string> names_of(const std::vector<Column>& columns) {
    std::vector<std::string> names;
    std::ranges::transform(columns, std::back_inserter(names), &Column::name);
    return names;
}

/// The columns of questions: id, the parameters, those of `names` that the questions have; all are
/// exact. `numbers`: the kind of x, value, bound and binary64.
std::vector<Column> exact_columns(const conformance::Questions& questions,
                                  std::initializer_list<std::string_view> names,
                                  Column::Kind numbers) {
    std::vector<Column> columns{{"id", Column::Kind::text}};
    for (const std::string& name : questions.columns()) {
        columns.push_back({name, Column::Kind::text, true});
    }
    for (const std::string_view name : names) {
        const bool number = name == "x" || name == "value" || name == "bound" || name == "binary64";
        const bool of_bodies = name == "body" || name == "z";
        if ((name != "tolerance" || questions.has_tolerances()) &&
            (!of_bodies || questions.has_body_points())) {
            columns.push_back({std::string(name), number ? numbers : Column::Kind::text, true});
        }
    }
    return columns;
}

/// The cells of a row by their columns.
using CellsByName = std::map<std::string, std::string, std::less<>>;

/// Returns the cells of a question without its parameters. `text` writes an exact number.
template <class Text> CellsByName cells_of(const conformance::Question& q, const Text& text) {
    const auto optional_text = [&](const std::optional<formula::Exact>& x) {
        return x ? text(*x) : std::string();
    };
    CellsByName cells{{"id", q.id},
                      {"edge", q.at_edge() ? scene::edge_name(q.edge) : ""},
                      {"tolerance", optional_text(q.tolerance)},
                      {"u", optional_text(q.u)},
                      {"quantity", symbol_of(q)}};
    if (q.in_body) {
        cells["body"] = q.in_body->body == scene::Body::A ? "A" : "B";
        cells["x"] = text(*q.in_body->x.number());
        cells["z"] = text(*q.in_body->z.number());
    }
    return cells;
}

std::vector<std::string> row_of(const std::vector<Column>& columns, CellsByName cells) {
    std::vector<std::string> row;
    for (const Column& column : columns) {
        row.push_back(std::move(cells[column.name]));
    }
    return row;
}

/// Returns x as an exact decimal, if a and u are rational.
std::string exact_place(const conformance::AskedContact& contact, const conformance::Question& q) {
    const contact::Load& load = contact.scene.load;
    const bool known = load.kind == contact::Load::Kind::right_edge &&
                       (q.edge == contact::Edge::right || contact.scene.symmetric());
    if (!q.u || !known || !load.value.is_rational() || !q.u->is_rational()) {
        return {};
    }
    const Rational x = load.value.rational() - q.u->rational();
    return exact_text(q.edge == contact::Edge::right ? x : Rational(-x));
}

} // namespace

std::string csv_line(const std::vector<std::string>& cells) {
    std::string text;
    for (const std::string& cell : cells) {
        add_csv_cell(text, cell);
        text += ',';
    }
    if (text.empty()) {
        return "\n";
    }
    text.back() = '\n';
    return text;
}

std::vector<Fact> facts_of_rows(const io::Csv& table) {
    const auto route = table.column("route");
    std::uint64_t hash = io::fnv1a(csv_line(table.header.cells));
    std::size_t estimates = 0;
    for (const io::Csv::Row& row : table.rows) {
        hash = io::fnv1a(csv_line(row.cells), hash);
        estimates += route && *route < row.cells.size() &&
                             row.cells[*route].find("(estimate)") != std::string::npos
                         ? 1
                         : 0;
    }
    return {{"rows", std::to_string(table.rows.size())},
            {"estimates", std::to_string(estimates)},
            {"checksum", fmt::format("fnv1a-64 {:016x}", hash)}};
}

namespace {

/// The number of digits of an input that no decimal gives exactly, beyond those of the values: its
/// rounding does not reach the digits of a value that a reader computes from it.
constexpr unsigned more_digits_of_inputs = 15;

std::string input_text(const formula::Exact& x, scene::Digits digits) {
    digits.count += more_digits_of_inputs;
    return decimal_text(x, digits);
}

std::string input_text(const conformance::AskedContact& contact, const std::string& key,
                       const scene::Digits& digits) {
    const auto found = std::ranges::find(contact.parameters, key, &conformance::Parameter::key);
    if (found == contact.parameters.end() || found->is_word()) {
        return parameter_text(contact, key);
    }
    std::vector<std::string> items = found->items();
    for (std::string& item : items) {
        item = input_text(formula::Exact::parse(item), digits);
    }
    return fmt::format("{}", fmt::join(items, "; "));
}

CellsByName cells_of(const conformance::AskedContact& contact, const conformance::Question& q,
                     const conformance::Reference& reference, const std::vector<std::string>& keys,
                     const scene::Digits& digits) {
    CellsByName cells = cells_of(q, [&](const formula::Exact& x) { return input_text(x, digits); });
    for (const std::string& key : keys) {
        cells[key] = input_text(contact, key, digits);
    }
    if (reference.x) {
        cells["x"] = printed(*reference.x, digits).text;
    }
    const scene::PrintedValue value = printed(reference.value, digits);
    cells["value"] = value.text;
    cells["bound"] = value.bound;
    cells["binary64"] = value.binary64 ? seventeen_digits(*value.binary64) : "";
    cells["route"] = how(reference.value, value);
    return cells;
}

constexpr const char* notes_of_bounds[] = {
    "|value - exact| <= bound, proved, and every digit is right, unless the route says (estimate): "
    "then bound and digits are what the quadrature estimates of itself",
    "binary64: the one nearest to the exact value, in 17 digits"};

} // namespace

Table reference_table(const conformance::Recipe& recipe, const conformance::Questions& some,
                      const std::vector<conformance::Reference>& values) {
    Table table;
    const std::vector<std::string> keys = recipe.questions.columns();
    table.title = recipe.title;
    table.notes_first = true;
    table.columns = exact_columns(recipe.questions,
                                  {"edge", "tolerance", "u", "body", "x", "z", "quantity", "value",
                                   "bound", "binary64", "route"},
                                  Column::Kind::number);
    io::Csv rows;
    rows.header.cells = names_of(table.columns);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const conformance::Question& q = some.list[i];
        table.rows.push_back(row_of(
            table.columns, cells_of(some.contacts[q.contact], q, values[i], keys, recipe.digits)));
        rows.rows.push_back({0, table.rows.back()});
    }
    table.facts = {
        {"recipe", std::filesystem::path(recipe.file).filename().string()},
        {"program", program_line()},
        {"digits", std::to_string(recipe.digits.count)},
        {"rounding", std::string(rounding_name(recipe.digits.rounding))},
    };
    std::ranges::copy(facts_of_rows(rows), std::back_inserter(table.facts));
    table.notes = {"u: distance inwards from the edge; x: place; c_k: coefficient of u^(k + 1/2) "
                   "in p; s_k: of q, from its lowest power on"};
    table.notes.insert(table.notes.end(), std::begin(notes_of_bounds), std::end(notes_of_bounds));
    if (recipe.questions.has_body_points()) {
        table.notes.emplace_back("x, z: place and depth in the body; tension positive");
    }
    if (recipe.questions.has_tolerances()) {
        table.notes.emplace_back(
            "extent_n: the first u at which |1 - (the sum of n terms)/p| reaches "
            "the tolerance; measure_n: the length of all that lies within it");
    }
    for (const scene::Quantity quantity : recipe.questions.quantities()) {
        const scene::QuantityRow& row = scene::row_of(quantity);
        if (!row.meaning.empty()) {
            table.notes.push_back(scene::family_of({quantity}) + ": " + std::string(row.meaning));
        }
    }
    return table;
}

Table wide_table(const conformance::Recipe& recipe,
                 const std::vector<conformance::Reference>& values) {
    Table table = reference_table(recipe, recipe.questions, values);
    std::erase_if(table.facts,
                  [](const Fact& f) { return f.key == "checksum" || f.key == "rows"; });
    std::erase_if(table.notes, [](const std::string& note) {
        return std::ranges::find(notes_of_bounds, note) != std::end(notes_of_bounds);
    });
    table.notes.emplace_back("every digit of the values is right");
    const auto column = [&](std::string_view name) {
        return static_cast<std::size_t>(std::ranges::find(table.columns, name, &Column::name) -
                                        table.columns.begin());
    };
    const std::size_t parameters = recipe.questions.columns().size();
    const std::size_t value = column("value");
    std::vector<Column> columns(table.columns.begin() + 1,
                                table.columns.begin() + 1 +
                                    static_cast<std::ptrdiff_t>(parameters));
    std::map<std::size_t, std::vector<std::string>> rows; // by the contact
    for (std::size_t i = 0; i < values.size(); ++i) {
        require(values[i].value.proved, "a wide table has no place for the routes of estimates",
                "leave --wide out, or the route of the recipe");
        const std::vector<std::string>& cells = table.rows[i];
        // The name of the quantity with what distinguishes the question: "c_0 left", "p u=1e-3".
        std::string name = cells[column("quantity")];
        for (const std::string_view key : {"body", "edge", "tolerance", "u"}) {
            const std::size_t at = column(key);
            if (at < cells.size() && !cells[at].empty() && cells[at] != "right") {
                name += (key == "edge" || key == "body" ? " " : " " + std::string(key) + "=") +
                        cells[at];
            }
        }
        if (recipe.questions.list[i].in_body) {
            name += " x=" + cells[column("x")] + " z=" + cells[column("z")];
        }
        const auto found = std::ranges::find(columns, name, &Column::name);
        const auto at = static_cast<std::size_t>(found - columns.begin());
        if (found == columns.end()) {
            columns.push_back({name});
        }
        std::vector<std::string>& row = rows[recipe.questions.list[i].contact];
        if (row.empty()) {
            row.assign(cells.begin() + 1,
                       cells.begin() + 1 + static_cast<std::ptrdiff_t>(parameters));
        }
        row.resize(std::max(row.size(), at + 1));
        row[at] = cells[value];
    }
    table.columns = std::move(columns);
    table.rows.clear();
    for (auto& [contact, row] : rows) {
        row.resize(table.columns.size());
        table.rows.push_back(std::move(row));
    }
    return table;
}

namespace {

/// Returns the facts that the head of a table states wrongly, or does not state, a sentence each.
std::vector<std::string> wrong_facts(const io::Csv& old, const Table& made) {
    std::map<std::string, std::string> expected;
    for (const Fact& fact : facts_of_rows(old)) {
        expected[fact.key] = fact.value;
    }
    for (const Fact& fact : made.facts) {
        if (fact.key == "digits" || fact.key == "rounding") {
            expected[fact.key] = fact.value;
        }
    }
    std::vector<std::string> wrong;
    for (const auto& [key, value] : expected) {
        const std::string start = key + ":";
        std::vector<std::string> stated;
        std::ranges::copy_if(old.notes, std::back_inserter(stated),
                             [&](const std::string& note) { return note.starts_with(start); });
        if (stated != std::vector{key + ": " + value}) {
            wrong.push_back(fmt::format(
                "the head {}, and the table has {}: {}",
                stated.empty() ? "has no " + key : fmt::format("has {}", fmt::join(stated, ", ")),
                key, value));
        }
    }
    return wrong;
}

} // namespace

Table question_table(const conformance::Questions& questions, const std::string& title) {
    Table table;
    table.title = title;
    table.facts = {{"questions", std::to_string(questions.list.size())}};
    table.notes = {"add a column `value` and give the file to `edgeproof check`: what it is held "
                   "against is computed at the numbers in its row, taken exactly",
                   "u: distance inwards from the edge; x: place, for reading"};
    table.columns = exact_columns(
        questions, {"quantity", "edge", "tolerance", "u", "body", "x", "z"}, Column::Kind::text);
    const std::vector<std::string> keys = questions.columns();
    for (const conformance::Question& q : questions.list) {
        const conformance::AskedContact& contact = questions.contacts[q.contact];
        CellsByName cells = cells_of(q, [](const formula::Exact& x) { return x.text(); });
        for (const std::string& key : keys) {
            cells[key] = parameter_text(contact, key);
        }
        cells.emplace("x", exact_place(contact, q));
        table.rows.push_back(row_of(table.columns, std::move(cells)));
    }
    return table;
}

std::vector<std::string> row_differences(const io::Csv& old,
                                         const std::vector<std::vector<std::string>>& made,
                                         const std::function<bool(const std::string&)>& is_made) {
    std::vector<std::string> said;
    const auto say = [&](std::size_t line, const std::string& id, const std::string& what) {
        said.push_back(fmt::format("{}:{}: row {} {}", old.file, line, id, what));
    };
    std::map<std::string, const io::Csv::Row*> by_id;
    for (const io::Csv::Row& row : old.rows) {
        if (!by_id.emplace(row.cells.front(), &row).second) {
            say(row.line, row.cells.front(), "occurs twice");
        }
    }
    for (const auto& row : made) {
        const auto found = by_id.find(row.front());
        if (found == by_id.end()) {
            say(1, row.front(), "is missing");
            continue;
        }
        const io::Csv::Row& was = *found->second;
        for (std::size_t i = 0; i < std::max(row.size(), was.cells.size()); ++i) {
            const std::string cell = i < was.cells.size() ? was.cells[i] : "";
            if (i >= row.size() || cell != row[i]) {
                say(was.line, row.front(),
                    i < row.size() ? fmt::format("has {} {}, made anew {}", old.header.cells.at(i),
                                                 cell, row[i])
                                   : "has a cell too many");
            }
        }
        by_id.erase(found);
    }
    for (const auto& [id, row] : by_id) {
        if (is_made(id)) {
            say(row->line, id, "is not there any more");
        }
    }
    return said;
}

std::vector<std::string> table_differences(const io::Csv& old, const Table& made, bool sample) {
    if (old.header.cells != names_of(made.columns)) {
        return {fmt::format("{}:{}: the columns are not those of the recipe", old.file,
                            old.header.line)};
    }
    std::vector<std::string> said = wrong_facts(old, made);
    for (std::string& fact : said) {
        fact = fmt::format("{}:1: {}", old.file, fact);
    }
    std::ranges::copy(row_differences(old, made.rows, [&](const std::string&) { return !sample; }),
                      std::back_inserter(said));
    return said;
}

} // namespace edgeproof::report
