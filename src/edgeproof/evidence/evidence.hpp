// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// How far the program's own numbers are to be trusted, and what others would have got instead.

#include "edgeproof/evidence/asked_value.hpp" // one number of a scene: by ball, and by two routes in Real
#include "edgeproof/evidence/count.hpp" // the values drawn, held to second routes, and counted
#include "edgeproof/evidence/count_state.hpp" // a count laid aside as text, and taken up again
#include "edgeproof/evidence/hard_cases.hpp" // the cases that are hard, as data, each with its reason
#include "edgeproof/evidence/honesty.hpp" // what routes claim of their error, and the error that they have
#include "edgeproof/evidence/obvious.hpp" // the textbook's formulas, straight, in any arithmetic
#include "edgeproof/evidence/run_cases.hpp" // each hard case by all routes, and by the obvious formula
#include "edgeproof/evidence/sample.hpp"    // contacts and values drawn from a stated seed
