// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/input/scene_words.hpp"
#include "edgeproof/scene/scene.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/paths.hpp"

#include <doctest/doctest.h>

#include <algorithm>
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

struct HardCase {
    std::string name;
    std::string quantity; ///< also residual and tilt-difference, which are made of others
    TomlSection section;
    Scene scene;
    AskedValue asked;
    Real expected;
};

HardCase read_case(const std::string& name, const TomlSection& section) {
    HardCase c{name, section.text("quantity"), section, read_contact(section), {}, {}};
    const std::string quantity = c.quantity == "residual"          ? "relative-error"
                                 : c.quantity == "tilt-difference" ? "pressure"
                                                                   : c.quantity;
    const auto row = std::ranges::find(quantity_rows(), quantity, &QuantityRow::name);
    REQUIRE_MESSAGE(row != quantity_rows().end(), name);
    std::map<std::string, std::string> where;
    for (const char* const key : {"edge", "u", "tolerance"}) {
        if (section.has(key)) {
            where[key] = section.text(key);
        }
    }
    if (section.has("x")) {
        where["at"] = section.text("x") + "," + section.text("z");
    }
    std::string symbol(row->symbol.empty() ? row->label : row->symbol);
    if (row->index != QuantityRow::Index::none) {
        symbol += "_" + std::to_string(section.count("n", 0, 20));
    }
    c.asked = asked_value(symbol, where, {});
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

BoundedValue single(const Scene& scene, const AskedValue& asked, unsigned digits) {
    return SceneValues(scene, {asked}, Digits{digits}).value(asked);
}

/// 1 - (the first n terms)/p, with its sign; p = sum of c_k u^(k + 1/2) (docs/expansions.md).
BoundedValue residual(const HardCase& c, unsigned digits) {
    const AskedValue& asked = c.asked;
    std::vector<AskedValue> all{asked};
    all.front().quantity = Quantity::p;
    for (std::size_t k = 0; k < asked.k; ++k) {
        all.push_back({Quantity::c, k, asked.edge});
    }
    SceneValues values(c.scene, all, Digits{digits});
    const BoundedValue p = values.value(all.front());
    const Ball u = ball_of(*asked.u, bits_for(digits) + 64);
    Ball sum;
    bool proved = p.proved;
    for (std::size_t k = asked.k; k-- > 0;) {
        const BoundedValue c_k = values.value(all[k + 1]);
        proved = proved && c_k.proved;
        sum = k + 1 < asked.k ? sum * u + c_k.value : c_k.value;
    }
    return {1 - sum * sqrt(u) / p.value, proved, "series"};
}

BoundedValue tilt_difference(const HardCase& c, unsigned digits) {
    const auto upright = [](std::string_view, std::string_view key, const std::string*) {
        return key == "alpha" ? std::optional<std::string>("0") : std::nullopt;
    };
    const BoundedValue p = single(c.scene, c.asked, digits);
    const BoundedValue q =
        single(read_contact(c.section.changed({"profile", "load"}, upright)), c.asked, digits);
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
        const BoundedValue d = difference(c, hard_digits + added);
        if (has_digits(d.value, Digits{hard_digits}) || added >= most_added) {
            return d;
        }
    }
}

void check_case(const HardCase& c) {
    CAPTURE(c.name);
    const BoundedValue ours = enclosed(c);
    CHECK(ours.proved);
    CHECK(printed(ours, Digits{hard_digits}).complete);
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
