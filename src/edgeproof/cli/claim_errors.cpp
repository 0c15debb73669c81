// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/claim_errors.hpp"

#include <cstdio>

namespace edgeproof::cli {

int report_claim_errors(const std::vector<audit::ClaimError>& errors) {
    std::fflush(stdout);
    for (const audit::ClaimError& e : errors) {
        std::fprintf(stderr, "%s\n", e.error.what());
    }
    return errors.empty() ? 0 : 2;
}

} // namespace edgeproof::cli
