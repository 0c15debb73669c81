// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// The cost of a value: digits reached, evaluations counted, processor time with its spread.
///   cost_case.hpp   contacts and points that are timed
///   cost_route.hpp  the routes in each arithmetic, with one interface for all
///   measure.hpp     CostCell: a route at a number of digits over the points of a case; the machine
///                   on which times are taken
///   growth.hpp      how cost grows with the digits; the cost of a proof, of tilt, shear,
///                   expansions and extents in a scene
///   cost_tables.hpp, cost_page.hpp  the results in each format
#include "lab/cost/cost_case.hpp"
#include "lab/cost/cost_route.hpp"
#include "lab/cost/growth.hpp"
#include "lab/cost/measure.hpp"
