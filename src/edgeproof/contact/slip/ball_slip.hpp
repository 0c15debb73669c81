// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/proved_pressure.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/contact/law/slip_series.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/slip/stick_zone.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// Whether a traction is that of a place that sticks or slips.
enum class SlipState { stick, slip, undecided };

/// Partial slip of a contact in balls, proved (docs/partial-slip.md): P held, then Q and sigma_0
/// applied so that the stick zone only shrinks. q = f (p - p*) in the direction of Q, p* being the
/// pressure of the slope g' + sigma_0 sgn(Q)/(2 f E*) under the force P - |Q|/f, whose edges bound
/// the stick zone. Signs as in shear.hpp.
class BallSlip {
public:
    /// Keeps references to the contact and the zones, which are of one precision. `force`: P;
    /// `stick`: the stick zone, where it is enclosed already. Q must not be zero. Throws
    /// BudgetError where the bits do not isolate the stick zone; sliding() tells where there is
    /// none.
    BallSlip(const ProvedPressure& contact, const ZoneSolver& zones, const Ball& force,
             const ShearLoad<Ball>& load, const Ball& friction,
             const std::optional<BallZone>& stick = {});

    /// |Q|/(f P).
    [[nodiscard]] const Ball& load_ratio() const { return ratio_; }
    [[nodiscard]] const Ball& force() const { return force_; } ///< P
    [[nodiscard]] const Ball& friction() const { return friction_; }
    /// |Q| >= f P: no zone sticks.
    [[nodiscard]] bool sliding() const { return !stick_; }
    [[nodiscard]] const BallZone& stick() const { return *stick_; }
    /// d at an edge.
    [[nodiscard]] Ball size(Edge edge) const { return whole_.at(edge) - stick_->at(edge); }
    /// The stick zone of the load ratio tau, 0 < tau < 1, sigma_0/Q and P being the same.
    [[nodiscard]] BallZone stick_at(const Ball& tau, const BallZone& near) const;
    [[nodiscard]] const BallZone& whole() const { return whole_; }
    /// d's rate by tau over all the stick zones between two of them, the greater one first.
    [[nodiscard]] Ball rate_between(const BallZone& outer, const BallZone& inner, Edge edge) const;
    /// The sizes that a slip zone may have from the stick zone `from` on, up to full sliding.
    [[nodiscard]] Ball sizes_to_sliding(const BallZone& from, Edge edge) const;
    /// s_0 at the edge is in the direction of Q, so that it slips that way from the first load on:
    /// then the stick zone shrinks at this edge while Q and sigma_0 grow in proportion.
    [[nodiscard]] bool slips_from_the_first(Edge edge) const;
    /// The places beyond which sigma_0 may not lie with this Q: where the stick zone reaches the
    /// left edge of the contact (from above, for Q > 0) and the right one.
    [[nodiscard]] Ball tension_limit(Edge edge) const;

    [[nodiscard]] SlipState state(Edge edge, const Ball& u) const;
    /// q at the distance u from an edge, p being the pressure there.
    [[nodiscard]] Ball traction(Edge edge, const Ball& u, const Ball& p) const;
    /// kappa_1 ... kappa_terms (slip_series.hpp).
    [[nodiscard]] SlipSeries<Ball> series(std::size_t terms) const;
    [[nodiscard]] const ZoneSolver& zones() const { return zones_; }

private:
    [[nodiscard]] Ball tilt_at(const Ball& tau) const;

    const ProvedPressure& contact_;
    const ZoneSolver& zones_;
    BallZone whole_;
    Ball force_;
    Ball friction_;
    Ball direction_; ///< 1 or -1
    Ball over_Q_;    ///< sigma_0/Q
    Ball ratio_;
    std::optional<BallZone> stick_;
};

} // namespace edgeproof::contact
