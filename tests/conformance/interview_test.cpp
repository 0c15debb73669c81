// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/interview.hpp"
#include "edgeproof/conformance/recipe.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace edgeproof;
using Cells = std::vector<std::string>;
using State = Answer::State;

namespace {

/// u = 1/10, ..., 16/10, one question each.
Questions sixteen() {
    return parse_recipe("[scenes.h]\nu = { from = \"0.1\", to = \"1.6\", points = 16 }\n"
                        "quantities = [\"p\"]\n[scenes.h.profile]\nkind = \"power-law\"\n"
                        "m = \"1\"\nC = \"1\"\n[scenes.h.load]\na = \"1\"\ncontact_modulus = "
                        "\"1\"\n",
                        "r.toml")
        .questions;
}

Answers asked(
    const std::string& command,
    const std::function<void(InterviewOptions&)>& change = [](InterviewOptions&) {}) {
    InterviewOptions options;
    options.command = command;
    options.seconds = 20;
    options.write_csv = [](const Questions& part) {
        std::string text = "id\n";
        for (const Question& q : part.list) {
            text += q.id + "\n";
        }
        return text;
    };
    change(options);
    static const Questions questions = sixteen();
    return interview(questions, options);
}

long count(const Answers& answers, State state) {
    return std::count_if(answers.given.begin(), answers.given.end(),
                         [&](const Answer& a) { return a.state == state; });
}

/// Answers 1 to everything; `at` is done when a line holds :u=0.7: or :u=1.2:.
std::string program(const std::string& at) {
    return "while read -r row; do case $row in id) echo id,value;; *:u=0.7:*|*:u=1.2:*|"
           "*:u=7/10:*|*:u=6/5:*) " +
           at + ";; *) echo $row,1;; esac; done";
}

} // namespace

TEST_CASE("an interview: every question is answered, in one batch or in many") {
    for (const std::size_t batch : {1U, 5U, 16U, 100U}) {
        const Answers a = asked(program("echo $row,1"), [&](auto& o) { o.batch = batch; });
        CAPTURE(batch);
        CHECK(a.faults.empty());
        CHECK(count(a, State::number) == 16);
    }
}

TEST_CASE("an interview: the questions that end a program are found, and none other suffers") {
    struct Bad {
        std::string command;
        std::string said;
    };
    for (const Bad& bad : {
             Bad{program("kill -SEGV $$"), "was ended by signal 11"},
             Bad{program("exit 3"), "ended with exit code 3"},
             // One that keeps its answers until the end, as buffered output does.
             Bad{"out=$(" + program("kill -KILL $$") + "); echo \"$out\"", "was ended by signal 9"},
         }) {
        const Answers a = asked(bad.command);
        CAPTURE(bad.command);
        CHECK(a.faults.empty());
        CHECK(count(a, State::number) == 14);
        CHECK(a.given[6].state == State::died);
        CHECK(a.given[11].state == State::died);
        CHECK(a.given[6].text.rfind(bad.said, 0) == 0);
    }
    const Answers slow = asked(program("sleep 50"), [](auto& o) { o.seconds = 0.4; });
    CHECK(count(slow, State::number) == 14);
    CHECK(slow.given[6].text == "was stopped: it took longer than --timeout allows");
}

TEST_CASE("an interview: a program that never answers is given up, and so is one past its runs") {
    const Answers never = asked("exit 1");
    CHECK(count(never, State::missing) + count(never, State::died) == 16);
    REQUIRE(never.faults.size() == 1);
    CHECK(never.faults[0].rfind("the program is given up after 3 runs that answered nothing", 0) ==
          0);
    const Answers past = asked(program("exit 1"), [](auto& o) {
        o.batch = 4;
        o.runs = 2;
    });
    CHECK(count(past, State::number) == 6);
    REQUIRE(past.faults.size() == 1);
    CHECK(past.faults[0].rfind("the program is given up after 2 runs (--runs)", 0) == 0);
}

TEST_CASE("JSON lines: questions as objects, answers with every digit as written") {
    const std::string lines = json_lines(sixteen());
    CHECK(std::count(lines.begin(), lines.end(), '\n') == 16);
    CHECK(lines.substr(0, lines.find('\n')) ==
          R"({"id":"h:right:u=0.1:p","kind":"power-law","m":"1","C":"1","a":"1",)"
          R"("contact_modulus":"1","quantity":"p","edge":"right","u":"0.1"})");
    const Csv csv = parse_json_lines("{\"id\": \"a\", \"value\": 0.12345678901234567890123}\n"
                                     "\n"
                                     "{\"value\": \"1e-3\", \"id\": \"b\", \"more\": [1, {}]}\n"
                                     "{\"id\": \"c\", \"value\": NaN}\n"
                                     "{\"id\": \"d\", \"value\": -Infinity}\n"
                                     "{\"id\": \"e\", \"value\": null}\n"
                                     "{\"id\": \"f\", \"value\": 7}\n"
                                     "Segmentation fault\n"
                                     "{\"id\": \"g\"}\n",
                                     "out");
    REQUIRE(csv.rows.size() == 8);
    CHECK(csv.rows[0].cells == Cells{"a", "0.12345678901234567890123"});
    CHECK(csv.rows[1].cells == Cells{"b", "1e-3"});
    CHECK(csv.rows[1].line == 3);
    CHECK(csv.rows[2].cells == Cells{"c", "NaN"});
    CHECK(csv.rows[3].cells == Cells{"d", "-Infinity"});
    CHECK(csv.rows[4].cells == Cells{"e", ""});
    CHECK(csv.rows[5].cells == Cells{"f", "7"});
    CHECK(csv.rows[6].cells.size() == 1);
    CHECK(csv.rows[7].cells.size() == 1);
}
