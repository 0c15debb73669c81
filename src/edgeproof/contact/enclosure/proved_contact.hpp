// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::contact {

class BallContact;

/// A contact in balls whose pressure is enclosed at points, over intervals, and with its
/// derivatives: the interface for searches that prove where an approximation is good
/// (ball_extent.hpp).
/// Lengths in one unit; pressures in the unit of the contact modulus.
class ProvedContact {
public:
    virtual ~ProvedContact() = default;

    [[nodiscard]] virtual long bits() const = 0;
    [[nodiscard]] virtual const Ball& a() const = 0;
    [[nodiscard]] virtual const Ball& b() const = 0;
    /// The distance of an edge from the origin (length), if it is given or proved exactly.
    [[nodiscard]] virtual std::optional<formula::Exact> known(Edge edge) const = 0;
    /// True if an edge that is not known exactly may lie on a knot at this number of bits.
    [[nodiscard]] virtual bool edge_may_be_on_knot() const = 0;
    /// The normal force P per unit length.
    [[nodiscard]] virtual Ball force() const = 0;
    /// The moment of p about the origin (moore-hills EQ22).
    [[nodiscard]] virtual Ball moment() const = 0;
    /// p at a distance from an edge that is known exactly.
    [[nodiscard]] virtual Ball pressure(Edge edge, const formula::Exact& u) const = 0;
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

    /// The contact as one with a closed form; null for a curved slope.
    [[nodiscard]] virtual const BallContact* closed_form() const { return nullptr; }
    /// The approximate cost of one enclosure over an interval; that of a closed form is 1. The
    /// budgets of searches are in this unit.
    [[nodiscard]] virtual std::size_t cost() const { return 1; }

protected:
    ProvedContact() = default;
    ProvedContact(const ProvedContact&) = default;
    ProvedContact(ProvedContact&&) = default;
    ProvedContact& operator=(const ProvedContact&) = default;
    ProvedContact& operator=(ProvedContact&&) = default;
};

} // namespace edgeproof::contact
