// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/tables/table_in_parts.hpp"

#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/tables/reference_table.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>

namespace edgeproof::report {
namespace {

constexpr std::string_view part_key = "part";
constexpr std::string_view recipe_key = "recipe_sha256";

/// A table in CSV, line by line.
struct Lines {
    std::vector<std::string> head; ///< the notes before the rows
    std::string columns;
    std::vector<std::string> rows;

    explicit Lines(std::istream&& in) {
        for (std::string line; std::getline(in, line);) {
            if (columns.empty() && line.starts_with("#")) {
                head.push_back(line);
            } else if (columns.empty()) {
                columns = line;
            } else {
                rows.push_back(line);
            }
        }
    }
    [[nodiscard]] std::string fact(std::string_view key) const {
        const std::string begin = "# " + std::string(key) + ": ";
        const auto found =
            std::ranges::find_if(head, [&](const std::string& s) { return s.starts_with(begin); });
        return found == head.end() ? "" : found->substr(begin.size());
    }
    [[nodiscard]] std::string checksum() const {
        std::uint64_t hash = io::fnv1a(columns + "\n");
        for (const std::string& row : rows) {
            hash = io::fnv1a(row + "\n", hash);
        }
        return checksum_text(hash);
    }
    [[nodiscard]] bool whole() const {
        return fact("rows") == std::to_string(rows.size()) && fact(checksum_key) == checksum();
    }
};

std::optional<std::pair<std::size_t, std::size_t>> numbers_of(std::string_view text) {
    std::size_t number = 0;
    std::size_t of = 0;
    const char* const end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, number);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != '/') {
        return std::nullopt;
    }
    const auto second = std::from_chars(first.ptr + 1, end, of);
    if (second.ec != std::errc() || second.ptr != end || number < 1 || number > of) {
        return std::nullopt;
    }
    return std::pair(number, of);
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
    return {{std::string(part_key), std::to_string(part.number) + "/" + std::to_string(part.of)},
            {std::string(recipe_key), part.recipe_sha256}};
}

bool is_complete_part(const std::filesystem::path& file, const PartOfTable& part) {
    std::error_code none;
    if (!std::filesystem::is_regular_file(file, none)) {
        return false;
    }
    const Lines lines(std::ifstream{file}); // no input: it may be replaced
    return lines.whole() && lines.fact("program") == program_line() &&
           std::ranges::all_of(facts_of(part), [&](const Fact& fact) {
               return lines.fact(fact.key) == fact.value;
           });
}

std::string merged_parts(const std::vector<std::string>& files) {
    std::map<std::size_t, Lines> parts;
    std::size_t of = 0;
    const auto refuse = [](const std::string& file, const std::string& problem) {
        throw InputError(problem, "make the part again by edgeproof table RECIPE --part K/N")
            .at(file, 1);
    };
    for (const std::string& file : files) {
        Lines lines(std::istringstream{io::read_text(file, "part of a table (CSV)")});
        const auto numbers = numbers_of(lines.fact(part_key));
        if (!numbers) {
            refuse(file, "this is no part of a table: its head has no line '# part: K/N'");
        }
        if (!lines.whole()) {
            refuse(file, "rows are missing or have changed: the checksum is not that of the head");
        }
        of = parts.empty() ? numbers->second : of;
        const auto same = [&](std::string_view key) {
            return parts.empty() || lines.fact(key) == parts.begin()->second.fact(key);
        };
        if (numbers->second != of || !same(recipe_key) || !same("program") || !same("digits") ||
            !same("rounding") ||
            (!parts.empty() && lines.columns != parts.begin()->second.columns)) {
            refuse(file, "this is a part of another table than " + files.front());
        }
        if (!parts.emplace(numbers->first, std::move(lines)).second) {
            refuse(file, "part " + std::to_string(numbers->first) + " is given twice");
        }
    }
    std::size_t count = 0;
    std::size_t estimates = 0;
    for (std::size_t k = 1; k <= of; ++k) {
        const auto found = parts.find(k);
        if (found == parts.end()) {
            refuse(files.front(),
                   "part " + std::to_string(k) + " of " + std::to_string(of) + " is not given");
        }
        count += found->second.rows.size();
        estimates += static_cast<std::size_t>(std::stoull(found->second.fact("estimates")));
    }
    Lines whole = parts.begin()->second;
    whole.rows.clear();
    for (std::size_t i = 0; i < count; ++i) {
        const std::vector<std::string>& rows = parts.at(i % of + 1).rows;
        if (i / of >= rows.size()) {
            refuse(files.front(), "the parts have not the numbers of rows of one table");
        }
        whole.rows.push_back(rows[i / of]);
    }
    const std::map<std::string, std::string> changed{{"rows", std::to_string(count)},
                                                     {"estimates", std::to_string(estimates)},
                                                     {std::string(checksum_key), whole.checksum()}};
    std::string text;
    for (const std::string& line : whole.head) {
        const std::string key =
            line.substr(2, line.find(':') - std::min<std::size_t>(2, line.find(':')));
        if (key == part_key || key == recipe_key) {
            continue;
        }
        const auto found = changed.find(key);
        text += (found == changed.end() ? line : "# " + key + ": " + found->second) + "\n";
    }
    text += whole.columns + "\n";
    for (const std::string& row : whole.rows) {
        text += row + "\n";
    }
    return text;
}

} // namespace edgeproof::report
