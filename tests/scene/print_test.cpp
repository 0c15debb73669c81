// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/print.hpp"
#include "edgeproof/scene/run_scene.hpp"
#include "tests/scene/scene_text.hpp"

#include <doctest/doctest.h>

#include <sstream>

using namespace edgeproof::scenes;

namespace {

std::string streamed_value(const BoundedValue& x) {
    std::ostringstream out;
    out << x;
    return out.str();
}

} // namespace

// E* = R = a = 1: p = sqrt(1 - x^2)/2 (johnson1985), 0.3 at x = 4/5, 0.217944947177... at x = 9/10.
TEST_CASE("a value is printed with its bound and its route") {
    const std::string hertz = "[profile]\nkind = \"power-law\"\nm = \"1\"\nC = \"1\"\n[load]\na = "
                              "\"1\"\ncontact_modulus = \"1\"\n[ask]\nu = [\"1/10\"]\n";
    const SceneResult result = run_scene(parsed(hertz));
    CHECK(streamed_value(result.points()[0].at(Quantity::p)) ==
          "0.217945 +/- 5.3e-08 (closed-form)");
    CHECK(streamed_value(result.at(Quantity::a)) == "1.00000 +/- 0 (given)");
    CHECK(streamed_value({Ball(Rational(1, 3), 64), true, "given", Rational(1, 3)}) ==
          "0.333333 +/- 3.4e-07 (given)");
    const SceneResult estimate = run_scene(parsed(hertz + "route = \"barber-mossakovskii\"\n"));
    CHECK(streamed_value(estimate.points()[0].at(Quantity::p)) ==
          "0.217945 +/- 5.3e-08 (barber-mossakovskii (estimate))");
}
