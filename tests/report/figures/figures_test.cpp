// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/figures_paper.hpp"

#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/report/figures/figures_svg.hpp"
#include "edgeproof/report/text/program_line.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <set>

namespace {

constexpr unsigned digits = 40;

Plot plot_of(const std::string& id) {
    for (const FigureRecipe& figure : paper_figures("moore-hills")) {
        if (id.starts_with(figure.id)) {
            return figure.plots.at(static_cast<std::size_t>(id.back() - 'a'))();
        }
    }
    FAIL("no figure " << id);
    return {};
}

std::size_t column(const Plot& plot, const std::string& name) {
    const auto found = std::ranges::find(plot.columns, name);
    REQUIRE(found != plot.columns.end());
    return static_cast<std::size_t>(found - plot.columns.begin());
}

/// p as a function of x/a, in the unit of the panel, and c_0, c_1, c_2 for a = 1.
struct Known {
    std::function<Real(const Real&)> p;
    std::array<Real, 3> c;
};

Real relative(const Real& x, const Real& y) { return abs(x - y) / abs(y); }

/// Compares every row of the panel with closed forms for the right edge with a = 1.
void expect(const Plot& plot, const Known& known) {
    CAPTURE(plot.id.text());
    REQUIRE(plot.rows.size() > 100);
    const PrecisionScope scope(digits);
    const Real tolerance("1e-18");
    for (const auto& row : plot.rows) {
        const Real x = *row[column(plot, "x_over_a")];
        const Real u = *row[column(plot, "fraction")];
        CHECK(abs(x + u - 1) < tolerance);
        const Real p = known.p(x);
        CHECK(relative(*row[column(plot, "p")], p) < tolerance);
        Real local = 0;
        for (std::size_t n = 0; n < 3; ++n) {
            local += known.c[n] * sqrt(u) * pow(u, static_cast<int>(n));
            CHECK(relative(*row[column(plot, "p" + std::to_string(n + 1))], local) < tolerance);
            const Real e = *row[column(plot, "e" + std::to_string(n + 1))];
            CHECK(abs(e - abs(1 - local / p)) < tolerance);
        }
    }
}

} // namespace

TEST_CASE("figures 2 and 3: a wedge, p = acosh(a/x)/pi") {
    const PrecisionScope scope(digits);
    // acosh(1/(1 - u)) = sqrt(2u)(1 + 5u/12 + 43u^2/160 + ...): DLMF 4.37, by hand.
    const Real k = sqrt(Real(2)) / pi<Real>();
    const Known wedge{[](const Real& x) { return Real(acosh(1 / x) / pi<Real>()); },
                      {k, Real(k * 5 / 12), Real(k * 43 / 160)}};
    expect(plot_of("fig2a"), wedge);
    expect(plot_of("fig3a"), wedge);
}

TEST_CASE("figures 2 and 3: Hertz, p = sqrt(a^2 - x^2)/2") {
    const PrecisionScope scope(digits);
    // sqrt(u)sqrt(2 - u)/2, by the binomial series.
    const Real k = 1 / sqrt(Real(2));
    const Known hertz{[](const Real& x) { return Real(sqrt(1 - x * x) / 2); },
                      {k, Real(-k / 4), Real(-k / 32)}};
    expect(plot_of("fig2c"), hertz);
    expect(plot_of("fig3b"), hertz);
}

TEST_CASE("figure 2: m = 5/8, one and two terms are the same; m = 10, 6.4 % at 1 %") {
    const Plot b = plot_of("fig2b");
    for (const auto& row : b.rows) {
        CHECK(abs(*row[column(b, "e1")] - *row[column(b, "e2")]) < Real("1e-18"));
    }
    // For g' = x^10, p is proportional to the integral of s^10/sqrt(s^2 - x^2) over x < s < 1. The
    // substitution s^2 = x^2 + w v^2, w = 1 - x^2, gives sqrt(w) times the integral of s^9 over 0 <
    // v < 1.
    const Plot d = plot_of("fig2d");
    const PrecisionScope scope(digits);
    for (const auto& row : d.rows) {
        const Real x = *row[column(d, "x_over_a")];
        const Real w = 1 - x * x;
        // Near the edge, s^9 = (x^2 + w v^2)^(9/2) is a binomial series in w v^2/x^2.
        if (w > Real("0.02")) {
            continue;
        }
        const Real r = w / (x * x);
        Real term = 1;
        Real sum = 0;
        for (int k = 0; k < 40; ++k) {
            sum += term / (2 * k + 1);
            term *= r * (Real(9) / 2 - k) / (k + 1);
        }
        const Real integral = sqrt(w) * pow(x, 9) * sum;
        // Its one-term approximation is sqrt(2u).
        const Real e = abs(1 - sqrt(2 * (1 - x)) / integral);
        CHECK(abs(e - *row[column(d, "e1")]) < Real("1e-17"));
    }
}

TEST_CASE("figures 4 and 5: the flat-and-rounded punch by its logarithms") {
    const PrecisionScope scope(digits);
    for (const auto& [id, text] : {std::pair{"fig4a", "0.4"}, std::pair{"fig5b", "0.8"}}) {
        const Plot plot = plot_of(id);
        const Real t = Exact::parse(text).to<Real>();
        const Real theta = asin(t);
        // Hills, Nowell and Sackfield, Mechanics of Elastic Contacts (1993), in the form of
        // Ciavarella et al. (1998): with x = a sin f, p is proportional to (pi - 2 theta) cos f
        //   + ln(|sin(f + theta)/sin(f - theta)|^sin f |tan((f + theta)/2) tan((f - theta)/2)|^sin
        //   theta).
        Real scale = 0;
        for (const auto& row : plot.rows) {
            const Real x = *row[column(plot, "x_over_a")];
            if (x <= 0 || abs(x - t) < Real("1e-10") || 1 - x < Real("1e-3")) {
                continue;
            }
            const Real f = asin(x);
            const Real shape = (pi<Real>() - 2 * theta) * cos(f) +
                               sin(f) * log(abs(sin(f + theta) / sin(f - theta))) +
                               sin(theta) * log(abs(tan((f + theta) / 2) * tan((f - theta) / 2)));
            const Real ratio = *row[column(plot, "p")] / shape;
            if (scale == 0) {
                scale = ratio;
            }
            CHECK(relative(ratio, scale) < Real("1e-17"));
        }
        CHECK(relative(scale, 1 / (2 * pi<Real>())) < Real("1e-17"));
    }
}

TEST_CASE("figures 6 and 7: the tilted wedge, its apex left out, both edges") {
    const PrecisionScope scope(digits);
    const Real phi = pi<Real>() / 16;
    const Real s = sin(pi<Real>() * Real(2) / 5); // alpha = pi/20: pi alpha/(2 phi) = 2 pi/5
    const Real gamma = (1 - s) / (1 + s);
    for (const char* id : {"fig6a", "fig6b", "fig7a", "fig7b"}) {
        const Plot plot = plot_of(id);
        CAPTURE(id);
        const bool left = plot.id.text().back() == 'a';
        for (const auto& row : plot.rows) {
            const Real x = *row[column(plot, "x_over_a")];
            const Real fraction = *row[column(plot, "fraction")];
            CHECK(abs(x - (left ? Real(gamma * (fraction - 1)) : Real(1 - fraction))) <
                  Real("1e-18"));
            // For a tilted wedge, p = (phi/pi) ln|(1 + k)/(1 - k)| with k^2 = b(a - x)/(a(x + b)).
            const Real k = sqrt(gamma * (1 - x) / (x + gamma));
            CHECK(relative(*row[column(plot, "p")],
                           Real(phi / pi<Real>() * log(abs((1 + k) / (1 - k))))) < Real("1e-15"));
        }
    }
}

TEST_CASE("every figure of the paper is there, and another paper has none") {
    std::set<std::string> ids;
    for (const FigureRecipe& figure : paper_figures("moore-hills")) {
        ids.insert(figure.id);
        CHECK_FALSE(figure.caption.empty());
    }
    CHECK(ids ==
          std::set<std::string>{"fig2", "fig3", "fig4", "fig5", "fig6", "fig7", "fig8", "fig9"});
    CHECK(paper_figures("another").empty());
    CHECK(residual_figures("another").empty());
}

TEST_CASE("residual fit: the tables have the slopes that the legends state") {
    const auto scenes = paper_scenes("moore-hills");
    const auto hertz = std::ranges::find(scenes, "hertz", &NamedScene::id);
    REQUIRE(hertz != scenes.end());
    const Plot plot = residual_fit_plot(*hertz, Edge::right);
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
    plot.columns = {"x", "y"};
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
    plot.columns = {"u", "p"};
    plot.rows = {{Real(1) / 3, std::nullopt}, {Real(2), Real("1e-30")}};
    CHECK(to_csv(plot) == "# t\n# d\n# program: " + program_line() +
                              "\nu,p\n0.33333333333333333333,\n2.0000000000000000000,"
                              "1.0000000000000000000e-30\n");
}
