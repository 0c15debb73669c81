// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/convention.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <random>

// Known mistakes in the exact answers of several contacts, with noise: each is named as long as the
// noise allows it, and no other mistake is named.

namespace {

using QuestionCells = std::map<std::string, std::string>; ///< the value for each column

const std::vector<std::string> columns{"kind", "m",  "C",  "phi", "alpha", "t",    "R", "a",
                                       "P",    "E1", "E2", "nu1", "nu2",   "edge", "u", "quantity"};

/// Returns points of both edges, coefficients and the load of contacts of every kind with a closed
/// form.
std::vector<QuestionCells> right_questions() {
    const std::vector<QuestionCells> contacts{
        {{"kind", "power-law"}, {"m", "1"}, {"C", "1/50"}, {"a", "2"}},
        {{"kind", "power-law"}, {"m", "0"}, {"C", "0.1"}, {"a", "0.7"}},
        {{"kind", "flat-and-rounded"}, {"t", "0.5"}, {"R", "20"}, {"a", "1.5"}},
        {{"kind", "tilted-wedge"}, {"phi", "0.2"}, {"alpha", "0.05"}, {"a", "1.3"}},
        {{"kind", "tilted-flat-and-rounded"},
         {"t", "1"},
         {"R", "9"},
         {"alpha", "0.01"},
         {"a", "3"}},
    };
    std::vector<QuestionCells> all;
    for (QuestionCells q : contacts) {
        q.insert({{"E1", "115"}, {"nu1", "0.32"}, {"E2", "70"}, {"nu2", "0.25"}});
        q["quantity"] = "P";
        all.push_back(q);
        for (const char* edge : {"right", "left"}) {
            q["edge"] = edge;
            for (const char* c : {"c_0", "c_1", "c_2"}) {
                q["quantity"] = c;
                all.push_back(q);
            }
            q["quantity"] = "p";
            for (const char* u : {"1e-6", "1e-3", "0.01", "0.03", "0.1", "0.17", "0.31", "0.6"}) {
                q["u"] = u;
                all.push_back(q);
            }
            q.erase("u");
        }
    }
    return all;
}

std::string csv(const std::vector<QuestionCells>& questions, const std::vector<double>& values) {
    std::string text = "id";
    for (const std::string& column : columns) {
        text += "," + column;
    }
    text += ",value\n";
    for (std::size_t i = 0; i < questions.size(); ++i) {
        text += std::to_string(i);
        for (const std::string& column : columns) {
            const auto cell = questions[i].find(column);
            text += "," + (cell == questions[i].end() ? "" : cell->second);
        }
        char value[40];
        std::snprintf(value, sizeof value, ",%.17g\n", values[i]);
        text += value;
    }
    return text;
}

std::vector<double> exact_values(const std::vector<QuestionCells>& questions) {
    const Answers asked =
        echoed_answers(parse_csv(csv(questions, std::vector<double>(questions.size(), 1)), "a"));
    std::vector<double> values;
    for (const Reference& r : compare(asked, {}, {}).references) {
        values.push_back(r.value.value.midpoint().convert_to<double>());
    }
    return values;
}

struct Mistake {
    std::string relation; ///< the expected relation
    std::function<void(QuestionCells&)> change = [](QuestionCells&) {};
    double factor = 1; ///< the factor of quantities that are not sizes
};

void times(QuestionCells& q, const std::string& column, const std::string& by) {
    if (const auto cell = q.find(column); cell != q.end()) {
        cell->second = "(" + cell->second + ")" + by;
    }
}

std::vector<Mistake> mistakes() {
    const auto cell = [](const std::string& column, const std::string& by) {
        return [=](QuestionCells& q) { times(q, column, by); };
    };
    const auto one_modulus = [](const std::string& formula) {
        return [=](QuestionCells& q) {
            for (const char* key : {"nu1", "nu2"}) {
                q[key] = "0";
            }
            q["E1"] = formula;
            q["E2"] = "10^40"; // rigid
        };
    };
    return {
        {"2 times ours", {}, 2},
        {"1/2 times ours", {}, 0.5},
        {"pi times ours", {}, 3.14159265358979323846},
        {"1/(2 pi) times ours", {}, 1 / 6.28318530717958647692},
        {"sqrt(2 pi) times ours", {}, 2.50662827463100050242},
        {"1/sqrt(2) times ours", {}, 0.70710678118654752440},
        {"minus ours", {}, -1},
        {"9.80665 times ours", {}, 9.80665},
        {"10^-3 times ours", {}, 1e-3},
        {"1.37 times ours", {}, 1.37},
        {"ours with half the radius", cell("R", "/2")},
        {"ours with the length of the flat instead of its half-length", cell("t", "*2")},
        {"ours with a quarter of the width instead of a", cell("a", "*0.5")},
        {"ours with the angle converted from degrees to radians twice",
         [](QuestionCells& q) {
             times(q, "alpha", "*pi/180");
             times(q, "phi", "*pi/180");
         }},
        {"ours with E/(1 - nu^2) of body 1 instead of E*", one_modulus("115/(1-0.32^2)")},
        {"ours with plane stress, 1/E* = 1/E1 + 1/E2", one_modulus("115*70/185")},
        {"ours at the other edge",
         [](QuestionCells& q) {
             if (const auto edge = q.find("edge"); edge != q.end()) {
                 edge->second = edge->second == "left" ? "right" : "left";
             }
         }},
    };
}

/// True if the relation is named; a factor without a name must be found to the digits that the
/// noise allows.
bool says(const Convention& c, const std::string& relation, double noise) {
    const auto is_it = [&](const std::string& said) {
        const bool factor = relation == "1.37 times ours" && said.ends_with(" times ours");
        return said == relation ||
               (factor && std::abs(std::atof(said.c_str()) / 1.37 - 1) <= 3 * noise);
    };
    return is_it(c.relation) || std::any_of(c.also.begin(), c.also.end(), is_it);
}

} // namespace

TEST_CASE("known mistakes are named under noise, and no others") {
    const std::vector<QuestionCells> questions = right_questions();
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (const Mistake& mistake : mistakes()) {
        std::vector<QuestionCells> otherwise = questions;
        for (QuestionCells& q : otherwise) {
            if (mistake.change) {
                mistake.change(q);
            }
        }
        const std::vector<double> exact = exact_values(otherwise);
        KnownReadings known;
        for (const double noise : {0.0, 1e-6, 3e-6, 1e-4, 1e-2}) {
            std::vector<double> values = exact;
            for (double& v : values) {
                v *= mistake.factor * (1 + noise * normal(random));
            }
            const Answers answers = echoed_answers(parse_csv(csv(questions, values), "a"));
            const Agreements agreements = compare(answers, Target{5, {}, false}, {});
            const auto found = infer_conventions(answers, agreements, {}, known);
            CAPTURE(mistake.relation);
            CAPTURE(noise);
            bool right = false;
            for (const Convention& c : found) {
                CAPTURE(c.of);
                CAPTURE(c.relation);
                right = right || says(c, mistake.relation, noise);
                CHECK(says(c, mistake.relation, noise)); // only this one is named
            }
            CHECK(right);
        }
    }
}

TEST_CASE("noise alone has no cause, and errors without a cause are reported as such") {
    const std::vector<QuestionCells> questions = right_questions();
    std::mt19937_64 random(2);
    std::normal_distribution<double> normal;
    const std::vector<double> exact = exact_values(questions);
    for (const double noise : {1e-6, 1e-4, 1e-2, 0.1, 1.0}) {
        std::vector<double> values = exact;
        for (double& v : values) {
            v *= 1 + noise * normal(random);
        }
        const Answers answers = echoed_answers(parse_csv(csv(questions, values), "a"));
        const Agreements agreements = compare(answers, Target{7, {}, false}, {});
        const auto found = infer_conventions(answers, agreements, {});
        CAPTURE(noise);
        CHECK(found.empty());
        CHECK(unexplained(answers, agreements, found) == std::vector<std::string>{"P", "c_k", "p"});
    }
}

// With half of P, p at these places of a nearly flat contact is 0.79 times p, to 2 %.
TEST_CASE("a constant is not called a mistake that nearly has its effect") {
    std::vector<QuestionCells> questions;
    for (const char* P : {"20", "30"}) {
        for (const char* edge : {"right", "left"}) {
            for (const char* u : {"0.01", "0.013", "0.016", "0.02", "0.023", "0.027", "0.03",
                                  "0.034", "0.037", "0.04", "0.046", "0.055"}) {
                questions.push_back({{"kind", "flat-and-rounded"},
                                     {"t", "1"},
                                     {"R", "50"},
                                     {"P", P},
                                     {"E1", "9000"},
                                     {"nu1", "0.3"},
                                     {"E2", "9000"},
                                     {"nu2", "0.3"},
                                     {"edge", edge},
                                     {"u", u},
                                     {"quantity", "p"}});
            }
        }
    }
    const std::vector<double> exact = exact_values(questions);
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    for (const double noise : {0.0, 1e-4, 1e-3}) {
        CAPTURE(noise);
        std::vector<double> values = exact;
        for (double& v : values) {
            v *= 0.785 * (1 + noise * normal(random));
        }
        const Answers answers = echoed_answers(parse_csv(csv(questions, values), "a"));
        const auto found =
            infer_conventions(answers, compare(answers, Target{5, {}, false}, {}), {});
        REQUIRE(found.size() == 1);
        CAPTURE(found[0].relation);
        CHECK(found[0].name == "factor");
        CHECK(found[0].factor == doctest::Approx(0.785).epsilon(1e-3));
        CHECK(found[0].also.empty());
    }
}

TEST_CASE("a dominant factor is named with what remains, and is not called a constant") {
    const std::vector<QuestionCells> questions = right_questions();
    const std::vector<double> exact = exact_values(questions);
    struct Dominant {
        double factor;
        const char* name;
        std::vector<double> rests;
    };
    KnownReadings known;
    for (const Dominant& d :
         {Dominant{1000, "power-of-ten", {0.005, 0.04}}, Dominant{1e-3, "power-of-ten", {0.1}},
          Dominant{3.14159265358979323846, "factor-pi", {0.04}}, Dominant{0.5, "factor-2", {0.035}},
          Dominant{1.41421356237309504880, "factor-sqrt-2", {0.01}}}) {
        for (const double rest : d.rests) {
            std::vector<double> values = exact;
            for (std::size_t i = 0; i < values.size(); ++i) {
                const auto u = questions[i].find("u");
                const double part = u == questions[i].end() ? 0 : std::atof(u->second.c_str());
                const double slow = 1 + std::sin(static_cast<double>(i) / 20);
                values[i] *= d.factor * (1 + rest * (slow + std::sqrt(part)) / 2.8);
            }
            const Answers answers = echoed_answers(parse_csv(csv(questions, values), "a"));
            const auto found =
                infer_conventions(answers, compare(answers, Target{7, {}, false}, {}), {}, known);
            CAPTURE(d.factor);
            CAPTURE(rest);
            std::size_t rows = 0;
            double remains = 0;
            for (const Convention& c : found) {
                CAPTURE(c.of);
                CAPTURE(c.relation);
                CHECK(c.name == d.name);
                CHECK(c.factor == doctest::Approx(d.factor));
                rows += c.rows;
                remains = std::max(remains, c.remains);
            }
            CHECK(rows > questions.size() / 2);
            CHECK(remains > rest / 3);
            CHECK(remains < rest);
        }
    }
}

TEST_CASE("a constant that is nearly a common factor may be the factor and another mistake") {
    const std::vector<QuestionCells> questions = right_questions();
    const std::vector<double> exact = exact_values(questions);
    const std::vector<std::pair<double, std::string>> constants{
        {1040.0, "power-of-ten"}, {2.05, "factor-2"}, {1.37, "factor-sqrt-2"}, {1.2, ""}};
    for (const auto& tried : constants) {
        std::vector<double> values = exact;
        for (double& v : values) {
            v *= tried.first;
        }
        const Answers answers = echoed_answers(parse_csv(csv(questions, values), "a"));
        const auto found =
            infer_conventions(answers, compare(answers, Target{7, {}, false}, {}), {});
        CAPTURE(tried.first);
        REQUIRE(found.size() == 1);
        CHECK(found[0].name == "factor");
        CHECK(found[0].equally_likely == (tried.second.empty()
                                              ? std::vector<std::string>{}
                                              : std::vector<std::string>{tried.second}));
    }
}
