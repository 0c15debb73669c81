// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/sample/evaluated_scene.hpp"
#include "edgeproof/formula/expr.hpp"

#include <optional>
#include <vector>

namespace edgeproof::audit {

/// A ratio printed/exact where the parameters have these values.
struct RatioSample {
    Variables parameters;
    Real ratio;
};

/// The ratio as a closed form: a sign, a rational, a power of pi, and whole, half or quarter powers
/// of the parameters, that gives every sample to `digits` digits. Nothing where there is none
/// (of moderate size), or too few samples to tell.
[[nodiscard]] std::optional<formula::Expr> recognise_ratio(const std::vector<RatioSample>& samples,
                                                           unsigned digits);

} // namespace edgeproof::audit
