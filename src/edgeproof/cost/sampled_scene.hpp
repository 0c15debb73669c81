// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace edgeproof::cost {

/// A scene that is drawn, to be timed.
struct SampledScene {
    std::string kind; ///< of the profile: its neighbours are the scenes of that kind
    std::string text; ///< as TOML
};

/// The scene of that number, the same for the same seed whatever else is drawn. Every other one has
/// a curved slope: whole, half and odd powers, functions with poles or branch points near the
/// contact or on a knot, symmetric or not, by `a` or by P; the others are those of
/// validation/counts/sample.hpp.
[[nodiscard]] SampledScene sampled_scene(std::uint64_t seed, std::size_t number);

} // namespace edgeproof::cost
