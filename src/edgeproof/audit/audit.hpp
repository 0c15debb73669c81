// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// The check of printed claims against the mechanics. The main headers are:
///     claim.hpp            Claim: a printed statement as data; Vocabulary: the names it may use;
///                          CheckKind: the interface of a kind of claim (checks/)
///     family.hpp           Family: the scenes at which a claim is sampled, drawn deterministically
///     ledger.hpp           Ledger: a file of claims and families, read strictly
///     enclosed_sample.hpp  EnclosedSample: a scene in balls, in which formulas are enclosed
///     judgement.hpp        Verdict; Evidence: the reasons for a verdict
///     enclosures.hpp       verdicts by ball arithmetic: disjoint enclosures, proved digits
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/family.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/audit/ledger/ledger.hpp"
#include "edgeproof/audit/run.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"
