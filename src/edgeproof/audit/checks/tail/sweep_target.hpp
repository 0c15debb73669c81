// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::audit {

/// Where a list of values goes, as far as the list shows: the end of the values that `along` means.
class SweepTarget {
public:
    /// To 0 where each value is at most half of the one before, to infinity where each is at least
    /// twice that. Else to the simplest number (a multiple of one of `units`, of 1 or of pi) to
    /// which the distance falls at least twofold at each step. Nothing where no number fits, or
    /// where two do.
    [[nodiscard]] static std::optional<SweepTarget> of(const std::vector<formula::Exact>& listed,
                                                       const std::vector<formula::Exact>& units);

    [[nodiscard]] bool is_infinite() const { return kind_ == Kind::infinity; }
    /// "0", "infinity", "3/7".
    [[nodiscard]] std::string text() const;
    /// The value that is 10^decades times as near to the target as the last one listed, times a
    /// factor between 1/2 and 1 that `which` draws: formulas such as sin(Pi/s) are special at
    /// powers of ten.
    [[nodiscard]] formula::Exact beyond(unsigned decades, std::size_t which) const;
    /// The last value listed is 10^-decades from the target, or 10^decades if that is infinity.
    [[nodiscard]] double decades() const { return decades_; }

private:
    enum class Kind { zero, infinity, finite };
    SweepTarget(Kind kind, formula::Expr at, const formula::Exact& last);
    Kind kind_;
    formula::Expr at_; ///< of a finite target
    formula::Exact last_;
    double decades_ = 0;
};

/// log10 |x|; nothing where x contains zero or is not finite. Only for where to look.
[[nodiscard]] std::optional<double> decades_of(const Ball& x);

} // namespace edgeproof::audit
