// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/audit_result.hpp"
#include "edgeproof/audit/ledger/ledger.hpp"

#include <string>
#include <vector>

namespace edgeproof::certificate {

/// A claim's theorems as a file for Coq, or why there are none. Nothing here is trusted: what is
/// written is a statement and a proposal for its proof, and Coq's kernel accepts it or does not.
struct Certificate {
    std::string id;      ///< of the claim
    std::string verdict; ///< that `verify` gives
    /// Name of each theorem, and what it states in words.
    struct Theorem {
        std::string name;
        std::string states;
    };
    std::vector<Theorem> theorems; ///< empty: there is no file
    bool whole_verdict = false;    ///< the theorems say all that the verdict does
    std::string leaves_out;        ///< of what the verdict rests on; or why there is no theorem
    std::string file;              ///< "EQ18.v"
    std::string text;              ///< of the file
};

/// What can be stated of a claim under its own words (readings are left out).
[[nodiscard]] Certificate certify(const audit::ClaimResult& result, const audit::Ledger& ledger);

/// "EQ30.L" as a name in Coq: "EQ30_L".
[[nodiscard]] std::string coq_name(const std::string& id);

} // namespace edgeproof::certificate
