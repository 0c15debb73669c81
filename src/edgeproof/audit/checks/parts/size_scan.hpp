// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/family.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/arithmetic.hpp"

#include <functional>
#include <string>
#include <vector>

namespace edgeproof::audit {

/// Contact sizes a, where a paper gives none. They are searched in binary128, whatever digits an
/// audit asks for: ends are good to about 14 digits and are the same on every machine.
struct SizeInterval {
    Float128 from;
    Float128 to;
    bool open_below = false; ///< it begins where the search began
    bool open_above = false; ///< it ends where the search ended
};

/// The scene with another right edge a; all its other parameters stay.
[[nodiscard]] SceneSpec with_size(SceneSpec scene, const Float128& a);

/// Disjoint and ascending.
using SizeSet = std::vector<SizeInterval>;

[[nodiscard]] SizeSet intersection(const SizeSet& x, const SizeSet& y);
/// "1.23456789012 ... 2.5; 7.5 ... end of the search": each end to so many digits.
[[nodiscard]] std::string to_text(const SizeSet& set, unsigned digits = 12);
/// One size.
[[nodiscard]] std::string to_text(const Float128& a, unsigned digits = 12);
/// One interval from one end of the search to the other.
[[nodiscard]] bool is_everything(const SizeSet& set);

/// Sizes between two given ones, split where an edge meets a knot of the profile: there, functions
/// of the size are not smooth, and the search goes near from both sides.
class SizeScan {
public:
    /// Throws InputError unless 0 < from < to.
    SizeScan(const contact::Profile& profile, const formula::Exact& from, const formula::Exact& to,
             int per_decade = 8);

    using Function = std::function<Float128(const Float128& a)>;
    using Test = std::function<bool(const Float128& a)>;

    /// Where the search looks first: ascending, its ends included, no knot among them.
    [[nodiscard]] const std::vector<Float128>& sizes() const noexcept { return sizes_; }
    /// Sizes at which an edge is on a knot.
    [[nodiscard]] const std::vector<Float128>& breaks() const noexcept { return breaks_; }
    /// Where lower <= f(a) < upper. `at_sizes`: f at sizes(). Between neighbouring sizes f is taken
    /// to cross each bound once at most, beyond extrema that three sizes in a row betray: sampled,
    /// not proved. A jump of f counts as a crossing.
    [[nodiscard]] SizeSet between(const Function& f, const std::vector<Float128>& at_sizes,
                                  const Float128& lower, const Float128& upper) const;
    /// Where a test holds, likewise.
    [[nodiscard]] SizeSet where(const Test& test) const;

private:
    [[nodiscard]] SizeSet joined(bool inside, std::vector<Float128> ends) const;
    std::vector<Float128> sizes_;
    std::vector<Float128> breaks_;
};

} // namespace edgeproof::audit
