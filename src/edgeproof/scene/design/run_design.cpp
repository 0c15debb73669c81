// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/design/design_file.hpp"

#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/scene/route/value_route.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace edgeproof::scene {
namespace {

constexpr unsigned estimate_digits = 12;
constexpr int curve_points = 240;
constexpr std::size_t most_curve_points = 2000;
constexpr double steepest_step = 0.02; ///< of the highest reach, between neighbours
constexpr double narrowest_step = 1e-6;
constexpr long printed_bits = 256;

/// Computes the reach or measure at single values, each as a scene of its own, if no closed form is
/// known.
class SampledScenes {
public:
    explicit SampledScenes(const DesignScene& design) : design_(design) {}
    [[nodiscard]] double operator()(const std::vector<double>& values) const {
        check_interruption();
        std::vector<Rational> exact;
        for (const double x : values) {
            exact.push_back(contact::exact_value(Real(x)));
        }
        try {
            Scene scene = design_.at(exact).without_shear();
            if (!scene.profile || design_.shear) {
                return std::numeric_limits<double>::quiet_NaN();
            }
            scene.ask.digits.count = estimate_digits;
            const Plan plan = make_plan(scene);
            Work work;
            const auto route = make_route(scene, plan, work);
            double least = std::numeric_limits<double>::infinity();
            for (const Edge edge : design_.edges) {
                const std::vector<Row> rows = extent(*route, scene, edge);
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
    [[nodiscard]] std::vector<Row> extent(ValueRoute& route, Scene& scene, Edge edge) const {
        const AskedValue asked{Quantity::extent, design_.terms, edge};
        const Exact whole = scene.ask.part.to;
        if (design_.objective == DesignObjective::first_exit) {
            for (const long share : {8L, 2L}) {
                if (Rational(1, share) < design_.part) {
                    scene.ask.part.to = Exact::of(Rational(1, share));
                    std::vector<Row> rows = route.search(asked);
                    scene.ask.part.to = whole;
                    if (rows.front().reached) {
                        return rows;
                    }
                }
            }
        }
        return route.search(asked);
    }
    const DesignScene& design_;
};

DesignResult estimated_design(const std::vector<contact::ParameterRange>& ranges,
                              const std::function<double(const std::vector<double>&)>& score,
                              const contact::SampleGrid& samples) {
    const contact::SampledBest found = contact::sampled_best(score, ranges, samples);
    if (found.value.empty()) {
        throw BudgetError("no reach is found anywhere in the range");
    }
    DesignResult result;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        result.best.value.push_back(
            Ball::around(Real(found.value[i]), Real(2 * found.width[i]), 64));
    }
    result.best.reach = Ball::around(Real(found.score), Real(std::fabs(found.score) * 1e-9), 64);
    return result;
}

std::optional<std::vector<Rational>> printed_values(const DesignScene& design) {
    std::vector<Rational> values;
    for (const DesignScene::Parameter& p : design.parameters) {
        if (!p.printed) {
            return {};
        }
        values.push_back(*p.printed);
    }
    return values;
}

/// Adds points between neighbours that differ by more than `step`. If such neighbours are closer
/// than `narrowest`, there is a jump between them.
void refine_curve(std::vector<std::pair<double, double>>& curve,
                  const std::function<double(const std::vector<double>&)>& score, double step,
                  double narrowest) {
    for (std::size_t k = 0; k + 1 < curve.size() && curve.size() < most_curve_points;) {
        const auto& [x0, y0] = curve[k];
        const auto& [x1, y1] = curve[k + 1];
        if (!(std::fabs(y1 - y0) > step) || x1 - x0 < narrowest) {
            ++k;
            continue;
        }
        const double m = (x0 + x1) / 2;
        curve.insert(curve.begin() + static_cast<std::ptrdiff_t>(k) + 1, {m, score({m})});
    }
}

std::vector<double> as_doubles(const std::vector<Rational>& values) {
    std::vector<double> all;
    for (const Rational& q : values) {
        all.push_back(q.convert_to<double>());
    }
    return all;
}

} // namespace

DesignResult run_design(const DesignScene& design, const DesignRunOptions& options) {
    DesignResult result;
    std::string why_not;
    const auto errors = design.errors(why_not);
    const auto ranges = design.ranges();
    contact::ReachProblem problem;
    problem.tolerance = design.tolerance.rational();
    problem.part = design.part;
    problem.parameters = ranges.size();
    for (const auto& e : errors) {
        problem.edges.push_back(e.get());
    }
    const bool measure = design.objective == DesignObjective::measure;
    const SampledScenes by_scenes(design);
    const auto score = [&](const std::vector<double>& x) {
        if (errors.empty()) {
            return by_scenes(x);
        }
        const contact::SampledReach r = sampled_reach(problem, x, measure);
        return measure ? r.measure : r.reach;
    };
    if (errors.empty() || measure) {
        if (errors.empty() && (design.shear || design.objective == DesignObjective::slip_load)) {
            const bool shear = design.shear;
            throw InputError(
                std::string("nothing is known of the ") +
                    (shear ? "shear traction" : "slip zones") + " over this range: " + why_not,
                shear ? "write of = \"pressure\", or change the scene" : "change the scene")
                .at(design.file, 0);
        }
        const contact::SampleGrid samples = errors.empty()
                                                ? contact::SampleGrid::coarse(ranges.size())
                                                : contact::SampleGrid::of(ranges.size());
        const std::size_t total = samples.count(ranges.size());
        std::size_t done = 0;
        const auto counted = [&](const std::vector<double>& x) {
            const double s = score(x);
            if (options.search.progress) {
                options.search.progress(++done * 1000 / total, 1000);
            }
            return s;
        };
        result = estimated_design(ranges, counted, samples);
        result.missing =
            errors.empty() ? why_not
                           : "the measure is found by samples: branch and bound is for first_exit";
    } else {
        result.best = best_reach(problem, ranges, options.search);
        result.missing = result.best.missing;
    }
    if (const auto printed = printed_values(design)) {
        if (result.missing.empty()) {
            result.printed_reach = proved_reach(problem, *printed, printed_bits).reach;
        } else {
            result.printed_reach = Ball(Real(score(as_doubles(*printed))), 64);
        }
        result.falls_short = 1 - *result.printed_reach / result.best.reach;
    }
    if (options.curve && ranges.size() == 1) {
        const double from = ranges[0].from.convert_to<double>();
        const double to = ranges[0].to.convert_to<double>();
        const int points = errors.empty() ? curve_points / 4 : curve_points;
        std::vector<double> at;
        for (int k = 0; k <= points; ++k) {
            at.push_back(from + (to - from) * k / points);
        }
        // Samples on both sides of the best value, where the reach may jump.
        const double best = result.best.value[0].midpoint().convert_to<double>();
        for (const double side : {-1.0, 1.0}) {
            const double x = best + side * 1e-7 * (to - from);
            if (x > from && x < to) {
                at.push_back(x);
            }
        }
        std::sort(at.begin(), at.end());
        double highest = 0;
        for (const double x : at) {
            result.curve.emplace_back(x, score({x}));
            highest = std::fmax(highest, result.curve.back().second);
        }
        refine_curve(result.curve, score, steepest_step * highest, narrowest_step * (to - from));
    }
    return result;
}

} // namespace edgeproof::scene
