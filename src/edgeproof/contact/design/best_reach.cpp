// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/design/best_reach.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/stress/isolated_pair.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace edgeproof::contact {
namespace {

/// The equations in u and the parameter.
PairOfEquations equations_at(const ReachProblem& problem, const DesignEquations& of,
                             const BallPair& at) {
    const auto& [u, parameter] = at;
    const Ball level(problem.tolerance, u.bits());
    const auto errors = problem.over(parameter);
    const Jet f = errors[of.edge].jet(u);
    const Ball off = f.v - level * of.side;
    if (of.kind == BestReach::Kind::two_edges) {
        const Jet other = errors[1 - of.edge].jet(u);
        return {{off, other.v - level * of.other_side}, {{f.g, other.g}}};
    }
    const std::size_t by = of.kind == BestReach::Kind::touching ? 0 : 1;
    return {{off, f.g[by]}, {{f.g, {f.h[by], f.h[by + 1]}}}};
}

} // namespace

std::optional<DesignPoint> design_point(const ReachProblem& problem,
                                        const DesignEquations& equations,
                                        const DesignPoint& start) {
    const auto at =
        isolated_pair([&](const BallPair& x) { return equations_at(problem, equations, x); },
                      {start.u, start.parameter});
    return at ? std::optional(DesignPoint{(*at)[0], (*at)[1]}) : std::nullopt;
}

std::optional<Ball> exit_near(const ErrorOverBox& f, const Ball& level, const Ball& start) {
    const Ball zero(0, start.bits());
    const auto at = isolated_pair(
        [&](const BallPair& x) -> PairOfEquations {
            const BallSeries value = f.along(x[0], Along::u);
            return {{value[0] - level, zero}, {{{value[1], zero}, {zero, zero}}}};
        },
        {start, zero}, {true, false});
    return at ? std::optional((*at)[0]) : std::nullopt;
}

std::optional<DesignPoint> touching_at_middle(const ReachProblem& problem,
                                              const DesignEquations& equations, const Ball& start) {
    const Ball zero(0, start.bits());
    const auto half_length = [&](const Ball& parameter) {
        return problem.over(parameter)[equations.edge].length / 2;
    };
    const auto at = isolated_pair(
        [&](const BallPair& x) -> PairOfEquations {
            const auto errors = problem.over(x[0]);
            const ErrorOverBox& f = errors[equations.edge];
            const BallSeries value = f.along(f.length / 2, Along::parameter);
            const Ball level = Ball(problem.tolerance, start.bits()) * equations.side;
            return {{value[0] - level, zero}, {{{value[1], zero}, {zero, zero}}}};
        },
        {start, zero}, {true, false});
    return at ? std::optional(DesignPoint{half_length((*at)[0]), (*at)[0]}) : std::nullopt;
}

namespace {

constexpr long reach_bits = 192;
constexpr int most_better_values = 12;   ///< the most that branch and bound may find
constexpr double share_of_samples = 0.4; ///< share of the budget
constexpr double share_of_best = 0.7;    ///< for samples and for the proof of the best value
constexpr double jump_of_reach = 1e-5;   ///< a larger difference of reaches is a jump
constexpr double farthest_jump = 1e-4;   ///< from the best sample, relative to the range
constexpr double farthest_from_sample =
    1e-4; ///< between the best value and the best sample, relative to the range
constexpr double nearest_to_middle = 1e-5; ///< for extrema at a cusp, relative to a + b

/// Returns a short rational near x, on one side of it (on any side for 0).
Rational short_rational(const Ball& x, int side, const Rational& distance) {
    return exact_value(Ball(Ball(x.midpoint(), 192) + Ball(Rational(distance * side), 192))
                           .with_bits(64)
                           .midpoint());
}

class DesignSearch {
public:
    DesignSearch(ReachProblem problem, ParameterRange range, const DesignOptions& options)
        : problem_(std::move(problem)), range_(std::move(range)), options_(options),
          bits_(formula::bits_for(options.digits) * 2 + 128) {
        problem_.count = &count_;
    }

    [[nodiscard]] BestReach run() {
        count_.most = share_of_samples * options_.budget;
        sample(range_, {});
        if (!sampled_.value) {
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
    void sample(const ParameterRange& range, const SampleGrid& grid) {
        sampled_ = sampled_best(
            [&](double x) {
                const auto at = reach_near(problem_, x);
                return at ? approximate(at->reach) : std::numeric_limits<double>::quiet_NaN();
            },
            range, grid);
    }
    [[nodiscard]] BestReach from_sample() {
        count_.most = share_of_best * options_.budget;
        BestReach best;
        try {
            by_kind(best);
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
    [[nodiscard]] BestReach from_better(const ParameterRange& better) {
        sample({std::max(better.from, range_.from), std::min(better.to, range_.to)}, {16, 8, 21});
        return from_sample();
    }
    [[nodiscard]] double span() const {
        return Rational(range_.to - range_.from).convert_to<double>();
    }
    [[nodiscard]] bool in_range(const Ball& x) const {
        return !certainly_less(x, Ball(range_.from, x.bits())) &&
               !certainly_less(Ball(range_.to, x.bits()), x);
    }
    void by_kind(BestReach& best) {
        const double x = *sampled_.value;
        const double step = std::max(8 * sampled_.width, 1e-12 * span());
        const double from = range_.from.convert_to<double>();
        const double to = range_.to.convert_to<double>();
        const auto here = reach_near(problem_, x);
        if (!here) {
            return;
        }
        if (!here->leaves && show(best, exact_value(Real(x)))) {
            best.kind = BestReach::Kind::everywhere;
            best.value = Ball(*best.shown_at, bits_);
            best.reach = best.shown_reach;
            return;
        }
        // Ends of the range come first: the reach need not be stationary there.
        for (const bool upper : {false, true}) {
            if (std::fabs((upper ? to : from) - x) <= step &&
                show(best, upper ? range_.to : range_.from)) {
                best.kind = BestReach::Kind::end_of_range;
                best.value = Ball(*best.shown_at, bits_);
                best.reach = best.shown_reach;
                return;
            }
        }
        for (double off = step; off < farthest_jump * span(); off *= 100) {
            for (const int good : {1, -1}) { // the side of the value on which the reach is long
                if (best.kind != BestReach::Kind::box) {
                    break;
                }
                const auto there = reach_near(problem_, x - good * off);
                if (there && approximate(here->reach - there->reach) >
                                 jump_of_reach * approximate(here->reach)) {
                    touching(best, *here, *there, good, x);
                } else if (!there) { // the scan does not end at a cusp in the middle
                    for (const int side : {1, -1}) {
                        const Ball centre = Ball(Real(length_at(x, here->edge) / 2), reach_bits);
                        touching(best, *here, {centre, true, here->edge, side}, good, x);
                    }
                }
            }
        }
        if (best.kind == BestReach::Kind::box && problem_.edges.size() == 2) {
            const auto errors = problem_.over(Ball(Real(x), reach_bits));
            const Ball other = errors[1 - here->edge].at(middle(here->reach));
            at_point(best,
                     {BestReach::Kind::two_edges, here->edge, here->side,
                      certainly_negative(other) ? -1 : 1},
                     *here, x);
        }
        if (best.kind == BestReach::Kind::box) {
            at_point(best, {BestReach::Kind::smooth, here->edge, here->side, 1}, *here, x);
        }
    }
    [[nodiscard]] double length_at(double x, std::size_t edge) const {
        return approximate(problem_.over(Ball(Real(x), reach_bits))[edge].length);
    }
    [[nodiscard]] DesignPoint start(const ProvedReach& at, double x) const {
        return {middle(at.reach).with_bits(bits_), Ball(Real(x), bits_)};
    }
    /// Beyond a jump the first exit is next to the extremum that touches the tolerance.
    /// `good`: the side of the value on which the reach is long.
    void touching(BestReach& best, const ProvedReach& here, const ProvedReach& beyond, int good,
                  double x) {
        const DesignEquations of{BestReach::Kind::touching, beyond.edge, beyond.side, 1};
        const Ball centre = Ball(Real(length_at(x, beyond.edge) / 2), reach_bits);
        const DesignPoint from = start(beyond, x);
        const bool in_middle = certainly_less(abs(from.u - centre),
                                              centre * Ball(Real(nearest_to_middle), reach_bits));
        const auto point = in_middle ? touching_at_middle(problem_, of, from.parameter)
                                     : design_point(problem_, of, from);
        if (best.kind != BestReach::Kind::box || !point || !near_sample(point->parameter, x)) {
            return;
        }
        const auto errors = problem_.over(point->parameter);
        const Ball level = Ball(problem_.tolerance, bits_) * here.side;
        const auto exit =
            here.leaves ? exit_near(errors[here.edge], level, start(here, x).u) : std::nullopt;
        if (here.leaves && !exit) {
            return;
        }
        Rational distance = (range_.to - range_.from) / 1'000'000'000;
        for (int k = 0; k < 3 && !show(best, short_rational(point->parameter, good, distance));
             ++k) {
            distance *= 100;
        }
        const Ball reach = exit ? *exit : best.shown_reach;
        if (take(best, BestReach::Kind::touching, point->parameter, reach)) {
            best.touches_at = point->u;
            best.attained = false;
        }
    }
    void at_point(BestReach& best, const DesignEquations& equations, const ProvedReach& here,
                  double x) {
        const auto point = design_point(problem_, equations, start(here, x));
        if (point && near_sample(point->parameter, x) &&
            show(best, short_rational(point->parameter, 0, 0))) {
            (void)take(best, equations.kind, point->parameter, point->u);
        }
    }
    /// Takes the value if the reach shown near it is as long.
    [[nodiscard]] bool take(BestReach& best, BestReach::Kind kind, const Ball& value,
                            const Ball& reach) const {
        if (!best.shown_at ||
            certainly_less(Ball(options_.gap, bits_), abs(reach - best.shown_reach))) {
            best.shown_at.reset();
            return false;
        }
        best.kind = kind;
        best.value = value;
        best.reach = reach;
        return true;
    }
    [[nodiscard]] bool near_sample(const Ball& parameter, double x) const {
        const Ball off = abs(parameter - Ball(Real(x), bits_));
        return in_range(parameter) &&
               certainly_less(off, Ball(Real(farthest_from_sample * span()), bits_));
    }
    /// Proves the reach for an exact parameter.
    bool show(BestReach& best, const Rational& at) const {
        for (long bits = reach_bits; bits <= 2 * std::max(bits_, reach_bits); bits *= 2) {
            try {
                ProvedReach r = proved_reach(problem_, Ball(at, bits));
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
    [[nodiscard]] Ball to_all_digits(const ProvedReach& r, const Rational& at) const {
        const auto errors = problem_.over(Ball(at, bits_));
        const Ball level = Ball(problem_.tolerance, bits_) * r.side;
        const auto exit = exit_near(errors[r.edge], level, middle(r.reach).with_bits(bits_));
        return exit && contains(r.reach, *exit) ? *exit : r.reach;
    }
    void estimate(BestReach& best) const {
        best.value = Ball(Real(*sampled_.value), 64);
        best.reach = Ball(Real(sampled_.score), 64);
        best.missing = "the reach at the best value sampled is not proved";
    }
    void by_samples(BestReach& best) const {
        estimate(best);
        if (show(best, std::clamp(exact_value(Real(*sampled_.value)), range_.from, range_.to))) {
            best.reach = best.shown_reach;
            best.missing.clear();
        }
    }
    /// Returns values that seem to reach farther than the best by more than the gap, if any.
    std::optional<ParameterRange> prove(BestReach& best) {
        count_.most = options_.budget;
        const Ball lowest(best.shown_reach.lower(), best.shown_reach.bits());
        const Rational shown = exact_value(lowest.with_bits(96).lower());
        const CoveredRange cover = covered_by_exits(problem_, range_, shown, options_);
        best.boxes = cover.boxes;
        best.proved = cover.covered;
        best.not_excluded = cover.best;
        if (!cover.covered) {
            best.missing = "that nothing reaches farther is not proved for the values " +
                           range_text(*cover.open);
        } else if (best.kind == BestReach::Kind::box) {
            best.value =
                Ball::hull(Ball(cover.best->from, reach_bits), Ball(cover.best->to, reach_bits));
            best.reach = Ball::hull(Ball(shown, reach_bits),
                                    Ball(Rational(shown + options_.gap), reach_bits));
        }
        return cover.better;
    }

    ReachProblem problem_;
    EvaluationCount count_;
    ParameterRange range_;
    const DesignOptions& options_;
    long bits_;
    SampledBest sampled_;
};

} // namespace

std::string range_text(const ParameterRange& range) {
    return to_decimal(range.from, 12, Rounding::down) + " ... " +
           to_decimal(range.to, 12, Rounding::up);
}

BestReach best_reach(const ReachProblem& problem, const ParameterRange& range,
                     const DesignOptions& options) {
    return DesignSearch(problem, range, options).run();
}

} // namespace edgeproof::contact
