// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cost/speed_scan.hpp"

#include "edgeproof/cost/measure.hpp"
#include "edgeproof/parallel/parallel_for.hpp"

#include <algorithm>
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

} // namespace edgeproof::cost
