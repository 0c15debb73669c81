// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/io/output_file.hpp"

#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <set>
#include <string>

namespace {

/// The documented rule, without the program's functions.
bool stays_in_its_folder(const std::string& name) {
    const std::string allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.";
    return !name.empty() && name.size() <= 120 && name[0] != '.' && name[0] != '-' &&
           name.find_first_not_of(allowed) == std::string::npos;
}

} // namespace

TEST_CASE("a name of a file: ids of the usual form are their own names") {
    for (const std::string id : {"EQ09.M", "fig2a", "residual-hertz-right", "a_b", "_.", "1"}) {
        CHECK(FileStem(id).text() == id);
    }
    CHECK(FileStem("EQ09.M").with(".svg") == "EQ09.M.svg");
    CHECK(FileStem(std::string(120, 'x')).text() == std::string(120, 'x'));
}

TEST_CASE("a name of a file: no id leads out of the folder or is read as an option") {
    for (const std::string id : {"",
                                 ".",
                                 "..",
                                 "../x",
                                 "../../etc/passwd",
                                 "/etc/passwd",
                                 "a/b",
                                 "a\\b",
                                 ".hidden",
                                 "-rf",
                                 "a b",
                                 "a\nb",
                                 "`touch x`",
                                 "$(touch x)",
                                 "x;y",
                                 "x|y",
                                 "\"",
                                 "'",
                                 "é",
                                 "\xff",
                                 "a\tb",
                                 "<b>",
                                 "%s",
                                 "*"}) {
        CAPTURE(id);
        CHECK(stays_in_its_folder(FileStem(id).text()));
    }
    CHECK(stays_in_its_folder(FileStem(std::string("a\0b", 3)).text()));
    CHECK(stays_in_its_folder(FileStem(std::string(100'000, 'x')).text()));
    CHECK(stays_in_its_folder(FileStem().text()));
}

TEST_CASE("a name of a file: different ids have different names") {
    std::set<std::string> ids{"a/b", "a-b", "a b", "a\\b", "", "_", ".", "..", "-", "--"};
    for (const std::string& id : std::set<std::string>(ids)) {
        ids.insert(FileStem(id).text()); // a changed name may be another id
        ids.insert(id + std::string(200, 'x'));
        ids.insert(id + std::string(201, 'x'));
    }
    std::uint64_t state = 30; // random ids of three characters
    const std::string characters = "ab/.-_ \"'`\\$";
    for (int i = 0; i < 3000; ++i) {
        std::string id;
        for (int k = 0; k < 3; ++k) {
            state = state * 6364136223846793005ULL + 1442695040888963407ULL;
            id += characters[(state >> 33U) % characters.size()];
        }
        ids.insert(id);
    }
    std::set<std::string> names;
    for (const std::string& id : ids) {
        CAPTURE(id);
        CHECK(stays_in_its_folder(FileStem(id).text()));
        CHECK(names.insert(FileStem(id).text()).second);
    }
}
