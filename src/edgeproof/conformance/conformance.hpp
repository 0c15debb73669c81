// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// Reference values, and other programs' numbers held against them.
///   asked_contact.hpp    a profile under a load, as parameters in text
///   question.hpp    Wanted, Question: what is asked of a contact
///   recipe.hpp      Recipe: grids of contacts and what is asked of each, from TOML
///   reference.hpp   references: the answers, by threads, the same bytes on any number of them
///   csv.hpp         CSV with the line of each row
///   text_file.hpp   files as text, and a checksum
#include "edgeproof/conformance/asked_contact.hpp"
#include "edgeproof/conformance/csv.hpp"
#include "edgeproof/conformance/question.hpp"
#include "edgeproof/conformance/recipe.hpp"
#include "edgeproof/conformance/reference.hpp"
#include "edgeproof/conformance/text_file.hpp"
