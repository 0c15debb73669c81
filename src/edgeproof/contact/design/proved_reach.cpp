// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/best_reach.hpp"
#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace edgeproof::contact {
namespace {

constexpr std::size_t most_intervals = 60'000;
constexpr int most_halvings_at_edge = 400;
constexpr int most_newton_images = 60;
constexpr double bits_of_the_costs = 192;
const Rational narrowest_interval(1, Integer(1) << 44); // NOLINT: no exception can matter here

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
            [jet = std::move(f.jet), cost = cost.jet, &count](const Ball& u) {
                charge(count, cost);
                return jet(u);
            },
            std::move(length)};
}

/// The scan of one edge (docs/expansions.md).
class ReachScan {
public:
    ReachScan(const ErrorOverBox& f, const Rational& tolerance, const Rational& part, long bits)
        : f_(f), bits_(bits), tolerance_(tolerance, bits),
          end_(exact_value(Ball(f.length * Ball(part, bits)).lower())) {}

    [[nodiscard]] ProvedReach run() {
        Rational lo = from_edge();
        while (lo < end_) {
            Rational hi = exact_value(Ball(Rational(lo * Rational(5, 4)), 24).midpoint());
            hi = std::min(hi, end_);
            if (auto found = look(lo, hi)) {
                return *found;
            }
            lo = hi;
        }
        return {f_.length * Ball(1, bits_), false, 0, 0};
    }

private:
    [[nodiscard]] bool within(const Ball& x) const {
        return side_of(x, tolerance_) == Side::within;
    }
    [[nodiscard]] bool beyond(const Ball& x) const { return is_beyond(side_of(x, tolerance_)); }
    /// Returns a distance up to which the error is within the tolerance, from the edge on.
    [[nodiscard]] Rational from_edge() const {
        Rational hi = end_ / 8;
        for (int k = 0; k < most_halvings_at_edge; ++k) {
            if (within(f_.at(Ball::hull(Ball(0, bits_), Ball(hi, bits_))))) {
                return hi;
            }
            hi /= 2;
        }
        throw BudgetError("the error by the edge is not enclosed");
    }
    /// Returns the first exit in lo ... hi; f is within the tolerance at lo.
    [[nodiscard]] std::optional<ProvedReach> look(const Rational& lo, const Rational& hi) {
        check_interruption();
        if (++intervals_ > most_intervals) {
            throw BudgetError("undecided after " + std::to_string(most_intervals) + " intervals");
        }
        const Rational m = middle(lo, hi);
        const Ball whole = Ball::hull(Ball(lo, bits_), Ball(hi, bits_));
        const Ball h = whole - Ball(m, bits_);
        const Jet over = f_.jet(whole);
        const Ball& curvature = over.h[Jet::second(0, 0)];
        if (curvature.is_finite()) {
            const Jet at = f_.jet(Ball(m, bits_));
            if (within(at.v + at.g[0] * h + curvature * h * h / 2)) {
                return {};
            }
            const Ball rate = at.g[0] + curvature * h;
            if (certainly_positive(rate) || certainly_negative(rate)) {
                const Ball there = f_.at(Ball(hi, bits_));
                if (within(there)) {
                    return {};
                }
                if (beyond(there)) {
                    return crossing(lo, hi, certainly_positive(there) ? 1 : -1);
                }
            }
        } else if (within(f_.at(whole))) {
            return {};
        }
        if (hi - lo < narrowest_interval * hi) {
            throw BudgetError("the error touches the tolerance near u = " +
                              std::to_string(m.convert_to<double>()));
        }
        if (auto found = look(lo, m)) {
            return found;
        }
        return look(m, hi);
    }
    /// Encloses the exit in lo ... hi, where f is monotone, within the tolerance at lo and beyond
    /// it at hi.
    [[nodiscard]] ProvedReach crossing(const Rational& lo, const Rational& hi, int side) const {
        Ball x = Ball::hull(Ball(lo, bits_), Ball(hi, bits_));
        const Ball level = side > 0 ? tolerance_ : -tolerance_;
        for (int k = 0; k < most_newton_images; ++k) {
            const Ball m(x.midpoint(), bits_);
            Ball image = m - (f_.at(m) - level) / f_.jet(x).g[0];
            if (!image.is_finite()) {
                image = x; // bisect below
            }
            Ball next = x;
            if (arb_intersection(next.data(), x.data(), image.data(), bits_) == 0) {
                break;
            }
            if (certainly_less(Ball(next.radius(), bits_) * 2, Ball(x.radius(), bits_))) {
                x = next;
                continue;
            }
            const Ball at_m = f_.at(m);
            if (within(at_m)) {
                x = Ball::from_interval(m.midpoint(), x.upper(), bits_);
            } else if (beyond(at_m)) {
                x = Ball::from_interval(x.lower(), m.midpoint(), bits_);
            } else {
                break;
            }
        }
        return {x, true, 0, side};
    }

    const ErrorOverBox& f_;
    long bits_;
    Ball tolerance_;
    Rational end_;
    std::size_t intervals_ = 0;
};

} // namespace

std::vector<ErrorOverBox> ReachProblem::over(const Ball& parameter) const {
    std::vector<ErrorOverBox> all;
    all.reserve(edges.size());
    for (const ErrorFamily* family : edges) {
        if (count == nullptr) {
            all.push_back(family->over(parameter));
            continue;
        }
        EvaluationCost cost = family->cost;
        const double more = cost_of_bits(parameter.bits());
        cost = {cost.over * more, cost.at * more, cost.jet * more};
        charge(*count, cost.over);
        all.push_back(counted(family->over(parameter), cost, *count));
    }
    return all;
}

ProvedReach proved_reach(const ReachProblem& problem, const Ball& parameter) {
    const long bits = parameter.bits();
    const auto errors = problem.over(parameter);
    std::optional<ProvedReach> least;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const Ball& length = errors[i].length;
        if (!length.is_finite()) {
            throw BudgetError("the edges of the contact are not enclosed");
        }
        ProvedReach here = ReachScan(errors[i], problem.tolerance, problem.part, bits).run();
        here.edge = i;
        if (!here.leaves) {
            here.reach = length * Ball(problem.part, bits);
        }
        if (!least || certainly_less(here.reach, least->reach)) {
            least = std::move(here);
        } else if (overlaps(here.reach, least->reach) && here.leaves) {
            least->reach = min(least->reach, here.reach);
        }
    }
    return *least;
}

} // namespace edgeproof::contact
