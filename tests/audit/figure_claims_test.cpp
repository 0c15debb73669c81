// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "tests/audit/small_ledger.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::small_ledger;

namespace {

std::string figure(const std::string& of, const std::string& quoted) {
    return "kind = \"figure\"\nover = \"hertz\"\nof = \"" + of + "\"\nquoted = \"" + quoted + "\"";
}

std::string extent(int terms, const std::string& base, const std::string& quoted) {
    return "kind = \"extent\"\nover = \"hertz\"\nterms = " + std::to_string(terms) +
           "\ntolerance = \"1/100\"\nreach = \"first-exit\"\nupto = \"1/2\"\nbase = \"" + base +
           "\"\nquoted = \"" + quoted + "\"";
}

} // namespace

TEST_CASE("a figure holds if the value rounds to it, to the last place quoted") {
    CHECK(verdict_of(figure("Pi", "3.14")) == "confirmed");
    CHECK(verdict_of(figure("Pi", "3.142")) == "confirmed");
    CHECK(verdict_of(figure("Pi", "3.1")) == "confirmed");
    CHECK(verdict_of(figure("Pi", "3.141")) == "imprecise");
    CHECK(verdict_of(figure("Pi", "3.2")) == "imprecise");
    CHECK(verdict_of(figure("Pi", "3.3")) == "refuted");
    CHECK(verdict_of(figure("Pi", "3.145")) == "refuted");
    CHECK(verdict_of(figure("Pi/100", "3 %")) == "confirmed");
    CHECK(verdict_of(figure("Pi/100", "3.14%")) == "confirmed");
    CHECK(verdict_of(figure("Pi/100", "3")) == "refuted");
    CHECK(verdict_of(figure("1/2", "0")) == "imprecise"); // a half is rounded up
    CHECK(verdict_of(figure("49/100", "0")) == "confirmed");
}

TEST_CASE("a half is rounded up, on whichever side of it roundoff leaves the value") {
    // sqrt(2)^2/16, (1/3 + 1/24)/3, sqrt(2)*sqrt(3)*sqrt(6)/48 and sqrt(5)*sqrt(5)/40 are 1/8.
    for (const char* text : {"1/8", "sqrt(2)*sqrt(2)/16", "(1/3 + 1/24)/3", "sqrt(5)*sqrt(5)/40",
                             "sqrt(2)*sqrt(3)*sqrt(6)/48", "(1/3)*(3/8)"}) {
        CAPTURE(text);
        CHECK(verdict_of(figure(text, "0.13")) == "confirmed");
        CHECK(verdict_of(figure(text, "0.12")) == "imprecise");
        CHECK(verdict_of(figure(text, "13 %")) == "confirmed");
        CHECK(verdict_of(figure(text, "0.125")) == "confirmed");
    }
    // An enclosure of an integral cannot decide on which side of a half it lies: the integral of
    // 1/(1 + s^2) is pi/4.
    CHECK(verdict_of(figure("integral(1/(1 + s^2), s, 0, 1)/(2*Pi)", "0.13")) == "undecided");
    CHECK(verdict_of(figure("integral(1/(1 + s^2), s, 0, 1)/(2*Pi)", "0.125")) == "confirmed");
    const ClaimResult r = result_of(figure("sqrt(2)*sqrt(3)*sqrt(6)/48", "0.11"));
    CHECK(r.outcome.note.starts_with("rounds to 0.13: 2 units of the last quoted place above"));
    CHECK(r.outcome.note.find("half-way") != std::string::npos);
}

TEST_CASE("a figure at a place of a contact") {
    // u = a/100: 1/sqrt(1 - 1/200) - 1 = 0.00250940...
    CHECK(verdict_of(figure("abs(1 - right_local(1, x)/p(x))", "0.25 %")) == "confirmed");
    CHECK(verdict_of(figure("abs(1 - right_local(1, x)/p(x))", "0.251 %")) == "confirmed");
    CHECK(verdict_of(figure("abs(1 - right_local(1, x)/p(x))", "0.27 %")) == "refuted");
}

TEST_CASE("a figure that depends on the scene is judged by its largest error") {
    CHECK(verdict_of(figure("a", "1.5")) == "refuted"); // in one scene a = 3/2
}

TEST_CASE("a quoted figure is a decimal") {
    CHECK_THROWS_AS(static_cast<void>(verdict_of(figure("Pi", "about 3"))), InputError);
    CHECK_THROWS_AS(static_cast<void>(verdict_of(figure("Pi", "3.1.4"))), InputError);
    CHECK_THROWS_AS(static_cast<void>(verdict_of(figure("Pi", " %"))), InputError);
}

TEST_CASE("the extent of the one-term approximation of Hertz's pressure") {
    // v = 2 (1 - 1/1.01^2) = 3.94079 %, which is half as much as a fraction of the whole contact.
    CHECK(verdict_of(extent(1, "a", "4 %")) == "confirmed");
    CHECK(verdict_of(extent(1, "a", "3.94 %")) == "confirmed");
    CHECK(verdict_of(extent(1, "a", "3.941 %")) == "confirmed");
    CHECK(verdict_of(extent(1, "a+b", "1.97 %")) == "confirmed");
    CHECK(verdict_of(extent(1, "a", "5 %")) == "imprecise");
    CHECK(verdict_of(extent(1, "a", "2 %")) == "refuted");
    CHECK(verdict_of(extent(1, "a+b", "4 %")) == "refuted");
    CHECK(*result_of(extent(1, "a", "4 %")).outcome.computed == "3.9408 %");
    // Two terms: (1 - v/4)/sqrt(1 - v/2) = 1.01 at v = 0.492369 (the root of a quadratic).
    CHECK(verdict_of(extent(2, "a", "49.2 %")) == "confirmed");
    CHECK(verdict_of(extent(2, "a", "46 %")) == "refuted");
}
