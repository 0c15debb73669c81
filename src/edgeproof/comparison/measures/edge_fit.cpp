// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/measures/measures.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace edgeproof::comparison {
namespace {

constexpr std::size_t fewest_spare = 3; ///< the number of nodes minus the number of terms

struct NearNodes {
    std::vector<double> u;
    std::vector<double> p;
    std::vector<double> exact;
};

NearNodes nodes_between(const AlignedResult& data, contact::Edge edge, double outwards, double from,
                        double to) {
    NearNodes near;
    for (const Node& node : data.nodes) {
        const double u = outwards + (edge == contact::Edge::right ? node.place.from_right
                                                                  : node.place.from_left);
        if (u > 0 && u >= from && u <= to) {
            near.u.push_back(u);
            near.p.push_back(node.p.data);
            near.exact.push_back(node.p.exact.value_or(node.p.data));
        }
    }
    return near;
}

/// Fits `terms` powers of u/unit, the first with the exponent `first`, a multiple of 1/2.
std::optional<LeastSquares> fit_terms(const NearNodes& near, const std::vector<double>& p,
                                      std::size_t terms, double unit, double first = 0.5) {
    std::vector<std::vector<double>> columns(terms);
    for (const double u : near.u) {
        double power = std::pow(u / unit, first);
        for (auto& column : columns) {
            column.push_back(power);
            power *= u / unit;
        }
    }
    return least_squares(columns, p);
}

} // namespace

std::optional<LeastSquares> least_squares(const std::vector<std::vector<double>>& columns,
                                          std::span<const double> y) {
    const std::size_t n = columns.size();
    const std::size_t m = y.size();
    if (n == 0 || m <= n) {
        return {};
    }
    const auto product = [](const std::vector<double>& v, const std::vector<double>& w) {
        return std::inner_product(v.begin(), v.end(), w.begin(), 0.0);
    };
    std::vector<std::vector<double>> q = columns;
    std::vector<double> right(y.begin(), y.end());
    std::vector<std::vector<double>> r(n, std::vector<double>(n + 1)); // R, and Q^T y
    for (std::size_t k = 0; k < n; ++k) {
        const double norm = std::sqrt(product(q[k], q[k]));
        if (!(norm > 1e-12 * std::sqrt(product(columns[k], columns[k])))) {
            return {};
        }
        r[k][k] = norm;
        std::ranges::transform(q[k], q[k].begin(), [=](double x) { return x / norm; });
        for (std::size_t j = k + 1; j <= n; ++j) {
            std::vector<double>& other = j < n ? q[j] : right;
            r[k][j] = product(q[k], other);
            for (std::size_t i = 0; i < m; ++i) {
                other[i] -= r[k][j] * q[k][i];
            }
        }
    }
    const auto solved = [&](std::vector<double> v) { // R x = v
        for (std::size_t k = n; k-- > 0;) {
            for (std::size_t j = k + 1; j < n; ++j) {
                v[k] -= r[k][j] * v[j];
            }
            v[k] /= r[k][k];
        }
        return v;
    };
    LeastSquares result;
    for (const auto& row : r) {
        result.coefficients.push_back(row[n]);
    }
    result.coefficients = solved(std::move(result.coefficients));
    // The variance of c_k is that of the data times the squared length of row k of R^-1.
    const double variance = product(right, right) / static_cast<double>(m - n);
    result.standard_errors.assign(n, 0);
    for (std::size_t column = 0; column < n; ++column) {
        std::vector<double> unit(n, 0.0);
        unit[column] = 1;
        const std::vector<double> e = solved(std::move(unit));
        for (std::size_t k = 0; k < n; ++k) {
            result.standard_errors[k] =
                std::hypot(result.standard_errors[k], e[k] * std::sqrt(variance));
        }
    }
    return result;
}

namespace {

/// Fits a window; the spread includes the effect of omitting one term.
std::optional<EdgeFit> fit_window(const NearNodes& near, std::size_t terms) {
    if (near.u.size() < terms + fewest_spare) {
        return {};
    }
    const auto ends = std::ranges::minmax_element(near.u);
    const double most = *ends.max;
    const auto all = fit_terms(near, near.p, terms, most);
    const auto fewer = fit_terms(near, near.p, terms - 1, most);
    const auto of_exact = fit_terms(near, near.exact, terms, most);
    if (!all || !fewer || !of_exact) {
        return {};
    }
    EdgeFit fit;
    fit.nodes = near.u.size();
    fit.terms = terms;
    fit.from = *ends.min;
    fit.to = most;
    const auto coefficient = [&](std::size_t k) {
        const double unit = std::pow(most, static_cast<double>(k) + 0.5);
        return FittedCoefficient{
            all->coefficients[k] / unit,
            std::hypot(all->standard_errors[k], all->coefficients[k] - fewer->coefficients[k]) /
                unit,
            of_exact->coefficients[k] / unit};
    };
    fit.c0 = coefficient(0);
    fit.c1 = coefficient(1);
    return fit;
}

/// Adds the effect of an edge that lies elsewhere in the data: all nodes share it, so that the
/// residuals do not show it. sqrt(u + d) is sqrt(u) + d/2 u^(-1/2) + ..., so the fit is repeated
/// with the power -1/2.
void allow_for_edge(const NearNodes& near, EdgeFit& fit) {
    const auto moved = fit_terms(near, near.p, fit.terms + 1, fit.to, -0.5);
    if (!moved) {
        return;
    }
    for (const std::size_t k : {0U, 1U}) {
        FittedCoefficient& c = k == 0 ? fit.c0 : fit.c1;
        const double unit = std::pow(fit.to, static_cast<double>(k) + 0.5);
        c.spread = std::hypot(c.spread, moved->coefficients[k + 1] / unit - c.value);
    }
}

} // namespace

std::optional<EdgeFit> fit_edge(const AlignedResult& data, const ExactContact& exact,
                                contact::Edge edge, double leave_out,
                                const std::optional<double>& own_edge) {
    const double radius = exact.convergence_radius(edge);
    std::optional<EdgeFit> best;
    NearNodes of_best;
    for (const double part : {0.1, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9}) {
        const NearNodes near =
            nodes_between(data, edge, own_edge.value_or(0), leave_out, part * radius);
        for (const std::size_t terms : {3U, 4U, 5U}) {
            const auto fit = fit_window(near, terms);
            if (fit && (!best || fit->c0.spread < best->c0.spread)) {
                best = fit;
                of_best = near;
            }
        }
    }
    if (best) {
        best->own_edge = own_edge.has_value();
        allow_for_edge(of_best, *best);
    }
    return best;
}

} // namespace edgeproof::comparison
