// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/alignment.hpp"

#include <functional>
#include <string>
#include <vector>

namespace edgeproof::comparison {

/// The pressures that a program with one mistake would write at the nodes.
struct Suspect {
    std::string name;
    std::string what;
    double a = 0; ///< its contact is -b < x < a
    double b = 0;
    std::vector<double> p; ///< at each node; NaN where it says nothing
};

/// Every mistake that makes sense of a scene. Those whose contact cannot be solved are left out.
/// `take` is called with one after another.
void for_each_suspect(const AlignedResult& data, const scene::Scene& scene,
                      const ExactContact& exact, const std::function<void(const Suspect&)>& take);

} // namespace edgeproof::comparison
