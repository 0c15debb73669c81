// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof::contact {

/// A contact in balls whose pressure is enclosed at points, over intervals, and with its
/// derivatives: the interface for searches that prove where an approximation is good
/// (ball_extent.hpp).
/// Lengths in one unit; pressures in the unit of the contact modulus.
class ProvedPressure {
public:
    virtual ~ProvedPressure() = default;

    [[nodiscard]] virtual long bits() const = 0;
    [[nodiscard]] virtual const Ball& a() const = 0;
    [[nodiscard]] virtual const Ball& b() const = 0;
    /// p at the distance u from an edge. Not finite if the ball of x contains a corner.
    [[nodiscard]] virtual Ball pressure(Edge edge, const Ball& u) const = 0;
    /// A ball whose lower end is a lower bound of the pressure over u; finite also if the ball of x
    /// contains a corner.
    [[nodiscard]] virtual Ball least_pressure(Edge edge, const Ball& u) const = 0;
    /// p(u + z) in powers of z. The coefficients hold for every u of the ball, so that the last one
    /// bounds Taylor's remainder over it. Not finite if the ball of x contains a knot.
    [[nodiscard]] virtual BallSeries pressure_series(Edge edge, const Ball& u,
                                                     std::size_t order) const = 0;
    /// The distances of the corners from the edge. There p is infinite.
    [[nodiscard]] virtual std::vector<Ball> corners(Edge edge) const = 0;
    /// A distance from the edge up to which p/sqrt(u) is proved to have a power series; zero if
    /// there is no proof.
    [[nodiscard]] virtual Ball reach(Edge edge) const = 0;
    /// M with |c_k| <= M/rho^k for all k, 0 < rho < reach.
    [[nodiscard]] virtual Ball majorant(Edge edge, const Ball& rho) const = 0;
    /// c_0 ... c_{terms-1} at an edge, each enclosed; not finite if the edge may lie on a knot.
    [[nodiscard]] virtual std::vector<Ball> expansion(Edge edge, std::size_t terms) const = 0;

    /// The approximate cost of one enclosure over an interval; that of a closed form is 1. The
    /// budgets of searches are in this unit.
    [[nodiscard]] virtual std::size_t cost() const { return 1; }

protected:
    ProvedPressure() = default;
    ProvedPressure(const ProvedPressure&) = default;
    ProvedPressure(ProvedPressure&&) = default;
    ProvedPressure& operator=(const ProvedPressure&) = default;
    ProvedPressure& operator=(ProvedPressure&&) = default;
};

} // namespace edgeproof::contact
