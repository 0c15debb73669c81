// SPDX-License-Identifier: BSD-3-Clause
// Outputs to devices, FIFOs, links, descriptors, files with permissions, and places that cannot be
// written.
#include "tests/cli/inputs.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <fstream>
#include <sstream>

using namespace edgeproof::test;
namespace fs = std::filesystem;

namespace {

constexpr const char* output_scene = "[profile]\nkind = \"power-law\"\nm = \"1\"\nC = \"1\"\n"
                                     "[load]\na = \"1\"\ncontact_modulus = \"2\"\n"
                                     "[ask]\nedges = [\"right\"]\nu = [\"2/5\"]\n";
const std::string output_recipe = tilted_recipe(1, 20);

} // namespace

TEST_CASE("--out follows a link, keeps permissions, and leaves no other file") {
    const Folder folder;
    folder.write("in.toml", output_scene);
    folder.write("file", "edge,u,x,p,p_bound,route\nleft,");
    fs::permissions(folder.path() / "file", fs::perms(0640));
    fs::create_directory(folder.path() / "sub");
    fs::create_symlink("../file", folder.path() / "sub" / "link");
    fs::create_symlink("sub/link", folder.path() / "link");
    const std::string expected = run(folder, "pressure in.toml").out;
    REQUIRE(expected.find("\nright,0.4,") != std::string::npos);
    REQUIRE(run(folder, "pressure in.toml --out link").code == 0);
    CHECK(fs::is_symlink(folder.path() / "link"));
    CHECK(fs::is_symlink(folder.path() / "sub" / "link"));
    CHECK(file_text(folder.path() / "file") == expected);
    CHECK((fs::status(folder.path() / "file").permissions() & fs::perms(07777)) == fs::perms(0640));
    CHECK(folder.files() == 4); // in.toml, file, link, sub
    // A dangling link makes its target; a link to itself is refused.
    fs::create_symlink("made", folder.path() / "dangling");
    REQUIRE(run(folder, "pressure in.toml --out dangling").code == 0);
    CHECK(file_text(folder.path() / "made") == expected);
    fs::create_symlink("loop", folder.path() / "loop");
    CHECK(run(folder, "pressure in.toml --out loop").code == 2);
}

TEST_CASE("--out writes to a FIFO, a device and a descriptor as they are") {
    const Folder folder;
    folder.write("in.toml", output_scene);
    folder.write("recipe.toml", output_recipe);
    for (const std::string command : {"pressure in.toml", "table recipe.toml"}) {
        CAPTURE(command);
        const Outcome printed = run(folder, command);
        REQUIRE(printed.code == 0);
        for (const std::string file : {"-", "/dev/stdout", "/proc/self/fd/1", "/dev/fd/1"}) {
            CAPTURE(file);
            const Outcome o = run(folder, command + " --out " + file);
            CHECK(o.code == 0);
            CHECK(o.out == printed.out);
        }
        const Outcome piped =
            in_shell(folder, "mkfifo fifo && (cat fifo > got & " + called(command + " --out fifo") +
                                 "; code=$?; wait; exit $code)");
        CHECK(piped.code == 0);
        CHECK(file_text(folder.path() / "got") == printed.out);
        CHECK(fs::is_fifo(folder.path() / "fifo"));
        CHECK_FALSE(fs::exists(folder.path() / "fifo.part"));
        fs::remove(folder.path() / "fifo");
        // The test makes a device of its own, like /dev/null (only root can).
        const fs::path device = folder.path() / "null";
        if (::mknod(device.c_str(), S_IFCHR | 0666, makedev(1, 3)) == 0) {
            CHECK(run(folder, command + " --out null").code == 0);
            CHECK(fs::is_character_file(device));
            CHECK_FALSE(fs::exists(folder.path() / "null.part"));
            fs::remove(device);
        }
    }
}

TEST_CASE("no temporary folder is needed before the input is read") {
    const Folder folder;
    folder.write("file", "old");
    const Outcome o = in_shell(folder, "TMPDIR=" + (folder.path() / "file").string() + " " +
                                           called("check --junit f.xml a.csv"));
    CHECK(o.code == 2);
    CHECK(has(o.err, "a.csv"));
}

TEST_CASE("no output replaces a file of the user's or an input; a former result is replaced") {
    const Folder folder;
    folder.write("in.toml", output_scene);
    folder.write("recipe.toml", output_recipe);
    folder.write("verdicts.md", "mine");
    folder.write("mine.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"></svg>\n");
    folder.write("ledger.toml", hertz_head + hertz_claim("right", "Es*C/2*sqrt(a^2-x^2)"));
    const bool converts = std::system("command -v rsvg-convert >/dev/null") == 0;
    const std::size_t before = folder.files();
    for (const std::string command :
         {"pressure in.toml --out in.toml", "pressure in.toml --out ledger.toml",
          "plot in.toml --out mine.svg", "verify ledger.toml --digits 10 --out .",
          "pressure in.toml --out verdicts.md"}) {
        CAPTURE(command);
        const Outcome o = run(folder, command);
        CHECK(o.code == 2);
        CHECK(lines(o.err).size() == 1);
    }
    // The refusal comes before the work, which has another error.
    CHECK(has(run(folder, "verify ledger.toml --only none --out .").err, "verdicts.md"));
    CHECK(folder.files() == before);
    CHECK(file_text(folder.path() / "in.toml") == output_scene);
    CHECK(file_text(folder.path() / "verdicts.md") == "mine");
    folder.write("mesh.csv", "x,p\n-1,0\n-0.5,0.8660254\n0,1\n0.5,0.8660254\n1,0\n");
    REQUIRE(run(folder, "table recipe.toml --out answers.csv").code == 0);
    for (const std::string command :
         {"pressure in.toml --out a.csv", "pressure in.toml --out a.csv --no-notes",
          "pressure in.toml --out a.json --format json",
          "pressure in.toml --out a.tex --format tex", "pressure in.toml --out a.md --format md",
          "plot in.toml --out a.svg", "table recipe.toml --out t.csv",
          "verify ledger.toml --digits 10 --out audit",
          "check answers.csv --out c.txt --junit c.xml", "check answers.csv --json --out c.json",
          "compare in.toml mesh.csv --partial --out m.txt",
          "compare in.toml mesh.csv --partial --json --out m.json", "plot in.toml --out a.png",
          "plot in.toml --out a.pdf"}) {
        if (has(command, ".p") && !converts) {
            continue;
        }
        CAPTURE(command);
        CHECK(run(folder, command).code == 0);
        CHECK(run(folder, command).code == 0);
    }
    // Other results begin in another way.
    folder.write("other.toml", output_scene);
    folder.write("wrong.csv", "x,p\n-1,0\n-0.5,1\n0,1\n0.5,1\n1,0\n");
    CHECK(run(folder, "compare other.toml wrong.csv --partial --out m.txt").code == 1);
    CHECK(run(folder, "compare other.toml wrong.csv --partial --json --out m.json").code == 1);
    REQUIRE(run(folder, "check t.csv").code == 0);
    const std::string table = file_text(folder.path() / "t.csv");
    CHECK(run(folder, "check t.csv --out t.csv").code == 2);
    CHECK(file_text(folder.path() / "t.csv") == table);
}

TEST_CASE("a standard output that is full or closed is an error of every command, in one line") {
    const Folder folder;
    folder.write("in.toml", output_scene);
    folder.write("recipe.toml", output_recipe);
    folder.write("mesh.csv", "x,p\n-1,0\n-0.5,0.8660254\n0,1\n0.5,0.8660254\n1,0\n");
    folder.write("ledger.toml", hertz_head + hertz_claim("right", "Es*C/2*sqrt(a^2-x^2)"));
    REQUIRE(run(folder, "table recipe.toml --out recipe.csv").code == 0);
    for (const std::string command :
         {"--version", "--help", "pressure in.toml --digits 5", "expand in.toml --digits 5",
          "relations b1", "table recipe.toml", "table recipe.toml --check", "points recipe.toml",
          "check recipe.csv", "compare in.toml mesh.csv", "compare in.toml mesh.csv --json",
          "verify ledger.toml", "check --ledger ledger.toml",
          "cost in.toml --digits 16 --points 1"}) {
        for (const std::string where : {" > /dev/full", " >&-"}) {
            CAPTURE(command);
            CAPTURE(where);
            const Outcome o = in_shell(folder, called(command) + where);
            CHECK(o.code == 2);
            CHECK(lines(o.err).size() == 1);
            CHECK(has(o.err, "cannot write standard output"));
        }
    }
    // The output file does not become a closed stream.
    const Outcome closed =
        in_shell(folder, called("pressure in.toml --out p.csv") + " <&- >&- 2>&-");
    CHECK(closed.code == 0);
    CHECK(file_text(folder.path() / "p.csv").starts_with("edge,"));
}
