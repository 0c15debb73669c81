// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

using namespace edgeproof::test;

namespace {

const std::string header = "id,kind,m,C,a,contact_modulus,quantity,edge,u,value\n";
const std::string hertz_cells = ",power-law,1,1,1,1,";

} // namespace

TEST_CASE("check: control characters in answers are shown, and the report is complete") {
    const Folder folder;
    // Bytes that would cut the report off, clear the screen or imitate a line of the report.
    folder.write("a.csv", header + "1" + hertz_cells + "p,right,0.2,0.3" + std::string(1, '\0') +
                              "\n2" + hertz_cells + "p,right,0.4,\"\x1b[2J\npass: all\xff\"\n" +
                              "3\x1b[2J" + hertz_cells + "p,right,0.4,0.4\n");
    const Outcome o = run(folder, "check a.csv --junit j.xml");
    CHECK(o.code == 1);
    CHECK(has(o.out, "a.csv:2: 1: garbage: \"0.3\\x00\"\n"));
    CHECK(has(o.out, "a.csv:3: 2: garbage: \"\\x1b[2J pass: all\\xff\"\n"));
    CHECK(o.out.find('\0') == std::string::npos);
    CHECK(o.out.find('\x1b') == std::string::npos);
    CHECK(lines(o.out).front() == "FAIL: 3 answers, 2 failures");
    const std::string junit = file_text(folder.path() / "j.xml");
    CHECK(has(junit, "tests=\"4\" failures=\"2\""));
    CHECK(has(junit, "<failure message=\""));
    CHECK(junit.find('\x1b') == std::string::npos);
    CHECK(has(junit, "\\x1b[2J pass: all\\xff"));
}

TEST_CASE(
    "check: the outcome and the cause come first, then five failing rows unless more are asked") {
    const Folder folder;
    std::string text = header;
    for (int k = 1; k <= 9; ++k) { // the exact value is sqrt(u (2 - u))/2
        const double u = k / 16.0;
        text +=
            fmt::format("{},power-law,1,1,1,1,p,right,{},{:.17g}\n", k, u, std::sqrt(u * (2 - u)));
    }
    folder.write("a.csv", text);
    const auto failing_rows = [](const Outcome& o) {
        const auto all = lines(o.out);
        return std::ranges::count_if(all, [](const auto& l) { return l.starts_with("a.csv:"); });
    };
    const Outcome o = run(folder, "check a.csv");
    CAPTURE(o.out);
    REQUIRE(lines(o.out).size() > 8);
    CHECK(lines(o.out)[0] == "FAIL: 9 answers, 9 failures");
    CHECK(lines(o.out)[1].starts_with("p, right edge: yours are 2 times ours, to 1"));
    CHECK(lines(o.out)[2].empty());
    CHECK(lines(o.out)[3].starts_with("a.csv:2: 1: "));
    CHECK(failing_rows(o) == 5);
    CHECK(has(o.out, "and 4 more (--errors shows more of them)"));
    CHECK(failing_rows(run(folder, "check a.csv --errors 7")) == 7);
    const Outcome none = run(folder, "check a.csv --errors 0");
    CHECK(failing_rows(none) == 0);
    CHECK(has(none.out, "\n9 more (--errors shows more of them)"));
}

TEST_CASE("check --exec: the standard error of a program is handed on, and is the cause if nothing "
          "is answered") {
    const Folder folder;
    copy_files(folder);
    const auto check = [&](const std::string& command) {
        return run(folder, "check three.toml --digits 15 --exec '" + command + "'");
    };
    const Outcome loud = check("head -c 300000 /dev/zero >&2; sh hertz.sh");
    CHECK(loud.code == 0);
    CHECK(loud.err.size() > 65536);
    CHECK(loud.err.size() < 66000);
    CHECK(has(loud.err, "the program\'s messages beyond 65536 bytes are left out"));
    const std::string cause = "its standard error begins: no module named scipy";
    CHECK(has(check("echo no module named scipy >&2; exit 1").out,
              "the program answers nothing; " + cause));
    CHECK_FALSE(has(check("echo no module named scipy >&2; sh hertz.sh").out, cause));
}
