// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/family.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/arithmetic.hpp"

#include <functional>
#include <string>
#include <vector>

namespace edgeproof::audit {

/// An interval of contact sizes a, for claims whose source gives no size. Sizes are searched in
/// binary128, independently of the digits of the audit: ends are right to about 14 digits and are
/// the same on every machine.
struct SizeInterval {
    Float128 from;
    Float128 to;
    bool open_below = false; ///< it begins where the search began
    bool open_above = false; ///< it ends where the search ended
};

/// Returns the scene with another right edge a and the same other parameters.
[[nodiscard]] SceneSpec with_size(SceneSpec scene, const Float128& a);

/// Disjoint intervals in ascending order.
using SizeSet = std::vector<SizeInterval>;

[[nodiscard]] SizeSet intersection(const SizeSet& x, const SizeSet& y);
/// Returns "1.23456789012 ... 2.5; 7.5 ... end of the search", each end with `digits` digits.
[[nodiscard]] std::string to_text(const SizeSet& set, unsigned digits = 12);
[[nodiscard]] std::string to_text(const Float128& a, unsigned digits = 12);
/// True for a single interval from one end of the search to the other.
[[nodiscard]] bool is_everything(const SizeSet& set);

/// The sizes between two given ones, split where an edge meets a knot of the profile: functions of
/// the size are not smooth there, and the search approaches it from both sides.
class SizeScan {
public:
    /// Throws InputError unless 0 < from < to.
    SizeScan(const contact::Profile& profile, const formula::Exact& from, const formula::Exact& to,
             int per_decade = 8);

    using Function = std::function<Float128(const Float128& a)>;
    using Test = std::function<bool(const Float128& a)>;

    /// The first sizes tried: ascending, with the ends of the range, without sizes at a knot.
    [[nodiscard]] const std::vector<Float128>& sizes() const noexcept { return sizes_; }
    /// The sizes at which an edge is on a knot.
    [[nodiscard]] const std::vector<Float128>& breaks() const noexcept { return breaks_; }
    /// Adds the range (as the texts of a claim's `sizes`), the number of sizes and the breaks.
    void describe(const std::vector<std::string>& range, Evidence& evidence) const;
    /// Returns the set where lower <= f(a) < upper. `at_sizes`: f at sizes(). Between neighbouring
    /// sizes, f is assumed to cross each bound at most once, except near extrema indicated by three
    /// successive sizes: sampled, not proved. A jump of f counts as a crossing.
    [[nodiscard]] SizeSet between(const Function& f, const std::vector<Float128>& at_sizes,
                                  const Float128& lower, const Float128& upper) const;
    /// Returns the set where a test holds, in the same way.
    [[nodiscard]] SizeSet where(const Test& test) const;

private:
    [[nodiscard]] SizeSet joined(bool inside, std::vector<Float128> ends) const;
    std::vector<Float128> sizes_;
    std::vector<Float128> breaks_;
};

} // namespace edgeproof::audit
