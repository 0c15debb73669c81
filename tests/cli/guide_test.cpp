// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/on_terminal.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <regex>

using namespace edgeproof::test;

namespace {

/// A block between ``` lines, and the text of the page before it.
struct CodeBlock {
    std::string language;
    std::vector<std::string> lines;
    std::string before;
};

std::vector<CodeBlock> code_blocks(const std::string& page) {
    std::vector<CodeBlock> blocks;
    std::string before;
    bool within = false;
    for (const std::string& line : lines(page)) {
        if (line.starts_with("```")) {
            within = !within;
            if (within) {
                blocks.push_back({line.substr(3), {}, before});
            }
        } else if (within) {
            blocks.back().lines.push_back(line);
        } else {
            before += line + "\n";
        }
    }
    CHECK_FALSE(within);
    return blocks;
}

/// Returns the lines that a terminal shows in the end, without the line of the progress.
std::vector<std::string> shown_by_terminal(const std::string& written) {
    std::vector<std::string> shown;
    for (std::string line : lines(written)) {
        if (line.ends_with('\r')) {
            line.pop_back();
        }
        const std::size_t cleared = line.rfind("\x1b[K");
        if (cleared == std::string::npos) {
            shown.push_back(line);
        } else if (cleared + 3 < line.size()) {
            shown.push_back(line.substr(cleared + 3));
        }
    }
    return shown;
}

/// True if the printed lines are the lines of the page, where "..." stands for any lines.
bool is_printed(const std::vector<std::string>& page, const std::vector<std::string>& printed) {
    auto at = printed.begin();
    bool skip = false;
    for (auto part = page.begin(); part != page.end();) {
        const auto end = std::find(part, page.end(), "...");
        const auto found = std::search(at, printed.end(), part, end);
        if ((!skip && found != at) || (part != end && found == printed.end())) {
            return false;
        }
        at = found + (end - part);
        skip = end != page.end();
        part = skip ? end + 1 : end;
    }
    return skip || at == printed.end();
}

/// Runs the commands of the page's console blocks, and compares what they write with the page.
/// Returns the number of commands.
std::size_t run_commands(const std::string& page) {
    const Folder folder;
    for (const char* name : {"examples", "verify", "reference"}) {
        std::filesystem::create_directory_symlink(source_dir() / name, folder.path() / name);
    }
    std::filesystem::create_directories(folder.path() / "build/release");
    std::filesystem::create_directory_symlink(program().parent_path(),
                                              folder.path() / "build/release/bin");
    const std::vector<std::string> environment{"TERM=xterm", "NO_COLOR=1",
                                               "PATH=" + program().parent_path().string() + ":" +
                                                   std::getenv("PATH")};
    std::size_t commands = 0;
    for (const CodeBlock& block : code_blocks(page)) {
        if (block.language != "console") {
            continue;
        }
        for (auto line = block.lines.begin(); line != block.lines.end(); ++commands) {
            REQUIRE(line->starts_with("$ "));
            const std::string command = line->substr(2);
            const auto next = std::find_if(line + 1, block.lines.end(), [](const std::string& l) {
                return l.starts_with("$ ");
            });
            const std::vector<std::string> printed = shown_by_terminal(
                written_to_terminal(folder, environment, {"/bin/sh", "-c", command}));
            CAPTURE(command);
            CHECK_MESSAGE(is_printed({line + 1, next}, printed), joined(printed));
            line = next;
        }
    }
    return commands;
}

/// Checks that each TOML and Python block that is preceded by the name of a file is in this file.
std::size_t compare_files(const std::string& page) {
    std::size_t files = 0;
    for (const CodeBlock& block : code_blocks(page)) {
        static const std::regex name("`(examples/[^` ]+\\.(toml|py))`");
        std::string file;
        for (std::sregex_iterator at(block.before.begin(), block.before.end(), name), end;
             at != end; ++at) {
            file = at->str(1);
        }
        if (block.language == "toml" || block.language == "python") {
            CAPTURE(file);
            CHECK(has(file_text(source_dir() / file), joined(block.lines)));
            ++files;
        }
    }
    return files;
}

std::string guide_page(const std::string& name) {
    return file_text(source_dir() / "docs" / "guide" / name);
}

} // namespace

TEST_CASE("lines of a page are compared with those printed; ... stands for any lines") {
    const std::vector<std::string> printed{"a", "b", "c", "b"};
    CHECK(is_printed({"a", "b", "c", "b"}, printed));
    CHECK(is_printed({"a", "...", "b"}, {"a", "c", "b"}));
    CHECK(is_printed({"...", "c", "..."}, printed));
    CHECK(is_printed({"..."}, {}));
    CHECK(is_printed({}, {}));
    CHECK_FALSE(is_printed({}, printed));
    CHECK_FALSE(is_printed({"a", "b"}, printed));
    CHECK_FALSE(is_printed({"b", "..."}, printed));
    CHECK_FALSE(is_printed({"a", "...", "d"}, printed));
    CHECK_FALSE(is_printed({"a", "c", "..."}, printed));
}

TEST_CASE("the README: its commands print what it shows") {
    CHECK(run_commands(file_text(source_dir() / "README.md")) == 1);
}

TEST_CASE("the guide: its commands print what it shows" * doctest::test_suite("slow")) {
    const std::pair<std::string, std::size_t> pages[] = {
        {"start.md", 3}, {"contacts.md", 14}, {"slip-and-stress.md", 10}, {"checks.md", 7}};
    for (const auto& page : pages) {
        CHECK_MESSAGE(run_commands(guide_page(page.first)) == page.second, page.first);
    }
}

TEST_CASE("the guide: the files that it shows are those of examples/") {
    CHECK(compare_files(guide_page("contacts.md")) == 3);
    CHECK(compare_files(guide_page("slip-and-stress.md")) == 1);
    CHECK(compare_files(guide_page("checks.md")) == 3);
}
