// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// Reference values, and the comparison of other programs' numbers with them.
///   questions/question.hpp     Question: a value requested for a contact; Recipe: grids of
///                              contacts with questions, from TOML; the answers, the same on any
///                              number of threads; how much of an error the rounding of the inputs
///                              explains
///   answers/answers.hpp        the answers of another program, right or wrong; correct digits,
///                              ulps, and the position in the contact
///   causes/convention.hpp      failures that another convention or interpretation explains
#include "edgeproof/conformance/answers/answers.hpp"
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/conformance/questions/question.hpp"
