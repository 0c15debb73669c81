// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/design/design_file.hpp"

#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/scene/route/scene_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace edgeproof::scene {
namespace {

constexpr unsigned estimate_digits = 12;
constexpr long printed_bits = 256;
/// For reaches without a closed form.
constexpr contact::SampleGrid coarse_grid{16, 6, 4};

/// Computes the reach or measure at single values, each as a scene of its own, if no closed form is
/// known.
class SampledScenes {
public:
    explicit SampledScenes(const DesignScene& design) : design_(design) {}
    [[nodiscard]] double operator()(double parameter) const {
        check_interruption();
        try {
            Scene scene = design_.at(contact::exact_value(Real(parameter))).without_shear();
            if (!scene.profile || design_.shear) {
                return std::numeric_limits<double>::quiet_NaN();
            }
            scene.ask.digits.count = estimate_digits;
            SceneValues values(std::move(scene));
            double least = std::numeric_limits<double>::infinity();
            for (const Edge edge : design_.edges) {
                const std::vector<Row> rows = extent(values, edge);
                const bool fraction = design_.unit == contact::ReachUnit::fraction;
                const Quantity quantity =
                    design_.objective == DesignObjective::measure
                        ? (fraction ? Quantity::measure_fraction : Quantity::measure)
                        : (fraction ? Quantity::extent_fraction : Quantity::extent);
                const RowsAt at_edge(rows);
                const BoundedValue& value = at_edge.at(quantity, design_.terms);
                least = std::min(least, value.value.midpoint().convert_to<double>());
            }
            return least;
        } catch (const Error&) { // no contact, or no profile, for these values
            return std::numeric_limits<double>::quiet_NaN();
        }
    }

private:
    /// Searches for a first exit near the edge before the whole part: most exits lie there, and the
    /// rest of the contact takes long.
    [[nodiscard]] std::vector<Row> extent(SceneValues& values, Edge edge) const {
        const AskedValue asked{Quantity::extent, design_.terms, edge};
        const contact::ExtentRange whole{Exact(), Exact::of(design_.part)};
        if (design_.objective == DesignObjective::first_exit) {
            for (const long share : {8L, 2L}) {
                if (Rational(1, share) < design_.part) {
                    values.look_at({whole.from, Exact::of(Rational(1, share))});
                    std::vector<Row> rows = values.search(asked);
                    values.look_at(whole);
                    if (rows.front().reached) {
                        return rows;
                    }
                }
            }
        }
        return values.search(asked);
    }
    const DesignScene& design_;
};

DesignResult estimated_design(const contact::ParameterRange& range,
                              const std::function<double(double)>& score,
                              const contact::SampleGrid& samples) {
    const contact::SampledBest found = contact::sampled_best(score, range, samples);
    if (!found.value) {
        throw BudgetError("no reach is found anywhere in the range");
    }
    DesignResult result;
    result.best.value = Ball::around(Real(*found.value), Real(2 * found.width), 64);
    result.best.reach = Ball::around(Real(found.score), Real(std::fabs(found.score) * 1e-9), 64);
    return result;
}

} // namespace

DesignResult run_design(const DesignScene& design, const contact::DesignOptions& options) {
    DesignResult result;
    std::string why_not;
    const auto errors = design.errors(why_not);
    contact::ReachProblem problem;
    problem.tolerance = design.tolerance.rational();
    problem.part = design.part;
    for (const auto& e : errors) {
        problem.edges.push_back(e.get());
    }
    const bool measure = design.objective == DesignObjective::measure;
    const SampledScenes by_scenes(design);
    const auto score = [&](double x) {
        if (errors.empty()) {
            return by_scenes(x);
        }
        if (measure) {
            return sampled_measure(problem, x);
        }
        const auto at = reach_near(problem, x);
        return at ? contact::approximate(at->reach) : std::numeric_limits<double>::quiet_NaN();
    };
    if (errors.empty() || measure) {
        if (errors.empty() && design.shear) {
            throw InputError("nothing is known of the shear traction over this range: " + why_not,
                             "write of = \"pressure\", or change the scene")
                .at(design.file, 0);
        }
        const contact::SampleGrid samples = errors.empty() ? coarse_grid : contact::SampleGrid{};
        const auto total = static_cast<std::size_t>(samples.count());
        std::size_t done = 0;
        const auto counted = [&](double x) {
            const double s = score(x);
            if (options.progress) {
                options.progress(++done * 1000 / total, 1000);
            }
            return s;
        };
        result = estimated_design(design.range, counted, samples);
        result.missing =
            errors.empty() ? why_not
                           : "the measure is found by samples: branch and bound is for first_exit";
    } else {
        result.best = best_reach(problem, design.range, options);
        result.missing = result.best.missing;
    }
    if (design.printed) {
        if (result.missing.empty()) {
            result.printed_reach = proved_reach(problem, Ball(*design.printed, printed_bits)).reach;
        } else {
            result.printed_reach = Ball(Real(score(design.printed->convert_to<double>())), 64);
        }
        result.falls_short = 1 - *result.printed_reach / result.best.reach;
    }
    return result;
}

} // namespace edgeproof::scene
