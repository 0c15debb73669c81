// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/error.hpp"
#include "tests/scene/scene_words.hpp"

#include <doctest/doctest.h>

#include <set>

using namespace edgeproof::scenes;

namespace {

using Index = QuantityRow::Index;

/// The words of the contacts of each kind of quantity, with lengths and moduli multiplied by the
/// arguments: a cylinder with a = 1 and Q = 3/10, one that slips, one by steps; a wedge under P and
/// M, whose tilt is unknown; a sphere.
std::string words_for(const QuantityRow& row, const std::string& L = "1",
                      const std::string& E = "1") {
    const std::string force = "*" + E + "*" + L;
    const std::string plain =
        "power-law m=1 C=1/" + L + " a=" + L + " E=" + E + " nu=1/4 Q=3/10" + force;
    const std::string friction = " friction=8/(5*pi)";
    return row.needs == QuantityRow::Needs::unknown_tilt
               ? "tilted-wedge phi=1/10 P=1/10" + force + " M=1/100" + force + "*" + L + " E=" + E
           : row.needs == QuantityRow::Needs::round
               ? "axisymmetric hertz R=" + L + " a=" + L + " E=" + E
           : row.needs == QuantityRow::Needs::history
               ? "hertz R=" + L + " E=" + E + friction + " [P=pi/4" + force + "] [Q=3/10" + force +
                     "]"
           : row.of_friction() ? plain + friction
                               : plain;
}

/// Returns a row's quantity at the right edge, u = 1/5, with a tolerance of 1% and k = 1 if it has
/// these; a stress at x = 0, z = 3/4, the gap at x = 5/4, the dissipation at x = 4/5, other values
/// of the surface at x = 1/5, relative to x = 0.
AskedValue asked_of(const QuantityRow& row, const std::string& length = "1") {
    AskedValue asked{row.quantity};
    asked.k = row.index == Index::none ? 0 : 1;
    if (row.at_point()) {
        asked.u = Exact::parse("1/5*" + length);
    }
    if (row.place == QuantityRow::Place::body) {
        asked.in_body = {Exact(), Exact::parse("3/4*" + length)};
    }
    if (row.place == QuantityRow::Place::surface) {
        const std::string x = row.quantity == Quantity::gap           ? "5/4*"
                              : row.quantity == Quantity::dissipation ? "4/5*"
                                                                      : "1/5*";
        const auto at = [&](const std::string& text) {
            return Place::parse(text, Place::From::origin, {}).distance(asked.edge);
        };
        asked.place = at(x + length);
        asked.reference = at("0");
        asked.in_body = scene::BodyPoint{};
    }
    if (row.tolerance) {
        asked.tolerance = parse_tolerance("1%");
    }
    return asked;
}

} // namespace

TEST_CASE("each quantity that has a symbol is read by it and written with it") {
    std::size_t symbols = 0;
    for (const QuantityRow& row : quantity_rows()) {
        CAPTURE(row.name);
        CHECK(row_of(row.quantity).name == row.name);
        if (row.symbol.empty()) {
            continue;
        }
        ++symbols;
        const std::string symbol(row.symbol);
        const std::size_t least = row.index == Index::terms ? 1 : 0;
        for (const std::size_t k : {least, std::size_t{7}, std::size_t{399}}) {
            const std::string text =
                row.index == Index::none ? symbol : symbol + "_" + std::to_string(k);
            const auto read = quantity_named(text);
            REQUIRE(read);
            CHECK(read->quantity == row.quantity);
            CHECK(read->k == (row.index == Index::none ? 0 : k));
            CHECK(symbol_of({read->quantity, read->k}) == text);
        }
        if (row.index != Index::none) {
            CHECK(family_of({row.quantity, 3}) == symbol + "_k");
            for (const char* bad : {"", "_", "_400", "_-1", "_1x", "_ 1", "1"}) {
                CHECK_FALSE(quantity_named(symbol + bad));
            }
            CHECK(quantity_named(symbol + "_0").has_value() == (row.index == Index::order));
        }
    }
    CHECK(symbols == 26);
    CHECK_FALSE(quantity_named(""));
    CHECK_FALSE(quantity_named("heat"));
    CHECK_FALSE(quantity_named("p_1"));
}

TEST_CASE("the dimension of each quantity: lengths doubled, moduli three times as large") {
    for (const QuantityRow& row : quantity_rows()) {
        CAPTURE(row.name);
        const AskedValue asked = asked_of(row);
        const double one = number_of(made(words_for(row)), asked);
        const double other = number_of(made(words_for(row, "2", "3")), asked_of(row, "2"));
        // A force per length is a modulus times a length.
        const double factor = scale_of(asked, 3 * 2, 2) / scale_of(asked, 1, 1);
        CHECK(other == doctest::Approx(factor * one).epsilon(1e-12));
    }
    CHECK(scale_of({Quantity::c, 2}, 6, 4) == 6.0 / 128); // 6/4^(7/2)
    CHECK(scale_of({Quantity::alpha}, 6, 4) == 1);
}

TEST_CASE("a name that is not a quantity: how to write one, and which one was likely meant") {
    const std::string all =
        "write p, q, c_0, c_1, ..., s_0, s_1, ..., a, b, P, M, alpha, "
        "extent_1, measure_1, slip, stick_a, stick_b, p_max, cycle_energy, sxx, szz, sxz, "
        "mises, tau_max, syy, tresca, step_energy, delta or stiffness";
    CHECK(quantity_advice("temperature") == all);
    CHECK(quantity_advice("c1") == "did you mean c_1? " + all);
    CHECK(quantity_advice("alhpa") == "did you mean alpha? " + all);
    CHECK(quantity_advice("extend_2") == "did you mean extent_2? " + all);
    CHECK(quantity_advice("pressure") == "did you mean p? " + all);
    CHECK(quantity_advice("moment") == "did you mean M? " + all);
    for (const GroupRow& row : group_rows()) {
        // The shear is small compared with friction, also for a small load.
        const Scene scene =
            made("tilted-wedge phi=0.1 alpha=0.02 a=2 u=1/2 terms=1 tolerance=1% reference=0 "
                 "quantities=" +
                 std::string(row.name) +
                 (row.friction ? " Q=1/1000 friction=1/2"
                  : row.shear  ? " Q=1"
                               : " nu=0.3"));
        CHECK(scene.ask.quantities == std::set{row.group});
        CHECK(group_name(row.group) == row.name);
        CHECK_NOTHROW((void)make_plan(scene));
    }
}

TEST_CASE("a value in words") {
    const Exact u = Exact::parse("1e-40");
    CHECK(text_of({.quantity = Quantity::p, .u = u}) == "p at u = 1e-40 from the right edge");
    CHECK(text_of({Quantity::c, 1, Edge::left}) == "c_1 at the left edge");
    CHECK(text_of({Quantity::extent, 2}) == "extent of 2 terms at the right edge");
    CHECK(text_of({Quantity::rel, 20, Edge::left, u}) ==
          "relative-error of 20 terms at u = 1e-40 from the left edge");
    CHECK(text_of({Quantity::b}) == "b");
    CHECK(edge_named("left") == Edge::left);
    CHECK_FALSE(edge_named("top"));
}
