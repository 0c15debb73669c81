// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::conformance {

/// A failing row: the answer over the reference, and over what stands at the other edge.
struct FailingRow {
    std::size_t question;
    Real ratio;
    std::optional<Real> mirrored;
};

/// Whether the rows are ours times one number but 1, of the same edge or of the other one. The
/// number is the median ratio; the scatter about it says which factors with a name it may be, and
/// of those the nearest is named, others beside it. `named`: a factor with a name; else any.
[[nodiscard]] std::optional<Convention>
infer_factor(const std::string& of, const std::vector<FailingRow>& rows, bool named);

} // namespace edgeproof::conformance
