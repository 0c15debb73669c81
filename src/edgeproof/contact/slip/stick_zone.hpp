// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

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
    /// E*/2 times the integral of sqrt((v+b)/(a-v)) dg' (right) or of its inverse (left): dP/da and
    /// dP/db along the contacts of one tilt (docs/mechanics.md). For a wide zone they enclose the
    /// values of all zones in it; not finite if an edge may lie on a corner.
    Ball right_rate;
    Ball left_rate;
    [[nodiscard]] const Ball& rate(Edge edge) const {
        return edge == Edge::right ? right_rate : left_rate;
    }
};

/// The contacts of the slopes g' + tilt under any force, in balls: they bound the stick zone in
/// partial slip (docs/partial-slip.md, "The corrective contact"). The zone for a force P and a tilt
/// solves F = P and mean slope = -tilt. There is at most one, because F and the mean slope are
/// monotone in a and in b.
class ZoneSolver {
public:
    /// For the profile of a contact, at its precision.
    explicit ZoneSolver(const ProvedContact& contact)
        : bits_(contact.bits()), modulus_(contact.modulus()) {}
    virtual ~ZoneSolver() = default;
    ZoneSolver(const ZoneSolver&) = delete;
    ZoneSolver(ZoneSolver&&) = delete;
    ZoneSolver& operator=(const ZoneSolver&) = delete;
    ZoneSolver& operator=(ZoneSolver&&) = delete;

    [[nodiscard]] long bits() const { return bits_; }
    /// E* (stress).
    [[nodiscard]] const Ball& modulus() const { return modulus_; }
    /// Returns the integrals over `zone` (length).
    [[nodiscard]] virtual ZoneValues values(const BallZone& zone) const = 0;
    /// Returns the pressure (stress) of that contact at the distance `u` inwards from an edge of
    /// the zone (length).
    [[nodiscard]] virtual Ball pressure(const BallZone& zone, Edge edge, const Ball& u) const = 0;
    /// Returns the zone for a force and a tilt, proved. Throws BudgetError where the bits do not
    /// isolate it (or an edge is on a corner).
    /// @param force force/length
    /// @param tilt slope
    /// @param near a zone that contains it, from which the search begins
    [[nodiscard]] virtual BallZone zone(const Ball& force, const Ball& tilt,
                                        const BallZone& near) const;
    /// Finds the zone by Newton's method on midpoints, which proves nothing.
    [[nodiscard]] BallZone search(const Ball& force, const Ball& tilt, const BallZone& near) const;
    /// Encloses the zone that a search has found. Throws BudgetError where the bits do not isolate
    /// it.
    [[nodiscard]] BallZone proved(const Ball& force, const Ball& tilt, const BallZone& found) const;
    /// Returns the coefficients of dP/da (force/length) at the radius a - d in powers of d, of an
    /// axisymmetric contact; none for plane contacts.
    [[nodiscard]] virtual std::vector<Ball> force_rates(const Ball& /*a*/,
                                                        std::size_t /*terms*/) const {
        return {};
    }
    /// The minimum of g', which every stick zone without a tilt contains.
    [[nodiscard]] virtual BallZone core() const { return {Ball(0, bits()), Ball(0, bits())}; }
    /// See ProvedContact::cost.
    [[nodiscard]] virtual std::size_t cost() const { return 1; }

private:
    long bits_;
    Ball modulus_;
};

/// Returns the solver for piecewise linear slopes, or for power laws without a tilt, in closed
/// form. `total_force`: that of the axisymmetric power law with the same pressure as `contact`.
[[nodiscard]] std::unique_ptr<ZoneSolver>
closed_form_zones(const BallContact& contact, const std::optional<Ball>& total_force = {});

} // namespace edgeproof::contact
