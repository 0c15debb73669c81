// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/best_reach.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/roots/bracketed_root.hpp"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace edgeproof::contact {
namespace {

constexpr long sample_bits = 96;
constexpr int sample_points = 160;
constexpr double width_of_a_crossing = 0x1p-48; // relative
constexpr int bits_of_an_extremum =
    27; // half of those of a double, since the function is flat there
/// An extremum of |f| that is nearer to the tolerance than this share of it is refined.
constexpr double near_the_tolerance = 0.25;

double as_double(const Ball& x) {
    return x.is_finite() ? approximate(x) : std::numeric_limits<double>::quiet_NaN();
}

class EdgeSamples {
public:
    EdgeSamples(const ErrorOverBox& f, double tolerance, double end, double middle, bool whole)
        : f_(f), tolerance_(tolerance), end_(end), middle_(middle), whole_(whole) {}

    /// |f| - tolerance; at a corner, where p is infinite, f = -1.
    [[nodiscard]] double excess(double u) const {
        const double f = error(u);
        return std::isnan(f) ? 1 : std::fabs(f) - tolerance_;
    }
    [[nodiscard]] double error(double u) const {
        return as_double(f_.at(Ball(Real(u), sample_bits)));
    }

    void into(SampledReach& result, std::size_t edge) const {
        std::vector<double> u;
        for (int k = 0; k < sample_points; ++k) {
            const double s = static_cast<double>(k + 1) / sample_points;
            u.push_back(end_ * (k + 1 == sample_points ? 1 - 1e-9 : s * s * s));
        }
        if (middle_ < u.back()) { // a power law's error may have a cusp there
            u.insert(std::lower_bound(u.begin(), u.end(), middle_), middle_);
        }
        std::vector<double> e;
        bool passed = false;
        for (const double x : u) {
            // Far beyond the exit only the measure matters.
            e.push_back(passed ? tolerance_ : excess(x));
            passed = !whole_ && (passed || e.back() > near_the_tolerance * tolerance_);
        }
        double exit = end_;
        bool leaves = false;
        double measure = 0;
        for (std::size_t k = 0; k < u.size(); ++k) {
            const double before = k == 0 ? 0 : u[k - 1];
            const double at_before = k == 0 ? -tolerance_ : e[k - 1];
            const bool highest_here =
                k > 0 && k + 1 < u.size() && e[k] >= e[k - 1] && e[k] >= e[k + 1];
            // Adds the extremum next to a sample; returns its place and |f| - tolerance there.
            const auto add_extremum = [&] {
                double top = highest(u[k - 1], u[k + 1]);
                top = e[k] > excess(top) ? u[k] : top;
                const double most = excess(top);
                result.extrema.push_back({edge, top, most, error(top) > 0 ? 1 : -1});
                return std::pair(top, most);
            };
            if (!leaves && highest_here && e[k] < 0 && e[k] > -near_the_tolerance * tolerance_) {
                const auto [top, most] = add_extremum();
                if (most >= 0) { // the tolerance is exceeded between two samples
                    leaves = true;
                    exit = crossing(before, at_before, top, most);
                }
            }
            const bool was = at_before < 0;
            const bool is = e[k] < 0;
            if (was != is) {
                const double at = was ? crossing(before, at_before, u[k], e[k])
                                      : crossing(u[k], e[k], before, at_before);
                measure += was ? at - before : u[k] - at;
                if (was && !leaves) {
                    leaves = true;
                    exit = at;
                }
            } else if (is) {
                measure += u[k] - before;
            }
            // An exit may also be an extremum that exceeds the tolerance between its neighbours.
            if (highest_here && e[k] >= 0 && e[k] < near_the_tolerance * tolerance_) {
                add_extremum();
            }
        }
        if (exit < result.reach || edge == 0) {
            result.reach = exit;
            result.leaves = leaves;
            result.edge = edge;
            result.side = error(exit) > 0 ? 1 : -1;
        }
        result.measure = edge == 0 ? measure : std::min(measure, result.measure);
    }

private:
    /// Returns the crossing between `in`, within the tolerance, and `out`, beyond it, by the
    /// method of docs/expansions.md.
    [[nodiscard]] double crossing(double in, double at_in, double out, double at_out) const {
        return roots::bracketed_root([this](double u) { return excess(u); }, in, at_in, out, at_out,
                                     width_of_a_crossing)
            .x;
    }
    [[nodiscard]] double highest(double lo, double hi) const {
        return boost::math::tools::brent_find_minima([this](double u) { return -excess(u); }, lo,
                                                     hi, bits_of_an_extremum)
            .first;
    }

    const ErrorOverBox& f_;
    double tolerance_;
    double end_;
    double middle_;
    bool whole_;
};

} // namespace

SampledReach sampled_reach(const ReachProblem& problem, double parameter, bool whole) {
    check_interruption();
    const auto errors = problem.over(Ball(Real(parameter), sample_bits));
    SampledReach result;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const double length = as_double(errors[i].length);
        const double end = length * problem.part.convert_to<double>();
        if (std::isnan(end)) {
            result.reach = end;
            return result;
        }
        EdgeSamples(errors[i], problem.tolerance.convert_to<double>(), end, length / 2, whole)
            .into(result, i);
    }
    std::sort(result.extrema.begin(), result.extrema.end(),
              [](const SampledReach::Extremum& x, const SampledReach::Extremum& y) {
                  return std::fabs(x.excess) < std::fabs(y.excess);
              });
    return result;
}

SampledBest sampled_best(const std::function<double(double)>& score, const ParameterRange& range,
                         const SampleGrid& samples) {
    double lo = range.from.convert_to<double>();
    double hi = range.to.convert_to<double>();
    SampledBest best;
    // Tries a grid with its ends, and keeps the cells next to the best value.
    const auto refine = [&](int cells) {
        best.width = (hi - lo) / cells;
        for (int k = 0; k <= cells; ++k) {
            check_interruption();
            const double x = k == cells ? hi : lo + (hi - lo) * k / cells;
            const double s = score(x);
            if (!std::isnan(s) && (!best.value || s > best.score)) {
                best.value = x;
                best.score = s;
            }
        }
        if (best.value) {
            lo = std::max(lo, *best.value - best.width);
            hi = std::min(hi, *best.value + best.width);
        }
    };
    try {
        refine(samples.first);
        for (int k = 0; k < samples.rounds && best.value; ++k) {
            refine(samples.later);
        }
    } catch (const BudgetError&) { // the best of the values tried is returned
    }
    return best;
}

} // namespace edgeproof::contact
