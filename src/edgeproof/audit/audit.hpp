// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// Printed claims against the mechanics, from the bottom up:
///   claim.hpp     Claim: what is printed, as data; Vocabulary: the names it may use
///   family.hpp    Family: the scenes that a claim is sampled over, drawn deterministically
///   ledger.hpp    Ledger: a file of claims and families, read strictly
///   setting.hpp   Setting: a scene in numbers, in which formulas are evaluated
///   verdict.hpp   Verdict
///   evidence.hpp  Evidence: what a verdict rests on
///   check.hpp     Outcome, and the interface of a kind of claim (checks/ has one file a kind)
///   enclosures.hpp  what balls say of a verdict: disjoint enclosures, digits proved
///   mutants.hpp   formulas that stand, broken on purpose: the power of the check, measured
#include "edgeproof/audit/check.hpp"
#include "edgeproof/audit/claim.hpp"
#include "edgeproof/audit/enclosures.hpp"
#include "edgeproof/audit/evidence.hpp"
#include "edgeproof/audit/family.hpp"
#include "edgeproof/audit/ledger.hpp"
#include "edgeproof/audit/mutants.hpp"
#include "edgeproof/audit/run.hpp"
#include "edgeproof/audit/setting.hpp"
#include "edgeproof/audit/verdict.hpp"
