// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::audit {

/// The limit of the values in `along`, as far as the list shows it.
class SweepTarget {
public:
    /// Returns 0 if each value is at most half of the previous one, and infinity if each is at
    /// least twice it. Otherwise returns the simplest number (a multiple of one of `units`, of 1 or
    /// of pi) from which the distance decreases at least by half at each step. Returns nothing if
    /// no number fits, or if two do.
    [[nodiscard]] static std::optional<SweepTarget> of(const std::vector<formula::Exact>& listed,
                                                       const std::vector<formula::Exact>& units);

    [[nodiscard]] bool is_infinite() const { return kind_ == Kind::infinity; }
    /// Returns "0", "infinity", "3/7", ...
    [[nodiscard]] std::string text() const;
    /// Returns a value 10^decades times as near to the target as the last listed one, times a
    /// factor between 1/2 and 1 chosen by `which`, as formulas such as sin(Pi/s) are special at
    /// powers of ten.
    [[nodiscard]] formula::Exact beyond(unsigned decades, std::size_t which) const;
    /// The distance of the last listed value from the target is 10^-decades; if the target is
    /// infinity, the value is 10^decades.
    [[nodiscard]] double decades() const { return decades_; }

private:
    enum class Kind { zero, infinity, finite };
    SweepTarget(Kind kind, formula::Expr at, const formula::Exact& last);
    Kind kind_;
    formula::Expr at_; ///< for a finite target
    formula::Exact last_;
    double decades_ = 0;
};

/// Returns log10 |x|; nothing if x contains zero or is not finite. Used only to choose where to
/// evaluate.
[[nodiscard]] std::optional<double> decades_of(const Ball& x);

} // namespace edgeproof::audit
