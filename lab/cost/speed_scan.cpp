// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/cost/speed_scan.hpp"
#include "edgeproof/parallel/parallel_for.hpp"
#include "lab/cost/measure.hpp"
#include "lab/counts/sample.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>

namespace edgeproof::cost {

double SpeedCell::median() const {
    std::vector<double> seconds;
    for (const Scene& s : scenes) {
        seconds.push_back(s.answer.seconds);
    }
    return quartiles(std::move(seconds)).median;
}

double SpeedCell::ratio() const {
    const double usual = median();
    return usual > 0 ? scenes.front().answer.seconds / usual : 0;
}

std::size_t SpeedCell::stopped() const {
    return static_cast<std::size_t>(std::count_if(scenes.begin(), scenes.end(),
                                                  [](const Scene& s) { return s.answer.stopped; }));
}

std::size_t SpeedCell::failed() const {
    return static_cast<std::size_t>(std::count_if(
        scenes.begin(), scenes.end(), [](const Scene& s) { return !s.answer.failure.empty(); }));
}

std::vector<SpeedCell> scan_speed(const SpeedOptions& options) {
    std::map<std::tuple<std::string, std::size_t, unsigned>, SpeedCell> cells;
    std::mutex mutex;
    std::atomic<std::size_t> done = 0;
    const std::size_t scenes = options.only ? 1 : options.scenes;
    parallel::work_through(parallel::all_pieces(scenes), options.threads, [&](std::size_t piece) {
        const std::size_t number = options.only.value_or(piece);
        const SampledScene scene = sampled_scene(options.seed, number);
        for (std::size_t c = 0; c < scanned_commands.size(); ++c) {
            for (const unsigned digits : options.digits) {
                const TimedAnswer answer = options.answer(scene, scanned_commands.at(c), digits);
                const std::lock_guard lock(mutex);
                SpeedCell& cell = cells[{scene.kind, c, digits}];
                cell.kind = scene.kind;
                cell.command = c;
                cell.digits = digits;
                cell.scenes.push_back({number, answer});
            }
        }
        if (options.progress) {
            const std::lock_guard lock(mutex);
            options.progress(++done, scenes);
        }
    });
    std::vector<SpeedCell> all;
    for (auto& [key, cell] : cells) {
        std::sort(cell.scenes.begin(), cell.scenes.end(),
                  [](const SpeedCell::Scene& x, const SpeedCell::Scene& y) {
                      return std::pair(-x.answer.seconds, x.number) <
                             std::pair(-y.answer.seconds, y.number);
                  });
        all.push_back(std::move(cell));
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const SpeedCell& x, const SpeedCell& y) { return x.ratio() > y.ratio(); });
    return all;
}

namespace {

using validation::Dice;

/// A function h(y) with h(0) = 0 that increases for y > 0.
struct Slope {
    const char* h;
    bool odd = false;     ///< it may be the slope of both sides
    bool bounded = false; ///< too weak to balance another side
    bool ends = false;    ///< defined for y <= 1 only
};

constexpr std::array<Slope, 26> slopes{{
    {"y + y^3", true},
    {"y + 5*y^9", true},
    {"y + y^2/3"},
    {"y^(3/2)"},
    {"sqrt(y)"},
    {"y^(1/3)"},
    {"y^(7/3)"},
    {"y^(5/8)"},
    {"y^(1/10)", false, true},
    {"y^(21/2)"},
    {"sqrt(y + 1) - 1"},
    {"sqrt(y + 1/1000) - sqrt(1/1000)"},
    {"sqrt(y^2 + 1/10000) - 1/100"},
    {"sinh(2*y)", true},
    {"exp(3*y) - 1"},
    {"y + sin(9*y)/10", true},
    {"log(1 + 20*y)", false, true},
    {"tanh(5*y)", true, true},
    {"tanh(40*y)", true, true},
    {"atan(10*y)", true, true},
    {"asinh(30*y)", true, true},
    {"y/(1 + y)", false, true},
    {"gamma(2 + y) - 1"},
    {"y/sqrt(101/100 - y^2)", true, false, true},
    {"tan(3*y/2)", true, false, true},
    {"atanh(99*y/100) + asin(y*2/3)", true, false, true},
}};

const Slope& drawn_slope(Dice& dice, bool odd, bool unbounded, bool endless) {
    for (;;) {
        const Slope& s = slopes.at(dice.below(slopes.size()));
        if ((s.odd || !odd) && !(s.bounded && unbounded) && !(s.ends && endless)) {
            return s;
        }
    }
}

std::string with_argument(const std::string& h, const std::string& y) {
    std::string text;
    for (std::size_t i = 0; i < h.size(); ++i) {
        const bool alone = h[i] == 'y'; // no function's name contains a y
        text += alone ? "(" + y + ")" : h.substr(i, 1);
    }
    return text;
}

std::string list(const std::string& first, const std::string& second = {},
                 const std::string& third = {}) {
    std::string text = "[\"" + first + "\"";
    for (const std::string& more : {second, third}) {
        text += more.empty() ? "" : ", \"" + more + "\"";
    }
    return text + "]";
}

std::string curved_scene(Dice& dice) {
    const std::string a = dice.decimal(3, dice.between(-3, 2));
    const bool force_given = dice.below(3) == 0;
    const std::string steep = "1/" + std::to_string(dice.between(3, 40));
    const std::string half = a + "/" + std::to_string(dice.between(2, 30));
    const auto slope = [&](bool odd, bool unbounded, const std::string& y) {
        return steep + "*(" +
               with_argument(drawn_slope(dice, odd, unbounded, force_given).h, y + "/" + a) + ")";
    };
    std::string profile = "kind = \"piecewise\"\n";
    switch (dice.below(4)) {
    case 0: // one formula
        profile += "symmetric = true\nknots = []\nslopes = " + list(slope(true, false, "x"));
        break;
    case 1: // a flat, and a curve beyond it
        profile += "symmetric = true\nknots = " + list(half) +
                   "\nslopes = " + list("0", slope(false, false, "(x - " + half + ")"));
        break;
    case 2: // a cylinder, and an added curve beyond a knot
        profile += "symmetric = true\nknots = " + list(half) + "\nslopes = " +
                   list("x/(3*" + a + ")",
                        "x/(3*" + a + ") + " + slope(false, false, "(x - " + half + ")"));
        break;
    default: { // two different sides, with a flat between them
        const std::string left = slope(false, true, "(-x)");
        profile += "knots = " + list("0", half) + "\nslopes = " +
                   list("-(" + left + ")", "0", slope(false, true, "(x - " + half + ")"));
        break;
    }
    }
    const std::string load =
        force_given ? "P = \"" + a + "/" + std::to_string(dice.between(100, 9999)) + "\""
                    : "a = \"" + a + "\"";
    return "[profile]\n" + profile + "\n[load]\n" + load + "\ncontact_modulus = \"1\"\n";
}

} // namespace

SampledScene sampled_scene(std::uint64_t seed, std::size_t number) {
    const std::string ask = "[ask]\nu = [\"a/1000000\", \"a/3\"]\n";
    if (number % 2 == 0) {
        Dice dice(Dice(seed ^ (0x9fb21c651e98df25U * (number + 1))).next());
        return {"piecewise (curved)", curved_scene(dice) + ask};
    }
    const validation::SampledContact contact = validation::sampled_contact(seed, number, 0);
    return {std::string(validation::sampled_profiles.at(contact.profile)), contact.text + ask};
}

} // namespace edgeproof::cost
