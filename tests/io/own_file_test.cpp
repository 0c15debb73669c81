// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/own_file.hpp"

#include "edgeproof/io/output_file.hpp"
#include "edgeproof/io/text_file.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path target = fs::temp_directory_path() / ("edgeproof-own-" + std::to_string(::getpid()));

void write_target(const std::string& text) { std::ofstream(target, std::ios::binary) << text; }

const std::string own_line = "edgeproof 0.2.0 (commit 1; MPFR 4.2.0)";

} // namespace

TEST_CASE("an existing file is replaced only if the program wrote it") {
    struct Case {
        const char* name;
        std::string before;
        std::string text;
        bool replaced;
    };
    const std::string table = "edge,u,x,p,p_bound,route\n";
    const std::vector<Case> cases{
        {"an empty file", "", table, true},
        {"a table with notes", "edge,d\nright,1\n# program: " + own_line + "\n", table, true},
        {"a table without notes", "edge,u,x,p,p_bound,route,local_1\nleft,1\n", table, true},
        {"the same columns, other widths", "| edge  | coefficient |   k |\n| -- |",
         "| edge | coefficient | k |\n", true},
        {"JSON without notes", "{\n \"rows\": [\n  {\n   \"edge\": \"left\"",
         "{\n \"rows\": [\n  {\n   \"edge\": \"right\"", true},
        {"a picture", "<svg xmlns=\"x\">\n<metadata>" + own_line + "</metadata></svg>\n",
         "<svg xmlns=\"x\">\n", true},
        {"another picture", "<svg xmlns=\"x\" width=\"3\"></svg>\n",
         "<svg xmlns=\"x\" width=\"3\">", false},
        {"PNG", "\x89PNG\r\n\x1a\n tEXtSoftware" + own_line + "IEND", "\x89PNG\r\n\x1a\n", true},
        {"another PNG", "\x89PNG\r\n\x1a\n IHDR IEND", "\x89PNG\r\n\x1a\n IHDR IDAT", false},
        {"another PDF", "%PDF-1.7\n% the same head", "%PDF-1.7\n% the same head, new", false},
        {"another table", "x,p\n0,1\n", "x,gap,gap_bound,slip\n", false},
        {"a Makefile that runs the program", "all:\n\tedgeproof verify l.toml --out .\n",
         "all: theorems\n", false},
        {"a README", "# My project\n", "# Conformance pack\n", false},
        {"a paper that quotes a table", "\\documentclass{article}\n% program: " + own_line + "\n",
         "% scene: s.toml\n", false},
        {"another JSON", "{\"mine\": 1}", "{\n \"rows\": []\n}", false},
        {"the name of the program only", "edge\n# edgeproof 0.2.0\n", table, false},
    };
    std::vector<std::string> refused_late; // since only the new text decides
    for (const Case& c : cases) {
        CAPTURE(c.name);
        write_target(c.before);
        if (c.replaced) {
            check_output(target);
            write_whole(target, c.text);
        } else {
            CHECK_THROWS_AS(write_whole(target, c.text), InputError);
            try {
                check_output(target);
                refused_late.emplace_back(c.name);
            } catch (const InputError&) { // before the work
            }
        }
        CHECK((read_text(target, "") == c.text) == c.replaced);
        fs::remove(target);
    }
    CHECK(refused_late ==
          std::vector<std::string>{"another table", "a paper that quotes a table", "another JSON"});
}

TEST_CASE("a name of a file does not lead out of its folder and is no option") {
    for (const std::string name : {"EQ09.M", "fig2a", "residual-hertz-right", "a_b", "_.", "1"}) {
        CHECK(is_file_stem(name));
    }
    CHECK(is_file_stem(std::string(120, 'x')));
    CHECK_FALSE(is_file_stem(std::string(121, 'x')));
    CHECK_FALSE(is_file_stem(std::string_view("a\0b", 3)));
    for (const std::string name :
         {"",    ".",   "..",   "../x",      "/etc/passwd", "a/b", "a\\b", ".hidden",
          "-rf", "a b", "a\nb", "`touch x`", "$(touch x)",  "x;y", "x|y",  "\"",
          "'",   "é",   "\xff", "<b>",       "%s",          "*"}) {
        CAPTURE(name);
        CHECK_FALSE(is_file_stem(name));
    }
}
