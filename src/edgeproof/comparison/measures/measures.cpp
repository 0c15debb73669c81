// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/measures/measures.hpp"
#include "edgeproof/diagnose/diagnose.hpp"
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/roots/roots.hpp"

#include <functional>
#include <numeric>
#include <utility>

namespace edgeproof::comparison {

namespace {

constexpr double most_digits = 16;

/// `whole`: the norm of the exact value includes all nodes, not only those counted.
Errors errors_of(const AlignedResult& data, double scale,
                 const std::function<bool(const Node&)>& counts, TractionOf of = p_of,
                 bool whole = true) {
    Errors errors;
    std::vector<double> local;
    double square = 0;
    double exact_square = 0;
    for (std::size_t i = 0; i < data.nodes.size(); ++i) {
        const Node& node = data.nodes[i];
        const Traction* const value = of(node);
        if (value == nullptr || !value->exact) {
            continue;
        }
        const double width = width_of_node(data.nodes, i);
        const bool counted = counts(node);
        exact_square += whole || counted ? width * *value->exact * *value->exact : 0;
        if (!counted) {
            continue;
        }
        ++errors.nodes;
        const double error = value->counted();
        square += width * error * error;
        if (error / scale > errors.peak || !errors.worst) {
            errors.peak = error / scale;
            errors.worst = i;
        }
        errors.inside += node.place.inside() ? 1 : 0;
        const bool has_size = node.place.inside() && *value->exact != 0;
        const double size = has_size ? std::abs(*value->exact) : scale;
        if (error / size > errors.local || !errors.worst_local) {
            errors.local = error / size;
            errors.worst_local = i;
        }
        if (has_size) {
            local.push_back(error / size);
            errors.as_written = std::max(errors.as_written, std::abs(value->error) / size);
        }
    }
    errors.l2 = exact_square > 0 ? std::sqrt(square / exact_square) : 0;
    errors.median_local = local.empty() ? 0 : diagnose::sorted_at(std::move(local), 0.5);
    return errors;
}

} // namespace

double digits_of(double relative_error) {
    return relative_error > 0 ? std::min(most_digits, std::max(0.0, -std::log10(relative_error)))
                              : most_digits;
}

double Errors::digits() const { return digits_of(as_written); }

EdgeZone parse_edge_zone(std::string_view text) {
    const bool elements = text.ends_with('e') || text.ends_with('E');
    const auto number = io::read_number(elements ? text.substr(0, text.size() - 1) : text);
    if (!number || *number < 0) {
        throw InputError("--edge-zone " + std::string(text) + " is no width",
                         "write 2e for two elements, or a length such as 0.01");
    }
    const double value = number->convert_to<double>();
    return elements || value == 0 ? EdgeZone{value, {}} : EdgeZone{0, value};
}

bool is_counted(const Node& node, const EdgeZone& zone, const DataContact& contact) {
    // A node on the boundary of the zone is counted in spite of rounding.
    constexpr double almost = 1 - 1e-9;
    const double right = zone.at(contact::Edge::right, contact) * almost;
    const double left = zone.at(contact::Edge::left, contact) * almost;
    return node.p.exact && std::abs(node.place.from_right) >= right &&
           std::abs(node.place.from_left) >= left;
}

Errors measure(const AlignedResult& data, const ExactContact& exact, const DataContact& contact,
               const EdgeZone& zone) {
    return errors_of(data, exact.scale().value,
                     [&](const Node& node) { return is_counted(node, zone, contact); });
}

std::optional<Errors> measure_shear(const AlignedResult& data, const ExactContact& exact,
                                    const DataContact& contact, const EdgeZone& zone) {
    if (data.nodes.empty() || !data.nodes.front().q) {
        return {};
    }
    const double width = zone.length.value_or(zone.elements * contact.mean_element);
    const auto counts = [&, ends = exact.shear()->stick_edges](const Node& node) {
        return is_counted(node, zone, contact) &&
               std::ranges::none_of(ends, [&](double x) { return std::abs(node.x - x) < width; });
    };
    return errors_of(data, exact.shear()->scale, counts, q_of, false);
}

std::vector<DistanceErrors> by_distance(const AlignedResult& data, const ExactContact& exact) {
    std::vector<DistanceErrors> list;
    constexpr int decades = 12;
    for (const contact::Edge edge : both_edges) {
        for (int k = 0; k < decades; ++k) {
            const double to = k == 0 ? 0.5 : std::pow(10.0, -k);
            const double from = k + 1 == decades ? 0 : std::pow(10.0, -k - 1);
            const Errors errors = errors_of(data, exact.scale().value, [&](const Node& node) {
                const double part = node.place.u() / exact.length();
                return node.place.inside() && node.place.nearer() == edge && part > from &&
                       part <= (k == 0 ? 1 : to);
            });
            if (errors.nodes > 0) {
                list.push_back({edge, from, to, errors});
            }
        }
    }
    return list;
}

std::vector<KnotErrors> errors_near_knots(const AlignedResult& data, const ExactContact& exact,
                                          const DataContact& contact) {
    std::vector<KnotErrors> list;
    const double near = std::max(0.01 * exact.length(), 2 * contact.mean_element);
    for (const ContactKnot& knot : exact.knots()) {
        const Errors errors = errors_of(data, exact.scale().value, [&](const Node& node) {
            return node.place.inside() && std::abs(node.x - knot.x) <= near;
        });
        if (errors.nodes > 0) {
            list.push_back({knot, errors});
        }
    }
    return list;
}

namespace {

struct Sample {
    double x = 0;
    double p = 0;
    double x_rounding = 0;
    double p_rounding = 0;
};

/// The distance of a sample from the line through its neighbours, relative to what rounding of the
/// written digits, or to binary32, explains.
double change_of_slope(const Sample& before, const Sample& here, const Sample& after,
                       double largest) {
    constexpr double of_binary32 = 1e-6;
    const double slope = (after.p - before.p) / (after.x - before.x);
    const double off = std::abs(here.p - before.p - slope * (here.x - before.x));
    return off /
           (of_binary32 * largest + here.p_rounding +
            std::max(before.p_rounding, after.p_rounding) + 2 * std::abs(slope) * here.x_rounding);
}

} // namespace

std::optional<SampledElements> sampled_elements(const ResultTable& table) {
    std::vector<Sample> all;
    for (const ResultRow& row : table.rows) {
        all.push_back({row.x.convert_to<double>(), row.p.convert_to<double>(), row.x_rounding,
                       row.p_rounding});
    }
    const double largest =
        std::abs(std::ranges::max(all, {}, [](const Sample& s) { return std::abs(s.p); }).p);
    constexpr double loaded_share = 0.02;
    constexpr double clearly = 3;
    constexpr std::size_t most_of_a_node = 2; // a node between two samples is seen at both
    constexpr std::size_t fewest_nodes = 4;
    std::vector<double> nodes;
    std::size_t linear = 0;
    std::size_t run = 0; // of samples at which the slope changes
    double greatest = 0; // change of the slope in the run
    for (std::size_t i = 1; i + 1 < all.size(); ++i) {
        if (std::min({std::abs(all[i - 1].p), std::abs(all[i].p), std::abs(all[i + 1].p)}) <=
            loaded_share * largest) {
            continue;
        }
        if (!(all[i - 1].x < all[i].x && all[i].x < all[i + 1].x)) {
            return {};
        }
        const double change = change_of_slope(all[i - 1], all[i], all[i + 1], largest);
        if (change > 1) {
            if (run == 0) {
                nodes.emplace_back();
            }
            nodes.back() = change > greatest ? all[i].x : nodes.back();
            greatest = std::max(greatest, change);
            ++run;
            continue;
        }
        if (run > most_of_a_node || (run > 0 && greatest < clearly)) {
            return {}; // a curve
        }
        ++linear;
        run = 0;
        greatest = 0;
    }
    if (run > 0) {
        nodes.pop_back(); // where the rows end
    }
    const std::size_t n = nodes.size();
    if (n < fewest_nodes || linear < n) {
        return {};
    }
    return SampledElements{{nodes[n - 1] - nodes[n - 2], nodes[1] - nodes[0]},
                           (nodes[n - 1] - nodes[0]) / static_cast<double>(n - 1)};
}

std::optional<double> order_of(std::vector<MeshValue> errors) {
    std::ranges::stable_sort(errors, std::greater(), &MeshValue::h);
    std::vector<std::pair<double, double>> points; // of meshes of the same width, the last
    for (const MeshValue& e : errors) {
        constexpr double same = 0.99;
        if (!points.empty() && e.h > same * points.back().first) {
            points.pop_back();
        }
        points.emplace_back(e.h, std::abs(e.value));
    }
    const auto fit = roots::power_law_fit(points);
    return fit ? std::optional(fit->exponent) : std::nullopt;
}

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
        const double u = outwards + node.place.from(edge);
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
