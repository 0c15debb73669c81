// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/run_scene.hpp"

#include <pybind11/pybind11.h>

namespace edgeproof::python {

/// Returns a result as nested dicts and lists of Value, from which edgeproof/results.py makes its
/// objects.
[[nodiscard]] pybind11::dict results_of(const scene::Scene& scene,
                                        const scene::SceneResult& result);

/// Returns the questions of a scene's file: quantities, edges, terms, u, digits.
[[nodiscard]] pybind11::dict asked_of(const scene::Scene& scene);

} // namespace edgeproof::python
