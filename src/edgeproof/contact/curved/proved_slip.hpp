// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/slip/ball_slip.hpp"
#include "edgeproof/contact/slip/stick_zone.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// The partial slip of a contact of any profile that balls enclose, at one precision: the contact,
/// the solver of its stick zone and the slip in one object. BallSlip defines the signs.
class ProvedSlip {
public:
    /// Throws BudgetError or DomainError if `bits` do not suffice to enclose the contact or its
    /// stick zone.
    /// @param profile g'(x)
    /// @param contact_modulus E* (stress)
    /// @param load the right edge (length) or the force (force/length)
    /// @param shear Q (force/length), not zero, and the bulk tension (stress)
    /// @param friction coefficient of friction
    /// @param bits working precision
    /// @param total_force the total force P of an axisymmetric power law; `profile` is then that of
    /// the plane contact with the same pressure, and Q a total force, too
    ProvedSlip(const Profile& profile, const Exact& contact_modulus, const Load& load,
               const ShearLoad<Ball>& shear, const Ball& friction, long bits,
               const std::optional<Ball>& total_force = {});

    [[nodiscard]] const BallSlip& slip() const { return *slip_; }
    [[nodiscard]] const ProvedContact& contact() const { return *contact_; }
    /// Returns q (stress) at the distance `u` from an edge (length); `x`: the place, if it is known
    /// exactly.
    [[nodiscard]] Ball traction(Edge edge, const Ball& u, const std::optional<Exact>& x) const {
        const Ball p = x ? contact_->pressure(edge, u, *x) : contact_->pressure(edge, u);
        return slip_->traction(edge, u, p, x);
    }

private:
    std::unique_ptr<ProvedContact> contact_;
    std::unique_ptr<ZoneSolver> zones_;
    std::optional<BallSlip> slip_; ///< keeps references to the two above
};

/// Returns the contact of a load, by a closed form if there is one, otherwise by rigorous
/// integration; the contact is axisymmetric if the profile is. Throws BudgetError if `bits` do not
/// suffice to enclose the edges.
[[nodiscard]] std::unique_ptr<ProvedContact>
proved_contact(const Profile& profile, const Exact& contact_modulus, const Load& load, long bits);

/// Returns the solver for the stick zones of a contact made by proved_contact() or of one with a
/// closed form. `tilted`: a bulk tension tilts the zones; `total_force`: see ProvedSlip.
[[nodiscard]] std::unique_ptr<ZoneSolver> zone_solver(const ProvedContact& contact,
                                                      const Profile& profile,
                                                      const Exact& contact_modulus, bool tilted,
                                                      const std::optional<Ball>& total_force = {});

/// Returns the solver for zones of any slope that IntegratedContact handles, by rigorous
/// integration. It keeps a copy of `contact`.
[[nodiscard]] std::unique_ptr<ZoneSolver> integrated_zones(const IntegratedContact& contact);

/// The parts of the traction of partial slip, or after a load history, as contacts: by rigorous
/// integration for curved slopes and for power laws under a bulk tension.
struct TractionParts {
    /// The zone of a part of q, and its factor (BallSlip::parts).
    struct Part {
        std::shared_ptr<const PlaneContact> zone;
        Ball ratio;
    };
    /// @param slip the state, which does not slide
    /// @param contact the plane contact
    /// @param profile g'(x) of it
    /// @param contact_modulus E* (stress)
    /// @param tilted true if a bulk tension tilts the zones
    TractionParts(const BallSlip& slip, const PlaneContact& contact, const Profile& profile,
                  const Exact& contact_modulus, bool tilted);

    /// The Cauchy integral of q. Enclosed. `p` is that of the pressure at the same place; `x`: see
    /// ProvedContact::pressure.
    [[nodiscard]] CauchyIntegral integral(const CauchyIntegral& p, const Box& zeta,
                                          const std::optional<Exact>& x = {}) const;
    /// The same for the potential of q.
    [[nodiscard]] SurfacePotential potential(const SurfacePotential& p, const Ball& x,
                                             const std::optional<Exact>& known) const;

    Ball whole_ratio;
    std::vector<Part> parts;
};

} // namespace edgeproof::contact
