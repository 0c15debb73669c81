// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "lab/cost/cost_case.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::cost {

/// The result of a route at a point. A route that proves its values gives the ball as well.
struct CostValue {
    Real value;
    std::optional<std::size_t> evaluations = {}; ///< of an integrand, if the route counts them
    std::optional<Ball> ball = {};
};

/// A contact prepared for one route at one precision: the work that is done once for each contact.
/// Returns p at the point with index i of the case, which must outlive it. Throws the route's
/// errors.
using ReadyContact = std::function<CostValue(std::size_t i)>;

/// One route to a pressure, in one arithmetic.
struct CostRoute {
    std::string name;
    std::string arithmetic;
    bool proves = false;
    bool expensive = false; ///< so slow that it is timed at few points and digits, unless asked to
    /// True if the route takes this profile.
    std::function<bool(const scene::Scene&)> takes;
    std::function<ReadyContact(const CostCase&, unsigned digits)> ready;
};

/// Returns all routes; a new route is a new entry of this list.
[[nodiscard]] const std::vector<CostRoute>& cost_routes();

} // namespace edgeproof::cost
