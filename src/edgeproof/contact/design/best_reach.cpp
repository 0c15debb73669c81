// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/best_reach.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"

#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <cmath>

namespace edgeproof::contact {
namespace {

constexpr long reach_bits = 192;
constexpr double bits_a_digit = 3.3219281;
constexpr int most_better_values = 12;   ///< the most that branch and bound may find
constexpr double share_of_samples = 0.4; ///< share of the budget
constexpr double share_of_best = 0.7;    ///< for samples and for the proof of the best value
constexpr double jump_of_reach = 1e-5;   ///< a larger difference of reaches is a jump
constexpr double touching_excess =
    1e-2; ///< for an extremum that may touch the tolerance, relative to it
constexpr double farthest_from_sample =
    1e-4; ///< between the best value and the best sample, relative to the range
constexpr double nearest_to_middle = 1e-6; ///< for extrema at a cusp, relative to a + b

/// Returns a short rational near x, on one side of it (on any side for 0).
Rational short_rational(const Ball& x, int side, const Rational& distance) {
    return exact_value(Ball(Ball(x.midpoint(), 192) + Ball(Rational(distance * side), 192))
                           .with_bits(64)
                           .midpoint());
}

class DesignSearch {
public:
    DesignSearch(ReachProblem problem, const std::vector<ParameterRange>& ranges,
                 const DesignOptions& options)
        : problem_(std::move(problem)), ranges_(ranges), options_(options),
          bits_(static_cast<long>(options.digits * bits_a_digit) * 2 + 128) {
        problem_.count = &count_;
    }

    [[nodiscard]] BestReach run() {
        count_.most = share_of_samples * options_.budget;
        sample(ranges_, SampleGrid::of(ranges_.size(), is_costly(*problem_.edges[0])));
        if (sampled_.value.empty()) {
            throw BudgetError("no reach is found anywhere in the range");
        }
        BestReach best = from_sample();
        for (int k = 0; best.missing.empty(); ++k) {
            const auto better = prove(best);
            if (!better || k == most_better_values) {
                break;
            }
            BestReach other = from_better(*better);
            if (!other.missing.empty() || certainly_less(other.shown_reach, best.shown_reach)) {
                break;
            }
            best = std::move(other);
        }
        return best;
    }

private:
    void sample(const std::vector<ParameterRange>& ranges, const SampleGrid& grid) {
        sampled_ = sampled_best(
            [&](const std::vector<double>& x) { return sampled_reach(problem_, x).reach; }, ranges,
            grid);
    }
    [[nodiscard]] BestReach from_sample() {
        count_.most = share_of_best * options_.budget;
        BestReach best;
        try {
            if (ranges_.size() == 1) {
                one_parameter(best);
            }
            if (best.kind == BestReach::Kind::box) {
                by_samples(best);
            }
        } catch (const BudgetError&) {
            best = {};
            estimate(best);
        }
        return best;
    }
    /// Starts from values that branch and bound found, and from their neighbours.
    [[nodiscard]] BestReach from_better(const std::vector<ParameterRange>& better) {
        std::vector<ParameterRange> near;
        for (std::size_t i = 0; i < ranges_.size(); ++i) {
            near.push_back(
                {std::max(better[i].from, ranges_[i].from), std::min(better[i].to, ranges_[i].to)});
        }
        sample(near, {16, 8, 14});
        return from_sample();
    }
    [[nodiscard]] double span() const {
        return Rational(ranges_[0].to - ranges_[0].from).convert_to<double>();
    }
    [[nodiscard]] bool in_range(const Ball& x, std::size_t i = 0) const {
        return !certainly_less(x, Ball(ranges_[i].from, x.bits())) &&
               !certainly_less(Ball(ranges_[i].to, x.bits()), x);
    }
    void one_parameter(BestReach& best) {
        const double x = sampled_.value[0];
        const double step = std::max(8 * sampled_.width[0], 1e-12 * span());
        const double from = ranges_[0].from.convert_to<double>();
        const double to = ranges_[0].to.convert_to<double>();
        const SampledReach here = sampled_reach(problem_, {x});
        if (!here.leaves && show(best, {exact_value(Real(x))})) {
            best.kind = BestReach::Kind::everywhere;
            best.value = {Ball(best.shown_at[0], bits_)};
            best.reach = best.shown_reach;
            return;
        }
        // Ends of the range come first: the reach need not be stationary there.
        for (const bool upper : {false, true}) {
            if (std::fabs((upper ? to : from) - x) <= step &&
                show(best, {upper ? ranges_[0].to : ranges_[0].from})) {
                best.kind = BestReach::Kind::end_of_range;
                best.value = {Ball(best.shown_at[0], bits_)};
                best.reach = best.shown_reach;
                return;
            }
        }
        const SampledReach before = sampled_reach(problem_, {x - step});
        const SampledReach after = sampled_reach(problem_, {x + step});
        const auto jumps = [&](const SampledReach& there) {
            return here.reach - there.reach > jump_of_reach * here.reach;
        };
        if (jumps(before) || jumps(after)) {
            touching(best, here, jumps(before) ? 1 : -1, x);
        }
        if (best.kind == BestReach::Kind::box && problem_.edges.size() == 2) {
            const auto errors = problem_.over({Ball(Real(x), reach_bits)});
            const Ball other = errors[1 - here.edge].at(Ball(Real(here.reach), reach_bits));
            at_point(best,
                     {BestReach::Kind::two_edges, here.edge, here.side,
                      certainly_negative(other) ? -1 : 1},
                     here, x);
        }
        if (best.kind == BestReach::Kind::box) {
            at_point(best, {BestReach::Kind::smooth, here.edge, here.side, 1}, here, x);
        }
    }
    /// `good`: the side of the value on which the reach is long.
    void touching(BestReach& best, const SampledReach& here, int good, double x) {
        for (const SampledReach::Extremum& e : here.extrema) {
            if (std::fabs(e.excess) > touching_excess * problem_.tolerance.convert_to<double>()) {
                break;
            }
            const double middle = length_at(x, e.edge) / 2;
            const auto point =
                std::fabs(e.u - middle) < nearest_to_middle * middle
                    ? touching_at_middle(problem_, e.edge, e.side, Real(x), bits_)
                    : design_point(problem_, {BestReach::Kind::touching, e.edge, e.side, 1},
                                   Real(e.u), Real(x), bits_);
            if (!point || !near_sample(point->parameter, x)) {
                continue;
            }
            const auto errors = problem_.over({point->parameter});
            const Ball level = Ball(problem_.tolerance, bits_) * here.side;
            const auto exit = here.leaves
                                  ? exit_near(errors[here.edge], level, Real(here.reach), bits_)
                                  : std::nullopt;
            if (here.leaves && !exit) {
                continue;
            }
            Rational distance = (ranges_[0].to - ranges_[0].from) / 1'000'000'000;
            for (int k = 0; k < 3; ++k) {
                if (show(best, {short_rational(point->parameter, good, distance)})) {
                    break;
                }
                distance *= 100;
            }
            const Ball reach = exit ? *exit : best.shown_reach;
            if (best.shown_at.empty() ||
                certainly_less(Ball(options_.gap, bits_), abs(reach - best.shown_reach))) {
                best.shown_at.clear();
                continue;
            }
            best.kind = BestReach::Kind::touching;
            best.value = {point->parameter};
            best.touches_at = point->u;
            best.attained = false;
            best.reach = reach;
            return;
        }
    }
    void at_point(BestReach& best, const DesignEquations& equations, const SampledReach& here,
                  double x) {
        const auto point = design_point(problem_, equations, Real(here.reach), Real(x), bits_);
        if (!point || !near_sample(point->parameter, x) ||
            !show(best, {short_rational(point->parameter, 0, 0)}) ||
            certainly_less(Ball(options_.gap, bits_), abs(point->u - best.shown_reach))) {
            best.shown_at.clear();
            return;
        }
        best.kind = equations.kind;
        best.value = {point->parameter};
        best.reach = point->u;
    }
    [[nodiscard]] bool near_sample(const Ball& parameter, double x) const {
        const Ball off = abs(parameter - Ball(Real(x), bits_));
        return in_range(parameter) &&
               certainly_less(off, Ball(Real(farthest_from_sample * span()), bits_));
    }
    [[nodiscard]] double length_at(double x, std::size_t edge) const {
        const auto errors = problem_.over({Ball(Real(x), reach_bits)});
        return errors[edge].length.midpoint().convert_to<double>();
    }
    /// Proves the reach for exact parameters.
    bool show(BestReach& best, const std::vector<Rational>& at) const {
        for (long bits = reach_bits; bits <= 2 * std::max(bits_, reach_bits); bits *= 2) {
            try {
                ProvedReach r = proved_reach(problem_, at, bits);
                best.shown_at = at;
                best.shown_reach = r.leaves ? to_all_digits(r, at) : r.reach;
                return true;
            } catch (const BudgetError&) {
            }
        }
        return false;
    }
    /// Applies Newton's method to an enclosure that contains exactly one exit
    /// (moore-kearfott-cloud2009).
    [[nodiscard]] Ball to_all_digits(const ProvedReach& r, const std::vector<Rational>& at) const {
        std::vector<Ball> balls;
        for (const Rational& q : at) {
            balls.emplace_back(q, bits_);
        }
        const auto errors = problem_.over(balls);
        const Ball level = Ball(problem_.tolerance, bits_) * r.side;
        const auto exit = exit_near(errors[r.edge], level, r.reach.midpoint(), bits_);
        return exit && contains(r.reach, *exit) ? *exit : r.reach;
    }
    void estimate(BestReach& best) const {
        best.value.clear();
        for (std::size_t i = 0; i < ranges_.size(); ++i) {
            best.value.push_back(Ball(Real(sampled_.value[i]), 64));
        }
        best.reach = Ball(Real(sampled_.score), 64);
        best.missing = "the reach at the best value sampled is not proved";
    }
    void by_samples(BestReach& best) const {
        std::vector<Rational> at;
        for (std::size_t i = 0; i < ranges_.size(); ++i) {
            at.push_back(
                std::clamp(exact_value(Real(sampled_.value[i])), ranges_[i].from, ranges_[i].to));
        }
        estimate(best);
        if (show(best, at)) {
            best.reach = best.shown_reach;
            best.missing.clear();
        }
    }
    /// Returns values that seem to reach farther than the best by more than the gap, if any.
    std::optional<std::vector<ParameterRange>> prove(BestReach& best) {
        count_.most = options_.budget;
        const Ball lowest(best.shown_reach.lower(), best.shown_reach.bits());
        const Rational shown = exact_value(lowest.with_bits(96).lower());
        const CoveredRange cover = covered_by_exits(problem_, ranges_, shown, options_);
        best.boxes = cover.boxes;
        best.proved = cover.covered;
        best.not_excluded = cover.best;
        if (!cover.covered) {
            best.missing =
                "that nothing reaches farther is not proved for the values " + text_of(cover.open);
        } else if (best.kind == BestReach::Kind::box) {
            best.value.clear();
            for (const ParameterRange& r : cover.best) {
                best.value.push_back(Ball::hull(Ball(r.from, reach_bits), Ball(r.to, reach_bits)));
            }
            best.reach = Ball::hull(Ball(shown, reach_bits),
                                    Ball(Rational(shown + options_.gap), reach_bits));
        }
        return cover.better;
    }

    ReachProblem problem_;
    EvaluationCount count_;
    const std::vector<ParameterRange>& ranges_;
    const DesignOptions& options_;
    long bits_;
    SampledBest sampled_;
};

} // namespace

std::string text_of(const std::vector<ParameterRange>& ranges) {
    std::string text;
    for (const ParameterRange& r : ranges) {
        text += (text.empty() ? "" : ", ") + to_decimal(r.from, 12, Rounding::down) + " ... " +
                to_decimal(r.to, 12, Rounding::up);
    }
    return text;
}

BestReach best_reach(const ReachProblem& problem, const std::vector<ParameterRange>& ranges,
                     const DesignOptions& options) {
    return DesignSearch(problem, ranges, options).run();
}

} // namespace edgeproof::contact
