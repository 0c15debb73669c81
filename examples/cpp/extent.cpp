// SPDX-License-Identifier: GPL-3.0-or-later
// How far from the edge are one, two and three terms within 1 % of the pressure? A question of a
// process zone, asked of a scene: the text of a scene file, as examples/scenes has them.
#include "edgeproof/scene/scene.hpp"

#include <iostream>

int main() {
    using namespace edgeproof;

    const char* const text = R"toml(
[profile]
kind = "power-law"     # g' = C x^m; m = 1: a cylinder of radius 1/C
m = "1"
C = "1"
[load]
a = "1"
contact_modulus = "1"
[ask]
quantities = ["extent"]
edges = ["right"]
terms = [1, 2, 3]
tolerance = "1%"
digits = 20
)toml";
    try {
        const scene::Scene cylinder = scene::parse_scene(text, "cylinder");
        const scene::SceneResult result = scene::run_scene(cylinder);
        for (const scene::Row& row : result.rows) {
            if (row.asked.quantity != scene::Quantity::extent) {
                continue; // the contact, and the measures of the same extents
            }
            // `proved`: a search by enclosures that leaves no gap; otherwise the route is an
            // estimate, and how() contains that word.
            const scene::BoundedValue& exit = *row.value;
            std::cout << row.asked.k
                      << " within 1 % up to u = " << scene::printed(exit, cylinder.ask.digits).text
                      << (exit.proved ? ", proved" : ", estimated") << '\n';
        }
    } catch (const Error& error) { // InputError has the file, the line and what to write instead
        std::cerr << error.what() << '\n';
        return 2;
    }
}
