// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/conformance/answers/answers.hpp"
#include "edgeproof/io/foreign_text.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <regex>
#include <sstream>
#include <string>

using Kind = WrittenNumber::Kind;

namespace {

/// The grammar as a regular expression, independent of the reader.
const std::regex& number_grammar() {
    static const std::regex grammar(
        R"([+-]?(([0-9]+\.?[0-9]*|\.[0-9]+)([eEdD][+-]?[0-9]+)?)"
        R"(|0[xX]([0-9a-fA-F]+\.?[0-9a-fA-F]*|\.[0-9a-fA-F]+)([pP][+-]?[0-9]+)?))");
    return grammar;
}

/// Reads by MPFR at 4000 bits, independently of the reader; no value for a text that is not a
/// number.
std::optional<double> error_of(std::string text, const char* exact) {
    if (!std::regex_match(text, number_grammar())) {
        return {};
    }
    if (text.find_first_of("xX") == std::string::npos) {
        const std::size_t exponent = text.find_first_of("eEdD");
        if (exponent != std::string::npos &&
            std::labs(std::strtol(text.c_str() + exponent + 1, nullptr, 10)) > 100'000) {
            return {}; // beyond the supported range
        }
        for (char& c : text) {
            c = c == 'd' || c == 'D' ? 'e' : c;
        }
    }
    mpfr_t value;
    mpfr_t wanted;
    mpfr_inits2(4000, value, wanted, static_cast<mpfr_ptr>(nullptr));
    mpfr_strtofr(value, text.c_str(), nullptr, 0, MPFR_RNDN);
    mpfr_strtofr(wanted, exact, nullptr, 10, MPFR_RNDN);
    mpfr_div(value, value, wanted, MPFR_RNDN);
    mpfr_sub_ui(value, value, 1, MPFR_RNDN);
    const double error = std::abs(mpfr_get_d(value, MPFR_RNDN));
    mpfr_clears(value, wanted, static_cast<mpfr_ptr>(nullptr));
    return error;
}

/// Returns the text with one to three bytes inserted, removed, doubled, exchanged or replaced.
std::string corrupted(std::string text, std::mt19937_64& random) {
    static const std::string bytes(
        "0123456789+-..,;\"'eEdDxXpPaf_ \t\r\n/#()naninf\0\x7f\xc2\xa0\xe2"
        "\x88\x92\xef\xbb\xbf\xff",
        54); // including its NUL
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    for (std::size_t n = 1 + below(3); n > 0; --n) {
        const std::size_t at = below(text.size() + 1);
        const char c = bytes[below(bytes.size())];
        switch (below(5)) {
        case 0:
            text.insert(at, 1, c);
            break;
        case 1:
            text.erase(at, 1);
            break;
        case 2:
            text.insert(at, text.substr(at, 1));
            break;
        case 3:
            if (at + 1 < text.size()) {
                std::swap(text[at], text[at + 1]);
            }
            break;
        default:
            if (at < text.size()) {
                text[at] = c;
            }
        }
    }
    return text;
}

constexpr double answer_tolerance = 1e-12;
const char* const forms_of_three_eighths[] = {"0.375",    "+.375",   "375e-3",    "3.75D-01",
                                              "0x1.8p-2", "0X.6P+0", "0.3750000", "-0.375",
                                              "37.5E-2",  "0x3p-3",  "0.375d0",   "3.75e-1"};

} // namespace

TEST_CASE("numbers in answers: one grammar, the whole text or nothing") {
    const auto value = [](const char* text) {
        const WrittenNumber number = written_number(text);
        REQUIRE(number.kind == Kind::number);
        return number.value;
    };
    CHECK(value("-1.5e-3") == Rational(-3, 2000));
    CHECK(value("5.") == 5);
    CHECK(value(".5D+1") == 5);
    CHECK(value("007") == 7);
    CHECK(value("-0x1P+3") == -8);
    CHECK(value("0xA.8") == Rational(21, 2));
    // More than the 53 bits of a double, exactly: 1 + 2^-80.
    CHECK(value("0x1.00000000000000000001p0") == 1 + Rational(1, Integer(1) << 80U));
    // Less than the smallest double, but not zero.
    CHECK(value("0x1p-2000") == Rational(1, Integer(1) << 2000U));
    for (const char* text : {"nan", "-NaN", "+nan(0x1)", "nan()"}) {
        CAPTURE(text);
        CHECK(written_number(text).kind == Kind::nan);
    }
    for (const char* text : {"inf", "-Infinity", "+INF"}) {
        CAPTURE(text);
        CHECK(written_number(text).kind == Kind::infinite);
    }
    std::istringstream others("+ ++0.4 +-1 -+1 --1 1e 1e+ 1e++ e5 . 1.2.3 3/2 1,5 0x 0x."
                              " 0x1p 0x1p+-3 0x1g 1p3 1e5.0 1d2e3 nano nan( nan()x infx"
                              " infinit 1e100001 0x1p999999999999999999999"
                              " 1e999999999999999999999 None");
    for (std::string text; others >> text;) {
        CAPTURE(text);
        CHECK(written_number(text).kind == Kind::other);
    }
    for (const char* text : {"", " 1", "1 ", "0.4 NaN (diverged)"}) {
        CAPTURE(text);
        CHECK(written_number(text).kind == Kind::other);
    }
    CHECK(written_number(std::string_view("0.4\0", 4)).kind == Kind::other);
    CHECK(with_decimal_point("-1,5E-03") == "-1.5E-03");
    for (const char* text : {"1.5", "1,5,2", "1.000,5", "15", ",", "0x1,8"}) {
        CAPTURE(text);
        CHECK_FALSE(with_decimal_point(text));
    }
}

TEST_CASE(
    "numbers in answers: a corrupted right number counts only where its value is still right") {
    std::mt19937_64 random(20);
    std::size_t still_right = 0;
    for (int n = 0; n < 40'000; ++n) {
        const std::string text = corrupted(forms_of_three_eighths[random() % 12], random);
        CAPTURE(text);
        const WrittenNumber read = written_number(text);
        const auto error = error_of(text, "0.375");
        REQUIRE((read.kind == Kind::number) == error.has_value());
        if (error) {
            const Rational off = abs(Rational(read.value / Rational(3, 8) - 1));
            const bool right = off <= Rational(answer_tolerance);
            REQUIRE(right == (*error <= answer_tolerance));
            still_right += right ? 1 : 0;
        }
    }
    CHECK(still_right > 500); // the test has both kinds
}

TEST_CASE("answers: a corrupted right row passes only if it is still a right row") {
    const Csv alone = parse_csv("id,kind,m,C,a,contact_modulus,quantity,value\n"
                                "h,power-law,1,1,1,1,P,1\n",
                                "q.csv");
    const Questions asked = echoed_answers(alone).questions;
    // A row by RFC 4180, with blanks around a bare cell, independent of the reader.
    const std::regex row(R"([ \t\r]*(?:h|"h")[ \t\r]*,[ \t\r]*(?:("?)([^",\n]*?)\1)[ \t\r]*\n?)");
    std::mt19937_64 random(21);
    std::size_t passed = 0;
    for (int n = 0; n < 40'000; ++n) {
        const std::string form = forms_of_three_eighths[random() % 12];
        const bool quoted = random() % 2 == 0;
        const std::string text =
            corrupted(quoted ? "h,\"" + form + "\"\n" : "h," + form + "\n", random);
        CAPTURE(text);
        bool passes = false;
        try {
            const Answers answers =
                answers_to(asked, parse_csv("id,value\n" + text, "a.csv", {.keep_faults = true}));
            const Answer& given = answers.given.front();
            passes = answers.faults.empty() && given.state == Answer::State::number &&
                     abs(Rational(given.value / Rational(3, 8) - 1)) <= Rational(answer_tolerance);
        } catch (const InputError&) { // the whole text is refused
        }
        if (passes) {
            // Blank lines and notes may precede and follow it.
            std::string rest;
            std::size_t rows = 0;
            for (std::size_t at = 0; at < text.size();) {
                const std::size_t end = std::min(text.find('\n', at), text.size() - 1);
                const std::string line = text.substr(at, end - at + 1);
                at = end + 1;
                const std::size_t first = line.find_first_not_of(" \t\r\n");
                if (first != std::string::npos && line[first] != '#') {
                    ++rows;
                    rest = line;
                }
            }
            std::smatch match;
            REQUIRE(rows == 1);
            REQUIRE(std::regex_match(rest, match, row));
            const auto error = error_of(match[2].str(), "0.375");
            REQUIRE(error.has_value());
            REQUIRE(*error <= answer_tolerance);
            ++passed;
        }
    }
    CHECK(passed > 500);
}
