// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/io/text_file.hpp"

#include "edgeproof/precision/error.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <stdexcept>

namespace {

std::string said_of(const std::filesystem::path& file, std::size_t most) {
    try {
        (void)read_text(file, "scene (TOML)", most);
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing";
}

template <class Thrown> std::string placed(const Thrown& thrown) {
    try {
        at_place("f.toml", 3, [&] { throw thrown; });
    } catch (const std::exception& error) {
        return error.what();
    }
    return "nothing";
}

class OfItsOwn : public Error {
public:
    using Error::Error;
};

} // namespace

TEST_CASE("read_text: returns a whole file, or the reason why it cannot be read") {
    const test::Folder own;
    const std::filesystem::path& folder = own.path();
    for (const std::size_t size : {0U, 1U, 65535U, 65536U, 65537U, 200000U}) {
        const std::string text(size, 'x');
        std::ofstream(folder / "file") << text;
        CHECK(read_text(folder / "file", "file", size) == text);
        if (size > 0) {
            CHECK(said_of(folder / "file", size - 1) ==
                  (folder / "file").string() + ": the file holds more than " +
                      std::to_string(size - 1) + " bytes; give the path of a scene (TOML)");
        }
    }
    CHECK(said_of(folder, 10) ==
          folder.string() + ": this is a folder, not a file; give the path of a scene (TOML)");
    CHECK(said_of(folder / "none", 10) ==
          (folder / "none").string() + ": there is no such file; give the path of a scene (TOML)");
    std::filesystem::create_symlink("none", folder / "link");
    CHECK(said_of(folder / "link", 10) ==
          (folder / "link").string() +
              ": this is a link to a file that is not there; give the path of a scene (TOML)");
    REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
    CHECK(said_of(folder / "pipe", 10) == (folder / "pipe").string() +
                                              ": this is a named pipe, not a file; read it as "
                                              "standard input: - < " +
                                              (folder / "pipe").string());
    std::array<int, 2> ends{};
    REQUIRE(::pipe(ends.data()) == 0);
    REQUIRE(::write(ends[1], "text", 4) == 4);
    ::close(ends[1]);
    CHECK(read_text("/dev/fd/" + std::to_string(ends[0]), "file") == "text");
    ::close(ends[0]);
    CHECK(said_of("/dev/zero", 1000).find("/dev/zero: the file holds more than 1000 bytes; ") == 0);
    CHECK(read_text("/dev/null", "file").empty());
}

TEST_CASE("at_place: Edgeproof's errors get the file, the line and advice; others are unchanged") {
    CHECK(at_place("f.toml", 3, [] { return 7; }) == 7);
    CHECK(placed(InputError("a", "b")) == "f.toml:3: a; b");
    CHECK(placed(InputError("a", "b").at("g.toml", 5)) == "g.toml:5: a; b");
    CHECK(placed(InputError("a", "")).find("f.toml:3: a; ") == 0);
    CHECK(placed(DomainError("log of 0")).find("f.toml:3: log of 0; give ") == 0);
    CHECK(placed(BudgetError("4096 bits")).find("f.toml:3: 4096 bits; ask ") == 0);
    CHECK(placed(Error("no meaning")).find("f.toml:3: no meaning; write ") == 0);
    CHECK(placed(OfItsOwn("stopped")) == "stopped");
    CHECK(placed(std::runtime_error("x")) == "x");
}

TEST_CASE("SHA-256: the examples of FIPS 180") {
    // These are the examples of FIPS 180-2, appendix B; the empty text is from NIST's example
    // values.
    CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
          "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    CHECK(sha256(std::string(1'000'000, 'a')) ==
          "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}
