// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/scene.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/paths.hpp"

#include <doctest/doctest.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

// The cases of reference/hard-cases.toml, by balls, are compared with tests/oracles/hard-cases.csv,
// which tests/oracles/hard_cases.py computes with mpmath.
namespace {

constexpr unsigned hard_digits = 50;
/// The digits that are added until a difference of other values has its own.
constexpr unsigned most_added = 4000;

Digits rounded_to(unsigned digits) { return {digits, Rounding::nearest, false}; }

std::optional<Quantity> hard_quantity(const std::string& name) {
    for (const QuantityRow& row : quantity_rows()) {
        if (row.name == name) {
            return row.quantity;
        }
    }
    return std::nullopt;
}

struct HardCase {
    std::string name;
    std::string quantity; ///< also residual and tilt-difference, which are made of others
    Scene scene;
    AskedValue asked;
    Real expected;
};

HardCase read_case(const std::string& name, const TomlSection& section) {
    HardCase c{name, section.text("quantity"), read_contact(section), {}, {}};
    const auto quantity = hard_quantity(c.quantity == "residual"          ? "relative-error"
                                        : c.quantity == "tilt-difference" ? "pressure"
                                                                          : c.quantity);
    REQUIRE_MESSAGE(quantity, name);
    c.asked.quantity = *quantity;
    const QuantityRow& row = row_of(*quantity);
    if (section.has("edge")) {
        c.asked.edge = edge_named(section.text("edge")).value();
    }
    if (row.at_point()) {
        c.asked.u = section.exact("u");
    }
    if (row.of_bodies()) {
        c.asked.in_body = {section.exact("x"), section.exact("z"), Body::A};
    }
    if (row.tolerance) {
        c.asked.tolerance = parse_tolerance(section.text("tolerance"));
    }
    if (row.index != QuantityRow::Index::none) {
        c.asked.k = section.count("n", 0, 20);
    }
    return c;
}

std::vector<HardCase> hard_cases() {
    const auto root = test::source_dir();
    const std::string toml = (root / "reference" / "hard-cases.toml").string();
    const std::string csv = (root / "tests" / "oracles" / "hard-cases.csv").string();
    std::map<std::string, std::string> values;
    for (const auto& row : parse_csv(read_text(csv, "stored values"), csv).rows) {
        values[row.cells.at(0)] = row.cells.at(1);
    }
    const TomlSection all =
        TomlSection::parse(read_text(toml, "hard cases"), toml).section("cases");
    std::vector<HardCase> cases;
    const PrecisionScope scope(80);
    for (const std::string& name : all.keys()) {
        cases.push_back(read_case(name, all.section(name)));
        CAPTURE(name);
        REQUIRE(values.contains(name));
        cases.back().expected = Real(values.at(name));
    }
    CHECK(values.size() == cases.size());
    return cases;
}

/// The same scene with zero tilt.
Scene upright(const Scene& scene) {
    const Exact none = Exact::of(Rational(0));
    const auto& parameters = scene.profile->parameters();
    Scene s = scene;
    s.profile =
        scene.profile->kind() == Profile::Kind::tilted_wedge
            ? Profile::tilted_wedge(parameters.at("phi"), none)
            : Profile::tilted_flat_and_rounded(none, parameters.at("t"), parameters.at("R"));
    return s;
}

BoundedValue single(const Scene& scene, const AskedValue& asked, unsigned digits) {
    return SceneValues(scene, {asked}, rounded_to(digits)).value(asked);
}

/// 1 - (the first n terms)/p, with its sign; p = sum of c_k u^(k + 1/2) (docs/expansions.md).
BoundedValue residual(const Scene& scene, const AskedValue& asked, unsigned digits) {
    std::vector<AskedValue> all{asked};
    all.front().quantity = Quantity::p;
    for (std::size_t k = 0; k < asked.k; ++k) {
        all.push_back({Quantity::c, k, asked.edge});
    }
    SceneValues values(scene, all, rounded_to(digits));
    const BoundedValue p = values.value(all.front());
    const Ball u = ball_of(*asked.u, bits_for(digits) + 64);
    Ball sum;
    bool proved = p.proved;
    for (std::size_t k = asked.k; k-- > 0;) {
        const BoundedValue c = values.value(all[k + 1]);
        proved = proved && c.proved;
        sum = k + 1 < asked.k ? sum * u + c.value : c.value;
    }
    return {1 - sum * sqrt(u) / p.value, proved, "series"};
}

BoundedValue tilt_difference(const Scene& scene, const AskedValue& asked, unsigned digits) {
    const BoundedValue p = single(scene, asked, digits);
    const BoundedValue q = single(upright(scene), asked, digits);
    return {p.value - q.value, p.proved && q.proved, p.route};
}

BoundedValue enclosed(const HardCase& c) {
    const auto difference = c.quantity == "residual"          ? residual
                            : c.quantity == "tilt-difference" ? tilt_difference
                                                              : nullptr;
    if (difference == nullptr) {
        return single(c.scene, c.asked, hard_digits);
    }
    for (unsigned added = 32;; added *= 2) {
        const BoundedValue d = difference(c.scene, c.asked, hard_digits + added);
        if (has_digits(d.value, rounded_to(hard_digits)) || added >= most_added) {
            return d;
        }
    }
}

void check_case(const HardCase& c) {
    CAPTURE(c.name);
    const BoundedValue ours = enclosed(c);
    CHECK(ours.proved);
    CHECK(printed(ours, rounded_to(hard_digits)).complete);
    // Every number of the ball is within a unit of the last digit of the stored value.
    const PrecisionScope scope(80);
    CHECK(digits_reached(c.expected, ours.value) + 1 >= hard_digits);
}

} // namespace

TEST_CASE("every hard case has the digits of mpmath") {
    const std::vector<HardCase> cases = hard_cases();
    CHECK(cases.size() >= 325);
    for (const HardCase& c : cases) {
        check_case(c);
    }
}
