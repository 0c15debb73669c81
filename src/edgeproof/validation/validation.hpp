// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// Tests of the program's own numbers, and comparisons with simpler methods.

#include "edgeproof/validation/counts/binary64_count.hpp" // double words compared with balls
#include "edgeproof/validation/counts/count.hpp"     // random values compared with second routes
#include "edgeproof/validation/counts/sample.hpp"    // random contacts and values of a given seed
#include "edgeproof/validation/enclosed_value.hpp"   // one number of a scene, by balls
#include "edgeproof/validation/hard_cases.hpp"       // difficult cases as data, with reasons
#include "edgeproof/validation/honesty.hpp"          // claimed and true errors of routes
#include "edgeproof/validation/second_route.hpp"     // one number by two routes in Real
#include "edgeproof/validation/textbook_formula.hpp" // textbook formulas in any arithmetic
