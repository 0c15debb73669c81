// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <memory>

namespace edgeproof::contact {

/// -b < x < a, in balls.
struct BallZone {
    Ball a;
    Ball b;
    [[nodiscard]] Ball length() const { return a + b; }
    [[nodiscard]] const Ball& at(Edge edge) const { return edge == Edge::right ? a : b; }
};

/// What a zone of the profile takes to be a contact.
struct ZoneValues {
    Ball force;      ///< F = (E*/2) integral of w dg'
    Ball mean_slope; ///< (1/pi) integral of g'/w ds: less the tilt
    /// E*/2 times the integral of sqrt((v+b)/(a-v)) dg' (right), or of its inverse (left): dP/da,
    /// dP/db along the contacts of one tilt. Of a wide zone they hold those of all in it; not
    /// finite where an edge may be on a corner.
    Ball right_rate;
    Ball left_rate;
    [[nodiscard]] const Ball& rate(Edge edge) const {
        return edge == Edge::right ? right_rate : left_rate;
    }
};

/// The contacts of the slopes g' + tilt under any force, in balls: they bound the stick zone of a
/// partial slip (docs/partial-slip.md). The zone of a force P and a tilt solves F = P and mean
/// slope = -tilt; there is one at most, as F and the mean slope are monotone in a and in b.
class ZoneSolver {
public:
    ZoneSolver() = default;
    virtual ~ZoneSolver() = default;
    ZoneSolver(const ZoneSolver&) = delete;
    ZoneSolver(ZoneSolver&&) = delete;
    ZoneSolver& operator=(const ZoneSolver&) = delete;
    ZoneSolver& operator=(ZoneSolver&&) = delete;

    [[nodiscard]] virtual long bits() const = 0;
    [[nodiscard]] virtual const Ball& modulus() const = 0;
    [[nodiscard]] virtual ZoneValues values(const BallZone& zone) const = 0;
    /// The pressure of that contact at the distance u inwards from an edge of the zone.
    [[nodiscard]] virtual Ball pressure(const BallZone& zone, Edge edge, const Ball& u) const = 0;
    /// Of a force and a tilt, proved; `near`: where the search begins, a zone that holds it. Throws
    /// BudgetError where the bits do not isolate it (or an edge is on a corner).
    [[nodiscard]] virtual BallZone zone(const Ball& force, const Ball& tilt,
                                        const BallZone& near) const;
    /// Newton's method on midpoints, which proves nothing.
    [[nodiscard]] BallZone search(const Ball& force, const Ball& tilt, const BallZone& near) const;
    /// The minimum of g', which every stick zone without a tilt holds.
    [[nodiscard]] virtual BallZone core() const { return {Ball(0, bits()), Ball(0, bits())}; }
    /// As ProvedPressure::cost.
    [[nodiscard]] virtual std::size_t cost() const { return 1; }
};

/// Piecewise linear slopes, and power laws without a tilt, in closed form.
[[nodiscard]] std::unique_ptr<ZoneSolver> closed_form_zones(const BallContact& contact);

} // namespace edgeproof::contact
