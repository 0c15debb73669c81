// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/causes.hpp"

#include "edgeproof/comparison/suspects.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace edgeproof::comparison {
namespace {

constexpr double mesh_allowance = 0.003; ///< of the largest pressure, for the mesh
constexpr double scatter_allowance = 1.6;
constexpr double share_left = 0.3;
constexpr double as_little = 1.2;
constexpr std::size_t fewest_nodes_told = 8;
constexpr double edge_share = 0.02; ///< of the suspect's contact

/// How data stand to the pressures of a suspect.
struct Fit {
    double left = 0;  ///< rms of data less suspect, of its largest pressure
    double noise = 0; ///< rms scatter of that from node to node
    double scale = 1; ///< of the suspect's pressures that fits the data best
    std::size_t nodes = 0;

    [[nodiscard]] bool is_scatter() const {
        const double n = static_cast<double>(nodes);
        return left <= scatter_allowance * noise + mesh_allowance &&
               std::abs(scale - 1) <= 4 * noise / std::sqrt(n) + mesh_allowance;
    }
};

/// White noise has second differences of sqrt(6) times its size. Only nodes that follow each other.
double scatter_of(const std::vector<std::optional<double>>& left) {
    double sum = 0;
    std::size_t n = 0;
    for (std::size_t i = 1; i + 1 < left.size(); ++i) {
        if (left[i - 1] && left[i] && left[i + 1]) {
            const double second = *left[i - 1] - 2 * *left[i] + *left[i + 1];
            sum += second * second;
            ++n;
        }
    }
    return n > 0 ? std::sqrt(sum / (6 * static_cast<double>(n))) : 0;
}

std::optional<Fit> fit_of(const AlignedResult& data, const DataContact& contact,
                          const Suspect& suspect) {
    const double zone = std::max(2 * std::max(contact.element[0], contact.element[1]),
                                 edge_share * (suspect.a + suspect.b));
    double largest = 0;
    for (const double p : suspect.p) {
        largest = std::isfinite(p) ? std::max(largest, std::abs(p)) : largest;
    }
    if (!(largest > 0)) {
        return {};
    }
    std::vector<std::optional<double>> left; // of nodes inside the suspect's contact
    Fit fit;
    double square = 0;
    double products = 0;
    double squares = 0;
    std::size_t inside = 0;
    for (std::size_t i = 0; i < data.nodes.size(); ++i) {
        const Node& node = data.nodes[i];
        const bool near =
            std::min(std::abs(node.x - suspect.a), std::abs(node.x + suspect.b)) < zone;
        const bool told = std::isfinite(suspect.p[i]) && !near;
        const double off = told ? (node.p - suspect.p[i]) / largest : 0;
        const bool within = node.x < suspect.a && node.x > -suspect.b;
        left.push_back(told && within ? std::optional(off) : std::nullopt);
        if (told) {
            ++fit.nodes;
            inside += within ? 1 : 0;
            square += off * off;
            products += node.p * suspect.p[i];
            squares += suspect.p[i] * suspect.p[i];
        }
    }
    if (inside < fewest_nodes_told || !(squares > 0)) {
        return {};
    }
    fit.left = std::sqrt(square / static_cast<double>(fit.nodes));
    fit.noise = scatter_of(left);
    fit.scale = products / squares;
    fit.nodes = inside;
    return fit;
}

double median_ratio(const AlignedResult& data) {
    std::vector<double> ratios;
    for (const Node& node : data.nodes) {
        if (node.exact.p && *node.exact.p > 0) {
            ratios.push_back(node.p / *node.exact.p);
        }
    }
    if (ratios.empty()) {
        return 1;
    }
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::ranges::nth_element(ratios, middle);
    return *middle;
}

} // namespace

Diagnosis diagnose(const AlignedResult& data, const DataContact& contact, const scene::Scene& scene,
                   const ExactContact& exact) {
    Diagnosis diagnosis;
    Suspect right{"", "", exact.a().value, exact.b().value, {}};
    for (const Node& node : data.nodes) {
        right.p.push_back(node.exact.p.value_or(std::nan("")));
    }
    const auto as_it_is = fit_of(data, contact, right);
    if (!as_it_is) {
        return diagnosis;
    }
    diagnosis.unexplained = as_it_is->left;
    diagnosis.noise = as_it_is->noise;
    if (as_it_is->is_scatter()) {
        diagnosis.at_edges_only = true;
        return diagnosis;
    }
    const double factor = median_ratio(data);
    for_each_suspect(data, scene, exact, [&](const Suspect& suspect) {
        const auto fit = fit_of(data, contact, suspect);
        if (fit && fit->is_scatter() && fit->left < share_left * as_it_is->left) {
            diagnosis.causes.push_back({suspect.name, suspect.what, factor, fit->left, {}});
        }
    });
    std::ranges::stable_sort(diagnosis.causes, {}, &Cause::scatter);
    if (!diagnosis.causes.empty()) {
        const double best = diagnosis.causes.front().scatter;
        diagnosis.noise = best;
        // What leaves clearly more is told apart from the best, and no cause.
        std::erase_if(diagnosis.causes, [best](const Cause& cause) {
            return cause.scatter > as_little * best + 1e-12;
        });
        for (Cause& cause : diagnosis.causes) {
            for (const Cause& other : diagnosis.causes) {
                const bool new_name = other.name != cause.name &&
                                      std::ranges::find(cause.equally_likely, other.name) ==
                                          cause.equally_likely.end();
                if (new_name) {
                    cause.equally_likely.push_back(other.name);
                }
            }
        }
    }
    return diagnosis;
}

} // namespace edgeproof::comparison
