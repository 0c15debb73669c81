// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof::contact {

/// A contact in balls whose pressure is enclosed at points, over intervals, and with its
/// derivatives: what a search needs that proves where an approximation is good (ball_extent.hpp).
class ProvedPressure {
public:
    virtual ~ProvedPressure() = default;

    [[nodiscard]] virtual long bits() const = 0;
    [[nodiscard]] virtual const Ball& a() const = 0;
    [[nodiscard]] virtual const Ball& b() const = 0;
    /// p at the distance u from an edge. Not finite when the ball of x meets a corner.
    [[nodiscard]] virtual Ball pressure(Edge edge, const Ball& u) const = 0;
    /// A ball whose lower end no pressure over u is below, finite where the ball of x meets a
    /// corner.
    [[nodiscard]] virtual Ball least_pressure(Edge edge, const Ball& u) const = 0;
    /// p(u + z) in powers of z: coefficients that hold for every u of a ball, so that the last one
    /// bounds Taylor's remainder over it. Not finite when the ball of x meets a knot.
    [[nodiscard]] virtual BallSeries pressure_series(Edge edge, const Ball& u,
                                                     std::size_t order) const = 0;
    /// The distances of the corners, where p is infinite.
    [[nodiscard]] virtual std::vector<Ball> corners(Edge edge) const = 0;
    /// p/sqrt(u) has a power series at least up to this distance from the edge; zero where none
    /// is shown.
    [[nodiscard]] virtual Ball reach(Edge edge) const = 0;
    /// M with |c_k| <= M/rho^k for all k, 0 < rho < reach.
    [[nodiscard]] virtual Ball majorant(Edge edge, const Ball& rho) const = 0;
    /// c_0 ... c_{terms-1} at an edge, each enclosed; not finite where the edge may be on a knot.
    [[nodiscard]] virtual std::vector<Ball> expansion(Edge edge, std::size_t terms) const = 0;

    /// What one enclosure over an interval takes, in those of a closed form, roughly: searches have
    /// a budget of the latter.
    [[nodiscard]] virtual std::size_t cost() const { return 1; }

protected:
    ProvedPressure() = default;
    ProvedPressure(const ProvedPressure&) = default;
    ProvedPressure(ProvedPressure&&) = default;
    ProvedPressure& operator=(const ProvedPressure&) = default;
    ProvedPressure& operator=(ProvedPressure&&) = default;
};

} // namespace edgeproof::contact
