// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/shell_text.hpp"
#include "tests/cli/tilted_recipe.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::test;

namespace {

/// True if Open MPI is installed, and the program was built with it.
bool can_run() {
    const bool here = std::system("mpirun --version 2>/dev/null | grep -q 'Open MPI'") == 0;
    const bool built = std::filesystem::exists(program().parent_path() /
                                               "../lib/edgeproof/mpi/edgeproof_mpi.so") ||
                       std::system(("find '" + program().parent_path().parent_path().string() +
                                    "' -maxdepth 4 -name edgeproof_mpi.so | grep -q .")
                                       .c_str()) == 0;
    if (!here || !built) {
        const std::string why = here ? "built without MPI" : "no mpirun of Open MPI";
        MESSAGE("skipped: ", why);
    }
    return here && built;
}

std::string mpirun(int ranks, const std::string& arguments) {
    // More ranks than cores, and root in a container, must be allowed explicitly. Open MPI's own
    // messages depend on its version; the tests read only the output of the started programs.
    return "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun "
           "--map-by :OVERSUBSCRIBE -n " +
           std::to_string(ranks) + " '" + program().string() + "' " + arguments;
}

/// True if the table was made with nothing on standard output. Open MPI's own warnings (about
/// interfaces that it cannot use), which each rank writes to standard error, are ignored.
bool makes_table(const Folder& folder, int ranks) {
    return shell_text(folder, mpirun(ranks, "table r.toml --out t.csv") +
                                  " 2>/dev/null; echo \"ended with $?\"") == "ended with 0\n";
}

/// Kills one rank with SIGKILL after a wait (a shell command). Returns mpirun's messages and its
/// exit status.
std::string run_and_kill(const Folder& folder, int ranks, int rank, const std::string& wait) {
    return shell_text(
        folder,
        "{ " + mpirun(ranks, "table r.toml --out t.csv") + "; } & here=$PWD; " + wait +
            "; for p in /proc/[0-9]*; do if [ \"$(readlink $p/cwd)\" = \"$here\" ]"
            " && tr '\\0' '\\n' < $p/environ 2>/dev/null | grep -qx "
            "OMPI_COMM_WORLD_RANK=" +
            std::to_string(rank) +
            "; then kill -KILL ${p#/proc/}; fi; done; wait $!; echo \"mpirun ended with $?\"");
}

} // namespace

TEST_CASE("table under mpirun: the same bytes as from one process") {
    if (!can_run()) {
        return;
    }
    const Folder folder;
    folder.write("r.toml", tilted_recipe(30, 30));
    const std::string whole = run(folder, "table r.toml --threads 1").out;
    REQUIRE(lines(whole).size() > 300);
    for (const int ranks : {1, 2, 4}) {
        CAPTURE(ranks);
        CHECK(makes_table(folder, ranks));
        CHECK(file_text(folder.path() / "t.csv") == whole);
        CHECK(folder.files() == 2); // there is no part file
        std::filesystem::remove(folder.path() / "t.csv");
    }
}

TEST_CASE("table under mpirun: a rank that is killed leaves a table that resumes") {
    if (!can_run()) {
        return;
    }
    const Folder folder;
    std::string said;
    // More contacts, if the table is done before the rank is killed.
    for (int contacts = 200; contacts < 20000; contacts *= 3) {
        std::filesystem::remove(folder.path() / "t.csv");
        folder.write("r.toml", tilted_recipe(contacts, 30));
        said = run_and_kill(folder, 3, 2,
                            "until [ -e t.csv.part ] || [ -e t.csv ]; do sleep 0.01; done; sleep "
                            "0.1");
        if (!std::filesystem::exists(folder.path() / "t.csv")) {
            break;
        }
    }
    CAPTURE(said);
    CHECK(has(said, "mpirun ended with 137")); // 128 + SIGKILL
    CHECK(std::filesystem::exists(folder.path() / "t.csv.part"));
    CHECK(makes_table(folder, 2));
    CHECK(file_text(folder.path() / "t.csv") == run(folder, "table r.toml").out);
    CHECK(folder.files() == 2);
}

TEST_CASE("table under mpirun: any rank killed, many times" * doctest::test_suite("slow")) {
    if (!can_run()) {
        return;
    }
    const Folder folder;
    folder.write("r.toml", tilted_recipe(400, 30));
    const std::string whole = run(folder, "table r.toml --threads 1").out;
    const char* const after[] = {"0.8", "1.0", "1.3", "1.7", "2.2"};
    for (int rank = 0; rank < 4; ++rank) {
        for (const char* seconds : after) {
            (void)run_and_kill(folder, 4, rank, std::string("sleep ") + seconds);
        }
        CHECK(makes_table(folder, 2));
        CAPTURE(rank);
        CHECK(file_text(folder.path() / "t.csv") == whole);
        CHECK(folder.files() == 2);
        std::filesystem::remove(folder.path() / "t.csv");
    }
}

TEST_CASE("table under mpirun: an error is reported once") {
    if (!can_run()) {
        return;
    }
    const Folder folder;
    std::string wrong = tilted_recipe(20, 30);
    wrong.replace(wrong.find("1/9"), 3, "300");
    folder.write("r.toml", wrong);
    const std::string alone = run(folder, "table r.toml --out t.csv").err;
    CHECK(alone.rfind("r.toml:4: u = 300 from the right edge", 0) == 0);
    for (const char* recipe_file : {"r.toml", "nothing.toml"}) {
        const std::string said =
            shell_text(folder, mpirun(3, std::string("table ") + recipe_file + " --out t.csv"));
        const std::string line = run(folder, std::string("table ") + recipe_file).err;
        CHECK(said.find(line) != std::string::npos);
        CHECK(said.find(line) == said.rfind(line));
    }
    CHECK(shell_text(folder, mpirun(2, "table r.toml")).find("add --out FILE") !=
          std::string::npos);
    CHECK(folder.files() == 1);
}

TEST_CASE("a table is not begun by several processes that cannot find each other") {
    const Folder folder;
    folder.write("r.toml", tilted_recipe(2, 30));
    const std::string said = shell_text(folder, "OMPI_COMM_WORLD_SIZE=2 '" + program().string() +
                                                    "' table r.toml --out t.csv");
    CHECK(said.rfind("edgeproof: started as one of 2 processes, and ", 0) == 0);
    CHECK(lines(said).size() == 1);
    CHECK(folder.files() == 1);
}
