// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/exact_contact.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/enclosure/plane_contact.hpp"
#include "edgeproof/contact/enclosure/power_law_integral.hpp"
#include "edgeproof/contact/enclosure/zone_equations.hpp"
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/contact/law/linear_measure.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// A normal contact in ball arithmetic (Arb, `johansson2017`): every value is a proved enclosure.
/// For profiles with a closed form: g' piecewise linear (logarithms), or a power law
/// (power_law_integral.hpp). The formulas are those of contact/law/. Lengths in one unit, pressures
/// in the unit of contact_modulus, forces per unit length.
///
/// The edges are enclosed by the interval form of Newton's method (`moore-kearfott-cloud2009`),
/// which proves that there is exactly one edge in the ball. Radii grow with the condition of the
/// problem; callers increase the bits (escalate.hpp) until the radii are small enough.
class BallContact : public PlaneContact {
public:
    /// Throws DomainError for a profile without a closed form, and BudgetError if `bits` are too
    /// few to isolate the edges.
    BallContact(const Profile& profile, const Exact& contact_modulus, const Load& load, long bits);
    /// The contact of two known edges (exact_contact.hpp); nothing is solved for.
    BallContact(const Profile& profile, const Exact& contact_modulus, const ExactEdges& edges,
                long bits);
    /// The contact of a tilted wedge or punch whose tilt lies in the ball `alpha`; `near` is the
    /// profile of a tilt in or near it.
    BallContact(const Profile& near, const Ball& alpha, const Exact& contact_modulus,
                const Load& load, long bits);

    [[nodiscard]] bool piecewise_linear() const { return !power_; }
    /// The law of a profile that is a power law and not linear.
    [[nodiscard]] const std::optional<PowerLaw<Ball>>& power_law() const { return power_; }
    /// The distance from the origin at which the minimum, which may be a flat, ends on that side.
    [[nodiscard]] Ball minimum_end(Edge edge) const;
    [[nodiscard]] Ball force() const override;
    [[nodiscard]] Ball moment() const override;
    [[nodiscard]] const BallContact* closed_form() const override { return this; }
    [[nodiscard]] Ball force_rate() const; ///< dP/da
    /// P(a), P'(a), P''(a), ... (`count` values) along the family of contacts of this profile; not
    /// finite if an edge may lie on a knot.
    [[nodiscard]] std::vector<Ball> force_derivatives(std::size_t count) const;
    /// b(a), b'(a), b''(a), ...
    [[nodiscard]] std::vector<Ball> left_edge_derivatives(std::size_t count) const;
    /// P'(a + z) along the family of contacts, for every right edge in the ball a.
    [[nodiscard]] BallSeries total_rate_series(std::size_t order) const;
    [[nodiscard]] Ball pressure(Edge edge, const Ball& u) const override;
    /// If the edge is known exactly as well, the distances from the knots are exact.
    [[nodiscard]] Ball pressure(Edge edge, const Exact& u) const override;
    [[nodiscard]] Ball least_pressure(Edge edge, const Ball& u) const override;
    [[nodiscard]] BallSeries pressure_series(Edge edge, const Ball& u,
                                             std::size_t order) const override;
    /// A distance from the edge up to which p/sqrt(u) has a power series: the distance of the next
    /// knot, or, for a power law, a distance at which its majorant still converges.
    [[nodiscard]] Ball reach(Edge edge) const override;
    [[nodiscard]] Ball majorant(Edge edge, const Ball& rho) const override;
    [[nodiscard]] std::vector<Ball> expansion(Edge edge, std::size_t terms) const override;
    using PlaneContact::cauchy_integral;
    [[nodiscard]] CauchyIntegral cauchy_integral(const Box& zeta,
                                                 const std::optional<Exact>& x) const override;
    [[nodiscard]] CauchyDerivatives cauchy_derivatives(const Box& zeta) const override;
    [[nodiscard]] CauchyBounds cauchy_bounds(const Box& zeta) const override;
    [[nodiscard]] std::vector<Ball> edge_slope(std::size_t terms) const override;
    [[nodiscard]] Box edge_slope_rate(const Ball& radius) const override;
    [[nodiscard]] Ball gap_beyond(Edge edge, const Ball& beyond) const override;
    [[nodiscard]] SurfacePotential
    surface_potential(const Ball& x, const std::optional<Exact>& known) const override;
    [[nodiscard]] std::shared_ptr<const PlaneContact> mirror_image() const override {
        return std::make_shared<BallContact>(mirrored());
    }
    [[nodiscard]] std::shared_ptr<const PlaneContact> zone(const Ball& a,
                                                           const Ball& b) const override {
        return std::make_shared<BallContact>(between(a, b));
    }
    /// The parts of the pressure of a piecewise linear slope (linear_measure.hpp): the slope;
    /// the marks of its knots; whether a knot is inside and the formula of g' changes there, and
    /// the list of these knots; the integral of g'' over the angle; the factor E*/(2 pi) of the
    /// sum, or P'(a)/pi for a power law.
    [[nodiscard]] const LinearSlope<Ball>& slope() const { return slope_; }
    [[nodiscard]] const std::vector<Mark<Ball>>& knot_marks() const { return fixed_.marks; }
    [[nodiscard]] bool bends_inside(std::size_t knot) const { return fixed_.bends[knot]; }
    [[nodiscard]] const std::vector<std::size_t>& bends_inside() const { return fixed_.inside; }
    [[nodiscard]] const Ball& arc() const { return fixed_.arc; }
    [[nodiscard]] const Ball& pressure_factor() const { return fixed_.factor; }
    /// See PlaneContact::mirror_image and PlaneContact::zone.
    [[nodiscard]] BallContact mirrored() const;
    [[nodiscard]] BallContact between(const Ball& a, const Ball& b) const;
    /// The contact of the same profile whose right edge lies in the ball. Throws BudgetError if the
    /// bits, or the ball, do not isolate the left edge.
    [[nodiscard]] BallContact with_right_edge(const Ball& a) const;

    /// The integrals over a zone of a piecewise linear slope, of a contact without known edges.
    [[nodiscard]] ZoneValues values_of(const BallZone& zone) const;
    [[nodiscard]] ZoneRates rates_of(const BallZone& zone) const;

private:
    BallContact(const Profile& profile, const Ball& modulus, long bits);
    void tilt_by(const Ball& alpha);
    void solve(const Exact& contact_modulus, const Load& load);
    void lie_at(const ExactEdges& edges);
    [[nodiscard]] std::vector<Ball> right_expansion(std::size_t terms) const;
    [[nodiscard]] BallSeries left_edge_series(std::size_t order) const;
    [[nodiscard]] std::vector<Mark<BallSeries>> marks(const Extent<BallSeries>& e) const;
    [[nodiscard]] bool inside(std::size_t knot) const override { return !fixed_.marks[knot].end; }
    [[nodiscard]] bool bends(std::size_t knot) const override;
    /// The parts of the pressure that do not depend on the point.
    struct Fixed {
        std::vector<Mark<Ball>> marks;   ///< the marks of the knots
        std::vector<bool> bends;         ///< true for knots inside where the formula of g' changes
        std::vector<std::size_t> inside; ///< these knots
        std::vector<Ball> insets;        ///< a - knot
        std::vector<Ball> outsets;       ///< b + knot
        Ball length;
        Ball arc;    ///< the integral of g'' over the angle h
        Ball factor; ///< E*/(2 pi); for a power law P'(a)/pi
    };
    void fix();
    struct Place;
    [[nodiscard]] Place place(Edge edge, const Ball& u) const;
    [[nodiscard]] Ball pressure(const Place& at, bool least = false) const;
    /// The marks of the knots.
    [[nodiscard]] std::vector<Mark<Ball>> marks(const Extent<Ball>& e) const;
    /// The equations of the edges for a force, or for a right edge.
    [[nodiscard]] ZoneEquations equations(const std::optional<Ball>& force,
                                          const std::optional<Ball>& right_edge) const;
    [[nodiscard]] BallZone from_afar(const ZoneEquations& wanted) const;
    /// Encloses the edges, which are not known yet.
    void isolate(const ZoneEquations& wanted);
    [[nodiscard]] Ball imbalance(const Extent<Ball>& e) const;
    [[nodiscard]] Ball force_of(const Extent<Ball>& e) const;
    template <class Kernel> [[nodiscard]] Ball over_measure(const Extent<Ball>& e) const;

    /// True if the contact is its own mirror image, as no stick zone under a tension is.
    [[nodiscard]] bool about_origin() const { return power_ || (profile_.symmetric() && !zone_); }

    bool zone_ = false; ///< made by between()
    std::optional<PowerLawIntegral> power_law_integral_;
    std::optional<PowerLaw<Ball>> power_;
    Fixed fixed_;
};

/// The pressure to `digits` correct digits: the precision doubles until the relative radius of the
/// enclosure is below 10^-(digits + 2). `u` is the distance from the edge (length); the pressure is
/// in the unit of contact_modulus. Throws BudgetError if the budget of bits is not enough.
[[nodiscard]] Ball enclosed_pressure(const Profile& profile, const Exact& contact_modulus,
                                     const Load& load, Edge edge, const Exact& u, unsigned digits);

} // namespace edgeproof::contact
