// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/sample/audit_context.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace edgeproof::audit {

/// Returns the families of a ledger (without its claims) with one parameter of a family fixed.
/// Parameters that depend on it change, too.
[[nodiscard]] Ledger with_parameter(const Ledger& ledger, const std::string& family,
                                    const std::string& parameter, const Expr& value);

/// The samples of a claim at every listed value of the name in `along`, a parameter of the family
/// or a name of `vary`. Each sample except the last has the next one as its `next`.
struct Sweep {
    std::vector<std::string> values;
    std::vector<std::vector<Sample>> samples; ///< at each value
};
[[nodiscard]] Sweep sweep_of(const Claim& claim, const AuditContext& context);

} // namespace edgeproof::audit
