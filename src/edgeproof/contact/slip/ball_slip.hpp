// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/proved_contact.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/slip/stick_zone.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// The sizes of the slip zones as power series in the load ratio tau = |Q|/(f P), with P and
/// sigma_0/Q held: d = kappa_1 tau + kappa_2 tau^2 + ... (lengths); element 0 is kappa_1.
struct SlipSeries {
    std::vector<Ball> right;
    std::vector<Ball> left;
};

/// The first `terms` coefficients at both edges, enclosed, from the expansions of p there
/// (docs/partial-slip.md, "The series"). `right` and `left` are the coefficients c_0, c_1, ... of
/// p, at least `terms` of each; `length` D = a + b; `lead` = 2 P/(pi sqrt(D)); `tension` =
/// P (sigma_0/Q)/(4 sqrt(D)). The first term gives d_1 = 2 s_0/(f c_0). The work grows like
/// terms^4.
[[nodiscard]] SlipSeries slip_series(const std::vector<Ball>& right, const std::vector<Ball>& left,
                                     const Ball& length, const Ball& lead, const Ball& tension,
                                     std::size_t terms);

/// The sum of the first n terms at the load ratio tau, by Horner's rule (a length).
[[nodiscard]] Ball slip_sum(const std::vector<Ball>& kappa, std::size_t n, const Ball& tau);

/// The state of a place: it sticks or slips.
enum class SlipState { stick, slip, undecided };

/// A part of q: `ratio` times the pressure of the zone as a contact (docs/partial-slip.md,
/// docs/histories.md).
struct ShearPart {
    Ball ratio;
    BallZone zone;
};

/// The end of a layer of a load history: q grows by `ratio` dp up to the force `force`.
struct ShearLayer {
    Ball force;
    Ball ratio;
};

/// Partial slip of a contact in balls, proved (docs/partial-slip.md): P is held, then Q and sigma_0
/// are applied such that the stick zone only shrinks. q = f (p - p*) in the direction of Q, where
/// p* is the pressure of the slope g' + sigma_0 sgn(Q)/(2 f E*) under the force P - |Q|/f, whose
/// edges bound the stick zone. Signs as in shear.hpp.
class BallSlip {
public:
    /// Keeps references to the contact and the zones, which have one precision. Throws BudgetError
    /// where the bits do not isolate the stick zone. There is none if the contact slides, or if
    /// the bulk tension moves it beyond an edge: see sliding() and beyond().
    /// @param contact the contact
    /// @param zones the solver of its stick zone
    /// @param force P (force/length)
    /// @param load Q (force/length), not zero, and sigma_0 (stress)
    /// @param friction coefficient of friction
    /// @param stick the stick zone (length), if it is already enclosed
    BallSlip(const ProvedContact& contact, const ZoneSolver& zones, const Ball& force,
             const ShearLoad<Ball>& load, const Ball& friction,
             const std::optional<BallZone>& stick = {});
    /// The state after a history of P and Q without a bulk tension (docs/histories.md). Keeps
    /// references to the contact and the zones. Throws BudgetError where the bits do not isolate a
    /// zone.
    /// @param contact the contact
    /// @param zones the solver of its zones
    /// @param friction coefficient of friction
    /// @param Q the shear force (force/length)
    /// @param layers by ascending force; the last one ends at P
    /// @param stick the force of the zone that stuck in the last step; empty if nothing slipped
    BallSlip(const ProvedContact& contact, const ZoneSolver& zones, const Ball& Q,
             const Ball& friction, const std::vector<ShearLayer>& layers,
             const std::optional<Ball>& stick);

    /// |Q|/(f P).
    [[nodiscard]] const Ball& load_ratio() const { return ratio_; }
    [[nodiscard]] const Ball& force() const { return force_; } ///< P
    [[nodiscard]] const Ball& friction() const { return friction_; }
    /// |Q| >= f P: nothing sticks.
    [[nodiscard]] bool sliding() const { return !stick_ && !beyond_; }
    /// True unless the contact is proved to slide, or an edge of the stick zone to lie outside it.
    [[nodiscard]] bool admissible() const { return stick_ && !beyond_; }
    /// The edge beyond which the bulk tension moves the stick zone: it would slip against Q.
    [[nodiscard]] std::optional<Edge> beyond() const { return beyond_; }
    /// Only of an admissible state.
    [[nodiscard]] const BallZone& stick() const { return *stick_; }
    /// q is the sum of these parts and of whole_ratio() times p. Empty if the contact slides.
    [[nodiscard]] const std::vector<ShearPart>& parts() const { return parts_; }
    [[nodiscard]] const Ball& whole_ratio() const { return whole_ratio_; }
    /// The size d of the slip zone at an edge (length); only of an admissible state.
    [[nodiscard]] Ball size(Edge edge) const {
        return sticks_ ? Ball(0, zones_.bits()) : whole_.at(edge) - stick_->at(edge);
    }
    /// Returns the stick zone for the load ratio `tau`, 0 < tau < 1, with the same P and sigma_0/Q;
    /// the search begins at `near`.
    [[nodiscard]] BallZone stick_at(const Ball& tau, const BallZone& near) const;
    [[nodiscard]] const BallZone& whole() const { return whole_; }
    /// Returns the derivative of d by tau over all stick zones between two, of which the first is
    /// the larger one.
    [[nodiscard]] Ball rate_between(const BallZone& outer, const BallZone& inner, Edge edge) const;
    /// Returns the sizes that a slip zone may have from the stick zone `from` up to full sliding.
    [[nodiscard]] Ball sizes_to_sliding(const BallZone& from, Edge edge) const;
    /// True if s_0 at the edge is in the direction of Q, so that the edge slips that way from the
    /// first load: then the stick zone shrinks at this edge while Q and sigma_0 increase in
    /// proportion.
    [[nodiscard]] bool slips_from_the_first(Edge edge) const;
    /// Returns the limit of sigma_0 (stress) for this Q, at which the stick zone reaches the left
    /// edge of the contact (the upper limit, for Q > 0) or the right one.
    [[nodiscard]] Ball tension_limit(Edge edge) const;

    /// Returns the state at the distance `u` from an edge of the contact (length).
    [[nodiscard]] SlipState state(Edge edge, const Ball& u) const;
    /// Returns q (stress) at the distance `u` from an edge (length), where the pressure is `p`;
    /// `x`: the place, if it is known exactly.
    [[nodiscard]] Ball traction(Edge edge, const Ball& u, const Ball& p,
                                const std::optional<Exact>& x) const;
    /// Returns kappa_1 ... kappa_terms (SlipSeries; of an axisymmetric contact
    /// docs/axisymmetric.md, "Partial slip").
    [[nodiscard]] SlipSeries series(std::size_t terms) const;
    [[nodiscard]] const ZoneSolver& zones() const { return zones_; }

private:
    /// Returns the tilt (slope) for the load ratio `tau`.
    [[nodiscard]] Ball tilt_at(const Ball& tau) const;
    /// Finds the edge beyond which the tension moves the stick zone.
    void look_beyond(const Ball& tension);

    const ProvedContact& contact_;
    const ZoneSolver& zones_;
    BallZone whole_;
    Ball force_;
    Ball friction_;
    Ball direction_; ///< 1 or -1
    Ball over_Q_;    ///< sigma_0/Q
    Ball ratio_;
    std::optional<BallZone> stick_;
    std::optional<Edge> beyond_;
    bool sticks_ = false; ///< nothing slipped in the last step of a history
    Ball whole_ratio_;    ///< of the whole contact
    std::vector<ShearPart> parts_;
};

} // namespace edgeproof::contact
