// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/inputs.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <string>

using namespace edgeproof::test;

// If a run is stopped (by an interrupt, a kill, a full disk, or because its folder disappears), no
// file is incomplete or wrong, the program writes one line, and the same command completes the work
// later.

namespace {

const std::string former = "edge\n# edgeproof 0.1.0 (former)\n"; // a result of an earlier run

/// The right Hertz pressure, and one that is wrong by a factor: enough work to be stopped.
const std::string stopped_ledger = hertz_head + hertz_right + hertz_wrong;

const std::string tilted_scene = R"toml([profile]
kind = "tilted-flat-and-rounded"
alpha = "1/100"
t = "2/5"
R = "1"
[load]
a = "1"
contact_modulus = "1"
[ask]
edges = ["right"]
u = ["1e-12", "1e-3", "1/7"]
)toml";

/// Returns `count` wrong claims, each of which needs a search for its correction. On a fast machine
/// a run may end before it is stopped; then it is repeated with more claims.
std::string many_claims(int count) {
    std::string all = hertz_head;
    for (int i = 1; i <= count; ++i) {
        all += hertz_claim("wrong-" + std::to_string(i), "Es*C/3*sqrt(a^2-x^2)");
    }
    return all;
}

std::string seconds(int milliseconds) {
    const std::string rest = std::to_string(1000 + milliseconds % 1000);
    return std::to_string(milliseconds / 1000) + "." + rest.substr(1);
}

/// Returns every file under a folder that has its final name, and its text.
std::map<std::string, std::string> files_of(const std::filesystem::path& folder) {
    std::map<std::string, std::string> all;
    if (std::filesystem::exists(folder)) {
        for (auto at = std::filesystem::recursive_directory_iterator(folder);
             at != std::filesystem::recursive_directory_iterator(); ++at) {
            const auto& e = *at;
            if (e.is_directory() && e.path().extension() == ".tmp") {
                at.disable_recursion_pending();
            }
            if (e.is_regular_file() && e.path().extension() != ".tmp") {
                all[std::filesystem::relative(e.path(), folder).string()] = file_text(e.path());
            }
        }
    }
    return all;
}

} // namespace

TEST_CASE("verify --out: stopped at many moments, all files are there or none") {
    int stopped = 0;
    for (int claims = 1; stopped <= 10 && claims < 3000; claims *= 4) {
        const Folder folder;
        folder.write("own.toml", many_claims(claims) + hertz_right);
        REQUIRE(run(folder, "verify own.toml --digits 30 --out whole").code == 0);
        const auto whole = files_of(folder.path() / "whole");
        REQUIRE(whole.size() > 4);
        for (const std::string signal : {"KILL", "INT", "TERM"}) {
            CAPTURE(signal);
            const std::string command = "verify own.toml --digits 30 --out out-" + signal;
            const std::filesystem::path out = folder.path() / ("out-" + signal);
            for (int ms = 5; ms < 300; ms = ms * 6 / 5 + 1) {
                CAPTURE(ms);
                const Outcome o = in_shell(folder, "timeout -s " + signal + " " + seconds(ms) +
                                                       " " + called(command));
                const auto found = files_of(out);
                CHECK((found.empty() || found == whole));
                if (o.code != 0) {
                    ++stopped;
                    CHECK(lines(o.err).size() <= 1);
                }
            }
            REQUIRE(run(folder, command).code == 0);
            CHECK(files_of(out) == whole);
        }
        for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
            CAPTURE(entry.path());
            const bool killed = entry.path().filename().string().starts_with("out-KILL.");
            CHECK((killed || entry.path().extension() != ".tmp")); // only SIGKILL leaves a folder
        }
    }
    CHECK(stopped > 10);
}

TEST_CASE("verify --out: a full disk, and a file in place of a folder, are one line each") {
    const Folder folder;
    folder.write("own.toml", stopped_ledger);
    REQUIRE(run(folder, "verify own.toml --digits 20 --out whole").code == 0);
    const auto whole = files_of(folder.path() / "whole");
    // A limit on the size of files, in blocks of 512 bytes, acts like a full disk.
    for (const char* blocks : {"0", "1", "8", "20"}) {
        CAPTURE(blocks);
        const Outcome o = in_shell(folder, std::string("trap '' XFSZ; ulimit -f ") + blocks + "; " +
                                               called("verify own.toml --digits 20 --out full"));
        CHECK(o.code == 2);
        CHECK(lines(o.err).size() == 1);
        CHECK(o.err.rfind("edgeproof: cannot write full/", 0) == 0);
        CHECK_FALSE(std::filesystem::exists(folder.path() / "full"));
    }
    // The folder is made when everything is ready to be written; a file in its place is noticed
    // then.
    const Outcome gone =
        in_shell(folder, "touch d; " + called("verify own.toml --digits 20 --out d/e"));
    CHECK(gone.code == 2);
    CHECK(lines(gone.err).size() == 1);
    CHECK(gone.err.find("d/e") != std::string::npos);
    CHECK(run(folder, "verify own.toml --digits 20 --out full").code == 0);
    CHECK(files_of(folder.path() / "full") == whole);
}

TEST_CASE("scenes: stopped at many moments, --out is the old file or the whole new one") {
    const Folder folder;
    folder.write("s.toml", tilted_scene + "terms = [2]\ntolerance = \"0.01\"\n");
    for (const std::string command : {"pressure", "expand", "extent"}) {
        const std::string arguments = command + " s.toml --digits 400 --out t.csv";
        REQUIRE(run(folder, arguments).code == 0);
        const std::string whole = file_text(folder.path() / "t.csv");
        folder.write("t.csv", former);
        for (const std::string signal : {"KILL", "INT", "TERM"}) {
            for (int ms = 4; ms < 2000; ms = ms * 4 / 3 + 1) {
                const Outcome o = in_shell(folder, "timeout -s " + signal + " " + seconds(ms) +
                                                       " " + called(arguments));
                const std::string found = file_text(folder.path() / "t.csv");
                CAPTURE(signal);
                CAPTURE(ms);
                CHECK((found == former || found == whole));
                CHECK(lines(o.err).size() <= 1);
            }
        }
        CHECK(run(folder, arguments).code == 0);
        CHECK(file_text(folder.path() / "t.csv") == whole);
    }
}

TEST_CASE("scenes: a full disk, a full pipe and a folder that is not there are one line") {
    const Folder folder;
    folder.write("s.toml", tilted_scene);
    folder.write("t.csv", former);
    for (const char* command :
         {"trap '' XFSZ; ulimit -f 0; P s.toml --out t.csv", "P s.toml --out t.csv/t.csv",
          "P s.toml > /dev/full", "P s.toml --format json > /dev/full"}) {
        CAPTURE(command);
        std::string line = command;
        line.replace(line.find("P "), 1, called("pressure"));
        const Outcome o = in_shell(folder, line);
        CHECK(o.code == 2);
        CHECK(lines(o.err).size() == 1);
        CHECK(file_text(folder.path() / "t.csv") == former);
    }
    CHECK(folder.files() == 2);
}
