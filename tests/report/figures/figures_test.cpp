// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/figures/audit_figures.hpp"

#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/report/text/program_line.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/paths.hpp"

#include <doctest/doctest.h>

#include <array>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace {

constexpr unsigned digits = 40;

FiguresOfSource figures() {
    return figures_of_source(test::source_dir() / "verify/moore-hills.toml");
}

Plot plot_of(std::size_t figure, std::size_t panel) {
    return figures().printed.at(figure).plots.at(panel)().value();
}

Real relative(const Real& x, const Real& y) { return abs(x - y) / abs(y); }

/// p as a function of x, and c_0, c_1, c_2, for a = 1.
struct Known {
    std::size_t panel; ///< of the first two figures
    std::size_t panel_of_pressures;
    std::function<Real(const Real&)> p;
    std::array<Real, 3> c;
};

} // namespace

TEST_CASE("figures 2 and 3 of the paper have the values of closed forms") {
    const PrecisionScope scope(digits);
    const Real tolerance("1e-18");
    // Wedge: p = acosh(1/|x|)/pi, and acosh(1/(1 - u)) = sqrt(2u)(1 + 5u/12 + 43u^2/160 + ...)
    // (DLMF 4.37, by hand). Hertz: p = sqrt(1 - x^2)/2 = sqrt(u) sqrt(2 - u)/2, by the binomial
    // series.
    const Real k = sqrt(Real(2)) / pi<Real>();
    const Real h = 1 / sqrt(Real(2));
    for (const auto& [panel, panel_of_pressures, p, c] :
         {Known{0,
                0,
                [](const Real& x) { return Real(acosh(1 / abs(x)) / pi<Real>()); },
                {k, Real(k * 5 / 12), Real(k * 43 / 160)}},
          Known{2,
                1,
                [](const Real& x) { return Real(sqrt(1 - x * x) / 2); },
                {h, Real(-h / 4), Real(-h / 32)}}}) {
        const auto local = [&c = c](std::size_t n, const Real& u) {
            Real sum = 0;
            for (std::size_t i = 0; i < n; ++i) {
                sum += c[i] * sqrt(u) * pow(u, static_cast<int>(i));
            }
            return sum;
        };
        const Plot errors = plot_of(0, panel);
        CAPTURE(errors.id.text());
        REQUIRE(errors.rows.size() > 60);
        std::size_t compared = 0;
        for (const auto& row : errors.rows) {
            const Real& u = *row[0];
            for (std::size_t n = 1; n <= 3; ++n) {
                if (row[n]) {
                    ++compared;
                    CHECK(abs(*row[n] - abs(Real(1 - local(n, u) / p(Real(1 - u))))) < tolerance);
                }
            }
        }
        CHECK(compared > 150);
        const Plot pressures = plot_of(1, panel_of_pressures);
        REQUIRE(test::has(to_csv(pressures), "\nx,p,right1,right1_exit,right2,right2_exit,right3,"
                                             "right3_exit\n"));
        for (const auto& row : pressures.rows) {
            const Real& x = *row[0];
            if (row[1] && abs(x) < 1) {
                CHECK(relative(*row[1], p(x)) < tolerance);
            }
            for (std::size_t n = 1; n <= 3; ++n) {
                if (row[2 * n] && x < 1) {
                    CHECK(relative(*row[2 * n], local(n, Real(1 - x))) < tolerance);
                }
            }
        }
    }
}

TEST_CASE("every figure of the paper is there, and another paper has none") {
    std::set<std::string> ids;
    std::set<std::string> panels;
    for (const FigureRecipe& figure : figures().printed) {
        ids.insert(figure.id);
        CHECK_FALSE(figure.caption.empty());
        for (const auto& make : figure.plots) {
            CHECK(panels.insert(make().value().id.text()).second);
        }
    }
    CHECK(ids ==
          std::set<std::string>{"fig2", "fig3", "fig4", "fig5", "fig6", "fig7", "fig8", "fig9"});
    CHECK(panels.size() == 18);
    CHECK(figures().residuals.size() == 10);
    CHECK(figures_of_source("another.toml").printed.empty());
}

TEST_CASE("residual fit: the tables have the slopes that the legends state") {
    const Plot plot = figures().residuals.at(2).plots.at(0)().value(); // Hertz
    CHECK(plot.id.text() == "residual-fig2c-hertz-right");
    const PrecisionScope scope(digits);
    REQUIRE(plot.curves.size() == 8);
    for (std::size_t n = 0; n < 8; ++n) {
        const auto& near = plot.rows.back();
        const auto& next = plot.rows[plot.rows.size() - 2];
        const Real slope = log(*next[n + 1] / *near[n + 1]) / log(*next[0] / *near[0]);
        CHECK(abs(slope - (Real(static_cast<int>(n)) + Real(1) / 2)) < Real("1e-4"));
        CHECK(plot.curves[n].title ==
              "n = " + std::to_string(n) + ": slope " + std::to_string(n) + ".500000");
        // The remainder of the binomial series of sqrt(u(2 - u))/2.
        const Real u = *near[0];
        Real rest = 0;
        Real term = sqrt(u / 2);
        for (int k = 0; k < 30; ++k) {
            rest += static_cast<std::size_t>(k) >= n ? term : Real(0);
            term *= -(Real(1) / 2 - k) / (k + 1) * u / 2;
        }
        CHECK(relative(*near[n + 1], abs(rest)) < Real("1e-15"));
    }
}

TEST_CASE("a picture in a file has a white ground; in a page it takes the page's ground and ink") {
    const PrecisionScope scope(digits);
    Plot plot;
    plot.id = "line";
    plot.title = "t";
    plot.description = "d";
    plot.curves = {{"y", "a line", {}}};
    for (int k = 1; k < 4; ++k) {
        plot.rows.push_back({Real(k), Real(k)});
    }
    const std::string file = draw_svg({plot});
    CHECK(file.find("fill=\"#ffffff\"") != std::string::npos);
    const std::string part = inline_svg(file, plot);
    CHECK(part.find("#ffffff") == std::string::npos);
    CHECK(part.find("id=\"line-title\"") != std::string::npos);
    CHECK(part.find("currentColor") != std::string::npos);
}

TEST_CASE("CSV: notes, names, values to 20 digits, nothing where there is no value") {
    const PrecisionScope scope(digits);
    Plot plot;
    plot.title = "t";
    plot.description = "d";
    plot.first_column = "u";
    plot.curves = {{"p", "p", {}}};
    plot.rows = {{Real(1) / 3, std::nullopt}, {Real(2), Real("1e-30")}};
    CHECK(to_csv(plot) == "# t\n# d\n# program: " + program_line() +
                              "\nu,p\n0.33333333333333333333,\n2.0000000000000000000,"
                              "1.0000000000000000000e-30\n");
}
