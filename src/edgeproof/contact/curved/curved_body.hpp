// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"
#include "edgeproof/precision/ball/complex_box.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// An axisymmetric contact whose slope g'(r) has curved pieces, in ball arithmetic
/// (docs/axisymmetric.md, "Curved slopes"). delta, P and h' are integrals of g' over r, and the
/// pressure is an integral of h' over s, each by Arb's rigorous integration (`johansson2018`). g'
/// must be analytic on each piece, ends included; otherwise the values are not finite. The proofs
/// need a g' that does not decrease (curved_slope.hpp). The pressure is enclosed at points
/// only: over a wide ball, and its series, are not finite.
class CurvedBody : public RoundContact {
public:
    /// The radius r >= 0 (length) of a knot at which g' is not analytic on a piece, so that no
    /// value is enclosed; nothing if there is none.
    [[nodiscard]] static std::optional<Exact> not_analytic_at(const Profile& profile);

    /// Throws BudgetError where `bits` do not suffice to enclose the radius.
    /// @param profile g'(r), symmetric
    /// @param contact_modulus E* (stress)
    /// @param load the radius a (length), the total force P (force) or the approach delta (length)
    /// @param bits working precision
    CurvedBody(const Profile& profile, const Exact& contact_modulus, const Load& load, long bits);

    [[nodiscard]] Ball pressure(Edge edge, const Exact& u) const override;
    [[nodiscard]] Ball pressure(Edge edge, const Ball& u) const override;
    [[nodiscard]] Ball least_pressure(Edge edge, const Ball& u) const override {
        return pressure(edge, u);
    }
    [[nodiscard]] BallSeries pressure_series(Edge edge, const Ball& u,
                                             std::size_t order) const override;
    [[nodiscard]] Ball reach(Edge edge) const override;
    [[nodiscard]] Ball majorant(Edge edge, const Ball& rho) const override;
    [[nodiscard]] std::vector<Ball> force_rates(std::size_t terms) const override;
    [[nodiscard]] std::unique_ptr<RoundContact> resized(const Ball& a) const override;
    [[nodiscard]] Ball minimum_end() const override;
    [[nodiscard]] Ball gap_beyond(const Ball& beyond) const override;
    [[nodiscard]] Ball loop_integral(const Ball& from, const Ball& tau) const override;
    [[nodiscard]] std::size_t cost() const override { return 100; }
    /// The integral of f(L) ds/s over from < s < to, where L (force/length) is the force of the
    /// plane contact of the same profile with the half width s: both have the same integrals of g'.
    [[nodiscard]] Ball over_plane_widths(const Ball& from, const Ball& to,
                                         const std::function<Box(const Box& L)>& f) const;

private:
    /// A piece of g' begins at the radius v, with a jump of g'. The first one begins on the axis,
    /// where the jump is g'(0).
    struct Ring {
        Ball v;
        Ball jump;
        std::size_t knot;
    };
    enum class Integrand { slope, first_moment, moment, rate }; ///< g', r g', r^2 g', (r g')'
    /// A radius s, perhaps complex, that lies beyond the first rings.
    struct Radius {
        Box s;
        std::vector<Box> y; ///< sqrt(s^2 - v^2) of each of these rings
    };
    [[nodiscard]] Radius radius(const Ball& s) const;
    /// s^2 = A^2 + w^2 beyond the rings that are not beyond A; `on` is the ring at A itself.
    [[nodiscard]] Radius radius(const Ball& A, std::optional<std::size_t> on, const Box& w) const;
    /// s = a + z.
    [[nodiscard]] Radius radius_near_edge(const Box& z) const;
    [[nodiscard]] Box value(std::size_t ring, const Box& r, Integrand of) const;
    /// (r g')'/r near the axis, for g'(0) = 0.
    [[nodiscard]] Box rate_over_radius(const Box& r) const;
    /// The integral of f/sqrt(s^2 - r^2) over 0 < r < s to `accuracy` bits. A wide s gives a coarse
    /// enclosure.
    [[nodiscard]] Box over_rings(const Radius& at, Integrand of, long accuracy) const;
    /// A radius near the one at which the integral, times s for the slope, is `given`. It proves
    /// nothing.
    [[nodiscard]] Ball near_radius(const Ball& given, Integrand of) const;
    /// h'(s)/s before the second ring, for g'(0) = 0.
    [[nodiscard]] Box rate_over_radius_at(const Box& s) const;
    /// h'(s) without the jump of the ring `except`.
    [[nodiscard]] Box approach_rate(const Radius& at, std::optional<std::size_t> except) const;
    [[nodiscard]] Start start_for(Load::Kind kind, const Ball& given) const override;
    [[nodiscard]] Ball approach_rate_at(const Ball& s) const override;
    [[nodiscard]] Ball approach_at(const Ball& s) const override;
    [[nodiscard]] Ball force_at(const Ball& s) const override;
    /// True if g' does not change at a ring nor in the piece after it.
    [[nodiscard]] bool begins_flat(const Ring& ring) const;
    /// The integral of h'(s)/sqrt(s^2 - r^2) over A < s < sqrt(A^2 + W^2), A >= r.
    [[nodiscard]] Ball over_width(const Ball& r, const Ball& A, std::optional<std::size_t> on,
                                  bool from_r, const Ball& W) const;
    /// The same from s = r up to sqrt(r^2 + W^2), before the second ring, for a ball of r that
    /// contains the axis.
    [[nodiscard]] Ball over_axis(const Ball& r, const Ball& W) const;
    [[nodiscard]] Ball pressure_at(const Ball& u, const Ball& other, const Ball& r,
                                   std::optional<std::size_t> on) const;
    /// The integral of h'(s) f(s, sqrt(to^2 - s^2)) over from < s < to = from + beyond; `on` is the
    /// ring at `from`. A ring in the ball of `to` is left out.
    [[nodiscard]] Ball
    over_approach(const Ball& from, std::optional<std::size_t> on, const Ball& beyond,
                  const std::function<Box(const Radius& at, const Box& depth)>& f,
                  const Ball& scale) const;
    [[nodiscard]] std::vector<Ball> approach_rates(std::size_t terms) const override;
    /// A bound of |h'(s)| for |s - a| <= rho; not finite if none is found.
    [[nodiscard]] Ball most_rate(const Ball& rho) const;

    std::vector<Ring> rings_; ///< ascending
};

} // namespace edgeproof::contact
