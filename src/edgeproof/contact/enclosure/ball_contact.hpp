// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/ball_marks.hpp"
#include "edgeproof/contact/enclosure/exact_edges.hpp"
#include "edgeproof/contact/enclosure/power_law_integral.hpp"
#include "edgeproof/contact/enclosure/proved_pressure.hpp"
#include "edgeproof/contact/law/linear_measure.hpp"
#include "edgeproof/contact/law/load.hpp"
#include "edgeproof/contact/law/power_law.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/formula/exact/enclosed_constant.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"

#include <optional>
#include <vector>

namespace edgeproof::contact {

/// A normal contact in ball arithmetic: every value is an enclosure, proved. For profiles with a
/// closed form: g' piecewise linear (logarithms), or a power law (power_law_integral.hpp). The
/// formulas are those of contact/law/: eqn:SIEPressure integrated exactly; the arithmetic is Arb's.
///
/// The edges are enclosed by the interval form of Newton's method, which proves that the edge
/// inside the ball exists and is the only one. Radii grow with the condition of the problem;
/// callers ask for more bits (escalate.hpp) until they are narrow enough.
class BallContact : public ProvedPressure {
public:
    /// Throws DomainError for a profile without a closed form, or when `bits` are too few to
    /// separate the edges from the knots (ask for more).
    BallContact(const Profile& profile, const formula::Exact& contact_modulus, const Load& load,
                long bits);
    /// Where both edges are known (exact_edges.hpp), so that nothing is solved for.
    BallContact(const Profile& profile, const formula::Exact& contact_modulus,
                const ExactEdges& edges, long bits);
    /// Of a tilted wedge or punch whose tilt is known by a ball; `near` is one of a tilt in it.
    BallContact(const Profile& near, const Ball& alpha, const formula::Exact& contact_modulus,
                const Load& load, long bits);

    [[nodiscard]] static bool has_closed_form(const Profile& profile);

    [[nodiscard]] bool piecewise_linear() const { return !power_; }
    [[nodiscard]] const Ball& modulus() const { return modulus_; }
    /// Where the minimum, which may be a flat, ends on that side: its distance from the origin.
    [[nodiscard]] Ball minimum_end(Edge edge) const;
    [[nodiscard]] long bits() const override { return bits_; }
    [[nodiscard]] const Ball& a() const override { return a_; }
    [[nodiscard]] const Ball& b() const override { return b_; }
    /// The distance of an edge from the origin, where it is given, or proved by exact algebra
    /// (exact_edges.hpp).
    [[nodiscard]] const std::optional<formula::Exact>& known(Edge edge) const {
        return edge == Edge::right || profile_.symmetric() ? known_a_ : known_b_;
    }
    /// Whether an edge that is not known so may lie on a knot, as far as the bits tell.
    [[nodiscard]] bool edge_may_be_on_knot() const;
    [[nodiscard]] Ball force() const;
    [[nodiscard]] Ball moment() const;
    [[nodiscard]] Ball force_rate() const; ///< dP/da
    /// P(a), P'(a), P''(a), ..., `count` of them, along the family of contacts that share the
    /// profile; not finite where an edge may be on a knot.
    [[nodiscard]] std::vector<Ball> force_derivatives(std::size_t count) const;
    /// b(a), b'(a), b''(a), ...
    [[nodiscard]] std::vector<Ball> left_edge_derivatives(std::size_t count) const;
    /// P'(a + z) along the family of contacts, for every right edge of the ball a.
    [[nodiscard]] BallSeries total_rate_series(std::size_t order) const;
    /// p at the distance u from an edge. Not finite when the ball of x meets a corner.
    [[nodiscard]] Ball pressure(Edge edge, const Ball& u) const override;
    /// Where the edge is given as well, the distances from the knots are exact.
    [[nodiscard]] Ball pressure(Edge edge, const formula::Exact& u) const;
    /// A ball whose lower end no pressure over u is below, finite where the ball of x meets a
    /// corner.
    [[nodiscard]] Ball least_pressure(Edge edge, const Ball& u) const override;
    /// p(u + z) in powers of z: coefficients that hold for every u of a ball, so that the last one
    /// bounds Taylor's remainder over it. Not finite when the ball of x meets a knot.
    [[nodiscard]] BallSeries pressure_series(Edge edge, const Ball& u,
                                             std::size_t order) const override;
    /// The distances of the corners, where p is infinite.
    [[nodiscard]] std::vector<Ball> corners(Edge edge) const override;
    /// p/sqrt(u) has a power series at least up to this distance from the edge: to the next knot,
    /// or (a power law) to where its majorant still converges.
    [[nodiscard]] Ball reach(Edge edge) const override;
    /// M with |c_k| <= M/rho^k for all k, 0 < rho < reach.
    [[nodiscard]] Ball majorant(Edge edge, const Ball& rho) const override;
    /// c_0 ... c_{terms-1} at an edge, each enclosed. An edge that lies on a knot exactly, given
    /// so or proved, is expanded from inside the contact. One that may lie on a knot, as far as the
    /// bits tell, has no enclosed expansion: the coefficients are not finite.
    [[nodiscard]] std::vector<Ball> expansion(Edge edge, std::size_t terms) const override;
    /// What the logarithms of a piecewise linear slope are made of (logarithmic_pressure.hpp): the
    /// marks of its knots; whether one is inside and g' does not go on by one formula there; the
    /// integral of g'' over the angle. p is `pressure_factor` times them, for a power law P'(a)/pi.
    [[nodiscard]] const LinearSlope<Ball>& slope() const { return slope_; }
    [[nodiscard]] const std::vector<Mark<Ball>>& knot_marks() const { return fixed_.marks; }
    [[nodiscard]] bool bends_inside(std::size_t knot) const { return fixed_.bends[knot]; }
    [[nodiscard]] const Ball& arc() const { return fixed_.arc; }
    [[nodiscard]] const Ball& pressure_factor() const { return fixed_.factor; }
    /// The same contact seen in a mirror, edges and all.
    [[nodiscard]] BallContact mirrored() const;
    /// The contact of the same profile whose right edge is a number in the ball. Throws BudgetError
    /// where the bits, or the ball, do not isolate the left edge.
    [[nodiscard]] BallContact with_right_edge(const Ball& a) const;

    /// The zone -b < x < a of the same profile, whatever it takes to make it a contact (a tilt):
    /// its pressures are those of eqn:SIEPressure, to which a tilt adds nothing. Of a power law,
    /// symmetric zones only.
    [[nodiscard]] BallContact between(const Ball& a, const Ball& b) const;
    /// Of that zone, piecewise linear: the force; E*/2 times the kernel A, or B, of
    /// docs/mechanics.md; the mean of g' over the zone, weighted by 1/(pi w).
    [[nodiscard]] Ball zone_force() const { return force_of({a_, b_}); }
    [[nodiscard]] Ball zone_rate(Edge edge) const { return force_rate_of({a_, b_}, edge); }
    [[nodiscard]] Ball zone_mean_slope() const;

private:
    BallContact(const Profile& profile, const Ball& modulus, long bits);
    void read_profile();
    void tilt_by(const Ball& alpha);
    void solve(const formula::Exact& contact_modulus, const Load& load);
    void lie_at(const ExactEdges& edges);
    [[nodiscard]] std::optional<std::size_t> flat_end(Edge edge) const;
    [[nodiscard]] std::vector<Ball> right_expansion(std::size_t terms) const;
    [[nodiscard]] BallSeries left_edge_series(std::size_t order) const;
    [[nodiscard]] std::vector<Mark<BallSeries>> marks(const Extent<BallSeries>& e) const;
    [[nodiscard]] Ball constant(const formula::Expr& e) const;
    void find_knots_on_edges();
    /// What the pressure has of the contact and not of the point.
    struct Fixed {
        std::vector<Mark<Ball>> marks; ///< of the knots
        std::vector<bool> bends;       ///< whether a knot inside has a part in the pressure
        std::vector<Ball> insets;      ///< a - knot
        std::vector<Ball> outsets;     ///< b + knot
        /// The same two where they are exactly known.
        std::vector<std::optional<Rational>> exact_insets;
        std::vector<std::optional<Rational>> exact_outsets;
        Ball length;
        Ball arc;    ///< the integral of g'' over the angle h
        Ball factor; ///< E*/(2 pi); of a power law P'(a)/pi
    };
    void fix();
    struct Place;
    [[nodiscard]] Place place(Edge edge, const Ball& u) const;
    [[nodiscard]] Ball pressure(const Place& at, bool least = false) const;
    /// False at a knot where g' goes on by one formula (the origin of a parabola).
    [[nodiscard]] bool bends(std::size_t knot) const;
    /// Of the knots.
    [[nodiscard]] std::vector<Mark<Ball>> marks(const Extent<Ball>& e) const;
    /// `prove`: else the zero is the middle of a ball, about right.
    [[nodiscard]] Ball solve_left_edge(const Ball& a, bool prove = true) const;
    /// The left edge to a given right one, solved for as its distance from `end`.
    [[nodiscard]] Ball left_edge_from(const Ball& end, const Ball& start, const Ball& a,
                                      bool prove) const;
    [[nodiscard]] Ball solve_right_edge_for_force(const Ball& P, bool prove = true) const;
    [[nodiscard]] Ball imbalance(const Extent<Ball>& e) const;
    [[nodiscard]] Ball force_of(const Extent<Ball>& e) const;
    [[nodiscard]] Ball force_rate_of(const Extent<Ball>& e, Edge edge) const;
    template <class Kernel> [[nodiscard]] Ball over_measure(const Extent<Ball>& e) const;

    Profile profile_;
    long bits_;
    Ball modulus_;
    LinearSlope<Ball> slope_; ///< of a power law the knot alone
    /// Knots that are known to lie on an edge exactly, which no ball tells.
    std::vector<std::optional<Edge>> on_edge_;
    std::optional<formula::Exact> known_a_;
    std::optional<formula::Exact> known_b_;
    std::optional<PowerLawIntegral> power_law_integral_;
    std::optional<PowerLaw<Ball>> power_;
    Ball a_;
    Ball b_;
    Fixed fixed_;
};

/// Of a constant; false where it is not told from zero.
[[nodiscard]] bool certainly_zero(const formula::Expr& e);

/// c_0 ... c_{terms-1} to `digits` correct digits each (a coefficient that vanishes: to that many
/// digits of its natural size |c_0|/length^k). Throws BudgetError as below.
[[nodiscard]] std::vector<Ball> enclosed_expansion(const Profile& profile,
                                                   const formula::Exact& contact_modulus,
                                                   const Load& load, Edge edge, std::size_t terms,
                                                   unsigned digits);

/// The pressure to `digits` correct digits: precision doubles until the enclosure's relative
/// radius is below 10^-(digits + 2). Throws BudgetError when the budget of bits does not suffice.
[[nodiscard]] Ball enclosed_pressure(const Profile& profile, const formula::Exact& contact_modulus,
                                     const Load& load, Edge edge, const formula::Exact& u,
                                     unsigned digits);

} // namespace edgeproof::contact
