// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/comparison.hpp"
#include "edgeproof/io/text_file.hpp"
#include "tests/comparison/hertz_data.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/paths.hpp"

#include <doctest/doctest.h>

#include <sstream>

using namespace edgeproof::hertz_data;

TEST_CASE("samples of a line through a mesh are not its elements") {
    const auto through = [](double element) {
        return [element](double x) {
            const double left = element * std::floor(x / element);
            return p(left) + (p(left + element) - p(left)) * (x - left) / element;
        };
    };
    struct Case {
        double element; ///< 0: none, the curve itself
        double step;
    };
    for (const auto& [element, step] : {Case{0.1, 0.02}, Case{0.1, 0.0171}, Case{0.25, 0.05},
                                        Case{0.05, 0.025}, Case{0, 0.02}, Case{0, 0.0003}}) {
        CAPTURE(element);
        CAPTURE(step);
        const int n = static_cast<int>(4 / step);
        const auto places = even_places(-n * step / 2, n * step / 2, n);
        const FileComparison file =
            compared(element > 0 ? table(places, through(element)) : table(places, p), within(0.2));
        const double right = element > 0 ? element : step;
        CHECK(file.contact.mean_element == doctest::Approx(right).epsilon(0.1));
        CHECK(file.contact.element[0] == doctest::Approx(right).epsilon(0.2));
        CHECK(has_finding(file, "samples of a line") == (element > 0));
    }
}

TEST_CASE("least squares: a known line, its standard errors, dependent columns") {
    // For y = 1, 2, 2, 3 at x = 0, 1, 2, 3: slope 0.6, intercept 1.1, residual sum of squares 0.2,
    // so that s^2 = 0.1, and the standard errors are sqrt(0.1/5) and sqrt(0.1 * 14/20).
    const std::vector<std::vector<double>> columns{{1, 1, 1, 1}, {0, 1, 2, 3}};
    const std::vector<double> y{1, 2, 2, 3};
    const auto fit = least_squares(columns, y);
    REQUIRE(fit);
    CHECK(fit->coefficients[0] == doctest::Approx(1.1).epsilon(1e-13));
    CHECK(fit->coefficients[1] == doctest::Approx(0.6).epsilon(1e-13));
    CHECK(fit->standard_errors[0] == doctest::Approx(std::sqrt(0.07)).epsilon(1e-12));
    CHECK(fit->standard_errors[1] == doctest::Approx(std::sqrt(0.02)).epsilon(1e-12));
    CHECK_FALSE(least_squares({{1, 1, 1, 1}, {2, 2, 2, 2}}, y));
    CHECK_FALSE(least_squares({{1, 2}, {0, 1}}, std::vector<double>{1, 2}));
}

TEST_CASE("errors at the edges only: the zone to leave out is suggested, in elements") {
    // A mesh that smears the edge over an element: the error is in the elements next to it.
    const double h = 1.0 / 16;
    const auto text = table(mesh, [h](double x) { return smeared(x, h); });
    SuspectContacts suspects(edgeproof::hertz_data::hertz());
    const FileComparison file =
        compare_file(parse_result(text, "r.csv"), exact(), within(0.01), Rational(0), &suspects);
    REQUIRE_FALSE(file.passes());
    REQUIRE(file.suggested_zone);
    const SuggestedZone& zone = *file.suggested_zone;
    CHECK(zone.length[0] == doctest::Approx(zone.elements * h));
    Tolerances left_out = within(0.01);
    left_out.zone = parse_edge_zone(std::to_string(zone.elements) + "e");
    const FileComparison passing =
        compare_file(parse_result(text, "r.csv"), exact(), left_out, Rational(0), &suspects);
    CHECK(passing.passes());
    CHECK(passing.errors.peak == doctest::Approx(zone.error));
    if (zone.elements > 1) {
        left_out.zone = parse_edge_zone(std::to_string(zone.elements - 1) + "e");
        CHECK_FALSE(
            compare_file(parse_result(text, "r.csv"), exact(), left_out, Rational(0)).passes());
    }
}

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
