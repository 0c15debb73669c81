// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// Tests of the program's own numbers, and comparisons with simpler methods.

#include "lab/counts/binary64_count.hpp"       // double words compared with balls
#include "lab/counts/count.hpp"                // random values compared with second routes
#include "lab/counts/sample.hpp"               // random contacts and values of a given seed
#include "lab/validation/enclosed_value.hpp"   // one number of a scene, by balls
#include "lab/validation/hard_cases.hpp"       // difficult cases as data, with reasons
#include "lab/validation/honesty.hpp"          // claimed and true errors of routes
#include "lab/validation/second_route.hpp"     // one number by two routes in Real
#include "lab/validation/textbook_formula.hpp" // textbook formulas in any arithmetic
