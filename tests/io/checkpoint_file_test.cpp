// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/atomic_file.hpp"
#include "edgeproof/io/checkpoint_file.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path = fs::temp_directory_path() / ("edgeproof-part-" + std::to_string(::getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
};

void write(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

/// Two pieces: items 0, 2 and 3, then 1.
void fill(CheckpointFile& part) {
    if (!part.has(0)) {
        part.add(0, CheckpointFile::body({{0, 1, 0, "zero\nof two lines"}, {2, 2, 1, "two"}}));
    }
    if (!part.has(1)) {
        part.add(1, CheckpointFile::body({{1, 1, 1, "one"}}));
    }
}

std::string all(const CheckpointFile& part) {
    std::string text;
    for (const std::size_t piece : {0U, 1U}) {
        for (const CheckpointFile::Entry& entry : part.piece(piece)) {
            text += std::to_string(entry.index) + std::string(entry.items, '.') +
                    std::string(entry.marked, '!') + entry.text + "|";
        }
    }
    return text;
}

} // namespace

TEST_CASE("a part file returns its complete pieces, wherever it was cut off") {
    const Folder folder;
    const fs::path file = folder.path / "t.part";
    {
        CheckpointFile part(file, 7, 2);
        fill(part);
        CHECK(part.items() == 4);
        CHECK(part.marked() == 2);
    }
    const std::string whole = read_text(file, "part file");
    for (std::size_t size = 0; size <= whole.size(); ++size) {
        write(file, whole.substr(0, size));
        CheckpointFile part(file, 7, 2);
        CAPTURE(size);
        CHECK(part.items() == (size == whole.size() ? 4 : part.has(0) ? 3 : 0));
        fill(part);
        CHECK(all(part) == "0.zero\nof two lines|2..!two|1.!one|");
        CHECK(part.marked() == 2);
        CHECK(read_text(file, "part file") == whole);
    }
}

TEST_CASE("a part file drops pieces that were changed, and work of another kind") {
    const Folder folder;
    const fs::path file = folder.path / "t.part";
    { // closed before it is read
        CheckpointFile part(file, 7, 2);
        fill(part);
    }
    const std::string whole = read_text(file, "part file");
    std::string changed = whole;
    changed[changed.find("two lines")] = 'T';
    write(file, changed);
    CHECK(CheckpointFile(file, 7, 2).items() == 0); // the data after it are not trusted either
    write(file, whole);
    CHECK(CheckpointFile(file, 8, 2).items() == 0);
    // A file of an older version is begun anew, and so is one with a torn first line.
    for (const char* const text :
         {"edgeproof part file 3, 0000000000000007\n0 12 99\n", "edgepr"}) {
        write(file, text);
        CHECK(CheckpointFile(file, 7, 2).items() == 0);
    }
}

TEST_CASE("a part file's checksum holds the number of the piece and its size") {
    const Folder folder;
    const fs::path file = folder.path / "t.part";
    {
        CheckpointFile part(file, 7, 12);
        part.add(1, CheckpointFile::body({{0, 1, 0, "zero"}}));
    }
    const std::string whole = read_text(file, "part file");
    const std::size_t number = whole.find('\n') + 1;
    for (const char* const other : {"2", "0", "11"}) {
        std::string changed = whole;
        changed.replace(number, 1, other);
        write(file, changed);
        CAPTURE(other);
        CHECK(CheckpointFile(file, 7, 12).items() == 0);
    }
    write(file, whole);
    CHECK(CheckpointFile(file, 7, 12).has(1));
}

TEST_CASE("a part file takes no file that is not Edgeproof's, and follows no link") {
    const Folder folder;
    const fs::path file = folder.path / "t.part";
    const auto refused = [&] {
        CHECK_THROWS_WITH_AS(CheckpointFile(file, 7, 2),
                             (file.string() + " is where the work that is done would be kept, and "
                                              "is not a file that Edgeproof made; rename it, or "
                                              "name another output file")
                                 .c_str(),
                             InputError);
    };
    const fs::path notes = folder.path / "notes";
    for (const char* const text :
         {"another file altogether\n", "x", "edgeproof part files of mine"}) {
        write(notes, text);
        fs::copy_file(notes, file);
        refused();
        CHECK(read_text(file, "file") == text);
        fs::remove(file);
        fs::create_symlink(notes, file);
        refused();
        CHECK(read_text(notes, "file") == text);
        CHECK(fs::is_symlink(file));
        fs::remove(file);
    }
    fs::create_symlink(folder.path / "nowhere", file); // a dangling link is refused, too
    refused();
    CHECK_FALSE(fs::exists(folder.path / "nowhere"));
    fs::remove(file);
    fs::create_directory(file);
    refused();
    fs::remove(file);
    REQUIRE(::mkfifo(file.c_str(), 0600) == 0);
    refused();
}

TEST_CASE("a part file removes itself, but not a newer file with its name") {
    const Folder folder;
    const fs::path file = folder.path / "t.part";
    CheckpointFile part(file, 7, 2);
    fs::remove(file);
    write(file, "mine");
    part.remove();
    CHECK(read_text(file, "file") == "mine");
}

TEST_CASE("a part file accepts only complete pieces that it does not have yet") {
    const Folder folder;
    CheckpointFile part(folder.path / "t.part", 7, 2);
    const std::string body = CheckpointFile::body({{0, 1, 0, "zero"}, {2, 1, 1, "two"}});
    CHECK_THROWS_AS(part.add(0, ""), Error);
    CHECK_THROWS_AS(part.add(0, body.substr(0, body.size() - 1)), Error);
    CHECK_THROWS_AS(part.add(2, body), Error);
    part.add(0, body);
    CHECK_THROWS_AS(part.add(0, body), Error);
    CHECK(part.items() == 2);
}

TEST_CASE("a part file that is in use, removed, or in no folder is an error in one line") {
    const Folder folder;
    const fs::path file = folder.path / "t.part";
    CheckpointFile part(file, 7, 2);
    CHECK_THROWS_WITH_AS(
        CheckpointFile(file, 7, 2),
        (file.string() + " is in use; wait for the other run, or name another file").c_str(),
        InputError);
    fs::remove(file);
    CHECK_THROWS_AS(part.add(0, CheckpointFile::body({{0, 1, 0, "zero"}})), InputError);
    CHECK_THROWS_AS(CheckpointFile(folder.path / "nowhere" / "t.part", 7, 2), InputError);
}

TEST_CASE("a file is seen when it is whole, and not before") {
    const Folder folder;
    const fs::path file = folder.path / "t.csv";
    write(file, "the text of the run, old");
    {
        AtomicFile whole(file);
        whole.write("the text of the run, new");
        CHECK(read_text(file, "file") == "the text of the run, old");
    }
    CHECK(read_text(file, "file") == "the text of the run, old");
    {
        AtomicFile whole(file);
        whole.write("the text of the run, new");
        whole.commit();
    }
    CHECK(read_text(file, "file") == "the text of the run, new");
    CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator{}) == 1);
}
