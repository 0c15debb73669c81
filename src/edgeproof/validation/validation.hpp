// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// How far the program's own numbers are to be trusted, and what others would have got instead.

#include "edgeproof/validation/counts/binary64_count.hpp" // pressures in double words, held to balls, and counted
#include "edgeproof/validation/counts/count.hpp" // the values drawn, held to second routes, and counted
#include "edgeproof/validation/counts/count_state.hpp" // a count saved as text, and read again
#include "edgeproof/validation/counts/sample.hpp"  // contacts and values drawn from a stated seed
#include "edgeproof/validation/enclosed_value.hpp" // one number of a scene, by ball
#include "edgeproof/validation/hard_cases.hpp" // the cases that are hard, as data, each with its reason
#include "edgeproof/validation/honesty.hpp" // what routes claim of their error, and the error that they have
#include "edgeproof/validation/run_cases.hpp" // each hard case by all routes, and by the textbook formula
#include "edgeproof/validation/second_route.hpp" // the same by two routes in Real
#include "edgeproof/validation/textbook_formula.hpp" // the textbook's formulas, straight, in any arithmetic
