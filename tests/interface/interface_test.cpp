// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/edgeproof.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/paths.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

using namespace edgeproof;
using namespace edgeproof::test;

namespace {

std::string message_of(const Scene& scene, const std::string& quantity, const std::string& where) {
    try {
        (void)scene.value(quantity, where);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

} // namespace

// Hertz (johnson1985, sec. 4.2(a)), g' = x, E* = 2: p = sqrt(1 - x^2), P = pi/2. One term is 1 %
// off at u = 2 (1 - 1.01^-2), 25 % at 0.72.
TEST_CASE("edgeproof.hpp: values of a scene in words") {
    const Scene hertz("kind=hertz R=1 a=1 contact_modulus=2");
    const std::vector<Value> values = hertz.values({{"p", "u=2/5"},
                                                    {"p", "x=a/2"},
                                                    {"p", "x=2"},
                                                    {"c_0", "edge=left"},
                                                    {"P"},
                                                    {"extent_1", "tolerance=1%"},
                                                    {"extent_1", "tolerance=25%"},
                                                    {"extent_fraction_1"},
                                                    {"rel_1", "u=1"}},
                                                   12);
    const std::array texts{"0.800000000000", "0.866025403784", "0",
                           "1.41421356237",  "1.57079632679",  "0.0394079011861",
                           "0.72",           "0.019703950593", "0.4142135623731"};
    REQUIRE(values.size() == texts.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        CAPTURE(i);
        CHECK(std::abs(std::stod(values[i].text) - std::stod(texts.at(i))) < 1e-11);
        CHECK(values[i].proved);
        CHECK(std::stod(values[i].bound) <= 1e-11);
    }
    CHECK(values[0].text == texts[0]);
    CHECK(hertz.value("p", "u=1", 3).text == "1.00");

    const std::array x{-2.0, 0.0, 0.6};
    std::array<double, 3> p{};
    hertz.pressures(x, p);
    CHECK(p == std::array{0.0, 1.0, 0.8});
}

TEST_CASE("edgeproof.hpp: a file of a scene, words in place of its keys, and its text") {
    const std::string file = (source_dir() / "examples/scenes/fig2c-hertz.toml").string();
    const Scene half(file + " a=1/2");
    CHECK(std::stod(half.value("a").text) == 0.5);
    CHECK_THROWS_AS(Scene("no-such-file.toml"), InputError);
    CHECK_THROWS_WITH_AS((void)Scene::from_text("[profile]\nkind = 3\n", "mine.toml"),
                         doctest::Contains("mine.toml:1: there is no section [load]"), InputError);
}

TEST_CASE("edgeproof.hpp: questions that make no sense are refused with what to write") {
    const Scene hertz("kind=hertz R=1 a=1 contact_modulus=2");
    for (const auto& [quantity, where, words] : {std::array{"p", "", "add u="},
                                                 {"pp", "u=1", "write p, q"},
                                                 {"p", "v=1", "write u="},
                                                 {"p", "u", "write u="},
                                                 {"c_0", "edge=top", "no edge 'top'"},
                                                 {"sxx", "at=1", "add at=X,Z"},
                                                 {"sxx", "at=0,1 body=C", "write A"},
                                                 {"q", "u=1", "add Q or bulk_tension"},
                                                 {"c_0", "edge=right x", "write u="},
                                                 {"extent_1", "tolerance=-1", "tolerance > 0"}}) {
        const std::string message = message_of(hertz, quantity, where);
        CAPTURE(message);
        CHECK(message.find(words) != std::string::npos);
    }
    const Scene part("kind=hertz R=1 a=1 contact_modulus=2 part=0.1,0.5"); // the error is below 1
    CHECK(message_of(part, "extent_1", "tolerance=200%").find("there is no") != std::string::npos);
    std::array<double, 2> p{};
    CHECK_THROWS_AS(hertz.pressures(std::array{0.0}, p), Error);
    CHECK_THROWS_AS((void)hertz.value("P", "", 1), InputError);
    CHECK_THROWS_AS(hertz.stresses(p, p, {p, p, p, p, std::span(p).first(1), p}), Error);
    CHECK_THROWS_AS((void)verify("none.toml", 5), InputError);
    CHECK_THROWS_AS((void)check("none.toml", "none.csv", 0), InputError);
}

TEST_CASE("edgeproof.hpp: formulas, programs and meshes are checked") {
    const Folder folder;
    folder.write("hertz.toml", R"([ledger]
name = "Hertz"
[[family]]
name = "hertz"
profile = "power-law"
count = 3
parameters = { m = ["1"], C = ["3/7"], a = ["3/2"], Es = ["7/3"] }
[[claim]]
id = "right"
kind = "compare"
says = "pi*Es*C*a^2/4"
of = "P"
over = "hertz"
[[claim]]
id = "wrong"
kind = "compare"
says = "pi*Es*C*a^2/2"
of = "P"
over = "hertz"
)");
    const std::vector<Verdict> verdicts = verify((folder.path() / "hertz.toml").string(), 30);
    REQUIRE(verdicts.size() == 2);
    CHECK((verdicts[0].verdict == "proved" || verdicts[0].verdict == "confirmed"));
    CHECK(verdicts[1].verdict == "refuted");
    CHECK_FALSE(verdicts[1].correct.empty());

    folder.write("recipe.toml", R"([scenes.h]
quantities = ["P", "a"]
profile = { kind = "power-law", m = "1", C = "1" }
load = { a = "1", contact_modulus = "2" }
)");
    for (const std::string P : {"1.5707963267948966", "0.78539816339744831"}) {
        const auto answers = folder.write("answers.csv", "id,value\nh:P," + P + "\nh:a,1\n");
        const Outcome found = check((folder.path() / "recipe.toml").string(), answers.string(), 12);
        CAPTURE(found.text);
        CHECK(found.passes == P.starts_with("1.57"));
    }
    // Nodes of p = sqrt(1 - x^2), and twice it.
    const Scene hertz("kind=hertz R=1 a=1 contact_modulus=2");
    for (const double factor : {1.0, 2.0}) {
        std::string rows = "x,p\n";
        for (int k = -50; k <= 50; ++k) {
            const double x = k / 50.0;
            rows += std::to_string(x) + "," +
                    std::to_string(factor * std::sqrt(std::max(0.0, 1 - x * x))) + "\n";
        }
        folder.write("mesh.csv", rows);
        const Outcome found = compare(hertz, {(folder.path() / "mesh.csv").string()}, "1%");
        CHECK(found.passes == (factor == 1.0));
        CHECK(found.json.find(factor == 1.0 ? "\"passes\": true" : "factor-2") !=
              std::string::npos);
    }
}
