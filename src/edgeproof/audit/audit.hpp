// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// Printed claims against the mechanics, from the bottom up:
///   claim.hpp     Claim: what is printed, as data; Vocabulary: the names it may use
///   family.hpp    Family: the scenes that a claim is sampled over, drawn deterministically
///   ledger.hpp    Ledger: a file of claims and families, read strictly
///   evaluated_scene.hpp   EvaluatedScene: a scene in numbers, in which formulas are evaluated
///   verdict.hpp   Verdict
///   evidence.hpp  Evidence: what a verdict rests on
///   claim_kind.hpp  CheckKind: the interface of a kind of claim (checks/ has one file a kind)
///   enclosures.hpp  what balls say of a verdict: disjoint enclosures, digits proved
///   mutants.hpp   formulas that stand, broken on purpose: the power of the check, measured
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/claim_kind.hpp"
#include "edgeproof/audit/ledger/evidence.hpp"
#include "edgeproof/audit/ledger/family.hpp"
#include "edgeproof/audit/ledger/ledger.hpp"
#include "edgeproof/audit/ledger/verdict.hpp"
#include "edgeproof/audit/mutation/mutants.hpp"
#include "edgeproof/audit/run.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/audit/sample/evaluated_scene.hpp"
