// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/answers/agreement.hpp"
#include "edgeproof/conformance/questions/reference.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

const std::string conditioning_header = "id,kind,m,C,a,contact_modulus,quantity,edge,u,value\n";

Agreements held(const std::string& rows, const Target& target = {}) {
    return compare(echoed_answers(parse_csv(conditioning_header + rows, "a.csv")), target, {});
}

double condition_number(const std::string& row) {
    const Agreements a = held(row);
    return a.cases.at(0).conditioning.value().number();
}

} // namespace

TEST_CASE("numbers beyond the range of a double have no neighbours, and nothing breaks") {
    for (const char* u : {"1e-400", "1e-330", "5e-324", "1e-300"}) {
        CAPTURE(u);
        const Agreements a = held(std::string("1,power-law,1,1,1,1,p,right,") + u + ",1\n");
        CHECK(a.cases.at(0).no_reference.empty());
        CHECK_FALSE(a.cases.at(0).pass);
    }
}

TEST_CASE("condition numbers by hand") {
    // P = E* C a^(m + 1) I(m), I'/I = (psi(3/2) - psi(2))/2 = 1/2 - log 2 at m = 1: a counts twice.
    CHECK(condition_number("1,power-law,1,1,1,1,P,,,1\n") ==
          doctest::Approx(2 + 1 + 1 + std::log(2.0) - 0.5).epsilon(1e-6));
    // The wedge, with m = 0 exact: p = acosh(a/x)/pi, x = a - u = 2^-30; the condition numbers for
    // u and a are u/x/acosh(a/x) each.
    const double x = 0x1p-30;
    const double each = 1 / (x * std::acosh(1 / x));
    // The ulp of u = 1 - 2^-30 is half of that of a = 1.
    CHECK(condition_number("2,power-law,0,1,1,1,p,right,0.999999999068677425384521484375,1\n") ==
          doctest::Approx(each * 1.5).epsilon(1e-4));
    // A zero value has no condition number.
    CHECK_FALSE(held("3,power-law,1,1,1,1,M,,,0\n").cases.at(0).conditioning);
}

TEST_CASE("without a target: 12 digits, or the digits that the conditioning leaves, are required") {
    const std::string wedge = "w,power-law,0,1,1,1,p,right,0.999999999068677425384521484375,";
    // The exact value is acosh(2^30)/pi = 6.8396025...; the rounding of the inputs explains a
    // relative error of 1e-10.
    const double exact = std::acosh(0x1p30) / std::acos(-1.0);
    const auto value = [&](double off) { return std::to_string(exact * (1 + off)); };
    const auto row = [&](double off) {
        char text[40];
        std::snprintf(text, sizeof text, "%.17g", exact * (1 + off));
        return wedge + text + "\n";
    };
    CHECK(value(0).substr(0, 5) == "6.839");
    CHECK(held(row(1e-8)).cases[0].pass);
    CHECK(held(row(1e-8)).cases[0].explained);
    CHECK_FALSE(held(row(1e-8)).cases[0].within);
    CHECK_FALSE(held(row(1e-6)).cases[0].pass);
    CHECK_FALSE(held(row(1e-8), {12.0, {}}).cases[0].pass);
    CHECK(held(row(1e-8), {12.0, {}, true}).cases[0].pass);
    // The value 0.3 (3-4-5 triangle) is well conditioned.
    const std::string hertz = "h,power-law,1,1,1,1,p,right,0.2,";
    CHECK(held(hertz + "0.3000000000001\n").cases[0].pass);
    CHECK_FALSE(held(hertz + "0.300000000001\n").cases[0].pass);
    CHECK_FALSE(held(hertz + "0.300000000001\n").cases[0].explained);
    CHECK_FALSE(held(hertz + "0.4\n").cases[0].pass);
}

TEST_CASE("a value that is zero is measured by the force and the length of its contact") {
    // M = 0 is compared with P (a + b) = 2 pi/4; if the contact is scaled by a million, so is the
    // tolerance.
    CHECK(held("m,power-law,1,1,1,1,M,,,1e-12\n").cases[0].pass);
    CHECK(held("m,power-law,1,1,1,1e6,M,,,1e-6\n").cases[0].pass);
    CHECK_FALSE(held("m,power-law,1,1,1,1e-6,M,,,1e-12\n").cases[0].pass);
}
