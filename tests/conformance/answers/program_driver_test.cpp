// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/conformance/answers/answers.hpp"
#include "edgeproof/conformance/questions/question.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

using Cells = std::vector<std::string>;
using State = Answer::State;

namespace {

/// Returns u = 1/10, ..., 16/10 or u = 1/100, ..., 64/100, one question for each.
Questions questions_at(const std::string& range) {
    return parse_recipe("[scenes.h]\nu = { " + range +
                            " }\nquantities = [\"p\"]\n"
                            "profile = { kind = \"power-law\", m = \"1\", C = \"1\" }\n"
                            "load = { a = \"1\", contact_modulus = \"1\" }\n",
                        "r.toml")
        .questions;
}
const Questions& sixteen() {
    static const Questions questions = questions_at("from = \"0.1\", to = \"1.6\", points = 16");
    return questions;
}
const Questions& sixty_four() {
    static const Questions questions = questions_at("from = \"0.01\", to = \"0.64\", points = 64");
    return questions;
}

/// The answers of a program that reads `head` and the ids of the questions, a line each.
Answers asked(
    const std::string& command,
    const std::function<void(ProgramDriverOptions&)>& change = [](ProgramDriverOptions&) {},
    const Questions& questions = sixteen(), const std::string& head = "id\n") {
    ProgramDriverOptions options;
    options.command = command;
    options.seconds = 20;
    options.write_csv = [head](const Questions& part) {
        std::string text = head;
        for (const Question& q : part.list) {
            text += q.id + "\n";
        }
        return text;
    };
    change(options);
    return ask_program_in_batches(questions, options);
}

long count(const Answers& answers, State state) {
    return std::count_if(answers.given.begin(), answers.given.end(),
                         [&](const Answer& a) { return a.state == state; });
}

/// Returns a program that answers 1 to every question, and executes `at` if a line contains :u=0.7:
/// or :u=1.2:.
std::string program(const std::string& at) {
    return "while read -r row; do case $row in id) echo id,value;; *:u=0.7:*|*:u=1.2:*|"
           "*:u=7/10:*|*:u=6/5:*) " +
           at + ";; *) echo $row,1;; esac; done";
}

} // namespace

TEST_CASE("a program asked: every question is answered, in one batch or in many") {
    for (const std::size_t batch : {1U, 5U, 16U, 100U}) {
        const Answers a = asked(program("echo $row,1"), [&](auto& o) { o.batch = batch; });
        CAPTURE(batch);
        CHECK(a.faults.empty());
        CHECK(count(a, State::number) == 16);
    }
}

TEST_CASE(
    "a program asked: the questions that end a program are found, and the others are answered") {
    struct Bad {
        std::string command;
        std::string said;
    };
    for (const Bad& bad : {
             Bad{program("kill -SEGV $$"), "was ended by signal 11"},
             Bad{program("exit 3"), "ended with exit code 3"},
             // This program keeps its answers until the end, like buffered output.
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

TEST_CASE(
    "a program asked: a program that never answers is given up, and so is one past its runs") {
    const Answers never = asked("exit 1");
    CHECK(count(never, State::missing) + count(never, State::died) == 16);
    REQUIRE(never.faults.size() == 1);
    CHECK(never.faults[0].rfind("the program is given up after 4 runs that answered nothing", 0) ==
          0);
    const Answers past = asked(program("exit 1"), [](auto& o) {
        o.batch = 4;
        o.runs = 2;
    });
    CHECK(count(past, State::number) == 6);
    REQUIRE(past.faults.size() == 1);
    CHECK(past.faults[0].rfind("the program is given up after 2 runs (--runs)", 0) == 0);
}

namespace {

/// Runs a program that reads the ids of questions and ends itself at the bad ones. `begin`, `one`
/// and `end` are its commands at the beginning, at each question and at the end.
Answers asked_of_numbers(const std::vector<std::size_t>& bad, const std::string& begin,
                         const std::string& one, const std::string& end) {
    std::string ends;
    for (const std::size_t i : bad) {
        ends += (ends.empty() ? "" : "|") + sixty_four().list[i].id;
    }
    return asked(
        begin + " while read -r row; do case $row in " + ends + ") kill -SEGV $$;; *) " + one +
            ";; esac; done; " + end,
        [](ProgramDriverOptions&) {}, sixty_four(), "");
}

} // namespace

TEST_CASE("a program asked: the questions that end a program are found wherever they stand, "
          "whether or not it had written something") {
    struct Way {
        const char* what;
        std::string begin;
        std::string one;
        std::string end;
    };
    const Way ways[] = {
        {"as it goes", "echo id,value;", "echo $row,1", ":"},
        {"all at the end", "all=;", "all=\"$all$row,1\n\"", "printf \"id,value\\n$all\""},
        // The buffer contains three lines; the last one is written in halves.
        {"by a buffer", "echo id,value; n=0; all=;",
         "n=$((n+1)); all=\"$all$row,\"; if [ $n = 3 ]; then printf \"$all\"; n=0; "
         "all=\"123\\n\"; else all=\"${all}123\\n\"; fi",
         "printf \"$all\""},
    };
    for (const Way& way : ways) {
        for (const std::vector<std::size_t>& bad :
             {std::vector<std::size_t>{0}, {63}, {32}, {0, 63}, {5, 6, 40}, {31, 32}}) {
            CAPTURE(way.what);
            CAPTURE(bad.front());
            CAPTURE(bad.back());
            const Answers a = asked_of_numbers(bad, way.begin, way.one, way.end);
            CHECK(a.faults.empty());
            CHECK(count(a, State::number) == 64 - static_cast<long>(bad.size()));
            for (const std::size_t i : bad) {
                CHECK(a.given[i].state == State::died);
            }
            for (const Answer& answer : a.given) {
                // A number is never cut in half.
                const bool whole = answer.text == "1" || answer.text == "123";
                CHECK((whole || answer.state == State::died));
            }
        }
    }
}

TEST_CASE("a program asked: what a run writes is bounded in rows and in bytes") {
    const Answers rows = asked("echo id,value; head -c 100000 /dev/zero | tr '\\0' '\\n' | sed "
                               "s/^/x,1/");
    CHECK(rows.faults.size() <= 1000 + 2 * 16 + 1);
    CHECK(rows.faults.back() ==
          "the program: more than 1032 rows to 16 questions; the rest is not read");
    for (const std::string endless : {"yes", "yes id,value", "cat /dev/zero"}) {
        CAPTURE(endless);
        const Answers a = asked(endless);
        CHECK(count(a, State::number) == 0);
        REQUIRE(a.faults.size() < 20'000);
        CHECK(a.faults.back().find("it wrote without end") != std::string::npos);
    }
}
