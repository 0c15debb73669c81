// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <functional>
#include <optional>

namespace edgeproof::contact {

/// -b < x < a, in balls.
struct BallZone {
    Ball a;
    Ball b;
    [[nodiscard]] Ball length() const { return a + b; }
    [[nodiscard]] const Ball& at(Edge edge) const { return edge == Edge::right ? a : b; }
};

/// The integrals that decide which zone of the profile is a contact (docs/partial-slip.md, "The
/// corrective contact").
struct ZoneValues {
    Ball force;      ///< F = (E*/2) integral of w dg'
    Ball mean_slope; ///< (1/pi) integral of g'/w ds: minus the tilt
};

/// E*/2 times the integral of sqrt((v+b)/(a-v)) dg' (right) or of its inverse (left): dP/da and
/// dP/db along the contacts of one tilt (docs/mechanics.md). For a wide zone they enclose the
/// values of all zones in it; not finite if an edge may lie on a corner.
struct ZoneRates {
    Ball right;
    Ball left;
    [[nodiscard]] const Ball& at(Edge edge) const { return edge == Edge::right ? right : left; }
};

/// The equations of a zone -b < x < a: its mean slope is minus the tilt, and it carries a force or
/// ends at a given right edge. The edges of a contact are such a zone (tilt 0), and the stick zone
/// in partial slip is one. There is at most one, because F and the mean slope are monotone in a and
/// in b. All members use the precision of the modulus.
struct ZoneEquations {
    std::function<ZoneValues(const BallZone&)> values;
    std::function<ZoneRates(const BallZone&)> rates;
    Ball modulus; ///< E* (stress)
    Ball tilt;
    std::optional<Ball> force;      ///< force/length
    std::optional<Ball> right_edge; ///< a, if the force is not given
    bool symmetric = false;         ///< b = a

    /// Finds the zone by Newton's method on midpoints, from a start near it or from a zone that
    /// contains it; it proves nothing. Throws BudgetError if it finds none.
    [[nodiscard]] BallZone search(const BallZone& start) const;
    /// Encloses the zone that a search has found. Throws BudgetError where the bits do not isolate
    /// it, or an edge is on a corner.
    [[nodiscard]] BallZone proved(const BallZone& found) const;

    /// A search edge by edge, for which nothing need be known: a is sought by its distance from
    /// `a_from`; b by its distance from `b_from`, or from -a. `first`: the first distance.
    struct Distances {
        Ball a_from;
        std::optional<Ball> b_from;
        Ball first;
    };
    /// Throws DomainError if there is no such zone however far out.
    /// @param distances see there
    /// @param accuracy of the distances, in bits; it may be as large as half of those of the balls
    [[nodiscard]] BallZone from_afar(const Distances& distances, long accuracy) const;

private:
    [[nodiscard]] ZoneRates differences(const BallZone& zone) const;
    [[nodiscard]] Ball turn(const ZoneValues& v) const;
};

} // namespace edgeproof::contact
