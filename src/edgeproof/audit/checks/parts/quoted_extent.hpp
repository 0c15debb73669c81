// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/checks/parts/size_extents.hpp"
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::audit {

inline constexpr std::string_view size_extent_kind_name = "size-extent";

/// A quoted extent: the figure, and the quantity that it gives.
struct QuotedExtent {
    std::string id;
    std::string key; ///< everything except the scene on which the figure and its meaning depend
    ExtentOf of;
    std::optional<ExtentOf> over; ///< the divisor, if any
    Float128 lower;               ///< the numbers that round to the figure: lower end ...
    Float128 upper;               ///< ... and upper end (excluded)
    Rational figure;
    Rational unit; ///< one unit of its last place
    formula::Exact tolerance;
};

/// Reads the keys of a claim of the kind `size-extent`. Throws InputError for values that are not
/// possible.
[[nodiscard]] QuotedExtent read_quoted_extent(const Claim& claim);
/// Reads the other claims of this kind that the key `together` names.
[[nodiscard]] std::vector<QuotedExtent> companion_extents(const Claim& claim,
                                                          const AuditContext& context);
/// Returns the extent, or the quotient of two extents, of a contact under each reading.
[[nodiscard]] ContactsBySize::Fractions extents_of(const QuotedExtent& q,
                                                   ContactsBySize::At& contact);
/// Returns the same values with less accuracy.
[[nodiscard]] ContactsBySize::Fractions rough_extents_of(const QuotedExtent& q,
                                                         ContactsBySize::At& contact);

} // namespace edgeproof::audit
