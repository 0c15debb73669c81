// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

using namespace edgeproof::test;

namespace {

const std::string header = "id,kind,m,C,a,contact_modulus,quantity,edge,u,value\n";
const std::string hertz_cells = ",power-law,1,1,1,1,";

bool have_python() { return std::system("python3 -c '' >/dev/null 2>&1") == 0; }

std::string third_party(const char* file) {
    return "'" + (source_dir() / "examples" / "third-party" / file).string() + "'";
}

} // namespace

TEST_CASE("check: pass and fail against a target, the worst case of each regime named") {
    const Folder folder;
    // The exact values are 0.3 and 0.4 (3-4-5 triangle); the second one is wrong in its seventh
    // digit.
    folder.write("a.csv", header + "one" + hertz_cells + "p,right,0.2,0.3\ntwo" + hertz_cells +
                              "p,left,0.4,0.40000004\n");
    const Outcome pass = run(folder, "check a.csv --digits 6.9");
    CHECK(pass.code == 0);
    CHECK(pass.err.empty());
    CHECK(lines(pass.out).front() == "pass: 2 answers, 0 failures");
    const Outcome fail = run(folder, "check a.csv --digits 7.1 --junit j.xml");
    CHECK(fail.code == 1);
    CHECK(lines(fail.out).front() == "FAIL: 2 answers, 1 failure");
    CHECK(lines(fail.out).at(2) == "a.csv:3: two: 7.0 digits, 7.2e+08 ulps: 0.40000004 for "
                                   "0.40000000000000000000 (condition number 2.9: which does not "
                                   "explain it)");
    CHECK(has(fail.out, "interior          2       1          0"));
    const std::string junit = file_text(folder.path() / "j.xml");
    CHECK(has(junit, "tests=\"3\" failures=\"1\""));
    CHECK(has(junit, "name=\"two\">\n    <failure message=\"7.0 digits"));
    CHECK(run(folder, "check a.csv --ulps 1").code == 1);
    // The default target is 12 digits.
    const Outcome none = run(folder, "check a.csv");
    CHECK(none.code == 1);
    CHECK(has(none.out, "target: 12 digits, or an error that the conditioning explains (none is "
                        "stated: --digits or --ulps)"));
}

TEST_CASE("check: nan, inf, nothing and garbage fail, each named, and --errors caps the list") {
    const Folder folder;
    folder.write("a.csv", header + "1" + hertz_cells + "p,right,0.2,nan\n2" + hertz_cells +
                              "p,right,0.4,-inf\n3" + hertz_cells + "p,left,0.4,\n4" + hertz_cells +
                              "p,left,0.2,0.3 MPa\n5" + hertz_cells +
                              "P,,,0.785398163397448\nAborted\n");
    const Outcome o = run(folder, "check a.csv");
    CHECK(o.code == 1);
    for (const char* line :
         {"a.csv:2: 1: nan\n", "a.csv:3: 2: inf\n", "a.csv:4: 3: missing: the value is empty\n",
          "a.csv:5: 4: garbage: \"0.3 MPa\"\n",
          "a.csv:7: garbage: 1 cells, not 10: \"Aborted\"\n"}) {
        CAPTURE(line);
        CHECK(has(o.out, line));
    }
    CHECK(lines(o.out).front() == "FAIL: 5 answers, 4 failures, 1 fault of the rows or the "
                                  "program");
    CHECK(has(run(folder, "check a.csv --errors 2").out, "and 3 more"));
}

TEST_CASE("check: answers in UTF-16; marks between thousands are refused with what to write") {
    const Folder folder;
    const std::string text =
        header + "1" + hertz_cells + "p,right,0.2,0.3\n2" + hertz_cells + "p,right,0.4,0.4\n";
    std::string bytes = "\xFF\xFE";
    for (const char c : text) {
        bytes += {c, '\0'};
    }
    folder.write("a.csv", text);
    folder.write("wide.csv", bytes);
    const Outcome plain = run(folder, "check a.csv");
    CHECK(plain.code == 0);
    CHECK(run(folder, "check wide.csv").out == plain.out);
    CHECK(run(folder, "check wide.csv --only '*'").code == 0);
    folder.write("a.csv", header + "1" + hertz_cells + "p,right,0.2,\"1,234.5\"\n2" + hertz_cells +
                              "p,right,0.4,\"1,234\"\n");
    const Outcome marks = run(folder, "check a.csv");
    CHECK(marks.code == 1);
    CHECK(has(marks.out, "garbage: \"1,234.5\" (a mark between thousands; write 1234.5)\n"));
    CHECK(has(marks.out, "garbage: \"1,234\" (a mark between thousands, or a decimal one; write "
                         "1234 or 1.234)\n"));
}

TEST_CASE("check: text next to a number never passes, and the report is complete") {
    const Folder folder;
    const char* const spoilt[] = {
        "\"0.3\"999", "\"0.3\" NaN (diverged)", "++0.3", "+-0.3", "0.3\"", "\"0.3", "0.3 0.3"};
    for (const char* value : spoilt) {
        CAPTURE(value);
        folder.write("a.csv", header + "1" + hertz_cells + "p,right,0.2," + value + "\n");
        const Outcome o = run(folder, "check a.csv");
        CHECK(o.code != 0);
        CHECK_FALSE(has(o.out, "pass:"));
    }
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
    CHECK(junit.find('\x1b') == std::string::npos);
    CHECK(has(junit, "\\x1b[2J pass: all\\xff"));
}

TEST_CASE("check: the counts of the last line add up to the number of questions") {
    const Folder folder;
    folder.write("r.toml", "[scenes.h]\nu = [\"0.25\", \"0.5\", \"0.75\", \"1\"]\nquantities = "
                           "[\"p\"]\n[scenes.h.profile]\nkind = \"power-law\"\nm = \"1\"\nC = "
                           "\"1\"\n[scenes.h.load]\na = \"1\"\ncontact_modulus = \"1\"\n");
    // One answer is right, one wrong, one garbage and one missing; one occurs twice, one was not
    // asked.
    folder.write("a.csv", "id,value\nh:right:u=1:p,0.5\nh:right:u=0.25:p,0.4\nh:right:u=0.5:p,x\n"
                          "h:right:u=1:p,0.5\nh:right:u=7:p,1\n");
    const Outcome o = run(folder, "check a.csv --recipe r.toml");
    CHECK(o.code == 1);
    CHECK(has(o.out, "2 rows are not in the order of the questions: "
                     "their ids state what they answer\n"));
    CHECK(lines(o.out).front() ==
          "FAIL: 3 answers, 2 failures, 1 missing, 2 faults of the rows or the program");
    folder.write("b.csv", header + "1" + hertz_cells + "p,right,0.2,0.3\n2" + hertz_cells +
                              "p,right,2.5,0\n3" + hertz_cells + "p,left,0.4,0.5\n");
    const Outcome outside = run(folder, "check b.csv");
    CHECK(outside.code == 1);
    CHECK(has(outside.out, "b.csv:3: 2: nothing to compare with: u = 2.5 from the right edge: "));
    CHECK(lines(outside.out).front() == "FAIL: 3 answers, 1 failure, 1 without a reference");
}

TEST_CASE("check: a file as a spreadsheet saves it") {
    const Folder folder;
    folder.write("a.csv", "\xEF\xBB\xBFid;kind;m;C;a;contact_modulus;quantity;edge;u;value\r\n"
                          "1;power-law;1;1;1;1;p;right;0,2;0,3\r\n"
                          "2;power-law;1;1;1;1;p;left;0,4;4E-01\r\n");
    const Outcome o = run(folder, "check a.csv");
    CHECK(o.code == 0);
    CHECK(lines(o.out).front() == "pass: 2 answers, 0 failures");
}

TEST_CASE("check: bad input is one line; exit 2; no file") {
    const Folder folder;
    folder.write("a.csv", header + "1" + hertz_cells + "p,right,2.5,0.3\n");
    folder.write("b.csv", "id,answer\n1,2\n");
    struct Bad {
        const char* command;
        const char* said;
    };
    for (const Bad& bad : {
             Bad{"check nowhere.csv", "nowhere.csv: there is no such file; "},
             Bad{"check a.csv", "a.csv:2: u = 2.5 from the right edge: "},
             Bad{"check b.csv", "b.csv:1: there is no column value; "},
             Bad{"check a.csv --digits -1", "edgeproof: --digits -1 is out of range; "},
             Bad{"check a.csv --ulps x", "edgeproof: --ulps x: "},
             Bad{"check a.csv --recipe nowhere.toml", "nowhere.toml: there is no such file; "},
         }) {
        CAPTURE(bad.command);
        const Outcome o = run(folder, std::string(bad.command) + " --junit j.xml");
        CHECK(o.code == 2);
        CHECK(o.out.empty());
        REQUIRE(lines(o.err).size() == 1);
        CHECK(o.err.rfind(bad.said, 0) == 0);
        CHECK(folder.files() == 2);
    }
}

TEST_CASE("a program in Python: its closed forms hold in double, and the faults of the other one "
          "are found") {
    if (!have_python()) {
        MESSAGE("no python3 here");
        return;
    }
    const Folder folder;
    const std::string recipe = third_party("questions.toml");
    const auto answers_of = [&](const char* script, const char* file) {
        REQUIRE(run(folder, "points " + recipe + " --out q.csv").code == 0);
        const std::string command = "cd '" + folder.path().string() +
                                    "' && PYTHONDONTWRITEBYTECODE=1 python3 " +
                                    third_party(script) + " <q.csv >" + file;
        REQUIRE(std::system(command.c_str()) == 0);
    };
    answers_of("closed_forms.py", "right.csv");
    const Outcome right = run(folder, "check right.csv --digits 13");
    CHECK(right.code == 0);
    CHECK(lines(right.out).front() == "pass: 220 answers, 0 failures");
    CHECK(run(folder, "check right.csv --digits 17").code == 1); // a double does not have 17 digits

    answers_of("wrong_on_purpose.py", "wrong.csv");
    const Outcome wrong =
        run(folder, "check wrong.csv --errors 100 --digits 13 --recipe " + recipe);
    CHECK(wrong.code == 1);
    for (const char* part :
         {"P: yours are 2 times ours, to 15.", "c_1: yours are minus ours, to 15.",
          ": wedge:C=0.1:contact_modulus=1:right:u=0.999:p: nan\n",
          "wrong.csv: wedge:C=0.1:contact_modulus=1:right:u=0.9:p: missing\n",
          ": wedge:C=0.1:contact_modulus=1:left:c_0 is answered twice, first in line 10\n",
          ": flat:t=0.4:R=1:left:u=0.1:p: 7."}) {
        CAPTURE(part);
        CHECK(has(wrong.out, part));
    }
    CHECK_FALSE(has(wrong.out, ": flat:t=0.4:R=1:right:u=0.1:p: "));
}

// E* = 1/((1 - 0.3^2)/200 + (1 - 0.2^2)/70) and p = E* sqrt(u (2 - u))/2 of Hertz with C = a = 1.
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

TEST_CASE("check --json: the outcome, and the cause by its name") {
    const Folder folder;
    const auto answers = [](double modulus) {
        std::string text = "id,kind,m,C,a,E1,nu1,E2,nu2,quantity,edge,u,value\n";
        for (const double u : {0.125, 0.25, 0.5, 1.0, 1.5}) {
            text += fmt::format("{0},power-law,1,1,1,200,0.3,70,0.2,p,right,{0},{1:.17g}\n", u,
                                modulus * std::sqrt(u * (2 - u)) / 2);
        }
        return text;
    };
    const double modulus = 1 / (0.91 / 200 + 0.96 / 70);
    folder.write("right.csv", answers(modulus));
    folder.write("e.csv", answers(200));
    folder.write("minus.csv", answers(-modulus));
    const Outcome right = run(folder, "check right.csv --digits 12 --json");
    CHECK(right.code == 0);
    auto found = nlohmann::json::parse(right.out);
    CHECK(found.erase("program") == 1);
    CHECK(found ==
          nlohmann::json::parse(R"({"passes": true, "rows": 5, "failures": 0, "causes": []})"));
    const Outcome wrong = run(folder, "check e.csv --digits 12 --json");
    CHECK(wrong.code == 1);
    const nlohmann::json e = nlohmann::json::parse(wrong.out);
    CHECK(e.at("failures") == 5);
    REQUIRE(e.at("causes").size() == 1);
    CHECK(e.at("causes")[0].at("name") == "e-for-e-star");
    CHECK(e.at("causes")[0].at("rows") == 5);
    CHECK(e.at("causes")[0].at("remainder") < 1e-12);
    const nlohmann::json sign =
        nlohmann::json::parse(run(folder, "check minus.csv --digits 12 --json").out);
    CHECK(sign.at("causes")[0].at("name") == "sign");
    CHECK(sign.at("causes")[0].at("factor") == -1);
    CHECK(run(folder, "check --ledger moore-hills --json").code == 2);
}

TEST_CASE(
    "check --exec: the program is run with the questions; its end does not disturb the check") {
    const Folder folder;
    folder.write("r.toml", "[scenes.h]\nu = [\"0.25\", \"0.5\", \"1\"]\nquantities = [\"p\"]\n"
                           "[scenes.h.profile]\nkind = \"power-law\"\nm = \"1\"\nC = \"1\"\n"
                           "[scenes.h.load]\na = \"1\"\ncontact_modulus = \"1\"\n");
    // p = sqrt(u (2 - u))/2: sqrt(7)/8, sqrt(3)/4, 1/2
    folder.write("good.sh", "while read -r row; do case $row in\n"
                            "id,*) echo id,value;;\n"
                            "*u=0.25*) echo h:right:u=0.25:p,0.3307189138830738;;\n"
                            "*u=0.5*) echo h:right:u=0.5:p,0.4330127018922193;;\n"
                            "*u=1:*) echo h:right:u=1:p,0.5;;\nesac; done\n");
    const auto check = [&](const std::string& command) {
        return run(folder, "check r.toml --digits 15 --timeout 20 --exec '" + command + "'");
    };
    const Outcome good = check("sh good.sh");
    CHECK(good.code == 0);
    CHECK(lines(good.out).front() == "pass: 3 answers, 0 failures");
    // The ids identify the answers.
    const Outcome turned = check("sh good.sh >all; head -n 1 all; tail -n 3 all | sort -r");
    CHECK(turned.code == 0);
    CHECK(has(turned.out, "2 rows are not in the order of the questions"));
    struct Bad {
        const char* command;
        const char* said;
    };
    for (const Bad& bad : {
             Bad{"sh good.sh; kill -SEGV $$", "the program was ended by signal 11"},
             Bad{"sh good.sh; exit 3", "the program ended with exit code 3"},
             Bad{"exit 0", "the program:1: there is no header line"},
             Bad{"echo no questions please", "the program:1: there is no column id"},
             Bad{"sh good.sh | head -n 2", "the program: h:right:u=0.5:p: missing"},
             Bad{"sh good.sh; echo Bus error", "the program:5: garbage: 1 cells, not 2"},
             Bad{"sh good.sh | sed s/0.5$/inf/", "the program:4: h:right:u=1:p: inf"},
         }) {
        CAPTURE(bad.command);
        const Outcome o = check(bad.command);
        CAPTURE(o.out);
        CHECK(o.code == 1);
        CHECK(has(o.out, bad.said));
    }
    // Its standard error is shown, but cut if it is too long.
    const Outcome loud = check("head -c 300000 /dev/zero >&2; sh good.sh");
    CHECK(loud.code == 0);
    CHECK(loud.err.size() > 65536);
    CHECK(loud.err.size() < 66000);
    CHECK(has(loud.err, "the program\'s messages beyond 65536 bytes are left out"));
    CHECK(check("yes").code == 1);
    const Outcome slow = run(folder, "check r.toml --timeout 0.3 --exec 'sleep 60'");
    CHECK(slow.code == 1);
    CHECK(has(slow.out, "the program was stopped: it took longer than --timeout allows"));
}

TEST_CASE("check --only: a program that knows one profile is asked and judged for it alone") {
    const Folder folder;
    const std::string profile = "u = [\"0.25\", \"0.5\", \"1\"]\nquantities = [\"p\"]\n";
    const std::string load = ".load]\na = \"1\"\ncontact_modulus = \"1\"\n";
    folder.write("r.toml", "[scenes.h]\n" + profile +
                               "[scenes.h.profile]\nkind = \"power-law\"\nm = \"1\"\nC = \"1\"\n"
                               "[scenes.h" +
                               load + "[scenes.w]\n" + profile +
                               "[scenes.w.profile]\nkind = \"tilted-wedge\"\nphi = \"0.2\"\n"
                               "alpha = \"0\"\n[scenes.w" +
                               load);
    // p = sqrt(u (2 - u))/2 for the cylinder; the program ends if it is asked for a wedge.
    folder.write("hertz.sh", "while read -r row; do case $row in\n"
                             "*phi*|w:*) echo unknown profile >&2; exit 3;;\n"
                             "id,*) echo id,value;;\n"
                             "*u=0.25*) echo h:right:u=0.25:p,0.3307189138830738;;\n"
                             "*u=0.5*) echo h:right:u=0.5:p,0.4330127018922193;;\n"
                             "*u=1:*) echo h:right:u=1:p,0.5;;\nesac; done\n");
    const std::string asked = "check r.toml --digits 15 --exec 'sh hertz.sh'";
    CHECK(run(folder, asked).code == 1);
    const Outcome only = run(folder, asked + " --only 'h:*'");
    CAPTURE(only.out);
    CHECK(only.code == 0);
    CHECK(lines(only.out).front() == "pass: 3 answers, 0 failures");
    const Outcome one = run(folder, asked + " --only '*u=1:p' --only 'h:*=1:p'");
    CHECK(one.code == 2); // an option is given once
    CHECK(lines(run(folder, asked + " --only 'h:*u=0.?*'").out).front() ==
          "pass: 2 answers, 0 failures");
    // Files of answers: other rows are left out, with a recipe or without.
    folder.write("a.csv", "id,value\nh:right:u=0.25:p,0.3307189138830738\n"
                          "h:right:u=0.5:p,0.4330127018922193\nh:right:u=1:p,0.5\n"
                          "w:right:u=1:p,7\n");
    CHECK(run(folder, "check a.csv --recipe r.toml --digits 15 --only 'h:*'").code == 0);
    CHECK(run(folder, "check a.csv --recipe r.toml --digits 15").code == 1);
    folder.write("b.csv", "# questions: 2\n" + header + "h:1" + hertz_cells +
                              "p,right,0.2,0.3\nw:1" + hertz_cells + "p,right,0.2,7\n");
    CHECK(run(folder, "check b.csv --only 'h:*'").code == 0);
    CHECK(run(folder, "check b.csv").code == 1);
    for (const std::string& none :
         {asked, std::string("check b.csv"), std::string("check a.csv --recipe r.toml")}) {
        const Outcome o = run(folder, none + " --only 'x*'");
        CHECK(o.code == 2);
        CHECK(has(o.err, "--only x*: no id of "));
        CHECK(lines(o.err).size() == 1);
    }
}

TEST_CASE("check --exec: the standard error of a program that answers nothing is in the report") {
    const Folder folder;
    folder.write("r.toml",
                 "[scenes.h]\nu = [\"0.25\"]\nquantities = [\"p\"]\n[scenes.h.profile]\n"
                 "kind = \"power-law\"\nm = \"1\"\nC = \"1\"\n[scenes.h.load]\na = \"1\"\n"
                 "contact_modulus = \"1\"\n");
    const auto check = [&](const std::string& command) {
        return run(folder, "check r.toml --exec '" + command + "'");
    };
    const Outcome silent = check("echo no module named scipy >&2; exit 1");
    CHECK(has(silent.out,
              "the program answers nothing; its standard error begins: no module named scipy"));
    CHECK_FALSE(has(check("echo hello >&2; echo id,value; echo h:right:u=0.25:p,1").out,
                    "its standard error begins"));
}

TEST_CASE("check: a file of many answers is reported as one that is read at once") {
    const Folder folder;
    // 3-4-5 and 5-12-13 triangles, some values wrong; one id occurs twice, and a row is torn.
    std::string text = "# questions: 6000\n" + header;
    for (int k = 0; k < 5500; ++k) {
        const bool wrong = k % 1100 == 7;
        const char* const value = k % 2 == 0 ? wrong ? "0.31" : "0.3" : wrong ? "0.5" : "0.4";
        text += k == 5200 ? std::string("torn\n")
                          : "q" + std::to_string(k == 5300 ? 17 : k) + hertz_cells + "p," +
                                (k % 3 == 0 ? "right," : "left,") + (k % 2 == 0 ? "0.2" : "0.4") +
                                "," + value + "\n";
    }
    folder.write("a.csv", text);
    const Outcome blocks = run(folder, "check a.csv --errors 4");
    const Outcome once = run(folder, "check a.csv --errors 4 --junit j.xml"); // needs them all
    CHECK(blocks.code == 1);
    CHECK(once.code == 1);
    CHECK(blocks.out == once.out);
    CHECK(has(blocks.out, "a.csv:5303: q17 is answered twice, first in line 20"));
    CHECK(lines(blocks.out).front() ==
          "FAIL: 5498 answers, 5 failures, 3 faults of the rows or the "
          "program");
}
