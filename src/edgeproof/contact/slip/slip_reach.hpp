// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/slip/ball_slip.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/rational.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// The load ratio |Q|/(f P) up to which the first n terms of a slip zone's size stay within a
/// tolerance of it.
struct EnclosedReach {
    Ball ratio;         ///< 1 where they do so up to full sliding
    bool leaves = true; ///< false: up to full sliding
};

/// Finds that load ratio, and proves that there is no earlier one (docs/partial-slip.md): from 0 on
/// every load ratio lies in an interval over which |d_n/d - 1| is below the tolerance, up to one in
/// which d_n/d is monotone and passes it. P and sigma_0/Q are held.
class SlipReachSearch {
public:
    /// The slip at so many bits; lives as long as the search.
    using Slip = std::function<const BallSlip&(long bits)>;
    /// d_n of n terms at an edge which slips from the first load on.
    SlipReachSearch(Slip slip, Edge edge, std::size_t n, formula::Exact tolerance);
    /// Throws BudgetError where it is not decided within the budget, or by so few bits.
    [[nodiscard]] EnclosedReach at(long bits);

    static constexpr std::size_t most_zones = 20'000;
    [[nodiscard]] std::size_t zones() const { return zones_; }

private:
    struct Place;
    class Error;
    void scan();
    [[nodiscard]] bool within_from_the_start(const Error& f, const Rational& tau) const;
    void count(std::size_t cost);

    Slip slip_;
    Edge edge_;
    std::size_t n_;
    formula::Exact tolerance_;
    std::size_t zones_ = 0;
    bool scanned_ = false;
    bool leaves_ = true;
    int side_ = 1; ///< of the tolerance that is passed
    Rational lo_;  ///< within up to here
    Rational hi_;  ///< beyond here, d_n/d being monotone from lo on
};

} // namespace edgeproof::contact
