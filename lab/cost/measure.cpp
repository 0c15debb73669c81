// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/cost/measure.hpp"

#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/precision/ball/arb_values.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rounding/escalate.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <boost/version.hpp>

#include <gmp.h>
#include <mpfr.h>
#include <sys/utsname.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <thread>
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

/// Returns enclosures at the chosen points, by the route in balls, which shares no code with the
/// others.
std::vector<Ball> enclosures(const CostCase& c, const std::vector<std::size_t>& chosen,
                             unsigned digits) {
    const contact::Profile& profile = *c.scene.profile;
    const bool closed = contact::BallContact::has_closed_form(profile);
    const long wanted = static_cast<long>(static_cast<double>(digits) * 3.3219281) + 8;
    std::map<long, contact::IntegratedContact> curved; // for each number of bits
    std::vector<Ball> exact;
    for (const std::size_t i : chosen) {
        if (closed) {
            exact.push_back(enclosed_pressure(profile, c.scene.contact_modulus, c.scene.load,
                                              c.edge, c.u[i], digits));
            continue;
        }
        const auto at = [&](long bits) {
            const auto found = curved.find(bits);
            const contact::IntegratedContact& contact =
                found != curved.end()
                    ? found->second
                    : curved.try_emplace(bits, profile, c.scene.contact_modulus, c.scene.load, bits)
                          .first->second;
            return contact.pressure(c.edge, c.u[i]);
        };
        exact.push_back(escalate(
            at,
            [&](const Ball& p) { return p.is_finite() && p.relative_accuracy_bits() >= wanted; },
            {wanted + 64, 1L << 17}));
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

/// Times some points in rounds: the samples of each point lie apart, so that a temporary
/// disturbance of the machine does not affect one point only, and no point is evaluated twice in a
/// row.
class Timing {
public:
    Timing(const ReadyContact& contact, std::vector<PointCost>& points)
        : contact_(contact), points_(points), samples_(points.size()) {}

    void run() {
        for (std::size_t round = 0; round < most_samples; ++round) {
            bool any = false;
            for (std::size_t p = 0; p < points_.size(); ++p) {
                if (points_[p].failure.empty() && wants_more(samples_[p])) {
                    check_interruption();
                    samples_[p].push_back(sample(p));
                    any = true;
                }
            }
            if (!any) {
                break;
            }
        }
        for (std::size_t p = 0; p < points_.size(); ++p) {
            const Quartiles q = quartiles(samples_[p]);
            points_[p].seconds = q.median;
            points_[p].spread = q.median > 0 ? (q.high - q.low) / q.median : 0;
        }
    }

private:
    static bool wants_more(const std::vector<double>& samples) {
        double spent = 0;
        for (const double s : samples) {
            spent += s;
        }
        return samples.empty() || (samples.front() < too_long &&
                                   (samples.size() < fewest_samples || spent < enough_seconds));
    }
    double sample(std::size_t p) {
        const double about = samples_[p].empty() ? batch_seconds : samples_[p].back();
        const auto calls =
            static_cast<std::size_t>(std::ceil(batch_seconds / std::max(about, 1e-8)));
        const double begun = parallel::thread_seconds();
        for (std::size_t k = 0; k < calls; ++k) {
            (void)contact_(points_[p].point);
        }
        const double seconds = parallel::thread_seconds() - begun - clock_seconds();
        return std::max(seconds, 0.0) / static_cast<double>(calls);
    }

    const ReadyContact& contact_;
    std::vector<PointCost>& points_;
    std::vector<std::vector<double>> samples_;
};

/// Returns the cost of one point, without its times.
PointCost point_cost(const ReadyContact& contact, std::size_t i, const Ball& exact) {
    PointCost cost;
    cost.point = i;
    try {
        const CostValue value = contact(i);
        cost.evaluations = value.evaluations;
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
    return cost;
}

/// A cell to be measured.
struct Planned {
    const CostCase* c;
    const CostRoute* route;
    unsigned digits;
    std::size_t points;
};

std::vector<Planned> planned_cells(const std::vector<CostCase>& cases, const CostOptions& options) {
    std::vector<Planned> planned;
    for (const CostCase& c : cases) {
        for (const CostRoute& route : cost_routes()) {
            for (const unsigned digits :
                 route.takes(c.scene) ? options.digits : std::vector<unsigned>{}) {
                const std::size_t points = options.points > 0 ? options.points
                                           : options.full
                                               ? c.u.size()
                                               : usual_points(route, digits, &c == &cases.front());
                if (points > 0) {
                    planned.push_back({&c, &route, digits, points});
                }
            }
        }
    }
    return planned;
}

CostCell measured_cell(const Planned& plan, const std::vector<std::size_t>& chosen,
                       const std::vector<Ball>& exact, bool timed) {
    const auto& [c, route, digits, points] = plan;
    CostCell cell{c->name, route->name, route->arithmetic, digits, route->proves, 0, {}};
    try {
        const double begun = parallel::thread_seconds();
        const ReadyContact contact = route->ready(*c, digits);
        cell.contact_seconds = parallel::thread_seconds() - begun;
        for (std::size_t p = 0; p < chosen.size(); ++p) { // fills tables and caches
            check_interruption();
            cell.points.push_back(point_cost(contact, chosen[p], exact[p]));
        }
        if (timed) {
            Timing(contact, cell.points).run();
        }
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        cell.points.clear();
        for (const std::size_t i : chosen) {
            cell.points.push_back({i, 0, {}, 0, 0, error.what()});
        }
    }
    return cell;
}

template <class F> Quartiles over_points(const std::vector<PointCost>& points, const F& number) {
    std::vector<double> numbers;
    for (const PointCost& p : points) {
        if (p.failure.empty()) {
            numbers.push_back(number(p));
        }
    }
    return quartiles(std::move(numbers));
}

} // namespace

std::size_t usual_points(const CostRoute& route, unsigned digits, bool first_case) {
    struct Step {
        unsigned digits;
        std::size_t points;
    };
    constexpr Step compared[] = {{100, 40}, {200, 20}, {500, 8}, {1000, 4}};
    constexpr Step others[] = {{100, 10}, {200, 6}, {500, 3}, {1000, 2}};
    constexpr Step expensive[] = {{34, 10}, {50, 6}, {100, 2}};
    constexpr Step expensive_others[] = {{50, 3}};
    const auto look = [&](const auto& steps, std::size_t beyond) {
        for (const Step& step : steps) {
            if (digits <= step.digits) {
                return step.points;
            }
        }
        return beyond;
    };
    if (route.expensive) {
        return first_case ? look(expensive, 0) : look(expensive_others, 0);
    }
    return first_case ? look(compared, 2) : look(others, 1);
}

Quartiles quartiles(std::vector<double> numbers) {
    if (numbers.empty()) {
        return {};
    }
    std::sort(numbers.begin(), numbers.end());
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
    return static_cast<std::size_t>(std::count_if(
        points.begin(), points.end(), [](const PointCost& p) { return !p.failure.empty(); }));
}
Quartiles CostCell::right() const {
    return over_points(points, [](const PointCost& p) { return p.right; });
}
Quartiles CostCell::seconds() const {
    return over_points(points, [](const PointCost& p) { return p.seconds; });
}
std::optional<Quartiles> CostCell::evaluations() const {
    const bool counted = std::any_of(points.begin(), points.end(),
                                     [](const PointCost& p) { return p.evaluations.has_value(); });
    return counted ? std::optional(over_points(points,
                                               [](const PointCost& p) {
                                                   return static_cast<double>(
                                                       p.evaluations.value_or(0));
                                               }))
                   : std::nullopt;
}
std::size_t CostCell::total_evaluations() const {
    std::size_t total = 0;
    for (const PointCost& p : points) {
        total += p.evaluations.value_or(0);
    }
    return total;
}
double CostCell::spread() const {
    return over_points(points, [](const PointCost& p) { return p.spread; }).median;
}

std::vector<CostCell> measure(const std::vector<CostCase>& cases, const CostOptions& options) {
    const std::vector<Planned> planned = planned_cells(cases, options);
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

namespace {

std::string processor() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    utsname name{};
    return ::uname(&name) == 0 ? name.machine : "unknown";
}

std::string compiler() {
#ifdef __clang__
    return "Clang " __clang_version__;
#else
    return "GCC " __VERSION__;
#endif
}

} // namespace

std::vector<std::pair<std::string, std::string>> machine() {
    std::vector<std::pair<std::string, std::string>> facts{
        {"processor", processor()},
        {"cores", std::to_string(std::thread::hardware_concurrency())},
        {"compiler", compiler()},
        {"Boost", std::to_string(BOOST_VERSION / 100000) + "." +
                      std::to_string(BOOST_VERSION / 100 % 1000) + "." +
                      std::to_string(BOOST_VERSION % 100)},
        {"GMP", gmp_version},
        {"MPFR", mpfr_get_version()},
        {"FLINT", FLINT_VERSION},
    };
#ifndef EDGEPROOF_ARB_IN_FLINT
    facts.emplace_back("Arb", arb_version);
#endif
    return facts;
}

} // namespace edgeproof::cost
