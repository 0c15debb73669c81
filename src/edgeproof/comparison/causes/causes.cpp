// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/causes/causes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace edgeproof::comparison {
namespace {

using diagnose::Candidate;

constexpr double right_as_a_mesh = 0.003; ///< of the largest pressure: data that need no cause
constexpr double most_of_a_mesh = 0.03;   ///< the largest allowance for a mesh's own error
constexpr double roundoff = 1e-12;
constexpr double share_of_one_sign = 0.9;
constexpr double share_left = 0.3; ///< of the error, that a cause may leave

/// True if the part of the error that changes its sign from node to node has one sign at nearly all
/// nodes of the contact, if every second sign is reversed. That part of noise has no constant sign,
/// and that of a wave k elements long changes it after k/(k - 2) nodes.
bool has_one_sign(const Observed& data) {
    const auto error = [&](std::size_t i) { return data.values[i] - data.right.values[i]; };
    std::size_t all = 0;
    std::size_t positive = 0;
    for (std::size_t i = 1; i + 1 < data.size(); ++i) {
        if (data.inside(data.right, i - 1) && data.inside(data.right, i) &&
            data.inside(data.right, i + 1)) {
            const double part = 2 * error(i) - error(i - 1) - error(i + 1);
            positive += (part > 0) == (i % 2 == 0) ? 1 : 0;
            ++all;
        }
    }
    return static_cast<double>(std::max(positive, all - positive)) >=
           share_of_one_sign * static_cast<double>(all);
}

/// Recognises data that alternate from node to node, as those at the corners and in the middles of
/// the sides of quadratic elements do: every second node is right, or the means over neighbours
/// are. `unexplained`: the error of all nodes.
std::optional<Cause> alternation(const Observed& data, double allowance, double unexplained) {
    if (data.size() != data.data.nodes.size() || !has_one_sign(data)) {
        return {}; // if only some nodes are used, they are not neighbours
    }
    for (const std::optional<std::size_t> parity : {std::optional<std::size_t>(0), {1}, {}}) {
        const Observed part = data.part(parity);
        const auto left = part.left_by(part.right);
        if (!left || !is_noise(remainder_of(left->rows), allowance) ||
            left->rms > share_left * unexplained) {
            continue;
        }
        std::string what =
            "p alternates about the right one from node to node: corners and middles of the sides "
            "of quadratic elements; give means over neighbours";
        if (parity) {
            const Observed others = data.part(1 - *parity);
            const double off = diagnose::sorted_at(others.ratios(others.right), 0.5) - 1;
            what = fmt::format("every second node is right, and the others are {:.3g} % too {} in "
                               "the median: corners and middles of the sides of quadratic elements",
                               100 * std::abs(off), off < 0 ? "small" : "large");
        }
        return Cause{"mid-side-nodes", std::move(what), 1, left->rms, {}};
    }
    return {};
}

double median_of(std::vector<double> list) {
    return list.empty() ? 1 : diagnose::sorted_at(std::move(list), 0.5);
}

/// The mesh's own error that is allowed, and the error to be explained.
struct Unexplained {
    double allowance = 0;
    double size = 0; ///< the root mean square

    /// Noise of some percent needs the floor: the scatter of a few hundred nodes is not known
    /// better.
    Unexplained(double mesh_error, double unexplained) : size(unexplained) {
        constexpr double share_of_error = 0.05;
        allowance = std::max(std::min(mesh_error, most_of_a_mesh),
                             std::min(right_as_a_mesh, share_of_error * unexplained));
    }
};

/// The fit of a suspect, if it explains the data: what it leaves is a part of the error in the mean
/// over all nodes, too, since a fit is judged by the nodes that the suspect changes.
std::optional<diagnose::Fit> explained_by(const Left& left, const Unexplained& error) {
    return left.rms < share_left * error.size ? fit_of(left.rows, 0, error.allowance)
                                              : std::nullopt;
}
/// What a suspect leaves, if it explains the data.
std::optional<Left> explained_by(const Observed& data, const Suspect& suspect,
                                 const Unexplained& error) {
    auto left = data.left_by(suspect);
    return left && explained_by(*left, error) ? left : std::nullopt;
}

/// The causes that the data do not distinguish, the most likely first.
std::vector<Cause> causes_among(const std::vector<Suspect>& suspects, const Observed& data,
                                const Unexplained& error) {
    std::vector<Candidate> likely;
    std::vector<Candidate> others;
    std::vector<double> rms(suspects.size());
    for (std::size_t i = 0; i < suspects.size(); ++i) {
        const auto left = data.left_by(suspects[i]);
        if (!left) {
            continue;
        }
        rms[i] = left->rms;
        Candidate candidate{suspects[i].name, suspects[i].what, "", 1, Candidate::mistake, i};
        auto fit = explained_by(*left, error);
        candidate.fit = fit ? std::move(*fit) : remainder_of(left->rows);
        (fit ? likely : others).push_back(std::move(candidate));
    }
    if (likely.empty()) {
        return {};
    }
    double noise = error.allowance / 3;
    const double unit = unit_of(likely, noise);
    const double most = most_misfit(likely, unit, likely.front().fit.off.size(),
                                    [](const Candidate& c) { return c.fit; });
    std::ranges::copy_if(others, std::back_inserter(likely),
                         [&](const Candidate& c) { return misfit(c.fit, unit) <= most; });
    keep_best(likely, noise);
    // Mistakes of the same effect stay in the order of the catalogue.
    std::ranges::sort(likely, {}, [&](const Candidate& c) {
        return std::pair(std::round(rms[*c.source] / roundoff), *c.source);
    });
    const double factor = median_of(data.ratios(data.right));
    std::vector<Cause> causes;
    std::vector<std::string> names;
    for (const Candidate& one : likely) {
        const bool known = std::ranges::any_of(causes, [&](const Cause& other) {
            return other.name == one.name && other.what == one.what;
        });
        if (!known) {
            causes.push_back({one.name, one.what, factor, rms[*one.source], {}});
        }
        if (std::ranges::find(names, one.name) == names.end()) {
            names.push_back(one.name);
        }
    }
    for (Cause& cause : causes) {
        std::ranges::remove_copy(names, std::back_inserter(cause.equally_likely), cause.name);
    }
    return causes;
}

/// The ratio of the data to the exact values, if it explains the data as a cause would.
std::optional<CommonFactor> common_factor(const Observed& data, const Unexplained& error,
                                          double& noise) {
    std::vector<double> ratios = data.ratios(data.right);
    std::erase_if(ratios, [](double ratio) { return ratio == 0; });
    const double factor = median_of(ratios);
    Suspect scaled = data.right;
    for (double& value : scaled.values) {
        value *= factor;
    }
    const auto left = explained_by(data, scaled, error);
    if (!left) {
        return {};
    }
    noise = left->noise;
    for (double& ratio : ratios) {
        ratio = std::abs(ratio / factor - 1);
    }
    return CommonFactor{{factor, diagnose::error_of_median(std::move(ratios)) * std::abs(factor)}};
}

/// The factor of x, if the exact pressure at x over it explains the data.
std::optional<CommonFactor> stretch_of(const Observed& data, const ExactContact& exact,
                                       const Unexplained& unexplained, double& noise) {
    const auto stretched = [&](double k) {
        return data.suspect("", "", k * exact.a().value, k * exact.b().value, [&](std::size_t i) {
            return exact.quick_pressure(data[i].x / k).value_or(std::nan(""));
        });
    };
    const auto off = [&](double k) {
        const Suspect suspect = stretched(k);
        std::vector<double> list;
        for (std::size_t i = 0; i < data.size(); ++i) {
            const double error = data.values[i] - suspect.values[i];
            list.push_back(data.counts(suspect, i) ? error / exact.scale().value : 0);
        }
        return list;
    };
    const auto factor = diagnose::fitted_factor(off, off);
    const auto left =
        factor ? explained_by(data, stretched(factor->value), unexplained) : std::nullopt;
    if (!left) {
        return {};
    }
    noise = left->noise;
    return CommonFactor{*factor, true};
}

Diagnosis diagnose_observed(const Observed& data, const std::vector<Suspect>& suspects,
                            double mesh_error) {
    Diagnosis diagnosis;
    const auto as_it_is = data.left_by(data.right); // empty if hardly any node is in the contact
    diagnosis.unexplained = as_it_is ? as_it_is->rms : 1;
    diagnosis.too_few = !as_it_is;
    if (as_it_is) {
        diagnosis.noise = as_it_is->noise;
        diagnosis.inside = as_it_is->inside;
        diagnosis.worst = as_it_is->worst;
        diagnosis.at_edges_only =
            is_noise(remainder_of(as_it_is->rows),
                     std::max(right_as_a_mesh, std::min(mesh_error, most_of_a_mesh)));
    }
    const Unexplained error(mesh_error, diagnosis.unexplained);
    diagnosis.causes = causes_among(suspects, data, error);
    if (diagnosis.causes.empty() && as_it_is) {
        if (auto cause = alternation(data, error.allowance, error.size)) {
            diagnosis.causes.push_back(std::move(*cause));
        }
    }
    if (!diagnosis.causes.empty()) {
        diagnosis.noise = diagnosis.causes.front().scatter;
    } else if (as_it_is && !diagnosis.at_edges_only) {
        diagnosis.factor = common_factor(data, error, diagnosis.noise);
    }
    return diagnosis;
}

/// The scene under the force that the data carry. The rule for it is applied to its exact pressure,
/// too, to correct the error of the rule.
std::optional<Cause> own_force(const Observed& data, double force, SuspectContacts& suspects,
                               const Unexplained& error) {
    const auto solved = [&](double P) {
        return suspects.with(fmt::format("P = {:.17g}", P), [P](scene::Scene& other) {
            other = other.without_shear();
            scene::change_given(other, [P](scene::Scene& given) {
                given.load =
                    contact::Load::force(formula::Exact(formula::Expr::number(exact_rational(P))));
            });
        });
    };
    const bool possible = force > 0 && std::isfinite(force);
    const ExactContact* contact = possible ? solved(force) : nullptr;
    if (contact != nullptr) {
        const auto exact = [&](const Node& node) { return contact->quick_pressure(node.x); };
        const double corrected = force * force / force_of(data.data, *contact, exact);
        force = corrected > 0 && corrected < 2 * force ? corrected : force;
        contact = solved(force);
    }
    if (contact == nullptr) {
        return {};
    }
    const Suspect carried = data.suspect(
        "another-force", "", contact->a().value, contact->b().value,
        [&](std::size_t i) { return contact->quick_pressure(data[i].x).value_or(std::nan("")); });
    const auto left = explained_by(data, carried, error);
    if (!left) {
        return {};
    }
    return Cause{
        carried.name,
        fmt::format("the data carry P = {:.5g}; with that force they agree to {:.2g} %: "
                    "another load step{}?",
                    force, 100 * left->rms,
                    contact->axisymmetric() ? "" : ", or a total force for a force per length"),
        median_of(data.ratios(carried)),
        left->rms,
        {}};
}

/// Finds pressures that carry fewer digits than are written: their errors away from the edges are
/// no larger than this explains, and outside the contact, too.
std::optional<Cause> cause_in_digits(const ResultTable& table, const AlignedResult& data,
                                     const ExactContact& exact) {
    constexpr double near_edge_share = 0.02;
    const double factor = table.p_factor;
    std::vector<diagnose::Written> numbers;
    for (std::size_t i = 0; i < data.nodes.size(); ++i) {
        const Node& node = data.nodes[i];
        if (node.p.exact && std::abs(node.place.u()) > near_edge_share * exact.length()) {
            numbers.push_back({table.rows[i].p_text, node.p.data / factor, node.p.error / factor,
                               node.p.rounding / factor, exact.scale().value / factor});
        }
    }
    const auto found = few_digits(numbers);
    if (!found || found->rows.size() < numbers.size()) {
        return {};
    }
    return Cause{found->name, found->digits.empty()
                                  ? "p consists of binary32 numbers, about 7 digits"
                                  : "p is rounded to " + found->digits};
}

} // namespace

Diagnosis diagnose_pressure(const ResultTable& table, const AlignedResult& data,
                            const DataContact& contact, SuspectContacts& suspects,
                            const ExactContact& exact, double mesh_error) {
    const Observed observed = observed_in(data, contact, exact, p_of);
    Diagnosis diagnosis =
        diagnose_observed(observed, pressure_suspects(observed, suspects, exact), mesh_error);
    if (!diagnosis.causes.empty()) {
        return diagnosis;
    }
    if (diagnosis.at_edges_only) {
        if (auto cause = cause_in_digits(table, data, exact)) {
            diagnosis.causes.push_back(std::move(*cause));
        }
        return diagnosis;
    }
    const Unexplained error(mesh_error, diagnosis.unexplained);
    if (auto cause = own_force(observed, contact.force.value_or(0), suspects, error)) {
        diagnosis.causes.push_back(std::move(*cause));
        diagnosis.factor.reset();
    } else if (!diagnosis.factor && !diagnosis.too_few) {
        diagnosis.factor = stretch_of(observed, exact, error, diagnosis.noise);
    }
    return diagnosis;
}

Diagnosis diagnose_shear(const AlignedResult& data, const DataContact& contact,
                         SuspectContacts& suspects, const ExactContact& exact, double mesh_error) {
    const Observed observed = observed_in(data, contact, exact, q_of);
    return diagnose_observed(observed, shear_suspects(observed, suspects, exact), mesh_error);
}

} // namespace edgeproof::comparison
