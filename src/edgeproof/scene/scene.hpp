// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// A TOML file becomes a Scene, a Plan and a SceneResult:
///   scene_file.hpp   Scene, read_scene: exact numbers, errors with file and line
///   units.hpp        Units: labels of a scene's numbers
///   plan.hpp         Plan: what the request of a scene needs
///   quantity.hpp     the table of quantities: names, places, units, evaluators
///   rows.hpp         Row: one asked value with its result
///   scene_values.hpp  SceneValues: a solved scene, which computes single values
///   exact.hpp        exact constants, also as balls
///   bounded_value.hpp  BoundedValue: a value, its error, its route; printing
///   run_scene.hpp    run_scene: all values that a scene asks for
///                    greatest_value: the greatest stress of a body, and its place
///   binary64_values.hpp  many values, rounded to binary64
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/scene/input/bounded_value.hpp"
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/input/scene_file.hpp"
#include "edgeproof/scene/input/units.hpp"
#include "edgeproof/scene/route/plan.hpp"
#include "edgeproof/scene/route/scene_values.hpp"
#include "edgeproof/scene/run_scene.hpp"
