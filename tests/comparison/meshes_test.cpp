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

TEST_CASE("meshes that smear the edge: orders, limits, and their agreement") {
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
    REQUIRE(of("p_max").own_order);
    CHECK(*of("p_max").own_order == doctest::Approx(2).epsilon(0.01));
    CHECK(*of("p_max").order == doctest::Approx(2).epsilon(0.01));
    CHECK(of("p_max").trusted);
    CHECK(*of("p_max").agrees);
    CHECK(*of("p_max").extrapolated == doctest::Approx(p0).epsilon(1e-5));
    REQUIRE(of("l2").order);
    CHECK(*of("l2").order > 0.5);
}

TEST_CASE("convergence of known sequences") {
    const auto sequence = [](double limit, double C, double order) {
        std::vector<MeshValue> values;
        for (const double h : {0.125, 1.0, 0.5, 0.2}) { // in any order, without a fixed ratio
            values.push_back({h, limit + C * std::pow(h, order)});
        }
        return values;
    };
    for (const double order : {0.5, 1.0, 1.5, 2.0, 4.0}) {
        const Convergence c = converge("a", sequence(3, -0.7, order), 3);
        REQUIRE(c.own_order);
        CHECK(*c.own_order == doctest::Approx(order).epsilon(1e-6));
        CHECK(*c.order == doctest::Approx(order).epsilon(1e-6));
        CHECK(*c.extrapolated == doctest::Approx(3).epsilon(1e-9));
        CHECK(c.trusted);
        CHECK(*c.agrees);
        // The limit differs from the exact value.
        const Convergence other = converge("a", sequence(3, -0.7, order), 3.5);
        CHECK(other.trusted);
        CHECK_FALSE(*other.agrees);
    }
    const Convergence up_and_down = converge("a", {{1, 1}, {0.5, 2}, {0.25, 1}}, 1);
    CHECK_FALSE(up_and_down.own_order);
    CHECK_FALSE(up_and_down.agrees);
    const Convergence two = converge("a", {{1, 2}, {0.5, 1.5}}, 1);
    CHECK(*two.order == doctest::Approx(1));
    CHECK_FALSE(two.extrapolated);
    CHECK_FALSE(converge("a", {{1, 1}, {0.5, 1}}, 1).order); // all values are exact
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

TEST_CASE("several meshes: their own error follows from their differences") {
    const double e = 0.3;
    std::vector<ResultTable> tables;
    const std::vector<int> counts{32, 64, 128, 256};
    for (const int n : counts) {
        const double h = 4.0 / n;
        tables.push_back(parse_result(
            table(even_places(-2, 2, n), [=](double x) { return p(x) * (1 + e * h * h * x * x); }),
            "r.csv"));
    }
    const auto errors = mesh_errors(tables);
    REQUIRE(errors);
    // The error is e h^2 x^2 p/p_0: its rms over the contact is e h^2 a^2 sqrt(1/5 - 1/7) =
    // 0.24 e h^2 a^2. The estimate is that of the mesh that converges worst.
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double h = 4.0 / counts[i];
        CHECK((*errors)[i] > 0.17 * e * h * h * a * a);
        CHECK((*errors)[i] < 0.4 * e * h * h * a * a);
    }
    CHECK_FALSE(mesh_errors({tables[0]}));
    CHECK_FALSE(mesh_errors({tables[0], tables[0]}));
}
