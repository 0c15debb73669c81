// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/audit_result.hpp"
#include "edgeproof/audit/ledger/ledger.hpp"

#include <string>
#include <vector>

namespace edgeproof::certificate {

/// The theorems of one claim as a file for Coq, or the reason why there are none. Nothing here is
/// trusted: the file contains a statement and a proposed proof, and Coq's kernel accepts or rejects
/// it.
struct Certificate {
    std::string id;      ///< of the claim
    std::string verdict; ///< the verdict that `verify` gives
    /// The name of each theorem, and its statement in words.
    struct Theorem {
        std::string name;
        std::string states;
    };
    std::vector<Theorem> theorems; ///< empty: there is no file
    bool whole_verdict = false;    ///< the theorems state everything that the verdict does
    std::string leaves_out;        ///< the part that is not stated, or why there is no theorem
    std::string file;              ///< the file's name: "EQ18.v"
    std::string text;              ///< the file's content
};

/// Returns the theorems that can be stated about a claim as printed (its readings are left out).
[[nodiscard]] Certificate certify(const audit::ClaimResult& result, const audit::Ledger& ledger);

/// Returns the name in Coq for an id: "EQ30_L" for "EQ30.L".
[[nodiscard]] std::string coq_name(const std::string& id);

} // namespace edgeproof::certificate
