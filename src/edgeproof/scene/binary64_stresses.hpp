// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <span>

namespace edgeproof::scene {

/// The stresses at many points of a body, in units of the contact modulus. All arrays have the same
/// size; `mises` is empty if the scene has no Poisson's ratio.
struct Binary64Stresses {
    std::span<double> sxx;
    std::span<double> szz;
    std::span<double> sxz;
    std::span<double> tau_max;
    std::span<double> mises;
    std::span<double> bound; ///< of the error of each value at the point
};

/// Computes the stresses at the places x and the depths z, which are exactly these binary64. The
/// bounds are proved and at most 1e-12 of the mean pressure, or 2^-52 of the value itself where it
/// is large: binary64 with bounds decide most points of piecewise linear slopes, run_scene computes
/// the others. The scene's [ask] is ignored.
///
/// Throws InputError for z < 0, for points at which a stress is infinite, and if the stresses of
/// the scene are not computed; DomainError for numbers that are not finite; Interrupted.
/// @param scene the contact
/// @param body the body in which the points are
/// @param x places (length)
/// @param z depths (length), as many
/// @param stresses receives the values
/// @param threads 0: the processors available
void compute_binary64(const Scene& scene, Body body, std::span<const double> x,
                      std::span<const double> z, const Binary64Stresses& stresses,
                      unsigned threads = 0);

} // namespace edgeproof::scene
