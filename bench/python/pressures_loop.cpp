// SPDX-License-Identifier: BSD-3-Clause
// pressures_loop SCENE COUNT RUNS: writes the seconds for COUNT pressures of a scene in a loop of
// C++, with places and values in arrays of double; a line for each run. The contact is solved
// before.
#include "edgeproof/scene/binary64_values.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fputs("pressures_loop SCENE COUNT RUNS\n", stderr);
        return 2;
    }
    using namespace edgeproof;
    const scene::Scene scene = scene::read_scene(argv[1]);
    const std::size_t count = std::strtoul(argv[2], nullptr, 10);
    const long runs = std::strtol(argv[3], nullptr, 10);
    const scene::Binary64Pressures pressure(scene);
    std::vector<double> u(count);
    std::vector<double> p(count);
    for (std::size_t i = 0; i < count; ++i) {
        u[i] = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    }
    for (long run = 0; run <= runs; ++run) {
        const auto begun = std::chrono::steady_clock::now();
        for (std::size_t i = 0; i < count; ++i) {
            p[i] = pressure(contact::Edge::right, u[i]);
        }
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
        if (run > 0) { // the first run fills tables
            std::printf("%.9f\n", taken.count());
        }
    }
}
