// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/table.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <regex>

using namespace edgeproof::test;

namespace {

// The heads of refusals.txt and answers.txt describe their rows.

const std::filesystem::path cli_tests = source_dir() / "tests" / "cli";

/// Returns the cells of each row of a table.
std::vector<std::vector<std::string>> rows_of(const char* table) {
    std::vector<std::vector<std::string>> rows;
    for (const TableLine& line : table_lines(std::string("cli/") + table)) {
        rows.push_back(parts(line.text, " | "));
    }
    return rows;
}

/// Makes the edits {N: TEXT}{N-M: TEXT} in a file of the folder.
void edit(const Folder& folder, const std::string& file, const std::string& edits) {
    static const std::regex one(R"(\{(\d+)(-(\d+))?: (.*?)\}(?=\{\d|$))");
    for (std::sregex_iterator at(edits.begin(), edits.end(), one), end; at != end; ++at) {
        std::vector<std::string> text = lines(file_text(folder.path() / file));
        const auto first = std::stol(at->str(1)) - 1;
        const auto last = at->str(3).empty() ? first + 1 : std::stol(at->str(3));
        REQUIRE(first <= static_cast<long>(text.size()));
        text.erase(text.begin() + first,
                   text.begin() + std::min(last, static_cast<long>(text.size())));
        const std::string instead = std::regex_replace(at->str(4), std::regex(R"(\\n)"), "\n");
        const std::vector<std::string> added = lines(instead);
        text.insert(text.begin() + first, added.begin(), added.end());
        folder.write(file, joined(text));
    }
}

/// Makes the edits of the files that the command names; returns the command without them.
std::string edited(const Folder& folder, std::string command) {
    static const std::regex file(
        R"(([\w.-]+\.(toml|csv))((\{\d+(-\d+)?: .*?\}(?=[\{ ]|$))+)(?= |$))");
    for (std::smatch found; std::regex_search(command, found, file);) {
        edit(folder, found[1], found[3]);
        command = found.prefix().str() + found.str(1) + found.suffix().str();
    }
    return command;
}

/// Returns the commands of a row: every command that reads the file, if there is only a file.
std::vector<std::string> commands_of(const std::string& command) {
    const std::vector<std::string> scene{"pressure ", "expand ", "extent "};
    if (command.find(' ') != std::string::npos || !command.ends_with(".toml")) {
        return {command};
    }
    if (command == "recipe.toml") {
        return {"table recipe.toml", "points recipe.toml", "check recipe.toml --exec cat"};
    }
    if (command == "ledger.toml") {
        return {"verify ledger.toml", "check --ledger ledger.toml"};
    }
    std::vector<std::string> all;
    for (const std::string& each : scene) {
        all.push_back(each + command);
    }
    return all;
}

void check_refusal(const Folder& folder, const std::string& command, const std::string& place,
                   const std::string& words) {
    CAPTURE(command);
    const std::size_t files = folder.files();
    const Outcome o = run(folder, command);
    CAPTURE(o.err);
    CHECK(o.code == 2);
    CHECK(o.out.empty());
    CHECK(folder.files() == files);
    REQUIRE(lines(o.err).size() == 1);
    CHECK(o.err.starts_with(place + ": "));
    CHECK(has(o.err, words));
    CHECK(o.err.size() < 1500);
    CHECK_MESSAGE(std::regex_search(o.err, std::regex("[^;]+; .*[a-z]")), "no remedy");
    for (const char c : o.err.substr(0, o.err.size() - 1)) {
        CHECK((static_cast<unsigned char>(c) >= 0x20U && c != '\x7f'));
    }
}

/// True if the line LINE is printed, or LINE... begins one, or the file of >FILE WORDS has WORDS.
bool is_written(const Folder& folder, const std::vector<std::string>& printed, std::string line) {
    if (line.starts_with('>')) {
        const std::size_t blank = line.find(' ');
        return has(file_text(folder.path() / line.substr(1, blank - 1)), line.substr(blank + 1));
    }
    const bool begins = line.ends_with("...");
    line.resize(line.size() - (begins ? 3 : 0));
    return std::ranges::any_of(printed, [&](const std::string& other) {
        return begins ? other.starts_with(line) : other == line;
    });
}

} // namespace

TEST_CASE("refusals: one line with the place, the error and the remedy; exit 2; no file") {
    const Folder folder;
    const auto rows = rows_of("refusals.txt");
    CHECK(rows.size() > 200);
    for (const auto& row : rows) {
        CAPTURE(row[0]);
        REQUIRE(row.size() == 2);
        const std::size_t colon = row[1].find(": ");
        REQUIRE(colon != std::string::npos);
        copy_files(folder);
        for (const std::string& command : commands_of(edited(folder, row[0]))) {
            check_refusal(folder, command, row[1].substr(0, colon), row[1].substr(colon + 2));
        }
    }
}

TEST_CASE("answers: the lines that each command writes, by closed forms") {
    const auto rows = rows_of("answers.txt");
    CHECK(rows.size() > 90);
    for (const auto& row : rows) {
        const Folder folder;
        CAPTURE(row[0]);
        REQUIRE(row.size() > 1);
        copy_files(folder);
        const Outcome o = run(folder, edited(folder, row[0]));
        CAPTURE(o.err);
        const bool fails = row[1] == "exit 1";
        CHECK(o.code == (fails ? 1 : 0));
        CHECK(o.err.empty());
        const std::vector<std::string> printed = lines(o.out);
        for (auto cell = row.begin() + (fails ? 2 : 1); cell != row.end(); ++cell) {
            const bool absent = cell->starts_with('!');
            CHECK_MESSAGE(is_written(folder, printed, cell->substr(absent ? 1 : 0)) != absent,
                          *cell);
        }
    }
}

TEST_CASE("refusals: deep, long and binary input") {
    const Folder folder;
    const std::string flat = file_text(cli_tests / "files" / "flat.toml");
    const auto with_a = [&](const std::string& a) {
        return std::string(flat).replace(flat.find("\"1\"\ncon"), 3, "\"" + a + "\"");
    };
    const std::string recipe = file_text(cli_tests / "files" / "recipe.toml");
    const std::string ledger = file_text(cli_tests / "files" / "ledger.toml");
    struct Bad {
        std::string file;
        std::string text;
        int line;
        std::string words;
    };
    for (const Bad& bad : {
             Bad{"flat.toml", with_a(repeated("sqrt(2)+", 300) + "1-300*sqrt(2)-1"), 6, "[...]"},
             Bad{"flat.toml", with_a(repeated("1+", 8000) + "y"), 6, "[...]"},
             Bad{"flat.toml", "x" + repeated(".x", 50'000) + " = 1\n", 1, "32 levels deep"},
             Bad{"flat.toml", flat + "x = " + repeated("[", 50'000) + "\n", 12,
                 "nested value depth"},
             Bad{"flat.toml", "title = \"\\u001b[31m\"\n" + flat, 1, "control character"},
             Bad{"flat.toml", flat + "\"\x1b[31m\" = 1\n", 12, "not TOML"},
             Bad{"recipe.toml", recipe + repeated("x.", 50'000) + "x = 1\n", 8, "32 levels deep"},
             Bad{"ledger.toml", ledger + repeated("y.", 50'000) + "y = 1\n", 21, "32 levels deep"},
         }) {
        folder.write(bad.file, bad.text);
        for (const std::string& command : commands_of(bad.file)) {
            check_refusal(folder, command, bad.file + ":" + std::to_string(bad.line), bad.words);
        }
    }
}

TEST_CASE("refusals: a folder is not a missing file, and endless files are refused") {
    const Folder folder;
    std::filesystem::create_directory(folder.path() / "dir");
    for (const std::string command :
         {"pressure", "expand", "extent", "table", "points", "check", "verify", "check --ledger"}) {
        check_refusal(folder, command + " dir", "dir", "this is a folder, not a file");
        check_refusal(folder, command + " none", "none", "there is no such file");
        if (command != "check") {
            check_refusal(folder, command + " /dev/zero", "/dev/zero", "more than 10000000");
        }
    }
}
