// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// Reference values, and other programs' numbers held against them.
///   asked_contact.hpp  a profile under a load, as parameters in text
///   question.hpp       Question: what is asked of a contact (scene/input/quantity.hpp)
///   recipe.hpp         Recipe: grids of contacts and what is asked of each, from TOML
///   recipe_grid.hpp    RecipeGrid: a recipe of any number of rows, in pieces
///   parallel_for.hpp   pieces done on several threads
///   distributed_work.hpp pieces done by several processes (processes.hpp), one of which leads
///   reference.hpp      references: the answers, by threads, the same on any number of them
///   number_text.hpp    the one grammar of numbers in answers
///   answers.hpp        what another program answered, whatever that is
///   child_process.hpp  another program run, text in and text out
///   program_driver.hpp a program asked batch by batch, in CSV or JSON lines, however it ends
///   conditioning.hpp   how much of an error the inputs' rounding explains
///   agreement.hpp      digits right, ulps, and where in the contact
///   convention.hpp     failures that another convention explains
///   unit_mistake.hpp   failures that another reading of the question explains
///   corruption.hpp     right answers made wrong, to see that it is found
///   csv.hpp            CSV with the line of each row
///   atomic_file.hpp    a file that is whole or not there
#include "edgeproof/conformance/answers/agreement.hpp"
#include "edgeproof/conformance/answers/answers.hpp"
#include "edgeproof/conformance/answers/number_text.hpp"
#include "edgeproof/conformance/answers/program_driver.hpp"
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/conformance/causes/corruption.hpp"
#include "edgeproof/conformance/causes/unit_mistake.hpp"
#include "edgeproof/conformance/questions/asked_contact.hpp"
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
#include "edgeproof/parallel/processes.hpp"
