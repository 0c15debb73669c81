// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// What is asked, and what it takes: a TOML file becomes a Scene, a Plan, a SceneResult.
///   scene_file.hpp   Scene, read_scene: everything in it exact, errors with file and line
///   points.hpp       ladders of points, exact
///   plan.hpp         Plan: the effects that a scene calls for, and nothing else; their counts
///   value_route.hpp  ValueRoute: where values come from, one interface for all ways
///   exact_ball.hpp   exact constants as balls
///   vouched.hpp      BoundedValue: a value, how far it may be off, the route; and as it is printed
///   run_scene.hpp    run_scene: the plan carried out, with what was really done
#include "edgeproof/formula/exact/exact_ball.hpp"
#include "edgeproof/scene/bounded_value.hpp"
#include "edgeproof/scene/plan.hpp"
#include "edgeproof/scene/points.hpp"
#include "edgeproof/scene/run_scene.hpp"
#include "edgeproof/scene/scene_file.hpp"
#include "edgeproof/scene/value_route.hpp"
