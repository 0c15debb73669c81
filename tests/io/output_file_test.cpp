// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

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

namespace {

/// Returns all files and folders in a folder; a folder ends with a slash.
std::set<std::string> all_in(const test::Folder& folder) {
    std::set<std::string> names;
    for (const auto& e : fs::recursive_directory_iterator(folder.path())) {
        names.insert(fs::relative(e.path(), folder.path()).string() +
                     (e.is_directory() ? "/" : ""));
    }
    return names;
}

void fill_folder(const fs::path& folder) {
    make_folder(folder / "figures");
    write_whole(folder / "a.csv", "new");
    write_whole(folder / "figures" / "b.svg", "new");
}

void give_up(const fs::path& folder) {
    fill_folder(folder);
    throw Interrupted();
}

void write_user_file(const fs::path& file) { std::ofstream(file) << "of the user"; }

using Names = std::set<std::string>;
const Names whole{"out/", "out/a.csv", "out/figures/", "out/figures/b.svg"};

} // namespace

TEST_CASE("a folder: no file is there before the end, all are there after it") {
    for (const char* name : {"out", "out/", "./out"}) {
        CAPTURE(name);
        const test::Folder own;
        write_folder(own.path() / name, [&](const fs::path& folder) {
            fill_folder(folder);
            CHECK_FALSE(fs::exists(own.path() / "out"));
        });
        CHECK(all_in(own) == whole);
        CHECK_THROWS_AS(write_folder(own.path() / "other" / name, give_up), Interrupted);
        CHECK(all_in(own) == whole); // the parent folder is removed, too
    }
}

TEST_CASE("a folder whose parent folders are missing: all of them appear at once") {
    for (const char* name : {"x/y/out", "x/y/out/", "x/../x/./y/out"}) {
        CAPTURE(name);
        const test::Folder own;
        write_folder(own.path() / name, [&](const fs::path& folder) {
            fill_folder(folder);
            CHECK_FALSE(fs::exists(own.path() / "x"));
        });
        CHECK(all_in(own) == Names{"x/", "x/y/", "x/y/out/", "x/y/out/a.csv", "x/y/out/figures/",
                                   "x/y/out/figures/b.svg"});
    }
    const test::Folder own;
    write_folder(own.path() / "x" / "out", [&](const fs::path& folder) {
        fill_folder(folder);
        fs::create_directories(own.path() / "x"); // by another process
        write_user_file(own.path() / "x" / "mine");
    });
    CHECK(all_in(own) ==
          Names{"x/", "x/mine", "x/out/", "x/out/a.csv", "x/out/figures/", "x/out/figures/b.svg"});
}

TEST_CASE("a folder: an error while it is written names the requested folder") {
    const test::Folder own;
    write_user_file(own.path() / "file");
    CHECK_THROWS_AS(write_folder(own.path() / "file", fill_folder), InputError);
    CHECK_THROWS_AS(write_folder(own.path() / "file" / "out", fill_folder), InputError);
    try {
        write_folder(own.path() / "out", [](const fs::path& folder) {
            throw InputError("cannot write " + (folder / "a.csv").string(), "x");
        });
        FAIL("no error");
    } catch (const InputError& error) {
        CHECK(error.problem() == "cannot write " + (own.path() / "out" / "a.csv").string());
    }
}

TEST_CASE("a folder that exists: its files are replaced, the other files in it remain") {
    const test::Folder own;
    write_folder(own.path() / "out", fill_folder);
    write_user_file(own.path() / "out" / "mine");
    CHECK_THROWS_AS(write_folder(own.path() / "out", give_up), Interrupted);
    Names with_mine = whole;
    with_mine.insert("out/mine");
    CHECK(all_in(own) == with_mine);
    std::ofstream(own.path() / "out" / "a.csv")
        << "x,y\n1,2\n# program: edgeproof 0.1.0 (commit 1)\n";
    write_folder(own.path() / "out", fill_folder);
    CHECK(test::file_text(own.path() / "out" / "a.csv") == "new");
    CHECK(all_in(own) == with_mine);
}

TEST_CASE("a folder of the user: whatever stands in the way, nothing in it changes") {
    struct Case {
        const char* name;
        std::function<void(const fs::path&)> make; ///< puts it into the folder "out"
    };
    const std::vector<Case> cases{
        {"a file of the user's", [](const fs::path& out) { write_user_file(out / "a.csv"); }},
        {"a later file of the user's",
         [](const fs::path& out) {
             fs::create_directory(out / "figures");
             write_user_file(out / "figures" / "b.svg");
         }},
        {"a folder for a file", [](const fs::path& out) { fs::create_directory(out / "a.csv"); }},
        {"a file for a folder", [](const fs::path& out) { write_user_file(out / "figures"); }},
        {"a link for a file",
         [](const fs::path& out) {
             write_user_file(out / "mine");
             fs::create_symlink("mine", out / "a.csv");
         }},
        {"a dangling link", [](const fs::path& out) { fs::create_symlink("no", out / "a.csv"); }},
        {"a link for a folder",
         [](const fs::path& out) {
             fs::create_directory(out / "mine");
             fs::create_directory_symlink("mine", out / "figures");
         }},
        {"a FIFO", [](const fs::path& out) { ::mkfifo((out / "a.csv").c_str(), 0666); }},
    };
    for (const Case& c : cases) {
        CAPTURE(c.name);
        const test::Folder own;
        fs::create_directory(own.path() / "out");
        c.make(own.path() / "out");
        const Names before = all_in(own);
        CHECK_THROWS_AS(write_folder(own.path() / "out", fill_folder), InputError);
        CHECK(all_in(own) == before);
    }
}

TEST_CASE("a folder: files and folders with names like temporary ones remain") {
    const test::Folder own;
    // No process has this number, because it exceeds the largest on Linux.
    fs::create_directories(own.path() / "out.99999999.tmp" / "figures");
    write_user_file(own.path() / "out.99999999.tmp" / "mine");
    fs::create_directories(own.path() / "mine");
    const std::string own_number = std::to_string(::getpid());
    fs::create_directory_symlink("mine", own.path() / ("out." + own_number + ".tmp"));
    write_user_file(own.path() / ("t.csv." + own_number + ".tmp"));
    write_user_file(own.path() / "t.csv.99999999.tmp");
    const Names before = all_in(own);
    write_folder(own.path() / "out", fill_folder);
    write_folder(own.path() / "out", fill_folder);
    write_whole(own.path() / "t.csv", "new");
    Names after = before;
    after.insert(whole.begin(), whole.end());
    after.insert("t.csv");
    CHECK(all_in(own) == after);
}

TEST_CASE("a folder: files that vanish while it is written are an error, and nothing appears") {
    const std::vector<std::function<void(const fs::path&)>> removals{
        [](const fs::path& folder) { fs::remove(folder / "a.csv"); },
        [](const fs::path& folder) { fs::remove_all(folder); },
        [](const fs::path& folder) {
            fs::remove_all(folder.parent_path());
            write_whole(folder / "c.csv", "new"); // makes its folder anew
        }};
    for (const bool there : {false, true}) {
        for (const auto& remove : removals) {
            const test::Folder own;
            if (there) {
                fs::create_directory(own.path() / "out");
            }
            const Names before = all_in(own);
            CHECK_THROWS_AS(write_folder(own.path() / "out",
                                         [&](const fs::path& folder) {
                                             fill_folder(folder);
                                             remove(folder);
                                         }),
                            InputError);
            CHECK(all_in(own) == before);
        }
    }
}

TEST_CASE("a folder: runs that share it do not fail each other, and no files are mixed") {
    const test::Folder own;
    constexpr int runs = 8;
    std::vector<pid_t> started;
    for (int run = 0; run < runs; ++run) {
        started.push_back(::fork());
        if (started.back() == 0) {
            int failed = 0;
            try {
                for (int time = 0; time < 20; ++time) {
                    write_folder(own.path() / "out", [&](const fs::path& folder) {
                        for (const char* name : {"a", "b", "c", "d"}) {
                            write_whole(folder / name, "the same beginning " + std::to_string(run));
                        }
                    });
                }
            } catch (const std::exception&) {
                failed = 1;
            }
            ::_exit(failed);
        }
    }
    for (const pid_t run : started) {
        int status = -1;
        ::waitpid(run, &status, 0);
        CHECK(status == 0);
    }
    CHECK(all_in(own) == Names{"out/", "out/a", "out/b", "out/c", "out/d"});
    for (const char* name : {"b", "c", "d"}) {
        CHECK(test::file_text(own.path() / "out" / name) ==
              test::file_text(own.path() / "out" / "a"));
    }
}

TEST_CASE("a folder: if one file cannot be moved, the files moved before it are put back") {
    if (::geteuid() != 0) {
        return; // only root can give a file to another user
    }
    const test::Folder own;
    const fs::path out = own.path() / "out";
    fs::create_directory(out);
    fs::permissions(out, fs::perms(01777)); // in it, a user moves only files of his own
    const auto write_as_a_user = [&](const std::vector<std::string>& names, const char* end) {
        const pid_t user = ::fork();
        if (user == 0) {
            int failed = ::setuid(65534);
            try {
                write_folder(out, [&](const fs::path& folder) {
                    make_folder(folder / end);
                    for (const std::string& name : names) {
                        write_whole(folder / name, std::string("the same beginning, ") + end);
                    }
                });
            } catch (const InputError&) {
                failed = 2;
            }
            ::_exit(failed);
        }
        int status = -1;
        ::waitpid(user, &status, 0);
        return WEXITSTATUS(status);
    };
    const std::vector<std::string> old{"a", "b", "c", "d", "e", "f", "g", "h"};
    REQUIRE(write_as_a_user(old, "old") == 0);
    const Names before = all_in(own);
    std::vector<std::string> more = old;
    more.insert(more.end(), {"i", "j", "k", "l", "m", "n"});
    for (const std::string& stuck : old) { // the order of the moves is the file system's
        CAPTURE(stuck);
        REQUIRE(::chown((out / stuck).c_str(), 0, 0) == 0);
        CHECK(write_as_a_user(more, "new") == 2);
        REQUIRE(::chown((out / stuck).c_str(), 65534, 65534) == 0);
        CHECK(all_in(own) == before);
        for (const std::string& name : old) {
            CHECK(test::file_text(out / name) == "the same beginning, old");
        }
    }
    CHECK(write_as_a_user(more, "new") == 0);
}

TEST_CASE("a folder: unchanged by an interruption") {
    const test::Folder own;
    for (const bool there : {false, true}) {
        if (there) {
            fs::create_directory(own.path() / "out");
        }
        const Names before = all_in(own);
        CHECK_THROWS_AS(write_folder(own.path() / "out",
                                     [](const fs::path& folder) {
                                         fill_folder(folder);
                                         request_interruption(2);
                                     }),
                        Interrupted);
        withdraw_interruption();
        CHECK(all_in(own) == before);
    }
}
