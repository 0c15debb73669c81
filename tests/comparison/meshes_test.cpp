// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/comparison.hpp"
#include "edgeproof/io/text_file.hpp"
#include "tests/comparison/hertz_data.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/paths.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>

using namespace edgeproof::hertz_data;

TEST_CASE("meshes that smear the edge: orders") {
    std::vector<FileComparison> files;
    for (const int n : {32, 64, 128, 256}) {
        const double h = 4.0 / n;
        Tolerances t;
        t.zone = parse_edge_zone("2e");
        files.push_back(
            compared(table(even_places(-2, 2, n), [h](double x) { return smeared(x, h); }), t));
        CHECK(files.back().passes());
    }
    const auto list = convergence_of(files, exact());
    const auto of = [&](const std::string& name) {
        for (const Convergence& c : list) {
            if (c.quantity == name) {
                return c;
            }
        }
        return Convergence{};
    };
    // In the middle, the error of a mean over h is h^2 p''/24.
    CHECK(of("p_max").order.value() == doctest::Approx(2).epsilon(0.01));
    REQUIRE(of("l2").order);
    CHECK(*of("l2").order > 0.5);
}

TEST_CASE("orders of known sequences") {
    for (const double order : {0.5, 1.0, 1.5, 2.0, 4.0}) {
        std::vector<MeshValue> errors;
        for (const double h : {0.125, 1.0, 0.5, 0.2}) { // in any order, without a fixed ratio
            errors.push_back({h, -0.7 * std::pow(h, order)});
        }
        CHECK(order_of(errors).value() == doctest::Approx(order).epsilon(1e-6));
    }
    CHECK_FALSE(order_of({{1, 0}, {0.5, 0}})); // all values are exact
    CHECK_FALSE(order_of({{1, 2}, {1, 3}}));   // one width
}

TEST_CASE("the allowance for a mesh is that of the committed runs of CalculiX") {
    std::istringstream rows(io::read_text(
        test::source_dir() / "examples" / "third-party" / "solvers" / "mesh-errors.csv", "table"));
    double greatest = 0;
    std::size_t count = 0;
    for (std::string line; std::getline(rows, line);) {
        if (!line.starts_with('#') && !line.starts_with("contact")) {
            greatest = std::max(greatest, std::stod(line.substr(line.rfind(',') + 1)));
            ++count;
        }
    }
    CHECK(count >= 8);
    CHECK(greatest <= mesh_error_times_elements);
    CHECK(greatest > 0.75 * mesh_error_times_elements); // and not much more
}
