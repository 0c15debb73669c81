// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// A TOML file becomes a Scene, a Plan and a SceneResult:
///   scene_file.hpp   Scene, read_scene: exact numbers, errors with file and line
///   units.hpp        Units: labels of a scene's numbers
///   plan.hpp         Plan: the effects that a scene needs, and their counts
///   quantity.hpp     the table of quantities: names, places, units, evaluators
///   rows.hpp         Row: one asked value with its result
///   value_route.hpp  ValueRoute: computes the values
///   enclosure.hpp    exact constants as balls
///   bounded_value.hpp  BoundedValue: a value, its error, its route; printing
///   run_scene.hpp    run_scene: carries out the plan and counts the work
///                    SceneValues: single numbers of a scene
///                    greatest_value: the greatest stress of a body, and its place
///   binary64_values.hpp  many values, rounded to binary64
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/scene/input/bounded_value.hpp"
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/input/scene_file.hpp"
#include "edgeproof/scene/input/units.hpp"
#include "edgeproof/scene/route/plan.hpp"
#include "edgeproof/scene/route/value_route.hpp"
#include "edgeproof/scene/run_scene.hpp"
