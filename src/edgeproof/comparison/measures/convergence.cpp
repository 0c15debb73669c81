// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/measures/convergence.hpp"

#include "edgeproof/roots/power_law_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace edgeproof::comparison {
namespace {

constexpr double least_order = 0.1;
constexpr double greatest_order = 8;

/// The slope of log |error| over log h. An error of 0 has no logarithm and is left out.
std::optional<double> slope_of(const std::vector<MeshValue>& errors) {
    std::vector<std::pair<double, double>> points;
    for (const MeshValue& e : errors) {
        points.emplace_back(e.h, std::abs(e.value));
    }
    const auto fit = roots::power_law_fit(points);
    return fit ? std::optional(fit->exponent) : std::nullopt;
}

/// Solves (v1 - v2)/(v2 - v3) = (h1^p - h2^p)/(h2^p - h3^p) for p; the right side grows with p.
std::optional<double> order_of_triple(const MeshValue& v1, const MeshValue& v2,
                                      const MeshValue& v3) {
    const double ratio = (v1.value - v2.value) / (v2.value - v3.value);
    const auto excess = [&](double p) {
        const double r1 = std::pow(v1.h / v3.h, p);
        const double r2 = std::pow(v2.h / v3.h, p);
        return (r1 - r2) / (r2 - 1) - ratio;
    };
    if (!(ratio > 0) || !std::isfinite(ratio) || excess(least_order) > 0 ||
        excess(greatest_order) < 0) {
        return {};
    }
    double lower = least_order;
    double upper = greatest_order;
    for (int i = 0; i < 80; ++i) {
        const double middle = 0.5 * (lower + upper);
        (excess(middle) < 0 ? lower : upper) = middle;
    }
    return 0.5 * (lower + upper);
}

/// Sorts the finest mesh last; of meshes with the same width keeps the last.
std::vector<MeshValue> by_width(std::vector<MeshValue> values) {
    std::ranges::stable_sort(values,
                             [](const MeshValue& s, const MeshValue& t) { return s.h > t.h; });
    std::vector<MeshValue> out;
    for (const MeshValue& v : values) {
        constexpr double same = 0.99;
        if (!out.empty() && v.h > same * out.back().h) {
            out.back() = v;
        } else {
            out.push_back(v);
        }
    }
    return out;
}

} // namespace

Convergence converge(std::string quantity, std::vector<MeshValue> values, double exact) {
    values = by_width(std::move(values));
    Convergence c;
    c.quantity = std::move(quantity);
    c.exact = exact;
    std::vector<MeshValue> errors = values;
    for (MeshValue& e : errors) {
        constexpr double roundoff = 1e-8; // of printed digits: an error of that size has no order
        e.value = std::abs(e.value - exact) < roundoff * std::abs(exact) ? 0 : e.value - exact;
    }
    c.order = slope_of(errors);
    const std::size_t n = values.size();
    if (n < 3) {
        c.why_not = "three meshes of different widths are needed";
        return c;
    }
    c.own_order = order_of_triple(values[n - 3], values[n - 2], values[n - 1]);
    if (!c.own_order) {
        c.why_not = "the last three values do not converge as a power of the width";
        return c;
    }
    const double rest = (values[n - 1].value - values[n - 2].value) /
                        (std::pow(values[n - 2].h / values[n - 1].h, *c.own_order) - 1);
    c.extrapolated = values[n - 1].value + rest;
    if (n >= 4) {
        const auto before = order_of_triple(values[n - 4], values[n - 3], values[n - 2]);
        c.trusted = before && std::abs(*before / *c.own_order - 1) < 0.2;
        c.why_not = c.trusted ? "" : "the orders of the last two triples of meshes differ";
    } else {
        c.why_not = "a fourth mesh is needed to see whether the order holds";
    }
    constexpr double where_orders_agree = 1.25;
    constexpr double elsewhere = 3;
    c.extrapolation_error = (c.trusted ? where_orders_agree : elsewhere) * std::abs(rest);
    c.agrees = std::abs(*c.extrapolated - exact) <= c.extrapolation_error;
    return c;
}

Convergence converge_error(std::string quantity, std::vector<MeshValue> errors) {
    Convergence c;
    c.quantity = std::move(quantity);
    c.order = slope_of(by_width(std::move(errors)));
    c.why_not = "it is an error, whose limit is 0";
    return c;
}

} // namespace edgeproof::comparison
