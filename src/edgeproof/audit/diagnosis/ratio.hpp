// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/sample/evaluated_scene.hpp"
#include "edgeproof/formula/expr.hpp"

#include <optional>
#include <vector>

namespace edgeproof::audit {

/// The ratio printed/exact for given values of the parameters.
struct RatioSample {
    Variables parameters;
    Real ratio;
};

/// Returns the ratio as a closed form that agrees with every sample to `digits` digits: a sign, a
/// rational, a power of pi, and whole, half or quarter powers of the parameters. Returns nothing if
/// there is no such form of moderate size, or too few samples to decide.
[[nodiscard]] std::optional<formula::Expr> recognise_ratio(const std::vector<RatioSample>& samples,
                                                           unsigned digits);

} // namespace edgeproof::audit
