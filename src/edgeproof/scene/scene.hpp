// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// What is asked, and what it takes: a TOML file becomes a Scene, a Plan, a SceneResult.
///   scene_file.hpp   Scene, read_scene: everything in it exact, errors with file and line
///   units.hpp        Units: labels of a scene's numbers
///   points.hpp       grids of points, exact
///   plan.hpp         Plan: the effects that a scene calls for, and nothing else; their counts
///   quantity.hpp     the table of quantities: names, places, units, evaluators
///   value_route.hpp  ValueRoute: where values come from, one interface for all ways
///   exact_ball.hpp   exact constants as balls
///   bounded_value.hpp  BoundedValue: a value, how far it may be off, its route; as it is printed
///   run_scene.hpp    run_scene: the plan carried out, with what was really done
///   scene_values.hpp SceneValues: single numbers of a scene
#include "edgeproof/formula/exact/exact_ball.hpp"
#include "edgeproof/scene/input/bounded_value.hpp"
#include "edgeproof/scene/input/points.hpp"
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/input/scene_file.hpp"
#include "edgeproof/scene/input/units.hpp"
#include "edgeproof/scene/route/plan.hpp"
#include "edgeproof/scene/route/value_route.hpp"
#include "edgeproof/scene/run_scene.hpp"
#include "edgeproof/scene/scene_values.hpp"
