// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/cost/cost_case.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::cost {

/// What a route made of a point. A route that proves its values gives the ball as well.
struct CostValue {
    Real value;
    std::optional<std::size_t> evaluations = {}; ///< of an integrand, where it counts them
    std::optional<Ball> ball = {};
};

/// A contact made ready for one route at one precision: what is done once a contact is done.
class ReadyContact {
public:
    virtual ~ReadyContact() = default;
    /// p at point number i of the case. Throws what the route throws.
    [[nodiscard]] virtual CostValue at(std::size_t i) = 0;
};

/// One way to a pressure, in one arithmetic.
struct CostRoute {
    std::string name;
    std::string arithmetic;
    unsigned digits = 0; ///< that the arithmetic has; 0: as many as are asked for
    bool proves = false;
    bool expensive =
        false; ///< takes so long that it is timed at few points and digits, unless asked to
    /// Whether the route takes this profile.
    std::function<bool(const scene::Scene&)> takes;
    std::function<std::unique_ptr<ReadyContact>(const CostCase&, unsigned digits)> ready;
};

/// All of them; a new one is an entry of this list.
[[nodiscard]] const std::vector<CostRoute>& cost_routes();

} // namespace edgeproof::cost
