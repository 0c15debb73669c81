// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/proved_contact.hpp"
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"
#include "edgeproof/contact/enclosure/taylor_cover.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/contact/slip/stick_zone.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"
#include "edgeproof/precision/ball/complex_box.hpp"

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// An axisymmetric contact that is integrated, in ball arithmetic (docs/axisymmetric.md): x is the
/// radius r, a the radius of the contact, u = a - r; the left edge is the mirror image of the right
/// one. delta, P and h' are integrals of g' over r: of piecewise linear slopes elementary functions
/// (`sneddon1965`), else found by Arb's rigorous integration (`johansson2018`), as the pressure is,
/// an integral of h'. A curved slope must be analytic on each piece, ends included; otherwise the
/// values are not finite. Its pressure has no series over a ball that contains a knot or the axis.
/// The proofs need a g' that does not decrease (curved_slope.hpp).
class AxisymmetricContact : public ProvedContact {
public:
    /// The radius r >= 0 (length) of a knot at which g' is not analytic on a piece, so that no
    /// value is enclosed; nothing if there is none.
    [[nodiscard]] static std::optional<Exact> not_analytic_at(const Profile& profile);

    /// Throws BudgetError where `bits` do not suffice to enclose the radius.
    /// @param profile g'(r), symmetric
    /// @param contact_modulus E* (stress)
    /// @param load the radius a (length), the total force P (force) or the approach delta (length)
    /// @param bits working precision
    AxisymmetricContact(const Profile& profile, const Exact& contact_modulus, const Load& load,
                        long bits);

    /// The total force P (force).
    [[nodiscard]] Ball force() const override { return force_at(a_); }
    [[nodiscard]] Ball moment() const override { return {0, bits_}; }
    /// The approach delta of the bodies (length).
    [[nodiscard]] Ball approach() const { return approach_at(a_); }
    /// h'(s), the rate of the approach with the radius s (length).
    [[nodiscard]] Ball approach_rate_at(const Ball& s) const;
    /// dP/da (force/length).
    [[nodiscard]] Ball force_rate() const { return modulus_ * a_ * approach_rate_at(a_) * 2; }
    /// Returns the coefficients of dP/da (force/length) at the radius a - d in powers of d.
    [[nodiscard]] std::vector<Ball> force_rates(std::size_t terms) const;
    /// The radius (length) of the contact of the same profile under the total force P; the search
    /// begins at `start`.
    [[nodiscard]] Ball radius_for(const Ball& P, const Ball& start) const;
    /// The contact of the same profile with the radius `a` (length).
    [[nodiscard]] AxisymmetricContact with_radius(const Ball& a) const;
    /// The radius (length) at which g' begins to rise.
    [[nodiscard]] Ball minimum_end() const;
    /// True if g' jumps on the axis, where the pressure is then infinite.
    [[nodiscard]] bool has_apex() const {
        return on_axis(0) && !contains_zero(rings_.front().jump);
    }

    [[nodiscard]] Ball pressure(Edge edge, const Exact& u) const override;
    [[nodiscard]] Ball pressure(Edge edge, const Ball& u) const override;
    [[nodiscard]] Ball pressure(Edge edge, const Ball& u, const Exact& x) const override;
    [[nodiscard]] Ball least_pressure(Edge edge, const Ball& u) const override;
    [[nodiscard]] BallSeries pressure_series(Edge edge, const Ball& u,
                                             std::size_t order) const override;
    [[nodiscard]] Ball reach(Edge edge) const override;
    [[nodiscard]] Ball majorant(Edge edge, const Ball& rho) const override;
    [[nodiscard]] std::vector<Ball> expansion(Edge edge, std::size_t terms) const override;
    [[nodiscard]] std::size_t cost() const override { return 10; }

    /// The integral of h'(s) sqrt(s^2 - r^2) over r < s < a (length^2), for r > 0; `known`: r, if
    /// it is a number.
    [[nodiscard]] Ball outer_moment(const Ball& r, const std::optional<Exact>& known) const;
    /// The gap (length) between the bodies at the distance `beyond` >= 0 (length) outside the edge.
    [[nodiscard]] Ball gap_beyond(const Ball& beyond) const;
    /// Returns the integral of (1 - tau/2) P - L over the approach (force x length), where the
    /// force L grows from (1 - tau) P, at the radius `from` (length), to P.
    [[nodiscard]] Ball loop_integral(const Ball& from, const Ball& tau) const;
    /// The real part of the integral of h'(s) f(s, s^2) over 0 < s < a, for f as in `integral_of`
    /// (rigorous_integral.hpp), of `known` bits. `of_power(k)` is the integral of s^k f, where it
    /// is known in closed form.
    [[nodiscard]] Ball over_approach(const std::function<Box(const Box& s, const Box& s2)>& f,
                                     const std::function<Ball(long power)>& of_power = {},
                                     long known = std::numeric_limits<long>::max()) const;
    /// The integral of f(L) ds/s over from < s < to, where L (force/length) is the force of the
    /// plane contact of the same profile with the half width s: both have the same integrals of g'.
    [[nodiscard]] Ball over_plane_widths(const Ball& from, const Ball& to,
                                         const std::function<Box(const Box& L)>& f) const;

private:
    /// At the radius v g' rises by `jump`, and a piece begins; of a linear slope also the rate of
    /// g' grows, by `rate` (1/length). On the axis the jump is g'(0).
    struct Ring {
        Ball v;
        Ball jump;
        Ball rate;
        std::size_t knot;
    };
    enum class Integrand { slope, first_moment, moment, rate }; ///< g', r g', r^2 g', (r g')'
    /// A radius s, perhaps complex, that lies beyond the first rings.
    struct Radius {
        Box s;
        std::vector<Box> y; ///< sqrt(s^2 - v^2) of each of these rings
    };
    struct Place;
    [[nodiscard]] bool on_axis(std::size_t ring) const {
        return arb_is_zero(rings_[ring].v.data()) != 0;
    }
    [[nodiscard]] bool inside(std::size_t knot) const override;
    /// Finds the radius of a load.
    void find_radius(const Load& load);
    [[nodiscard]] Radius radius(const Ball& s) const;
    /// s^2 = A^2 + w^2 beyond the rings that are not beyond A; `on` is the ring at A itself.
    [[nodiscard]] Radius radius(const Box& A, std::optional<std::size_t> on, const Box& w) const;
    /// s^2 = A^2 + w2 beyond the rings before `end`; A may be a range that contains the last one.
    [[nodiscard]] Radius radius_beyond(const Box& A, std::size_t end, const Box& w2) const;
    /// s = a + z.
    [[nodiscard]] Radius radius_near_edge(const Box& z) const;
    /// arccos(v/s) of a ring.
    [[nodiscard]] Box angle(const Radius& at, std::size_t ring) const;
    /// The piece that begins at a knot, at the radius r.
    [[nodiscard]] Box value(std::size_t knot, const Box& r, Integrand of) const;
    /// (r g')'/r near the axis, for g'(0) = 0.
    [[nodiscard]] Box rate_over_radius(const Box& r) const;
    /// The integral of f/sqrt(s^2 - r^2) over 0 < r < s. A wide s gives a coarse enclosure.
    [[nodiscard]] Box over_rings(const Radius& at, Integrand of) const;
    /// h'(s)/s before the second ring, for g'(0) = 0.
    [[nodiscard]] Box rate_over_radius_at(const Box& s) const;
    /// h'(s) without the jump of the ring `except`, which is the last one before s.
    [[nodiscard]] Box approach_rate(const Radius& at, std::optional<std::size_t> except) const;
    /// The same without the jump of the last ring, directly.
    [[nodiscard]] Box smooth_rate(const Radius& at) const;
    /// One of the two functions above, by its series if enough values were computed. `variable`:
    /// sqrt(s^2 - v^2) of the last ring, in which it is analytic.
    [[nodiscard]] Box by_series(std::size_t function, const Box& variable,
                                const TaylorCover::Function& f) const;
    /// The force and the approach h for the radius s (length).
    [[nodiscard]] Ball force_at(const Ball& s) const;
    [[nodiscard]] Ball approach_at(const Ball& s) const;
    /// True if g' does not change at a ring nor in the piece after it; and if g' = h' = 0 up to it.
    [[nodiscard]] bool begins_flat(const Ring& ring) const;
    [[nodiscard]] bool is_flat_before(std::size_t ring) const;
    [[nodiscard]] Place place_of(Edge edge, const Ball& u) const;
    /// The place, on a ring if its x is known to be that of the ring.
    [[nodiscard]] Place on_ring(Place at, const Exact& x) const;
    [[nodiscard]] Ball pressure(const Place& at, bool least) const;
    /// The same of a linear slope, ring by ring; and the integral of h' by parts between the rings,
    /// with (s^2 - r^2)^(-1/2), or with its inverse.
    [[nodiscard]] Ball over_bends(const Place& at, bool least) const;
    [[nodiscard]] Box over_widths(const Place& at, const Box& r, bool moment, bool least) const;
    /// A part of it, over A < s < sqrt(A^2 + W^2), A >= r.
    [[nodiscard]] Box over_width(const Box& r, const Box& A, std::optional<std::size_t> on,
                                 bool from_r, const Box& W, bool moment) const;
    /// The same from s = r up to sqrt(r^2 + W^2), before the ring `end`, for a ball of r that
    /// contains the axis or the ring before it. `least`: a lower bound.
    [[nodiscard]] Ball over_start(const Ball& r, std::size_t end, const Ball& W, bool least) const;
    /// p/sqrt(a^2 - r^2) of a curved slope at a complex radius between two rings, or beyond the
    /// last one; and `order` coefficients of its Taylor series in r that hold for every r of a
    /// ball, empty if there is none.
    [[nodiscard]] Box pressure_over_root(const Box& r) const;
    [[nodiscard]] std::vector<Ball> over_root(const Ball& r, std::size_t order) const;
    /// The integral of h'(s) f(s, sqrt(to^2 - s^2)) over from < s < to = from + beyond; `on` is the
    /// ring at `from`. A ring in the ball of `to` is left out.
    [[nodiscard]] Ball
    over_approach(const Ball& from, std::optional<std::size_t> on, const Ball& beyond,
                  const std::function<Box(const Radius& at, const Box& depth)>& f,
                  const Ball& scale, long known = std::numeric_limits<long>::max()) const;
    /// The coefficients of h'(a + z) in powers of z; not finite if g' may jump or bend at the edge.
    [[nodiscard]] std::vector<Ball> approach_rates(std::size_t terms) const;
    [[nodiscard]] BallSeries linear_approach_rates(std::size_t terms) const;
    /// A bound of |h'(s)| for |s - a| <= rho; not finite if none is found.
    [[nodiscard]] Ball most_rate(const Ball& rho) const;

    bool linear_;
    std::vector<Ring> rings_; ///< ascending; of a linear slope those where g' changes
    /// Of a curved slope the series of h' beyond each ring, and of h'/s on the axis, which all
    /// contacts of the profile share; and those of p between the rings.
    struct Rates {
        std::vector<TaylorCover> of_function;
        long values = 0; ///< computed directly so far
    };
    std::shared_ptr<Rates> rates_;
    std::shared_ptr<TaylorCover> pressures_;
};

/// The zones of an axisymmetric contact under smaller forces, which bound its stick zone in partial
/// slip (docs/axisymmetric.md, "Partial slip"). The solver keeps a copy of `contact`.
[[nodiscard]] std::unique_ptr<ZoneSolver> axisymmetric_zones(const AxisymmetricContact& contact);

/// The real part of the integral of h'(s) f(s) over 0 < s < a (AxisymmetricContact::over_approach)
/// of an axisymmetric power law; `plane` is the plane contact that has the same pressure.
[[nodiscard]] Ball over_approach(const BallContact& plane,
                                 const std::function<Box(const Box& s)>& f);

/// The gap (length) at the distance `beyond` >= 0 (length) outside the edge of an axisymmetric
/// power law; `plane` is the plane contact that has the same pressure.
[[nodiscard]] Ball axisymmetric_gap(const BallContact& plane, const Ball& beyond);

/// A jump of g' at the radius v > 0 (length), of the size `jump`, and a change of its rate by
/// `rate` (1/length).
struct RingBend {
    const Ball& v;
    const Ball& jump;
    const Ball& rate;
};

/// The part of a bend in pi p/E* at the radius r (docs/axisymmetric.md, "What is integrated"): the
/// integral of h'(s) y/(s sqrt(x^2 + d2)) over 0 < x < X, as a series in the variable of `d2` and
/// `X`, where y^2 = s^2 - v^2.
/// @param bend the bend
/// @param beyond true for r > v: x^2 = s^2 - r^2; false for r < v: x = y
/// @param d2 |r^2 - v^2| (length^2), positive; 0 exactly for r = v, which counts as beyond
/// @param X sqrt(a^2 - r^2), or sqrt(a^2 - v^2) for r < v (length)
/// @param goal the accuracy
[[nodiscard]] BallSeries part_of_bend(const RingBend& bend, bool beyond, const BallSeries& d2,
                                      const BallSeries& X, const IntegralGoal& goal);

/// A power law g'(r) = C r^m as a body of revolution (docs/axisymmetric.md, "Power laws"), exactly.
struct AxisymmetricPowerLaw {
    Expr C; ///< 1/length^m
    Expr m;
    Expr kappa; ///< delta = kappa a^(m + 1)

    /// Throws InputError for a profile that is no power law.
    [[nodiscard]] static AxisymmetricPowerLaw of(const Profile& profile);
    /// The slope of the plane contact that has the same pressure for the same a.
    [[nodiscard]] Profile plane() const;
    /// The approach delta (length) for the radius a (length).
    [[nodiscard]] Exact approach(const Exact& a) const;
    /// The total force P for E* (stress) and the radius a (length).
    [[nodiscard]] Exact force(const Exact& modulus, const Exact& a) const;
    /// The radius a (length) for E* (stress) and the total force P.
    [[nodiscard]] Exact radius(const Exact& modulus, const Exact& P) const;
    /// The radius a (length) for the approach delta (length).
    [[nodiscard]] Exact radius_at(const Exact& delta) const;

private:
    /// P/a^(m + 2).
    [[nodiscard]] Expr force_factor(const Exact& modulus) const;
};

} // namespace edgeproof::contact
