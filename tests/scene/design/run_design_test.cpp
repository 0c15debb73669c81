// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/design/run_design.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>

// For a cylinder p = c_0 sqrt(u) sqrt(1 - u/2a), so that the error of one term is e at u/2a = 1 -
// 1/(1 + e)^2. A steeper slope farther out (k > 0) only reduces the reach.
TEST_CASE("design over a curved slope: the best of the values tried, called an estimate" *
          doctest::test_suite("slow")) {
    for (const char* load : {"a = \"1\"", "P = \"1/5\""}) {
        const auto design = edgeproof::scene::parse_design(
            "[profile]\nkind = \"piecewise\"\nsymmetric = true\nknots = []\n"
            "slopes = [\"x + k*x^3\"]\n[parameters]\nk = { from = \"0\", to = \"1\" }\n[load]\n" +
                std::string(load) +
                "\ncontact_modulus = \"1\"\n[design]\nmaximise = \"first_exit\"\nterms = 1\n"
                "tolerance = \"1%\"\n",
            "cubic.toml");
        const edgeproof::scene::DesignResult found = run_design(design, {});
        CHECK(found.missing.find("curved") != std::string::npos);
        CHECK(found.best.value.at(0).midpoint().convert_to<double>() == 0);
        const double expected = 1 - 1 / (1.01 * 1.01);
        CHECK(std::fabs(found.best.reach.midpoint().convert_to<double>() - expected) < 1e-11);
    }
}
