// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace edgeproof::cost {

/// A random scene to be timed.
struct SampledScene {
    std::string kind; ///< the kind of profile: a scene is compared with those of its kind
    std::string text; ///< in TOML
};

/// Returns the scene with that number; it depends only on the seed and the number. Every second
/// scene has a curved slope: whole, half and odd powers, functions with poles or branch points near
/// the contact or on a knot, symmetric or not, loaded by `a` or by P. The others are those of
/// validation/counts/sample.hpp.
[[nodiscard]] SampledScene sampled_scene(std::uint64_t seed, std::size_t number);

} // namespace edgeproof::cost
