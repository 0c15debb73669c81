// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/scene_file.hpp"
#include "lab/cost/cost.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <map>

TEST_CASE("scenes to be timed: the same for a seed, readable, of all kinds") {
    std::map<std::string, std::size_t> kinds;
    for (std::size_t n = 0; n < 120; ++n) {
        const SampledScene scene = sampled_scene(7, n);
        CAPTURE(scene.text);
        CHECK(scene.text == sampled_scene(7, n).text);
        CHECK(scene.text != sampled_scene(8, n).text);
        CHECK_NOTHROW((void)edgeproof::scene::parse_scene(scene.text, "scene"));
        ++kinds[scene.kind];
    }
    CHECK(kinds.size() == 6);
    CHECK(kinds["piecewise (curved)"] >= 60);
}

TEST_CASE("a speed scan lists first the scenes that take longer than their neighbours") {
    SpeedOptions options;
    options.seed = 3;
    options.scenes = 40;
    options.digits = {20, 70};
    options.threads = 2;
    const auto cells = [&] {
        options.answer = [&](const SampledScene& scene, const ScannedCommand& command,
                             unsigned digits) {
            TimedAnswer answer;
            answer.seconds = digits == 20 ? 1 : 2;
            if (scene.text == sampled_scene(3, 18).text && digits == 70 &&
                std::string(command.name) == "extent") {
                answer.seconds = 50;
                answer.stopped = true;
            }
            if (scene.text == sampled_scene(3, 4).text) {
                answer.failure = "refused";
            }
            return answer;
        };
        return scan_speed(options);
    }();
    std::size_t answers = 0;
    std::size_t failed = 0;
    for (const SpeedCell& cell : cells) {
        answers += cell.scenes.size();
        failed += cell.failed();
        CHECK(cell.ratio() <= cells.front().ratio());
    }
    CHECK(answers == 40 * scanned_commands.size() * 2);
    CHECK(failed == scanned_commands.size() * 2);
    const SpeedCell& worst = cells.front();
    CHECK(worst.kind == "piecewise (curved)");
    CHECK(std::string(scanned_commands.at(worst.command).name) == "extent");
    CHECK(worst.digits == 70);
    CHECK(worst.scenes.front().number == 18);
    CHECK(worst.median() == 2);
    CHECK(worst.ratio() == 25);
    CHECK(worst.stopped() == 1);

    options.only = 18;
    const auto alone = scan_speed(options);
    CHECK(alone.size() == scanned_commands.size() * 2);
    CHECK(alone.front().scenes.size() == 1);
    CHECK(alone.front().scenes.front().number == 18);
}
