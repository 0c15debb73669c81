// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/split_mix.hpp"
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::validation {

class Dice : public SplitMix64 {
public:
    using SplitMix64::SplitMix64;
    /// A number in least ... most.
    [[nodiscard]] int between(int least, int most) {
        return least + static_cast<int>(below(static_cast<std::size_t>(most - least) + 1));
    }
    /// A decimal of up to `digits` digits, from 1 up to 10 (but not 10), times 10^exponent.
    [[nodiscard]] std::string decimal(unsigned digits, int exponent);
};

inline constexpr std::array<std::string_view, 6> sampled_profiles{
    "power-law",          "flat-and-rounded",  "tilted-wedge", "tilted-flat-and-rounded",
    "piecewise (linear)", "piecewise (curved)"};

/// The regime of a value: its distance u from the edge in units of a, or another kind of value.
inline constexpr std::array<std::string_view, 8> sampled_regimes{
    "u < 1e-12 a", "u < 1e-3 a",   "u < a",   "beyond u = a",
    "by a knot",   "coefficients", "P and b", "shear"};

struct SampledValue {
    scene::AskedValue asked;
    std::size_t regime = 0; ///< index in sampled_regimes
};

struct SampledContact {
    std::size_t profile = 0; ///< index in sampled_profiles
    std::string text;        ///< the scene as TOML, to repeat a failure
    scene::Scene scene;
    std::vector<SampledValue> values;
};

/// The number of values per contact; the last contact of a count may have fewer.
inline constexpr std::size_t values_a_contact = 50;

/// Returns the contact of that number with `values` values; it depends only on the seed and the
/// number. Kinds of profile, sizes from 1e-3 to 1e3, loads by a and by P, edges, regimes and
/// quantities are random; one contact in 2000 has a curved g', whose integrals take minutes.
[[nodiscard]] SampledContact sampled_contact(std::uint64_t seed, std::size_t number,
                                             std::size_t values = values_a_contact);

} // namespace edgeproof::validation
