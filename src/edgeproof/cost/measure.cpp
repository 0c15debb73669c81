// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cost/cost.hpp"
#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace edgeproof::cost {
namespace {

constexpr unsigned more_digits = 30;    ///< of the enclosure from which errors are computed
constexpr double batch_seconds = 2e-5;  ///< at least, timed together: more than a clock reading
constexpr double enough_seconds = 4e-3; ///< for each point
constexpr std::size_t fewest_samples = 3;
constexpr std::size_t most_samples = 15;
constexpr double too_long = 0.2; ///< to take more than one sample

/// Returns enclosures at the chosen points, by the last route, which proves its values.
std::vector<Ball> enclosures(const CostCase& c, const std::vector<std::size_t>& chosen,
                             unsigned digits) {
    const ReadyContact contact = cost_routes().back().ready(c, digits);
    std::vector<Ball> exact;
    for (const std::size_t i : chosen) {
        try {
            exact.push_back(contact(i).ball.value());
        } catch (const DomainError& error) {
            throw InputError("u = " + c.u[i].text() + ": " + error.what(),
                             "give distances from the edge, 0 < u < a + b, off every corner")
                .at(c.scene.file, c.scene.ask.u.empty() ? 0 : c.scene.ask.u[i].line);
        }
    }
    return exact;
}

/// Returns the time of a clock reading, with the two calls that a sample makes.
double clock_seconds() {
    static const double seconds = [] {
        std::vector<double> looks;
        for (int k = 0; k < 200; ++k) {
            const double begun = parallel::thread_seconds();
            looks.push_back(parallel::thread_seconds() - begun);
        }
        return quartiles(std::move(looks)).median;
    }();
    return seconds;
}

/// Returns the time of one value, of which a batch is timed; `about` is the time expected.
double sample(const ReadyContact& contact, std::size_t point, double about) {
    const auto calls = static_cast<std::size_t>(std::ceil(batch_seconds / std::max(about, 1e-8)));
    const double begun = parallel::thread_seconds();
    for (std::size_t k = 0; k < calls; ++k) {
        (void)contact(point);
    }
    const double seconds = parallel::thread_seconds() - begun - clock_seconds();
    return std::max(seconds, 0.0) / static_cast<double>(calls);
}

bool enough(const std::vector<double>& samples) {
    const double spent = std::accumulate(samples.begin(), samples.end(), 0.0);
    return !samples.empty() && (samples.front() >= too_long ||
                                (samples.size() >= fewest_samples && spent >= enough_seconds));
}

/// Times points in rounds: the samples of each point lie apart, so that a temporary disturbance of
/// the machine does not affect one point only, and no point is evaluated twice in a row.
void time_points(const ReadyContact& contact, std::vector<PointCost>& points) {
    std::vector<std::vector<double>> samples(points.size());
    bool any = true;
    for (std::size_t round = 0; any && round < most_samples; ++round) {
        any = false;
        for (std::size_t p = 0; p < points.size(); ++p) {
            if (points[p].failure.empty() && !enough(samples[p])) {
                check_interruption();
                const double about = samples[p].empty() ? batch_seconds : samples[p].back();
                samples[p].push_back(sample(contact, points[p].point, about));
                any = true;
            }
        }
    }
    for (std::size_t p = 0; p < points.size(); ++p) {
        const Quartiles q = quartiles(samples[p]);
        points[p].seconds = q.median;
        points[p].spread = q.median > 0 ? (q.high - q.low) / q.median : 0;
    }
}

/// Evaluates a point, and adds all but its times.
void add_result(const ReadyContact& contact, const Ball& exact, PointCost& cost) {
    try {
        const CostValue value = contact(cost.point);
        cost.evaluations = static_cast<double>(value.evaluations);
        cost.right = digits_reached(value.value, exact);
        if (value.ball && !(value.ball->is_finite() && overlaps(*value.ball, exact))) {
            cost.failure = value.ball->is_finite() ? "the enclosures are disjoint" : "not finite";
        } else if (value.ball) {
            // Count the digits that it proves, not the distance of its midpoint from the exact
            // value.
            cost.right = std::min(cost.right, digits_reached(value.ball->midpoint(), *value.ball));
        }
    } catch (const std::exception& error) { // Error, or a type of Boost
        cost.failure = error.what();
    }
}

/// Returns the number of points of a case that are measured; in the first case the routes are
/// compared. 0: the route is left out.
std::size_t usual_points(const CostRoute& route, unsigned digits, bool first_case) {
    // Digits, at most, and the points of the first case, of others, and both of expensive routes.
    constexpr std::size_t steps[][5] = {
        {34, 40, 10, 10, 3}, {50, 40, 10, 6, 3}, {100, 40, 10, 2, 0},   {200, 20, 6, 0, 0},
        {500, 8, 3, 0, 0},   {1000, 4, 2, 0, 0}, {SIZE_MAX, 2, 1, 0, 0}};
    const auto& step = *std::ranges::find_if(steps, [&](const auto& s) { return digits <= s[0]; });
    return step[(route.expensive ? 3 : 1) + (first_case ? 0 : 1)];
}

/// A cell to be measured.
struct Planned {
    const CostCase* c;
    const CostRoute* route;
    unsigned digits;
    std::size_t points;
};

CostCell measured_cell(const Planned& plan, const std::vector<std::size_t>& chosen,
                       const std::vector<Ball>& exact, bool timed) {
    const auto& [c, route, digits, points] = plan;
    CostCell cell{c->name, route->name, route->arithmetic, digits, 0, {}};
    for (const std::size_t i : chosen) {
        cell.points.push_back({.point = i, .u = c->u[i].text()});
    }
    try {
        const double begun = parallel::thread_seconds();
        const ReadyContact contact = route->ready(*c, digits);
        cell.contact_seconds = parallel::thread_seconds() - begun;
        for (std::size_t p = 0; p < exact.size(); ++p) { // fills tables and caches
            check_interruption();
            add_result(contact, exact[p], cell.points[p]);
        }
        if (timed) {
            time_points(contact, cell.points);
        }
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        for (PointCost& p : cell.points) {
            p.failure = error.what();
        }
    }
    return cell;
}

} // namespace

Quartiles quartiles(std::vector<double> numbers) {
    if (numbers.empty()) {
        return {};
    }
    std::ranges::sort(numbers);
    const auto at = [&](double fraction) {
        const double place = fraction * static_cast<double>(numbers.size() - 1);
        const auto below = static_cast<std::size_t>(place);
        const std::size_t above = std::min(below + 1, numbers.size() - 1);
        const double rest = place - static_cast<double>(below);
        return numbers[below] + rest * (numbers[above] - numbers[below]);
    };
    return {numbers.front(), at(0.25), at(0.5), at(0.75), numbers.back()};
}

std::size_t CostCell::failed() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(points, [](const PointCost& p) { return !p.failure.empty(); }));
}

Quartiles CostCell::over_points(double PointCost::*number) const {
    std::vector<double> numbers;
    for (const PointCost& p : points) {
        if (p.failure.empty()) {
            numbers.push_back(p.*number);
        }
    }
    return quartiles(std::move(numbers));
}

std::vector<std::size_t> thinned(std::size_t points, std::size_t most) {
    std::vector<std::size_t> chosen;
    const std::size_t n = std::min(points, most);
    for (std::size_t i = 0; i < n; ++i) {
        chosen.push_back(n == 1 ? 0 : i * (points - 1) / (n - 1));
    }
    return chosen;
}

std::vector<CostCell> measure(const std::vector<CostCase>& cases, const CostOptions& options) {
    std::vector<Planned> planned;
    for (const CostCase& c : cases) {
        for (const CostRoute& route : cost_routes()) {
            for (const unsigned digits : options.digits) {
                const std::size_t points = options.points > 0
                                               ? options.points
                                               : usual_points(route, digits, &c == &cases.front());
                if (points > 0 && route.takes(c.scene)) {
                    planned.push_back({&c, &route, digits, points});
                }
            }
        }
    }
    std::map<std::tuple<const CostCase*, unsigned, std::size_t>, std::vector<Ball>> exact;
    std::vector<CostCell> cells;
    for (const Planned& plan : planned) {
        if (options.progress) {
            options.progress(cells.size(), planned.size());
        }
        const std::vector<std::size_t> chosen = thinned(plan.c->u.size(), plan.points);
        const auto [found, fresh] = exact.try_emplace({plan.c, plan.digits, chosen.size()});
        if (fresh) {
            found->second = enclosures(*plan.c, chosen, plan.digits + more_digits);
        }
        cells.push_back(measured_cell(plan, chosen, found->second, options.timed));
    }
    return cells;
}

} // namespace edgeproof::cost
