// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// The cost of a value: digits reached, evaluations counted, processor time with its spread.
///   cost_case.hpp   contacts and points that are timed
///   cost_route.hpp  the routes in each arithmetic, with one interface for all
///   measure.hpp     CostCell: a route at a number of digits over the points of a case
///   growth.hpp      how cost grows with the digits, and the cost of a proof
///   growth.hpp     the cost of tilt, shear, expansions and extents in a scene
///   speed_scan.hpp, speed_scan.hpp  random scenes: which take much longer than others
///   machine.hpp     the machine on which times were taken
#include "edgeproof/cost/cost_case.hpp"
#include "edgeproof/cost/cost_route.hpp"
#include "edgeproof/cost/growth.hpp"
#include "edgeproof/cost/machine.hpp"
#include "edgeproof/cost/measure.hpp"
#include "edgeproof/cost/speed_scan.hpp"
