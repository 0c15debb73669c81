// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// Reference values, and the comparison of other programs' numbers with them.
///   question.hpp  a profile under a load, as parameters in text
///   question.hpp       Question: a value requested for a contact (scene/input/quantity.hpp)
///   recipe.hpp         Recipe: grids of contacts and the questions for each, from TOML
///   recipe_grid.hpp    RecipeGrid: a recipe of any number of rows, in pieces
///   parallel_for.hpp   pieces of work on several threads
///   distributed_work.hpp pieces of work by several processes (distributed_work.hpp), one of which
///   leads reference.hpp      references: the answers, the same on any number of threads
///   number_text.hpp    the grammar of numbers in answers
///   answers.hpp        the answers of another program, right or wrong
///   child_process.hpp  runs another program, text in and text out
///   program_driver.hpp asks a program in batches, in CSV or JSON lines, and survives its crashes
///   conditioning.hpp   how much of an error the rounding of the inputs explains
///   agreement.hpp      correct digits, ulps, and the position in the contact
///   convention.hpp     failures that another convention explains
///   readings.hpp       failures that another interpretation of the question explains
///   corruption.hpp     correct answers made wrong, to test that this is detected
///   csv.hpp            CSV with the line of each row
///   atomic_file.hpp    a file that is either complete or absent
#include "edgeproof/conformance/answers/agreement.hpp"
#include "edgeproof/conformance/answers/answers.hpp"
#include "edgeproof/conformance/answers/number_text.hpp"
#include "edgeproof/conformance/answers/program_driver.hpp"
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/conformance/causes/corruption.hpp"
#include "edgeproof/conformance/causes/readings.hpp"
#include "edgeproof/conformance/questions/conditioning.hpp"
#include "edgeproof/conformance/questions/question.hpp"
#include "edgeproof/conformance/questions/recipe.hpp"
#include "edgeproof/conformance/questions/recipe_grid.hpp"
#include "edgeproof/conformance/questions/reference.hpp"
#include "edgeproof/io/atomic_file.hpp"
#include "edgeproof/io/child_process.hpp"
#include "edgeproof/io/csv.hpp"
#include "edgeproof/parallel/distributed_work.hpp"
#include "edgeproof/parallel/parallel_for.hpp"
