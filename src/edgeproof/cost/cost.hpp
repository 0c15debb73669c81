// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// What a value costs: digits really reached, evaluations counted, processor time with its spread.
///   cost_case.hpp   contacts and points that are timed
///   cost_route.hpp  the routes in their arithmetics, one interface for all
///   measure.hpp     CostCell: a route at so many digits over the points of a case
///   growth.hpp      how cost grows with the digits, and what a proof adds
///   effects.hpp     what tilt, shear, expansions and extents add to a scene
///   sampled_scene.hpp, speed_scan.hpp  scenes drawn at random: which take much longer than others
///   machine.hpp     where times were taken
#include "edgeproof/cost/cost_case.hpp"
#include "edgeproof/cost/cost_route.hpp"
#include "edgeproof/cost/effects.hpp"
#include "edgeproof/cost/growth.hpp"
#include "edgeproof/cost/machine.hpp"
#include "edgeproof/cost/measure.hpp"
#include "edgeproof/cost/sampled_scene.hpp"
#include "edgeproof/cost/speed_scan.hpp"
