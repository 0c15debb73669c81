// SPDX-License-Identifier: BSD-3-Clause
// The values of values.txt and of the tables of tests/oracles; values.txt describes the rows.
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/input/scene_words.hpp"
#include "tests/scene/scene_words.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <ios>
#include <optional>
#include <set>

using namespace edgeproof::scenes;

namespace {

/// A question of a cell; the cells of a row share the words of the place.
struct Question {
    AskedValue asked;
    std::string name;
    std::map<std::string, std::string> place; ///< its keys; also j and digits
    bool greatest = false;

    void read(const std::string& text);
    [[nodiscard]] Digits digits() const {
        const auto given = place.find("digits");
        const unsigned count =
            given == place.end() ? 30 : static_cast<unsigned>(std::stoul(given->second));
        return {row_of(asked.quantity).short_error ? std::min(count, 20U) : count};
    }
};

void Question::read(const std::string& text) {
    greatest = false;
    for (const std::string& word : words_of(text)) {
        const std::size_t equals = word.find('=');
        if (equals != std::string::npos) {
            const std::string key = word.substr(0, equals);
            place[key == "tol"   ? "tolerance"
                  : key == "ref" ? "reference"
                                 : key] = word.substr(equals + 1);
            if (word[0] == 'u' || word[0] == 'x') {
                place.erase(word[0] == 'u' ? "x" : "u");
            }
        } else if (word == "left" || word == "right") {
            place["edge"] = word;
        } else if (word == "greatest") {
            greatest = true;
        } else {
            name = word == "moved" ? "slip_displacement" : word;
        }
    }
    if (greatest) {
        place.emplace("at", "0,0"); // not used
    }
    asked = asked_value(name, place, {});
    const auto j = place.find("j");
    asked.j = j == place.end() ? 0 : std::stoul(j->second);
}

BoundedValue value_of(const std::string& scene, const Question& q, const Digits& digits) {
    const Scene s = made(scene);
    SceneValues values(s, {q.asked}, digits);
    return row_of(q.asked.quantity).searched && q.asked.quantity != Quantity::extent
               ? values.searched(q.asked).value.value()
               : values.value(q.asked);
}

/// Replaces {QUESTION} and {SCENE : QUESTION} by the value, from inside to outside.
std::string filled(std::string text, const std::string& scene, const Question& here) {
    for (std::size_t end = 0; (end = text.find('}')) != std::string::npos;) {
        const std::size_t begin = text.rfind('{', end);
        const std::string inner = text.substr(begin + 1, end - begin - 1);
        const std::size_t colon = inner.find(" : ");
        Question q = here;
        q.read(colon == std::string::npos ? inner : inner.substr(colon + 3));
        const Digits digits{q.digits().count + 15};
        const BoundedValue value =
            value_of(colon == std::string::npos ? scene : inner.substr(0, colon), q, digits);
        CHECK(value.proved);
        text.replace(begin, end + 1 - begin,
                     "(" +
                         value.value.midpoint().str(std::max(70U, digits.count + 5),
                                                    std::ios_base::scientific) +
                         ")");
    }
    return text;
}

Ball power_of_10(int n) { return Ball(pow_int(Ball(10, 128), n)); }

/// The last place of a decimal.
Ball last_place(const std::string& decimal) {
    const std::string digits = decimal.substr(0, decimal.find('e'));
    const std::size_t dot = digits.find('.');
    const int places = dot == std::string::npos ? 0 : static_cast<int>(digits.size() - dot - 1);
    const int power =
        digits.size() == decimal.size() ? 0 : std::stoi(decimal.substr(digits.size() + 1));
    return power_of_10(power - places);
}

/// Checks "= FORMULA": the enclosure contains the value of the formula, and has the digits.
void check_equal(const BoundedValue& found, const std::string& formula, const Digits& digits,
                 bool relation) {
    const Ball exact = enclosed_constant(Exact::parse(formula), bits_for(digits.count) + 200);
    const Ball size = contains_zero(exact) ? Ball(1, 128) : abs(exact);
    CHECK(found.proved);
    if (relation) {
        const Ball off = abs(Ball(found.value - exact));
        CHECK(certainly_less(off, size * power_of_10(2 - static_cast<int>(digits.count))));
        return;
    }
    CHECK(overlaps(found.value, exact));
    CHECK(certainly_less(Ball(found.value.radius(), 128),
                         size * power_of_10(1 - static_cast<int>(digits.count))));
    const PrintedValue expected = printed({exact, true, ""}, digits);
    if (expected.complete && !contains_zero(exact)) {
        CHECK(printed(found, digits).text == expected.text);
    }
}

/// Checks "~ DECIMAL" and "~ DECIMAL +-BOUND".
void check_near(const BoundedValue& found, const std::string& text) {
    const auto words = words_of(text);
    const Ball bound = words.size() < 2 ? last_place(words[0])
                                        : enclosed_constant(Exact::parse(words[1].substr(2)), 128);
    const bool decimal = words[0].find_first_not_of("-.0123456789e") == std::string::npos;
    const long bits = std::max(400L, found.value.bits());
    const Ball exact = decimal ? Ball(parse_decimal(words[0]), bits)
                               : enclosed_constant(Exact::parse(words[0]), bits);
    const Ball off = abs(Ball(found.value - exact));
    CHECK(found.proved);
    CHECK(off.upper() <= bound.upper());
}

/// Checks "prints NEAREST DOWN UP", or one text for all three.
void check_printed(const std::string& scene, const Question& q, const std::string& text) {
    const auto words = words_of(text);
    constexpr std::array modes{Rounding::nearest, Rounding::down, Rounding::up};
    for (std::size_t i = 0; i < modes.size(); ++i) {
        const Digits digits{q.digits().count, modes.at(i)};
        const BoundedValue value = value_of(scene, q, digits);
        const PrintedValue p = printed(value, digits);
        CHECK(p.text == words.at(words.size() == 1 ? 0 : i));
        CHECK(value.proved);
        CHECK(p.complete);
        CHECK_FALSE(p.undecided);
        CHECK(how(value, p) == value.route);
    }
}

void check_fails(const std::string& words, const auto& f) {
    try {
        f();
        FAIL_CHECK("not refused");
    } catch (const Error& error) {
        CHECK_MESSAGE(std::string(error.what()).find(words) != std::string::npos, error.what());
    }
}

void check_greatest(const std::string& scene, const Question& q, const std::string& op,
                    const std::string& expected) {
    Scene s = made(scene);
    s.ask.digits = q.digits();
    const Body body = q.place.contains("body") && q.place.at("body") == "B" ? Body::B : Body::A;
    const auto greatest = [&] { return greatest_value(s, q.asked.quantity, body); };
    if (op == " fails ") {
        check_fails(expected, greatest);
        return;
    }
    const GreatestValue found = greatest();
    const std::size_t at = expected.find(" at ");
    const auto place = words_of(expected.substr(at + 4));
    const std::string value = expected.substr(0, at);
    const std::string bound =
        value.find(' ') == std::string::npos ? "" : value.substr(value.find(' '));
    const auto check = [&](const BoundedValue& x, const std::string& text) {
        if (op == " = ") {
            check_equal(x, text, s.ask.digits, false);
        } else if (text == "0") {
            CHECK(x.exactly == Rational(0));
        } else {
            check_near(x, text);
        }
    };
    check(found.value, value);
    check(found.x, place.at(0) == "0" ? "0" : place.at(0) + bound);
    check(found.z, place.at(1) == "0" ? "0" : place.at(1) + bound);
}

/// The quantities of the rows that were checked.
std::set<Quantity> seen;

void check_cell(const std::string& scene, Question& q, const std::string& cell) {
    for (const std::string op : {" = ", " == ", " ~ ", " prints ", " < ", " > ", " fails "}) {
        const std::size_t at = cell.find(op);
        if (at == std::string::npos) {
            continue;
        }
        q.read(filled(cell.substr(0, at), scene, q));
        seen.insert(q.asked.quantity);
        const std::string given = cell.substr(at + op.size());
        const std::string expected = filled(given, scene, q);
        if (q.greatest) {
            check_greatest(scene, q, op, expected);
        } else if (op == " prints ") {
            check_printed(scene, q, expected);
        } else if (op == " fails ") {
            check_fails(expected, [&] { return value_of(scene, q, q.digits()); });
        } else {
            const BoundedValue found = value_of(scene, q, q.digits());
            CAPTURE(found);
            if (op == " = ") {
                check_equal(found, expected, q.digits(), expected != given);
            } else if (op == " ~ ") {
                check_near(found, expected);
            } else if (op == " == ") {
                const Rational exact = Exact::parse(expected).rational();
                CHECK((found.exactly ? *found.exactly == exact
                                     : found.value.is_exact() && contains(found.value, exact)));
            } else {
                const Ball limit = enclosed_constant(Exact::parse(expected), 400);
                CHECK(found.proved);
                CHECK((op == " < " ? certainly_less(found.value, limit)
                                   : certainly_less(limit, found.value)));
            }
        }
        return;
    }
    FAIL("no value in " << cell);
}

void check_table(const std::string& table, bool slow) {
    Question q;
    std::string scene;
    for (const TableRow& row : rows_of(table)) {
        if (row.slow != slow) {
            continue;
        }
        CAPTURE(row.at);
        CAPTURE(row.scene);
        if (!row.continues) {
            q = {};
            scene = filled(row.scene, "", q);
        }
        for (const std::string& cell : row.cells) {
            CAPTURE(cell);
            try {
                check_cell(scene, q, cell);
            } catch (const Error& error) {
                FAIL_CHECK(std::string(error.what()));
            }
        }
    }
}

} // namespace

TEST_CASE("the values of bodies of revolution of the oracles") {
    check_table("oracles/axisymmetric.txt", false);
    check_table("oracles/stress_of_revolution.txt", false);
}
TEST_CASE("the values of more bodies of revolution of the oracles" * doctest::test_suite("slow")) {
    check_table("oracles/axisymmetric.txt", true);
    check_table("oracles/stress_of_revolution.txt", true);
}
TEST_CASE("every hard case has the digits of mpmath") {
    check_table("oracles/hard-cases.txt", false);
}
TEST_CASE("values of scenes: closed forms, mpmath and relations") {
    check_table("scene/values.txt", false);
    for (const QuantityRow& row : quantity_rows()) {
        CHECK_MESSAGE((row.quantity == Quantity::u || seen.contains(row.quantity)), row.name);
    }
}
TEST_CASE("values of scenes that take longer" * doctest::test_suite("slow")) {
    check_table("scene/values.txt", true);
}
