// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/side_search.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/slip/ball_slip.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <functional>
#include <optional>

namespace edgeproof::contact {

/// The load ratio |Q|/(f P) up to which the first n terms of the size of a slip zone stay within a
/// tolerance.
struct EnclosedReach {
    Ball ratio;         ///< 1 if they do so up to full sliding
    bool leaves = true; ///< false: within the tolerance up to full sliding
};

/// Finds that load ratio, and proves that there is no smaller one (docs/partial-slip.md, "How far n
/// terms are good: proved"): every load ratio from 0 on lies in an interval over which |d_n/d - 1|
/// is below the tolerance, up to one in which d_n/d is monotone and leaves it. P and sigma_0/Q are
/// held.
class SlipReachSearch {
public:
    /// Returns the slip at a precision of `bits`; the result lives as long as the search.
    using Slip = std::function<const BallSlip&(long bits)>;
    /// For an edge that slips from the first load.
    /// @param slip the slip
    /// @param edge the edge
    /// @param n number of terms
    /// @param tolerance relative tolerance
    SlipReachSearch(Slip slip, Edge edge, std::size_t n, Exact tolerance);
    /// Throws BudgetError where the budget or `bits` do not suffice.
    [[nodiscard]] EnclosedReach at(long bits);

    static constexpr std::size_t most_zones = 20'000;
    [[nodiscard]] std::size_t zones() const { return zones_; }

private:
    struct Place;
    class Error;
    /// Finds an interval in which the tolerance is left, or proves that there is none.
    void scan();
    /// Counts `cost` stick zones; throws BudgetError when the budget is used up.
    void count(std::size_t cost);

    Slip slip_;
    Edge edge_;
    std::size_t n_;
    Exact tolerance_;
    std::size_t zones_ = 0;
    bool scanned_ = false;
    std::optional<SidePiece> exit_; ///< where the tolerance is left
};

} // namespace edgeproof::contact
