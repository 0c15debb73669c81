// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/causes/fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgeproof::comparison {
namespace {

constexpr double share_left = 0.3;
constexpr std::size_t fewest_nodes_counted = 8;
constexpr double edge_share = 0.02; ///< relative to the suspect's contact

/// Local scatter: the variances of noise that is constant, and of noise proportional to the values.
/// White noise has second differences of sqrt(6) times its size. Only consecutive nodes are used.
class Scatter {
public:
    /// `off`: the remaining error; `value`: the suspect's value; `weight`: the factor with which
    /// the noise of the node enters the sum whose error is asked.
    struct At {
        double off = 0;
        double value = 0;
        double weight = 0;
    };
    explicit Scatter(const std::vector<std::optional<At>>& nodes) {
        double values = 0;
        double fourth = 0;
        double weights = 0;
        double products = 0;
        for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
            if (nodes[i - 1] && nodes[i] && nodes[i + 1]) {
                const double second = nodes[i - 1]->off - 2 * nodes[i]->off + nodes[i + 1]->off;
                const double weight = nodes[i]->weight * nodes[i]->weight;
                const double value = nodes[i]->value * nodes[i]->value;
                sum_ += second * second / 6;
                values += value;
                fourth += value * value;
                weights += weight;
                products += weight * value;
                ++n_;
            }
        }
        if (values > 0) {
            variance_ =
                std::max(sum_ / static_cast<double>(n_) * weights, sum_ / values * products);
            // Second differences of white noise have correlations of -2/3 and 1/6, so that their
            // mean square has 18/35 of the degrees of freedom.
            freedom_ = 18.0 / 35 * values * values / fourth;
        }
    }
    /// The rms of the noise of a node.
    [[nodiscard]] double noise() const {
        return n_ > 0 ? std::sqrt(sum_ / static_cast<double>(n_)) : 0;
    }
    /// The standard error of the sum of weight times error.
    [[nodiscard]] double error_of_sum() const { return std::sqrt(variance_); }
    [[nodiscard]] double freedom() const { return freedom_; }

private:
    double sum_ = 0;
    double variance_ = 0;
    double freedom_ = 0;
    std::size_t n_ = 0;
};

/// The number of standard errors, estimated with some degrees of freedom, that is exceeded as
/// rarely as `normal` exact ones: the approximation of Gaver and Kafadar to Student's distribution
/// (gaver1984).
double students(double normal, double freedom) {
    const double f = std::max(freedom, 3.0);
    return std::sqrt(f * std::expm1(normal * normal * (f - 1.5) / ((f - 1) * (f - 1))));
}

} // namespace

bool Observed::counts(const Suspect& suspect, std::size_t i) const {
    const double zone = std::max(2 * element, edge_share * (suspect.a + suspect.b));
    const double x = nodes[i].x;
    return std::isfinite(suspect.values[i]) &&
           std::min(std::abs(x - suspect.a), std::abs(x + suspect.b)) >= zone &&
           std::ranges::none_of(corners, [=](double at) { return std::abs(x - at) < zone; });
}

bool Fit::is_scatter(double allowance, double standard_errors, double scatters) const {
    return left <= scatters * noise + allowance &&
           std::abs(scale - 1) <= students(standard_errors, freedom) * scale_error + allowance;
}

std::optional<Fit> fit_of(const Observed& data, const Suspect& suspect) {
    Fit fit;
    double largest = 0;
    double products = 0;
    double squares = 0;
    for (std::size_t i = 0; i < data.nodes.size(); ++i) {
        if (data.counts(suspect, i)) {
            largest = std::max(largest, std::abs(suspect.values[i]));
            products += data.values[i] * suspect.values[i];
            squares += suspect.values[i] * suspect.values[i];
        }
    }
    if (!(squares > 0)) {
        return {};
    }
    fit.sign = products < 0 ? -1 : 1;
    std::vector<std::optional<Scatter::At>> left; // of nodes inside the suspect's contact
    double square = 0;
    double inside = 0;
    std::size_t all = 0;
    std::array<double, 2> worst{}; // of nodes near an edge, and of those that count
    for (std::size_t i = 0; i < data.nodes.size(); ++i) {
        const double x = data.nodes[i].x;
        const bool counts = data.counts(suspect, i);
        const bool within = counts && x < suspect.a && x > -suspect.b;
        const double value = suspect.values[i] / largest;
        const double off = counts ? (fit.sign * data.values[i] - suspect.values[i]) / largest : 0;
        if (std::isfinite(suspect.values[i])) {
            double& most = worst[counts ? 1 : 0];
            most = std::max(most, std::abs(fit.sign * data.values[i] - suspect.values[i]));
        }
        left.push_back(within ? std::optional(Scatter::At{off, value, value}) : std::nullopt);
        all += counts ? 1 : 0;
        fit.nodes += within ? 1 : 0;
        inside += within ? value * value : 0;
        square += off * off;
    }
    if (fit.nodes < fewest_nodes_counted) {
        return {};
    }
    const Scatter scatter(left);
    fit.left = std::sqrt(square / static_cast<double>(all));
    fit.noise = scatter.noise();
    fit.freedom = scatter.freedom();
    fit.scale = fit.sign * products / squares;
    fit.scale_error = scatter.error_of_sum() / inside;
    fit.largest_counted = worst[1] >= worst[0];
    return fit;
}

bool is_excluded(const Observed& data, const Suspect& suspect, const Suspect& other) {
    const auto fit = fit_of(data, suspect);
    const auto other_fit = fit_of(data, other);
    if (!fit || !other_fit) {
        return true;
    }
    std::vector<std::optional<Scatter::At>> nodes;
    double projection = 0;
    for (std::size_t i = 0; i < data.nodes.size(); ++i) {
        nodes.emplace_back();
        if (data.counts(suspect, i) && data.counts(other, i)) {
            const double value = fit->sign * suspect.values[i];
            const double other_value = other_fit->sign * other.values[i];
            const double difference = other_value - value;
            nodes.back() = Scatter::At{data.values[i] - other_value, value, difference};
            projection += difference * (data.values[i] - value);
        }
    }
    const Scatter scatter(nodes);
    return projection > students(most_errors, scatter.freedom()) * scatter.error_of_sum();
}

double median_ratio(const Observed& data, const std::vector<double>& right) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < right.size(); ++i) {
        if (std::isfinite(right[i]) && right[i] != 0) {
            ratios.push_back(data.values[i] / right[i]);
        }
    }
    if (ratios.empty()) {
        return 1;
    }
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::ranges::nth_element(ratios, middle);
    return *middle;
}

bool explains(const Fit& fit, double allowance, double unexplained) {
    return fit.is_scatter(allowance) && fit.left < share_left * unexplained;
}

} // namespace edgeproof::comparison
