// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/staged_folder.hpp"

#include "edgeproof/io/output_file.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

namespace fs = std::filesystem;

namespace {

class OwnFolder {
public:
    OwnFolder()
        : path_(fs::temp_directory_path() / ("edgeproof-staged-" + std::to_string(::getpid()))) {
        fs::create_directories(path_);
    }
    ~OwnFolder() { fs::remove_all(path_); }
    OwnFolder(const OwnFolder&) = delete;
    OwnFolder& operator=(const OwnFolder&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }
    /// Returns all files and folders in it; a folder ends with a slash.
    [[nodiscard]] std::set<std::string> all() const {
        std::set<std::string> names;
        for (const auto& e : fs::recursive_directory_iterator(path_)) {
            names.insert(fs::relative(e.path(), path_).string() + (e.is_directory() ? "/" : ""));
        }
        return names;
    }

private:
    fs::path path_;
};

void fill(const StagedFolder& staged) {
    make_folder(staged.path() / "figures");
    write_whole(staged.path() / "a.csv", "new");
    write_whole(staged.path() / "figures" / "b.svg", "new");
}

std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    std::string text;
    std::getline(in, text);
    return text;
}

using Names = std::set<std::string>;
const Names whole{"out/", "out/a.csv", "out/figures/", "out/figures/b.svg"};

} // namespace

TEST_CASE("a staged folder: no file is there before the commit, all are there after it") {
    for (const char* name : {"out", "out/", "./out"}) {
        CAPTURE(name);
        const OwnFolder own;
        {
            StagedFolder staged(own.path() / name);
            fill(staged);
            CHECK_FALSE(fs::exists(own.path() / "out"));
            staged.commit();
            CHECK(own.all() == whole);
        }
        CHECK(own.all() == whole);
        {
            StagedFolder given_up(own.path() / "other" / name);
            fill(given_up);
        }
        CHECK(own.all() == whole); // the parent folder is removed, too
    }
}

TEST_CASE("a staged folder whose parent folders are missing: all of them appear at once") {
    for (const char* name : {"x/y/out", "x/y/out/", "x/../x/./y/out"}) {
        CAPTURE(name);
        const OwnFolder own;
        {
            StagedFolder staged(own.path() / name);
            fill(staged);
            CHECK_FALSE(fs::exists(own.path() / "x"));
            staged.commit();
        }
        CHECK(own.all() == Names{"x/", "x/y/", "x/y/out/", "x/y/out/a.csv", "x/y/out/figures/",
                                 "x/y/out/figures/b.svg"});
    }
    const OwnFolder own;
    {
        StagedFolder staged(own.path() / "x" / "out");
        fill(staged);
        fs::create_directories(own.path() / "x"); // by another process
        write_whole(own.path() / "x" / "mine", "mine");
        staged.commit();
    }
    CHECK(own.all() ==
          Names{"x/", "x/mine", "x/out/", "x/out/a.csv", "x/out/figures/", "x/out/figures/b.svg"});
}

TEST_CASE("a staged folder: an error while it is filled names the requested folder") {
    const OwnFolder own;
    const StagedFolder staged(own.path() / "out");
    try {
        staged.fill([](const fs::path& folder) {
            throw InputError("cannot write " + (folder / "a.csv").string(), "x");
        });
        FAIL("no error");
    } catch (const InputError& error) {
        CHECK(error.problem() == "cannot write " + (own.path() / "out" / "a.csv").string());
    }
}

TEST_CASE("a staged folder that replaces an existing one: the other files in it remain") {
    const OwnFolder own;
    fs::create_directories(own.path() / "out" / "figures");
    write_whole(own.path() / "out" / "a.csv", "old");
    write_whole(own.path() / "out" / "mine", "mine");
    {
        StagedFolder given_up(own.path() / "out");
        fill(given_up);
        CHECK(text_of(own.path() / "out" / "a.csv") == "old");
    }
    CHECK(own.all() == Names{"out/", "out/a.csv", "out/mine", "out/figures/"});
    {
        StagedFolder staged(own.path() / "out");
        fill(staged);
        staged.commit();
    }
    CHECK(text_of(own.path() / "out" / "a.csv") == "new");
    Names with_mine = whole;
    with_mine.insert("out/mine");
    CHECK(own.all() == with_mine);
}

TEST_CASE("a staged folder: temporary folders of killed runs next to it are removed") {
    const OwnFolder own;
    // No process has this number, because it exceeds the largest on Linux.
    fs::create_directories(own.path() / "out.99999999.tmp" / "figures");
    fs::create_directories(own.path() / "out" / ".edgeproof.99999999.tmp");
    {
        StagedFolder staged(own.path() / "out");
        fill(staged);
        staged.commit();
    }
    CHECK(own.all() == whole);
}

TEST_CASE("a staged folder: unchanged by an interruption; files of killed runs are removed") {
    const OwnFolder own;
    // No process has this number, because it exceeds the largest on Linux.
    fs::create_directories(own.path() / "out.99999999.tmp" / "figures");
    fs::create_directories(own.path() / "out.1.tmp"); // of another live process, which holds it
    const int held = ::open((own.path() / "out.1.tmp").c_str(), O_RDONLY | O_DIRECTORY);
    REQUIRE(::flock(held, LOCK_SH) == 0);
    fs::create_directories(own.path() / "out.2.tmp"); // of an ended process
    StagedFolder staged(own.path() / "out");
    CHECK_FALSE(fs::exists(own.path() / "out.99999999.tmp"));
    CHECK(fs::exists(own.path() / "out.1.tmp"));
    CHECK_FALSE(fs::exists(own.path() / "out.2.tmp"));
    ::close(held);
    fill(staged);
    request_interruption(2);
    CHECK_THROWS_AS(staged.commit(), Interrupted);
    withdraw_interruption();
    CHECK_FALSE(fs::exists(own.path() / "out"));
}

TEST_CASE("a staged folder: errors name the requested folder, and come before the work") {
    const OwnFolder own;
    write_whole(own.path() / "file", "x");
    CHECK_THROWS_AS(StagedFolder(own.path() / "file"), InputError);
    CHECK_THROWS_AS(StagedFolder(own.path() / "file" / "out"), InputError);
    const StagedFolder staged(own.path() / "out");
    const InputError error("cannot write " + (staged.path() / "a.csv").string() + ": full", "x");
    CHECK(staged.with_final_names(error).problem() ==
          "cannot write " + (own.path() / "out" / "a.csv").string() + ": full");
}
