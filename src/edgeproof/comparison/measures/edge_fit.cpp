// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/measures/edge_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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
        const double u = outwards + (edge == contact::Edge::right ? node.exact.from_right
                                                                  : node.exact.from_left);
        if (u > 0 && u >= from && u <= to) {
            near.u.push_back(u);
            near.p.push_back(node.p);
            near.exact.push_back(node.exact.p.value_or(node.p));
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
    std::vector<std::vector<double>> q = columns; // becomes R above, reflections below
    std::vector<double> scale(n);
    for (std::size_t k = 0; k < n; ++k) {
        double sum = 0;
        for (const double x : q[k]) {
            sum += x * x;
        }
        scale[k] = std::sqrt(sum);
        if (!(scale[k] > 0)) {
            return {};
        }
        for (double& x : q[k]) {
            x /= scale[k];
        }
    }
    std::vector<double> right(y.begin(), y.end());
    std::vector<double> diagonal(n);
    for (std::size_t k = 0; k < n; ++k) {
        double norm = 0;
        for (std::size_t i = k; i < m; ++i) {
            norm = std::hypot(norm, q[k][i]);
        }
        if (norm < 1e-12) {
            return {};
        }
        const double head = q[k][k] > 0 ? -norm : norm;
        diagonal[k] = head;
        q[k][k] -= head;
        double square = 0;
        for (std::size_t i = k; i < m; ++i) {
            square += q[k][i] * q[k][i];
        }
        const auto reflect = [&](std::vector<double>& v) {
            double dot = 0;
            for (std::size_t i = k; i < m; ++i) {
                dot += q[k][i] * v[i];
            }
            for (std::size_t i = k; i < m; ++i) {
                v[i] -= 2 * dot / square * q[k][i];
            }
        };
        for (std::size_t j = k + 1; j < n; ++j) {
            reflect(q[j]);
        }
        reflect(right);
    }
    double residual = 0;
    for (std::size_t i = n; i < m; ++i) {
        residual += right[i] * right[i];
    }
    const double variance = residual / static_cast<double>(m - n);
    const auto entry = [&](std::size_t i, std::size_t j) { return i == j ? diagonal[i] : q[j][i]; };
    LeastSquares result;
    result.coefficients.assign(n, 0);
    result.standard_errors.assign(n, 0);
    for (std::size_t k = n; k-- > 0;) {
        double sum = right[k];
        for (std::size_t j = k + 1; j < n; ++j) {
            sum -= entry(k, j) * result.coefficients[j];
        }
        result.coefficients[k] = sum / entry(k, k);
    }
    // The variance of c_k is that of the data times the squared length of row k of R^-1.
    for (std::size_t column = 0; column < n; ++column) {
        std::vector<double> e(n, 0.0);
        e[column] = 1;
        for (std::size_t k = n; k-- > 0;) {
            for (std::size_t j = k + 1; j < n; ++j) {
                e[k] -= entry(k, j) * e[j];
            }
            e[k] /= entry(k, k);
            result.standard_errors[k] += e[k] * e[k] * variance;
        }
    }
    for (std::size_t k = 0; k < n; ++k) {
        result.coefficients[k] /= scale[k];
        result.standard_errors[k] = std::sqrt(result.standard_errors[k]) / scale[k];
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

} // namespace

namespace {

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
