// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/tail/followed.hpp"

#include "edgeproof/audit/checks/tail/parameter_sweep.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/audit/symbolic/symbolic.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgeproof::audit {
namespace {

/// The small variable is divided by these powers of ten.
constexpr std::array<unsigned, 3> sizes{0, 6, 12};
/// Decades of the distance. Growth is measured at those that are powers of two.
constexpr std::array<unsigned, 20> main_stations{1,  2,  3,  4,   6,   8,   12,  16,  24,  32,
                                                 48, 64, 96, 128, 192, 256, 384, 512, 768, 1024};
constexpr double bounded_margin = 8; ///< decades from the last steps to the remainder
constexpr double most_hidden = 390;
constexpr std::size_t doublings = 3;
constexpr long rest_bits = 30;

/// Returns 10^-decades.
Expr decimal_power(unsigned decades) {
    return Expr::number(
        Rational(Integer(1), Integer(boost::multiprecision::pow(Integer(10), decades))));
}

/// True if `second` is certainly more than 3/2 of `first`.
bool certainly_half_more(const Ball& first, const Ball& second) {
    return certainly_less(first * 3, second * 2);
}
bool certainly_tenfold(const Ball& first, const Ball& second) {
    return certainly_positive(first) && certainly_less(first * 10, second);
}

double decades_of_size(const Sample& sample, const std::string& small) {
    const auto decades = decades_of(formula::ball_of(sample.variables.find(small)->second, 256));
    return decades ? std::max(0.0, -*decades) : 0;
}

/// Returns the stations at least up to `least_end`, and the distances small^(1/2), small,
/// small^(3/2), small^2.
std::vector<unsigned> stations_to(double least_end, double small) {
    std::vector<unsigned> stations;
    for (const unsigned station : main_stations) {
        stations.push_back(station);
        const bool power_of_two = (station & (station - 1)) == 0;
        if (power_of_two && station >= least_end) {
            break;
        }
    }
    for (int k = 1; k <= 4; ++k) {
        const auto layer = static_cast<unsigned>(std::lround(k * small / 2));
        if (layer > 0 && layer < stations.back()) {
            stations.push_back(layer);
        }
    }
    std::ranges::sort(stations);
    stations.erase(std::unique(stations.begin(), stations.end()), stations.end());
    return stations;
}

/// Returns the expression with cancelling terms removed, if symbols can do this.
Expr simplified(const Expr& e) {
    try {
        return derive(e, SymbolicCase());
    } catch (const Error&) {
        return e;
    }
}

} // namespace

Expr ExpansionToFollow::rest() const {
    return (of - approximation) / pow(Expr::symbol(small), Expr::number(Rational(order)));
}

Sample at_distance(const Sample& sample, const ExpansionToFollow& expansion, unsigned decades,
                   bool exactly) {
    // The distance is not a power of ten, as formulas such as sin(Pi/s) are special there.
    const Expr power = decimal_power(decades);
    const Expr off = exactly ? power : Expr::number(Rational(7919, 7001)) * power;
    const Expr& end = expansion.towards.expr();
    const auto own = sample.variables.find(expansion.variable);
    const bool from_above =
        own != sample.variables.end() && Exact(own->second.expr() - end).sign() > 0;
    Sample at = sample;
    at.variables.insert_or_assign(expansion.variable, Exact(from_above ? end + off : end - off));
    return at;
}

namespace {

using Course = FollowedRest::Course;

struct Station {
    unsigned decades;
    Ball rest; ///< |rest|
    bool nothing;
};

/// The remainder for one size of the small variable.
struct Run {
    Sample sample;
    std::optional<Ball> far; ///< |rest| at the variable's own value
    std::vector<Station> stations;
    double hidden = 0; ///< decades that the formula may hide

    [[nodiscard]] Ball largest() const {
        Ball most = stations.front().rest;
        for (const Station& r : stations) {
            most = max(most, r.rest);
        }
        return most;
    }
};

class RestFollower {
public:
    RestFollower(const ExpansionToFollow& expansion, unsigned digits)
        : expansion_(expansion), rest_(expansion.rest()), simplified_(simplified(rest_)),
          digits_(digits) {}
    [[nodiscard]] FollowedRest follow(const Sample& sample);

private:
    [[nodiscard]] bool add_run(const Sample& sample);
    [[nodiscard]] std::optional<Station> station(const Sample& at, unsigned decades, double small);
    [[nodiscard]] Course judge();
    [[nodiscard]] bool sums_settle(const Run& run) const;
    [[nodiscard]] std::string last_distance() const {
        return "10^-" + std::to_string(runs_.front().stations.back().decades);
    }

    const ExpansionToFollow& expansion_;
    Expr rest_;
    Expr simplified_; ///< the same expression with cancelling terms removed
    unsigned digits_;
    std::vector<Run> runs_;
    std::string problem_;
};

FollowedRest RestFollower::follow(const Sample& sample) {
    FollowedRest found{sample, Course::unknown, "", {}, {}, {}, ""};
    for (const unsigned size : sizes) {
        Sample smaller = sample;
        Exact& small = smaller.variables.find(expansion_.small)->second;
        small = Exact(decimal_power(size) * small.expr());
        if (!add_run(smaller)) {
            found.problem = problem_;
            return found;
        }
    }
    found.course = judge();
    found.problem = problem_;
    found.last_distance = last_distance();
    if (found.course == Course::unknown && problem_.empty()) {
        found.problem =
            "the remainder neither converges nor certainly grows, down to the distance " +
            last_distance();
    }
    const Run& first = runs_.front();
    const bool wrong_order = found.course == Course::wrong_order;
    found.before_last = wrong_order ? *first.far : first.stations[first.stations.size() - 2].rest;
    found.last = wrong_order ? *runs_.back().far : first.stations.back().rest;
    found.largest = first.largest();
    return found;
}

std::optional<Station> RestFollower::station(const Sample& at, unsigned decades, double small) {
    const double lost = (expansion_.order + 1) * small + decades;
    std::optional<Station> found;
    SampleInBalls sample(at, digits_ + static_cast<unsigned>(lost));
    // A remainder far below the small variable to twice the order is treated as zero.
    const auto nothing_below = -static_cast<long>(2 * expansion_.order * small + decades + digits_);
    (void)sample.until([&](const EnclosedSample& in) {
        Station here{decades, abs(in.evaluate(rest_)), false};
        if (!here.rest.is_finite()) {
            return false;
        }
        const Ball value =
            abs(in.evaluate(expansion_.of)) + abs(in.evaluate(expansion_.approximation));
        const Ball left = here.rest * pow_int(in.evaluate(Expr::symbol(expansion_.small)),
                                              static_cast<long>(expansion_.order));
        here.nothing = contains_zero(here.rest) &&
                       (arb_is_zero(here.rest.data()) != 0 ||
                        certainly_less(left, pow_int(Ball(10, 64), nothing_below) * value));
        const bool known = here.nothing || here.rest.relative_accuracy_bits() >= rest_bits;
        found = std::move(here);
        return known;
    });
    if (!found) {
        problem_ = "no enclosure: " + sample.problem();
    }
    return found;
}

bool RestFollower::add_run(const Sample& sample) {
    const double small = decades_of_size(sample, expansion_.small);
    Run run{sample, std::nullopt, {}, 0};
    try {
        const long bits = 2 * formula::bits_for(digits_ + static_cast<unsigned>(8 * small) + 40);
        const EnclosedSample before(at_distance(sample, expansion_, main_stations[3]), bits);
        const EnclosedSample after(at_distance(sample, expansion_, main_stations[5]), bits);
        // The smaller sizes hide nothing more, as the small variable is followed beyond its powers.
        run.hidden =
            runs_.empty() ? hidden_decades(simplified_, {before, after}) : runs_.front().hidden;
        if (!(run.hidden < most_hidden)) {
            problem_ = "the formula has numbers beyond the range that is followed";
            return false;
        }
        if (sample.variables.contains(expansion_.variable)) {
            if (const auto far = station(sample, 0, small)) {
                run.far = far->rest;
            }
        }
        // The last three steps begin at 3/8 of the end.
        const double end = std::max({64.0, 3 * (bounded_margin + run.hidden), 10 * small});
        for (const unsigned decades : stations_to(end, small)) {
            const auto here = station(at_distance(sample, expansion_, decades), decades, small);
            if (!here) {
                return false;
            }
            run.stations.push_back(*here);
        }
    } catch (const Error& error) {
        problem_ = std::string("no enclosure: ") + error.what();
        return false;
    }
    runs_.push_back(std::move(run));
    return true;
}

/// True if the last three steps are much smaller than the remainder, and do not grow.
bool is_bounded(const Run& run) {
    const std::size_t n = run.stations.size();
    const Ball tolerance =
        pow_int(Ball(10, 64), -static_cast<long>(std::ceil(bounded_margin + run.hidden)));
    const Ball most = run.largest();
    const auto step = [&](std::size_t i) {
        return abs(run.stations[i].rest - run.stations[i - 1].rest);
    };
    for (std::size_t i = n - 3; i < n; ++i) {
        if (!certainly_less(step(i), tolerance * most) || certainly_less(step(i - 1), step(i))) {
            return false;
        }
    }
    return true;
}

bool is_growing(const Run& run) {
    unsigned decades = run.stations.back().decades;
    const Ball* later = nullptr;
    for (std::size_t k = 0; k <= doublings; ++k, decades /= 2) {
        const auto at = std::ranges::find_if(
            run.stations, [&](const Station& r) { return r.decades == decades; });
        if (at == run.stations.end() ||
            (later != nullptr && !certainly_half_more(at->rest, *later))) {
            return false;
        }
        later = &at->rest;
    }
    return true;
}

bool RestFollower::sums_settle(const Run& run) const {
    const unsigned last = run.stations.back().decades;
    try {
        const double lost = 8 * decades_of_size(run.sample, expansion_.small) + 4.0 * last;
        const long bits = 2 * formula::bits_for(digits_ + static_cast<unsigned>(lost));
        const EnclosedSample before(at_distance(run.sample, expansion_, last / 2), bits);
        const EnclosedSample after(at_distance(run.sample, expansion_, last), bits);
        return sums_are_steady(simplified_, {before, after});
    } catch (const Error&) {
        return false;
    }
}

Course RestFollower::judge() {
    const auto all = [&](auto&& test) { return std::ranges::all_of(runs_, test); };
    if (all([](const Run& run) {
            return std::ranges::all_of(run.stations, [](const Station& r) { return r.nothing; });
        })) {
        return Course::nothing;
    }
    if (!all([&](const Run& run) { return sums_settle(run); })) {
        problem_ = "the terms of the formula do not show their order, down to the distance " +
                   last_distance();
        return Course::unknown;
    }
    const Run& first = runs_[0];
    const Run& second = runs_[1];
    const Run& third = runs_[2];
    if (first.far && second.far && third.far && certainly_tenfold(*first.far, *second.far) &&
        certainly_tenfold(*second.far, *third.far)) {
        return Course::wrong_order;
    }
    if (all(is_growing)) {
        return Course::grows;
    }
    std::vector<Ball> most;
    for (const Run& run : runs_) {
        most.push_back(run.largest());
    }
    if (certainly_tenfold(most[0], most[1]) && certainly_tenfold(most[1], most[2]) && first.far &&
        third.far && certainly_less(*third.far, *first.far * 3)) {
        return Course::grows;
    }
    const bool maximum_settles = certainly_less(abs(most[2] - most[1]) * 10000, most[1]) &&
                                 certainly_less(abs(most[1] - most[0]) * 100, most[0]);
    return all(is_bounded) && maximum_settles ? Course::bounded : Course::unknown;
}

} // namespace

FollowedRest follow_rest(const Sample& sample, const ExpansionToFollow& expansion,
                         unsigned digits) {
    return RestFollower(expansion, digits).follow(sample);
}

bool certainly_grows(const Expr& e, const Sample& sample, const ExpansionToFollow& expansion,
                     unsigned digits) {
    std::optional<Ball> before;
    for (unsigned decades = 8; decades <= 64; decades *= 2) {
        std::optional<Ball> here;
        SampleInBalls in_balls(at_distance(sample, expansion, decades), digits + 2 * decades);
        const bool known = in_balls.until([&](const EnclosedSample& in) {
            here = abs(in.evaluate(e));
            return here->is_finite() && here->relative_accuracy_bits() >= rest_bits;
        });
        if (!known || (before && !certainly_half_more(*before, *here))) {
            return false;
        }
        before = here;
    }
    return true;
}

} // namespace edgeproof::audit
