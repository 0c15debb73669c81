// SPDX-License-Identifier: GPL-3.0-or-later
// An outside project that uses all modules: a scene from text, its values printed to a stream, and
// a table of the report. With E* = 2, R = 1, a = 1 the pressure is sqrt(1 - x^2), sqrt(0.19) at x =
// 9/10, and c_0 = sqrt(2).
#include "edgeproof/certificate/certificate.hpp"
#include "edgeproof/contact/contact.hpp"
#include "edgeproof/precision/precision.hpp"
#include "edgeproof/report/report.hpp"
#include "edgeproof/scene/scene.hpp"

#include <iomanip>
#include <iostream>

int main() {
    using namespace edgeproof;
    const scene::Scene hertz = scene::parse_scene(R"([profile]
kind = "power-law"
m = "1"
C = "1"
[load]
a = "1"
contact_modulus = "2"
[ask]
u = ["1/10"]
terms = 1
quantities = ["pressure", "coefficients"]
)",
                                                  "hertz");
    const scene::SceneResult result = run_scene(hertz);
    const scene::BoundedValue& p = result.points().at(0).at(scene::Quantity::p);
    std::cout << p << '\n'; // with its bound and its route
    const scene::BoundedValue& c_0 =
        result.at_edges(scene::QuantityGroup::coefficients).at(0).at(scene::Quantity::c);
    std::cout << std::setprecision(20) << c_0.value << '\n';
    report::Table table;
    table.columns = {{"u"}, {"p"}};
    table.rows = {{"1/10", printed_text(p, {10})}};
    std::cout << report::aligned_lines(table, 0, false);
}
