// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/message.hpp"

#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <array>
#include <random>

TEST_CASE("no control sequence of a terminal is printable") {
    struct Case {
        std::string text;
        std::string shown;
    };
    const Case all[] = {{"plain", "plain"},
                        {"γ€😀", "γ€😀"},
                        {"a\nb\tc\rd", "a b c d"},
                        {"\x1b[31mred", "\\x1b[31mred"},
                        {std::string("a\0b", 3), "a\\x00b"},
                        {"\x7f\b\a", "\\x7f\\x08\\x07"},
                        {"\xc2\x9b"
                         "1m",
                         "\\xc2\\x9b1m"}, // CSI as one character
                        {"\xe2\x80\xae"
                         "x",
                         "\\xe2\\x80\\xaex"},                // right to left
                        {"\xef\xbf\xbf", "\\xef\\xbf\\xbf"}, // not a character of XML
                        {"\xff\xc3(", "\\xff\\xc3("},        // not UTF-8
                        {"\xc0\x9b", "\\xc0\\x9b"},          // overlong
                        {"\xe2\x82", "\\xe2\\x82"}};         // cut off
    for (const Case& c : all) {
        CHECK(printable(c.text) == c.shown);
    }
    CHECK(printable_lines("a\nb\tc\r\n\x1b") == "a\nb\tc \n\\x1b");
}

TEST_CASE("printable: no byte below a space remains, and text is unchanged") {
    std::mt19937 random(7);
    for (int round = 0; round < 2000; ++round) {
        std::string text;
        for (std::size_t n = random() % 12; n > 0; --n) {
            text += static_cast<char>(random() % 256);
        }
        const std::string shown = printable(text);
        for (const char c : shown) {
            CHECK((static_cast<unsigned char>(c) >= 0x20U && c != '\x7f'));
        }
        CHECK(printable(shown) == shown);
    }
}

TEST_CASE("a message is one line, and does not echo an oversized text") {
    const InputError error("a = \"" + std::string(100'000, '1') + "\x1b\": it is\nwrong",
                           "write 1");
    const std::string said = error.at("f.toml", 3).what();
    CHECK(said.size() < 300);
    CHECK(said.find("f.toml:3: a = \"111") == 0);
    CHECK(said.find("\\x1b\": it is wrong; write 1") != std::string::npos);
    const InputError words("no " + std::string(200, 'p') + " and " + std::string(201, 'q'),
                           std::string(5000, 'r'));
    CHECK(std::string(words.what()).find("no " + std::string(200, 'p') + " and qqq") == 0);
    CHECK(std::string(words.what()).size() < 620);
    CHECK(std::string(words.at(std::string(5000, 's'), 7).what()).size() < 930);
}

TEST_CASE("shortened: the ends stay, characters stay whole") {
    CHECK(shortened("short", 10) == "short");
    std::string greek;
    for (int i = 0; i < 1000; ++i) {
        greek += "γ";
    }
    for (std::size_t most = 20; most < 60; ++most) {
        const std::string cut = shortened("a" + greek + "z", most);
        CHECK(cut.size() <= most);
        CHECK(cut.size() + 6 >= most);
        CHECK(cut.front() == 'a');
        CHECK(cut.back() == 'z');
        CHECK(printable(cut) == cut);
    }
}

TEST_CASE("a near name is found for a misspelled word, and none for another word") {
    const std::array<std::string_view, 8> known{"pressure", "contact_modulus",  "a",   "P",
                                                "digits",   "flat-and-rounded", "nu1", "nu2"};
    const auto near = [&](std::string_view name) { return near_name(name, known); };
    CHECK(near("presure") == "pressure");
    CHECK(near("pressrue") == "pressure");
    CHECK(near("Pressure") == "pressure");
    CHECK(near("conact_modulus") == "contact_modulus");
    CHECK(near("contactmodulus") == "contact_modulus");
    CHECK(near("digit") == "digits");
    CHECK(near("flat_and_rounded") == "flat-and-rounded");
    CHECK(near("A") == "a");
    CHECK(near("p") == "P");
    CHECK(near("nu") == "nu1"); // one of three letters is missing
    CHECK(near("P1") == "");
    CHECK(near("nu3") == "nu1");
    CHECK(near("b") == "");
    CHECK(near("heat") == "");
    CHECK(near("") == "");
    CHECK(near(std::string(1000, 'p')) == "");
    CHECK(one_of("digit", known).find("did you mean digits? write one of pressure, ") == 0);
    CHECK(one_of("heat", known).find("write one of pressure, contact_modulus, a, P, ") == 0);
}
