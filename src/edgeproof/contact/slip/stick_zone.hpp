// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/zone_equations.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace edgeproof::contact {

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
    /// Return the integrals over `zone` (length).
    [[nodiscard]] virtual ZoneValues values(const BallZone& zone) const = 0;
    [[nodiscard]] virtual ZoneRates rates(const BallZone& zone) const = 0;
    [[nodiscard]] ZoneEquations equations(const Ball& force, const Ball& tilt) const;
    /// Returns the pressure (stress) of that contact at the distance `u` inwards from an edge of
    /// the zone (length); `x`: the place, if it is known exactly (ProvedContact::pressure).
    [[nodiscard]] virtual Ball pressure(const BallZone& zone, Edge edge, const Ball& u,
                                        const std::optional<Exact>& x) const = 0;
    /// Returns the zone for a force and a tilt, proved. Throws BudgetError where the bits do not
    /// isolate it (or an edge is on a corner).
    /// @param force force/length
    /// @param tilt slope
    /// @param near a zone that contains it, from which the search begins
    [[nodiscard]] virtual BallZone zone(const Ball& force, const Ball& tilt,
                                        const BallZone& near) const;
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
