// SPDX-License-Identifier: BSD-3-Clause
// A table of pressures made by all processors. Values are put where they belong, so that the table
// is the same for every number of threads.
#include "edgeproof/contact/contact.hpp"
#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <array>
#include <iostream>
#include <string>
#include <vector>

int main() {
    using namespace edgeproof;
    using namespace edgeproof::contact;
    using formula::Exact;

    const std::array<const char*, 5> m{"1", "3/2", "2", "7/3", "3"}; // g' = x^m
    const std::array<const char*, 4> u{"1e-100", "1e-15", "0.25", "0.999"};
    std::vector<std::string> cells(m.size() * u.size());

    // Profiles, balls and contacts belong to one thread each: every piece of work makes its own.
    // What one piece throws ends the work and is thrown here.
    const unsigned all_processors = 0;
    parallel::parallel_for(cells.size(), all_processors, [&](std::size_t i) {
        const Profile profile =
            Profile::power_law(Exact::parse("1"), Exact::parse(m[i / u.size()])); // C, m
        const Ball p =
            enclosed_pressure(profile, Exact::parse("1"), Load::right_edge(Exact::parse("1")),
                              Edge::right, Exact::parse(u[i % u.size()]), 50);
        cells[i] = round_ball(p, 50).text;
    });

    std::cout << "m,u,p\n";
    for (std::size_t i = 0; i < cells.size(); ++i) {
        std::cout << m[i / u.size()] << ',' << u[i % u.size()] << ',' << cells[i] << '\n';
    }
}
