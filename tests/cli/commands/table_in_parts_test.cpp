// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/shell_text.hpp"
#include "tests/cli/tilted_recipe.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::test;

namespace {

std::string table_command(const std::string& options) {
    return "'" + program().string() + "' table r.toml --out t.csv " + options;
}

/// Kills a run after `first` tenths of a millisecond, then again after later and later times, until
/// a run ends by itself; returns the number of killed runs. The times also grow with the number of
/// runs, because a build with sanitizers starts slowly. A run killed after the table is renamed but
/// before its part file is removed leaves both, and the next run completes the work: the end is a
/// table without a part file.
int kill_and_resume(const Folder& folder, int first, int step, const std::string& options) {
    for (int runs = 0;; ++runs) {
        const int slower = 1 + runs / 20;
        const double seconds = (first + runs * step * slower) / 1e4;
        (void)shell_text(folder, "timeout -s KILL " + std::to_string(seconds) + " " +
                                     table_command(options) + " || true");
        if ((std::filesystem::exists(folder.path() / "t.csv") &&
             !std::filesystem::exists(folder.path() / "t.csv.part")) ||
            runs > 200) {
            return runs;
        }
    }
}

/// Interrupts the table of tilted_recipe(contacts) as soon as it has a part file. The number of
/// contacts grows until a run is slow enough. Returns the output; empty if no run could be
/// interrupted.
std::string interrupt_a_table(const Folder& folder, const std::string& options) {
    for (int contacts = 100; contacts < 50000; contacts *= 3) {
        folder.write("r.toml", tilted_recipe(contacts, 40));
        const std::string said = shell_text(
            folder, "(until [ -e t.csv.part ] || [ -e t.csv ]; do sleep 0.01; done; kill -INT $$ "
                    "2>/dev/null) & exec " +
                        table_command(options));
        if (std::filesystem::exists(folder.path() / "t.csv.part")) {
            return said;
        }
        std::filesystem::remove(folder.path() / "t.csv");
    }
    return {};
}

} // namespace

TEST_CASE(
    "table --out: killed at many moments and restarted, it writes the same bytes in the end") {
    int killed = 0;
    // More contacts, if the machine is too fast for a run to be killed.
    for (int contacts = 40; killed == 0 && contacts < 20000; contacts *= 3) {
        const Folder folder;
        folder.write("r.toml", tilted_recipe(contacts, 40));
        const std::string whole = run(folder, "table r.toml --threads 1").out;
        REQUIRE(lines(whole).size() > 400);
        // 0.0040 s, 0.0047 s, ...: the program is killed while it starts, computes, writes.
        killed = kill_and_resume(folder, 40, 7, "--threads 2");
        CHECK(file_text(folder.path() / "t.csv") == whole);
        CHECK(folder.files() == 2); // there is no part file
    }
    CHECK(killed > 0);
}

TEST_CASE(
    "table --out: the part file of a run that was killed at its end is removed by the next run") {
    const Folder folder;
    // Make a part file by an interruption, keep it, and put it next to the whole table again.
    REQUIRE_FALSE(interrupt_a_table(folder, "--threads 1").empty());
    std::filesystem::copy(folder.path() / "t.csv.part", folder.path() / "kept");
    REQUIRE(run(folder, "table r.toml --out t.csv").code == 0);
    const std::string whole = file_text(folder.path() / "t.csv");
    std::filesystem::rename(folder.path() / "kept", folder.path() / "t.csv.part");
    CHECK(run(folder, "table r.toml --out t.csv").code == 0);
    CHECK(file_text(folder.path() / "t.csv") == whole);
    CHECK(folder.files() == 2);
}

TEST_CASE("table --out: killed hundreds of times" * doctest::test_suite("slow")) {
    const Folder folder;
    folder.write("r.toml", tilted_recipe(300, 40));
    const std::string whole = run(folder, "table r.toml --threads 1").out;
    int killed = 0;
    for (int round = 0; round < 10; ++round) {
        killed += kill_and_resume(folder, 100 + 13 * round, 11 + round, "--threads 2");
        CHECK(file_text(folder.path() / "t.csv") == whole);
        std::filesystem::remove(folder.path() / "t.csv");
    }
    CHECK(killed > 50);
}

TEST_CASE("table --out: an interrupt keeps the finished rows; every format continues from them") {
    const Folder folder;
    const std::string said = interrupt_a_table(folder, "--threads 1 --format md");
    CHECK(said.find("interrupted: ") == 0);
    CHECK(said.find(" rows are kept in t.csv.part; the same command goes on from there\n") !=
          std::string::npos);
    CHECK(lines(said).size() == 1);
    CHECK_FALSE(std::filesystem::exists(folder.path() / "t.csv"));
    CHECK(std::filesystem::exists(folder.path() / "t.csv.part"));
    CHECK(run(folder, "table r.toml --out t.csv --format md").code == 0);
    CHECK(file_text(folder.path() / "t.csv") == run(folder, "table r.toml --format md").out);
}

TEST_CASE("table --out: a full disk is one line, no partial file, and the run continues later") {
    const Folder folder;
    folder.write("r.toml", tilted_recipe(20, 40));
    folder.write("t.csv", "old\n");
    // A limit on the size of files, in blocks of 512 bytes, acts like a full disk.
    for (const char* blocks : {"0", "1", "40"}) {
        CAPTURE(blocks);
        const std::string said =
            shell_text(folder, std::string("trap '' XFSZ; ulimit -f ") + blocks + "; " +
                                   table_command("--threads 1"));
        CHECK(said.rfind("edgeproof: cannot write t.csv", 0) == 0);
        CHECK(lines(said).size() == 1);
        CHECK(file_text(folder.path() / "t.csv") == "old\n");
    }
    CHECK(run(folder, "table r.toml --out t.csv").code == 0);
    CHECK(file_text(folder.path() / "t.csv") == run(folder, "table r.toml").out);
    CHECK(folder.files() == 2);
}

TEST_CASE("table --out: a folder that is gone is one line; a recipe that is wrong leaves nothing") {
    const Folder folder;
    std::string said;
    // More contacts, if the table is done before its folder disappears.
    for (int contacts = 200; said.empty() && contacts < 50000; contacts *= 3) {
        folder.write("r.toml", tilted_recipe(contacts, 40));
        said = shell_text(
            folder, "mkdir d; (until [ -e d/t.csv.part ] || [ -e d/t.csv ]; do sleep 0.01; done; "
                    "while [ -e d ]; do rm -rf d; done) & '" +
                        program().string() + "' table r.toml --out d/t.csv --threads 1; wait");
    }
    CHECK(lines(said).size() == 1);
    CHECK(said.find("d/t.csv") != std::string::npos);
    CHECK(folder.files() == 1);
    folder.write("r.toml", tilted_recipe(20, 40) +
                               "[scenes.x]\nu = [\"5\"]\nquantities = [\"p\"]\n"
                               "[scenes.x.profile]\nkind = \"power-law\"\nm = \"1\"\n"
                               "C = \"1\"\n[scenes.x.load]\na = \"1\"\n"
                               "contact_modulus = \"1\"\n");
    const Outcome wrong = run(folder, "table r.toml --out t.csv");
    CHECK(wrong.code == 2);
    CHECK(wrong.err.find("u = 5 from the right edge") != std::string::npos);
    CHECK(folder.files() == 1);
}

TEST_CASE("table: extents as quantities, at each tolerance") {
    const Folder folder;
    folder.write("r.toml", "digits = 10\n[scenes.h]\nedges = [\"right\"]\n"
                           "tolerance = [\"1%\", \"1/10\"]\nquantities = [\"extent_1\", "
                           "\"measure_1\"]\n[scenes.h.profile]\nkind = \"power-law\"\nm = \"1\"\n"
                           "C = \"1\"\n[scenes.h.load]\na = \"1\"\ncontact_modulus = \"1\"\n");
    const Outcome o = run(folder, "table r.toml");
    CAPTURE(o.err);
    CHECK(o.code == 0);
    // p = c_0 sqrt(u (1 - u/2)): 1/sqrt(1 - u/2) - 1 = e, u = 2 (1 - 1/(1 + e)^2).
    CHECK(o.out.find("h:right:tolerance=1/100:extent_1") != std::string::npos);
    CHECK(o.out.find(",extent_1,0.03940790119,") != std::string::npos); // 2 (1 - 1/1.0201)
    CHECK(o.out.find(",extent_1,0.3471074380,") != std::string::npos);  // 2 (1 - 1/1.21)
    CHECK(run(folder, "points r.toml").out.find(",tolerance,") != std::string::npos);
}
