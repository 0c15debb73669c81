// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/conformance/causes/wrong_rows.hpp"

#include <optional>
#include <utility>

namespace edgeproof::conformance {

/// The digits of a relative error.
[[nodiscard]] double cause_digits(double off);

/// Adds the named factors near answers of `least` to `most` times ours (diagnose::near_factors()).
void add_near_factors(Convention& of, double least, double most);

/// The interval of the ratio of answers and ours, without a twentieth of the rows on each side.
[[nodiscard]] std::pair<double, double> interval_of(const WrongRows& all);

/// The interval, if it is not due to noise, and named factors are near it.
[[nodiscard]] std::optional<Convention> varying_factor(const Group& group, double noise);

} // namespace edgeproof::conformance
