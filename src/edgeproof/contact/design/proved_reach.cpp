// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/design/best_reach.hpp"
#include "edgeproof/contact/enclosure/side_search.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace edgeproof::contact {
namespace {

constexpr std::size_t most_intervals = 60'000;
constexpr int most_halvings_at_edge = 400;
constexpr long kept_bits = 24; ///< bits that are lost on the way to an exit
constexpr double bits_of_the_costs = 192;
constexpr long sample_bits = 96;
constexpr int sample_points = 160;
constexpr long narrowest = 44; ///< intervals are halved to 2^-44 of their distance from the edge

void charge(EvaluationCount& count, double cost) {
    if (count.spent > count.most) {
        throw BudgetError("the budget of evaluations is spent");
    }
    count.spent += cost;
}

double cost_of_bits(long bits) {
    return std::max(1.0, std::pow(static_cast<double>(bits) / bits_of_the_costs, 1.5));
}

/// The same errors; each evaluation is counted.
ErrorOverBox counted(ErrorOverBox f, const EvaluationCost& cost, EvaluationCount& count) {
    Ball length = f.length;
    return {[at = std::move(f.at), cost = cost.at, &count](const Ball& u) {
                charge(count, cost);
                return at(u);
            },
            [along = std::move(f.along), cost = cost.along, &count](const Ball& u, Along way) {
                charge(count, cost);
                return along(u, way);
            },
            std::move(length)};
}

/// The error at one edge as a function of the distance from it.
class ErrorAtEdge {
public:
    ErrorAtEdge(const ErrorOverBox& f, const Rational& tolerance, long bits)
        : f_(f), bits_(bits), tolerance_(tolerance, bits) {}
    [[nodiscard]] const Ball& tolerance() const { return tolerance_; }
    [[nodiscard]] Ball at(const Rational& u) const { return f_.at(Ball(u, bits_)); }
    [[nodiscard]] Side side_at(const Rational& u) const { return side(at(u)); }
    [[nodiscard]] std::pair<Ball, Ball> tangent(const Rational& u) const {
        const BallSeries at = f_.along(Ball(u, bits_), Along::u);
        return {at[0], at[1]};
    }
    [[nodiscard]] SideOver over(const Rational& lo, const Rational& hi) const {
        check_interruption();
        if (++intervals_ > most_intervals) {
            throw BudgetError("undecided after " + std::to_string(most_intervals) + " intervals");
        }
        const Ball m(middle(lo, hi), bits_);
        const Ball whole = Ball::hull(Ball(lo, bits_), Ball(hi, bits_));
        const Ball bend = f_.along(whole, Along::u)[2]; // half the second derivative
        if (!bend.is_finite()) {
            return {side(f_.at(whole)), false};
        }
        const BallSeries at = f_.along(m, Along::u);
        const Ball h = whole - m;
        const Ball rate = at[1] + bend * h * 2;
        return {side(at[0] + at[1] * h + bend * h * h),
                certainly_positive(rate) || certainly_negative(rate)};
    }
    /// Returns a distance up to which the error is within the tolerance, from the edge on, at most
    /// `hi`.
    [[nodiscard]] Rational safe_distance(Rational hi) const {
        for (int k = 0; k < most_halvings_at_edge; ++k, hi /= 2) {
            if (side(f_.at(Ball::hull(Ball(0, bits_), Ball(hi, bits_)))) == Side::within) {
                return hi;
            }
        }
        throw BudgetError("the error by the edge is not enclosed");
    }

private:
    [[nodiscard]] Side side(const Ball& x) const { return side_of(x, tolerance_); }

    const ErrorOverBox& f_;
    long bits_;
    Ball tolerance_;
    mutable std::size_t intervals_ = 0;
};

/// The first exit at one edge (docs/expansions.md).
ProvedReach first_exit(const ErrorOverBox& error, const Rational& tolerance, const Rational& part,
                       long bits) {
    const ErrorAtEdge f(error, tolerance, bits);
    const Rational end = exact_value(Ball(error.length * Ball(part, bits)).lower());
    ProvedReach found{error.length * Ball(part, bits), false, 0, 0};
    for_each_side_outwards(
        f, f.safe_distance(end / 8), end, narrowest, [&](const SidePiece& piece) {
            if (piece.to == Side::within) { // as it is at the beginning of the piece
                return true;
            }
            if (!piece.root) {
                throw BudgetError("the error touches the tolerance near u = " +
                                  std::to_string(piece.lo.convert_to<double>()));
            }
            const auto place = enclosed_crossing(f, piece, bits, kept_bits);
            found = {place ? *place : Ball::hull(Ball(piece.lo, bits), Ball(piece.hi, bits)), true,
                     0, *piece.root};
            return false;
        });
    return found;
}

} // namespace

std::vector<ErrorOverBox> ReachProblem::over(const Ball& parameter) const {
    std::vector<ErrorOverBox> all;
    all.reserve(edges.size());
    for (const ErrorFamily& family : edges) {
        if (count == nullptr) {
            all.push_back(family.over(parameter));
            continue;
        }
        EvaluationCost cost = family.cost;
        const double more = cost_of_bits(parameter.bits());
        cost = {cost.over * more, cost.at * more, cost.along * more};
        charge(*count, cost.over);
        all.push_back(counted(family.over(parameter), cost, *count));
    }
    return all;
}

ProvedReach proved_reach(const ReachProblem& problem, const Ball& parameter) {
    const long bits = parameter.bits();
    const auto errors = problem.over(parameter);
    std::optional<ProvedReach> least;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (!errors[i].length.is_finite()) {
            throw BudgetError("the edges of the contact are not enclosed");
        }
        ProvedReach here = first_exit(errors[i], problem.tolerance, problem.part, bits);
        here.edge = i;
        if (!least || certainly_less(here.reach, least->reach)) {
            least = std::move(here);
        } else if (overlaps(here.reach, least->reach) && here.leaves) {
            least->reach = min(least->reach, here.reach);
        }
    }
    return *least;
}

std::optional<ProvedReach> reach_near(const ReachProblem& problem, double parameter) {
    try {
        return proved_reach(problem, Ball(Real(parameter), sample_bits));
    } catch (const BudgetError&) {
        if (problem.count != nullptr && problem.count->spent > problem.count->most) {
            throw;
        }
        return {};
    }
}

double sampled_measure(const ReachProblem& problem, double parameter) {
    double least = std::numeric_limits<double>::infinity();
    for (const ErrorOverBox& f : problem.over(Ball(Real(parameter), sample_bits))) {
        const double end = approximate(f.length) * problem.part.convert_to<double>();
        const Ball tolerance(problem.tolerance, sample_bits);
        // At a corner, where p is infinite, f = -1.
        const auto within = [&](double u) {
            return certainly_less(abs(f.at(Ball(Real(u), sample_bits))), tolerance);
        };
        double measure = 0;
        double before = 0;
        bool was = true;
        for (int k = 1; k <= sample_points; ++k) {
            check_interruption();
            const double s = static_cast<double>(k) / sample_points;
            const double u = end * (k == sample_points ? 1 - 1e-9 : s * s * s);
            const bool is = within(u);
            double lo = before;
            double hi = u;
            for (int halvings = 0; was != is && halvings < 50; ++halvings) {
                const double m = (lo + hi) / 2;
                (within(m) == was ? lo : hi) = m;
            }
            measure += was && is ? u - before : was ? lo - before : is ? u - hi : 0;
            before = u;
            was = is;
        }
        least = std::min(least, std::isnan(end) ? end : measure);
    }
    return least;
}

SampledBest sampled_best(const std::function<double(double)>& score, const ParameterRange& range,
                         const SampleGrid& samples) {
    double lo = range.from.convert_to<double>();
    double hi = range.to.convert_to<double>();
    SampledBest best;
    std::map<double, double> known; // grids share places
    // Tries a grid with its ends, and keeps the cells next to the best value.
    const auto refine = [&](int cells) {
        best.width = (hi - lo) / cells;
        for (int k = 0; k <= cells; ++k) {
            check_interruption();
            const double x = k == cells ? hi : lo + (hi - lo) * k / cells;
            const auto at = known.find(x);
            const double s = at != known.end() ? at->second : known[x] = score(x);
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
