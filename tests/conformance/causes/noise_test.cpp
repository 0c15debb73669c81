// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/convention.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <functional>
#include <random>

// named_causes_test.cpp has the mistakes that must be named under noise; here nothing must be
// named.

namespace {

const std::string noisy_head =
    "id,kind,m,C,phi,alpha,t,R,a,P,E1,nu1,E2,nu2,quantity,edge,u,value\n";

/// The answers of a program to the rows: f(exact value) for each.
Answers answered(const std::vector<std::string>& rows, const std::function<double(double)>& f) {
    const auto with = [&](const std::function<double(std::size_t)>& value) {
        std::string text = noisy_head;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            text += fmt::format("{},{},{:.17g}\n", i, rows[i], value(i));
        }
        return echoed_answers(parse_csv(text, "a"));
    };
    const auto exact = compare(with([](std::size_t) { return 1; }), {}, {}).references;
    return with(
        [&](std::size_t i) { return f(exact[i].value.value.midpoint().convert_to<double>()); });
}

/// The load, three coefficients and eight pressures at each edge of contacts with a closed form.
std::vector<std::string> rows_of_every_kind() {
    std::vector<std::string> rows;
    for (const std::string contact :
         {"power-law,1,1/50,,,,,2", "power-law,0,0.1,,,,,0.7", "flat-and-rounded,,,,,0.5,20,1.5",
          "tilted-wedge,,,0.2,0.05,,,1.3", "tilted-flat-and-rounded,,,,0.01,1,9,3"}) {
        const std::string bodies = contact + ",,115,0.32,70,0.25,";
        rows.push_back(bodies + "P,,");
        for (const std::string edge : {"right", "left"}) {
            for (const std::string c : {"c_0", "c_1", "c_2"}) {
                rows.push_back(bodies + c + "," + edge + ",");
            }
            for (const std::string u :
                 {"1e-6", "1e-3", "0.01", "0.03", "0.1", "0.17", "0.31", "0.6"}) {
                rows.push_back(bodies + "p," + edge + "," + u);
            }
        }
    }
    return rows;
}

} // namespace

TEST_CASE("noise alone has no cause, and errors without a cause are reported as such") {
    std::mt19937_64 random(2);
    std::normal_distribution<double> normal;
    for (const double noise : {1e-6, 1e-4, 1e-2, 0.1, 1.0}) {
        CAPTURE(noise);
        const Answers answers = answered(rows_of_every_kind(), [&](double exact) {
            return exact * (1 + noise * normal(random));
        });
        const Agreements agreements = compare(answers, Target{7, {}, false}, {});
        const auto found = infer_conventions(answers, agreements, {});
        CHECK(found.empty());
        CHECK(unexplained(answers, agreements, found) == std::vector<std::string>{"P", "c_k", "p"});
    }
}

// With half of P, p at these places of a nearly flat contact is 0.79 times p, to 2 %.
TEST_CASE("a constant is not called a mistake that nearly has its effect") {
    std::vector<std::string> rows;
    for (const std::string P : {"20", "30"}) {
        for (const std::string edge : {"right", "left"}) {
            for (const std::string u : {"0.01", "0.013", "0.016", "0.02", "0.023", "0.027", "0.03",
                                        "0.034", "0.037", "0.04", "0.046", "0.055"}) {
                rows.push_back("flat-and-rounded,,,,,1,50,," + P + ",9000,0.3,9000,0.3,p," + edge +
                               "," + u);
            }
        }
    }
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    for (const double noise : {0.0, 1e-4, 1e-3}) {
        CAPTURE(noise);
        const Answers answers = answered(
            rows, [&](double exact) { return exact * 0.795 * (1 + noise * normal(random)); });
        const auto found =
            infer_conventions(answers, compare(answers, Target{5, {}, false}, {}), {});
        REQUIRE(found.size() == 1);
        CAPTURE(found[0].relation);
        CHECK(found[0].name == "factor");
        CHECK(found[0].factor == doctest::Approx(0.795).epsilon(1e-3));
        CHECK(found[0].also.empty());
    }
}
