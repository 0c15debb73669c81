// SPDX-License-Identifier: BSD-3-Clause

#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/tables/reference_table.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>

namespace edgeproof::report {
namespace {

constexpr const char* part_key = "part";
constexpr const char* recipe_key = "recipe_sha256";

/// Returns the fact of the head; empty if it is not stated.
std::string stated(const io::Csv& table, const std::string& key) {
    const auto found = std::ranges::find_if(
        table.notes, [&](const std::string& note) { return note.starts_with(key + ": "); });
    return found == table.notes.end() ? "" : found->substr(key.size() + 2);
}

/// True if the head states these facts.
bool states(const io::Csv& table, const std::vector<Fact>& facts) {
    return std::ranges::all_of(
        facts, [&](const Fact& fact) { return stated(table, fact.key) == fact.value; });
}

std::optional<std::pair<std::size_t, std::size_t>> numbers_of(std::string_view text) {
    const std::size_t slash = std::min(text.find('/'), text.size());
    const auto number = io::read_whole<std::size_t>(text.substr(0, slash));
    const auto of = io::read_whole<std::size_t>(text.substr(std::min(slash + 1, text.size())));
    return number && of && *number >= 1 && *number <= *of ? std::optional(std::pair(*number, *of))
                                                          : std::nullopt;
}

} // namespace

PartOfTable part_named(const std::string& text, const std::filesystem::path& recipe) {
    const auto numbers = numbers_of(text);
    if (!numbers) {
        throw InputError("--part " + text + " names no part",
                         "write K/N with 1 <= K <= N, such as --part 1/7");
    }
    return {numbers->first, numbers->second, io::sha256(io::read_text(recipe, "recipe (TOML)"))};
}

std::vector<Fact> facts_of(const PartOfTable& part) {
    return {{part_key, std::to_string(part.number) + "/" + std::to_string(part.of)},
            {recipe_key, part.recipe_sha256}};
}

bool is_complete_part(const std::filesystem::path& file, const PartOfTable& part) {
    std::error_code none;
    if (!std::filesystem::is_regular_file(file, none)) {
        return false;
    }
    std::vector<Fact> facts = facts_of(part);
    facts.push_back({"program", program_line()});
    std::ifstream in(file, std::ios::binary); // no input: it may be replaced
    try {
        const io::Csv table = io::parse_csv(std::string(std::istreambuf_iterator<char>(in), {}),
                                            file.string(), {.keep_faults = true});
        return states(table, facts_of_rows(table)) && states(table, facts);
    } catch (const InputError&) { // it is no table
        return false;
    }
}

std::string merged_parts(const std::vector<std::string>& files) {
    std::map<std::size_t, io::Csv> parts;
    std::size_t of = 0;
    const auto refuse = [](const std::string& file, const std::string& problem) {
        throw InputError(problem, "make the part again by edgeproof table RECIPE --part K/N")
            .at(file, 1);
    };
    for (const std::string& file : files) {
        io::Csv table = io::parse_csv(io::read_text(file, "part of a table (CSV)"), file);
        const auto numbers = numbers_of(stated(table, part_key));
        if (!numbers) {
            refuse(file, "this is no part of a table: its head has no line '# part: K/N'");
        }
        if (!states(table, facts_of_rows(table))) {
            refuse(file, "rows are missing or have changed: the checksum is not that of the head");
        }
        of = parts.empty() ? numbers->second : of;
        const io::Csv& first = parts.empty() ? table : parts.begin()->second;
        const auto same = [&](const char* key) { return stated(table, key) == stated(first, key); };
        if (numbers->second != of || !same(recipe_key) || !same("program") || !same("digits") ||
            !same("rounding") || table.header.cells != first.header.cells) {
            refuse(file, "this is a part of another table than " + files.front());
        }
        if (!parts.emplace(numbers->first, std::move(table)).second) {
            refuse(file, "part " + std::to_string(numbers->first) + " is given twice");
        }
    }
    io::Csv whole = parts.begin()->second;
    whole.rows.clear();
    std::size_t count = 0;
    for (std::size_t k = 1; k <= of; ++k) {
        if (!parts.contains(k)) {
            refuse(files.front(),
                   "part " + std::to_string(k) + " of " + std::to_string(of) + " is not given");
        }
        count += parts.at(k).rows.size();
    }
    for (std::size_t i = 0; i < count; ++i) {
        const std::vector<io::Csv::Row>& rows = parts.at(i % of + 1).rows;
        if (i / of >= rows.size()) {
            refuse(files.front(), "the parts have not the numbers of rows of one table");
        }
        whole.rows.push_back(rows[i / of]);
    }
    std::string text;
    const std::vector<Fact> facts = facts_of_rows(whole);
    for (const std::string& note : whole.notes) {
        const std::string key = note.substr(0, note.find(": "));
        const auto changed = std::ranges::find(facts, key, &Fact::key);
        if (key != part_key && key != recipe_key) {
            text += "# " + (changed == facts.end() ? note : key + ": " + changed->value) + "\n";
        }
    }
    text += csv_line(whole.header.cells);
    for (const io::Csv::Row& row : whole.rows) {
        text += csv_line(row.cells);
    }
    return text;
}

} // namespace edgeproof::report
