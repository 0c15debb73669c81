// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/causes/causes.hpp"
#include "edgeproof/comparison/causes/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace edgeproof::comparison {
namespace {

constexpr double right_as_a_mesh = 0.003; ///< of the largest pressure: data that need no cause
constexpr double share_of_error = 0.05;   ///< the least allowance, of the error to be explained
constexpr double most_of_a_mesh = 0.03;   ///< the largest allowance for a mesh's own error
constexpr double most_scatters = 2;       ///< that the error of a mistake not excluded may be
constexpr double as_little = 1.2;
constexpr std::size_t most_nodes = 1000;
constexpr double roundoff = 1e-12;

Observed observed_in(const AlignedResult& data, const DataContact& contact,
                     const ExactContact& exact) {
    Observed observed{{data, {}}, {}, std::max(contact.element[0], contact.element[1]), {}};
    const std::size_t step = (data.nodes.size() + most_nodes - 1) / most_nodes;
    for (std::size_t i = 0; i < data.nodes.size(); i += std::max<std::size_t>(1, step)) {
        observed.nodes.nodes.push_back(i);
    }
    for (const ContactKnot& knot : exact.knots()) {
        if (knot.corner) {
            observed.corners.push_back(knot.x);
        }
    }
    return observed;
}

/// A mistake that may have led to the data.
struct Candidate {
    const Suspect* suspect = nullptr;
    Fit fit;
};

/// Returns the most likely first, without those that leave clearly more than the best one and that
/// the data exclude.
std::vector<Cause> ranked(std::vector<Candidate> candidates, const Observed& data, double factor) {
    // Mistakes of the same effect stay in the order of the catalogue.
    std::ranges::stable_sort(
        candidates, {}, [](const Candidate& one) { return std::round(one.fit.left / roundoff); });
    std::vector<Cause> causes;
    for (const Candidate& one : candidates) {
        const Candidate& best = candidates.front();
        if (one.fit.left <= as_little * best.fit.left + roundoff ||
            !is_excluded(data, *one.suspect, *best.suspect)) {
            causes.push_back({one.suspect->name, one.suspect->what, factor, one.fit.left, {}});
        }
    }
    for (std::size_t i = 0; i < causes.size(); ++i) { // variants of one mistake
        const auto rest = causes.begin() + static_cast<std::ptrdiff_t>(i) + 1;
        causes.erase(std::remove_if(rest, causes.end(),
                                    [&one = causes[i]](const Cause& other) {
                                        return other.name == one.name && other.what == one.what;
                                    }),
                     causes.end());
    }
    for (Cause& cause : causes) {
        for (const Cause& other : causes) {
            const bool new_name =
                other.name != cause.name &&
                std::ranges::find(cause.equally_likely, other.name) == cause.equally_likely.end();
            if (new_name) {
                cause.equally_likely.push_back(other.name);
            }
        }
    }
    return causes;
}

/// Noise of some percent needs the floor: the scatter of a few hundred nodes is not known better.
double allowance_for(double mesh_error, double unexplained) {
    return std::max(std::min(mesh_error, most_of_a_mesh),
                    std::min(right_as_a_mesh, share_of_error * unexplained));
}

Diagnosis diagnose_observed(const Observed& data, const Suspect& right,
                            const std::vector<Suspect>& suspects, double mesh_error) {
    Diagnosis diagnosis;
    const auto as_it_is = fit_of(data, right); // empty if hardly any node lies in the exact contact
    diagnosis.unexplained = as_it_is ? as_it_is->left : 1;
    diagnosis.too_few = !as_it_is;
    if (as_it_is) {
        diagnosis.noise = as_it_is->noise;
        diagnosis.largest_inside = as_it_is->largest_counted;
        diagnosis.at_edges_only =
            as_it_is->is_scatter(std::max(right_as_a_mesh, std::min(mesh_error, most_of_a_mesh)));
    }
    const double allowance = allowance_for(mesh_error, diagnosis.unexplained);
    const double factor = median_ratio(data, right.values);
    // If one mistake explains the data, those are named with it that the data do not exclude: of
    // some hundred sets of data, the scale of the right one is off by more than three standard
    // errors in some.
    bool explained = false;
    std::vector<Candidate> candidates;
    for (const Suspect& suspect : suspects) {
        const auto fit = fit_of(data, suspect);
        if (fit && fit->left < diagnosis.unexplained &&
            fit->is_scatter(allowance, most_errors, most_scatters)) {
            candidates.push_back({&suspect, *fit});
            explained = explained || explains(*fit, allowance, diagnosis.unexplained);
        }
    }
    if (explained) {
        diagnosis.causes = ranked(std::move(candidates), data, factor);
    }
    if (diagnosis.causes.empty() && as_it_is) {
        if (auto cause = alternation(data, right, allowance, diagnosis.unexplained)) {
            diagnosis.causes.push_back(std::move(*cause));
        }
    }
    if (!diagnosis.causes.empty()) {
        diagnosis.noise = diagnosis.causes.front().scatter;
    } else if (as_it_is && !diagnosis.at_edges_only) {
        Suspect scaled = right;
        for (double& value : scaled.values) {
            value *= as_it_is->scale;
        }
        const auto fit = fit_of(data, scaled);
        if (fit && explains(*fit, allowance, diagnosis.unexplained)) {
            diagnosis.factor = {as_it_is->scale, fit->scale_error * std::abs(as_it_is->scale)};
            diagnosis.noise = fit->noise;
        }
    }
    return diagnosis;
}

/// The scene under the force that the data carry. The rule for it is applied to its exact pressure,
/// too, to correct the error of the rule.
std::optional<Cause> own_force(const Observed& data, double force, SuspectContacts& suspects,
                               double allowance, double unexplained) {
    const ExactContact* contact = nullptr;
    const auto solve = [&](double P) {
        contact = suspects.with(fmt::format("P = {:.17g}", P), [P](scene::Scene& other) {
            other = other.without_shear();
            scene::change_given(other, [P](scene::Scene& given) {
                given.load =
                    contact::Load::force(formula::Exact(formula::Expr::number(exact_rational(P))));
            });
        });
    };
    if (!(force > 0 && std::isfinite(force))) {
        return {};
    }
    solve(force);
    if (contact != nullptr) {
        const auto exact = [&](const Node& node) { return contact->quick_pressure(node.x); };
        const double corrected = force * force / force_of(data.nodes.data, *contact, exact);
        force = corrected > 0 && corrected < 2 * force ? corrected : force;
        solve(force);
    }
    if (contact == nullptr) {
        return {};
    }
    Suspect carried{"another-force", "", contact->a().value, contact->b().value, {}};
    for (std::size_t i = 0; i < data.nodes.size(); ++i) {
        carried.values.push_back(contact->quick_pressure(data.nodes[i].x).value_or(std::nan("")));
    }
    const auto fit = fit_of(data, carried);
    if (!fit || !explains(*fit, allowance, unexplained)) {
        return {};
    }
    return Cause{
        carried.name,
        fmt::format("the data carry P = {:.5g}; with that force they agree to {:.2g} %: "
                    "another load step{}?",
                    force, 100 * fit->left,
                    contact->axisymmetric() ? "" : ", or a total force for a force per length"),
        median_ratio(data, carried.values),
        fit->left,
        {}};
}

} // namespace

Diagnosis diagnose(const ResultTable& table, const AlignedResult& data, const DataContact& contact,
                   SuspectContacts& suspects, const ExactContact& exact, double mesh_error) {
    Observed observed = observed_in(data, contact, exact);
    Suspect right{"", "", exact.a().value, exact.b().value, {}};
    for (std::size_t i = 0; i < observed.nodes.size(); ++i) {
        const Node& node = observed.nodes[i];
        observed.values.push_back(node.p);
        right.values.push_back(node.exact.p.value_or(std::nan("")));
    }
    Diagnosis diagnosis = diagnose_observed(
        observed, right, pressure_suspects(observed.nodes, suspects, exact), mesh_error);
    if (diagnosis.causes.empty() && !diagnosis.at_edges_only) {
        const double allowance = allowance_for(mesh_error, diagnosis.unexplained);
        if (auto cause = own_force(observed, contact.force.value_or(0), suspects, allowance,
                                   diagnosis.unexplained)) {
            diagnosis.causes.push_back(std::move(*cause));
            diagnosis.factor.reset();
        }
    }
    if (diagnosis.at_edges_only && diagnosis.causes.empty()) {
        if (const auto cause = cause_in_digits(table, data, exact)) {
            diagnosis.causes.push_back(*cause);
        }
    }
    return diagnosis;
}

Diagnosis diagnose_shear(const AlignedResult& data, const DataContact& contact,
                         SuspectContacts& suspects, const ExactContact& exact, double mesh_error) {
    Observed observed = observed_in(data, contact, exact);
    Suspect right{"", "", exact.a().value, exact.b().value, {}};
    for (std::size_t i = 0; i < observed.nodes.size(); ++i) {
        const auto& shear = observed.nodes[i].shear;
        observed.values.push_back(shear ? shear->q : 0);
        right.values.push_back(shear ? shear->exact.value_or(std::nan("")) : std::nan(""));
    }
    return diagnose_observed(observed, right, shear_suspects(observed.nodes, suspects, exact),
                             mesh_error);
}

namespace {

constexpr int most_rounded_digits = 9;
constexpr double half_unit = 0.51; ///< of the last digit, with a little for binary64
constexpr double near_edge_share = 0.02;
constexpr double units_of_binary32 = 16;
/// Rounding errors are uniformly distributed, with an rms of 1/sqrt(3) of the largest; the data's
/// own noise, which is smaller, adds to them.
constexpr double rms_with_noise = 0.65;
constexpr double largest_with_noise = 2;

/// True if rounding by `allowed` at each node explains all errors that count.
template <class Allowed>
bool explains(const AlignedResult& data, const ExactContact& exact, const Allowed& allowed) {
    double largest = 0;
    double squares = 0;
    std::size_t n = 0;
    for (const Node& node : data.nodes) {
        if (node.exact.p && node.exact.u() > near_edge_share * exact.length()) {
            const double part = std::abs(node.error) / std::max(allowed(node), node.rounding);
            largest = std::max(largest, part);
            squares += part * part;
            ++n;
        }
    }
    return largest <= 1 || (largest <= largest_with_noise &&
                            squares <= rms_with_noise * rms_with_noise * static_cast<double>(n));
}

} // namespace

std::optional<Cause> cause_in_digits(const ResultTable& table, const AlignedResult& data,
                                     const ExactContact& exact) {
    const CarriedDigits& digits = table.p_digits;
    const double factor = table.p_factor;
    const auto significant_unit = [&](const Node& node) {
        const double p = std::abs(node.p / factor);
        const double leading = p > 0 ? std::floor(std::log10(p * (1 + 1e-15))) : -300;
        return half_unit * factor * std::pow(10.0, leading - digits.significant + 1);
    };
    const auto decimal_unit = [&](const Node&) {
        return half_unit * factor * std::pow(10.0, -digits.decimals);
    };
    const auto cause = [](const std::string& name, const std::string& what) {
        return Cause{name, what, 1, 0, {}};
    };
    const bool few = digits.significant <= most_rounded_digits;
    if (few && explains(data, exact, significant_unit)) {
        return cause(fmt::format("rounded-to-{}", digits.significant),
                     fmt::format("p is rounded to {} digits", digits.significant));
    }
    if (few && !digits.exponents && explains(data, exact, decimal_unit)) {
        return cause(fmt::format("rounded-to-{}-decimals", digits.decimals),
                     fmt::format("p is rounded to {} decimals", digits.decimals));
    }
    const double single = units_of_binary32 * std::ldexp(exact.scale().value, -24);
    if (digits.binary32 && explains(data, exact, [single](const Node&) { return single; })) {
        return cause("binary32", "p consists of binary32 numbers, about 7 digits");
    }
    return {};
}

} // namespace edgeproof::comparison
