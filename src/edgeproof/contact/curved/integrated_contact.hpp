// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/curved/curved_slope.hpp"
#include "edgeproof/contact/curved/pressure_disk.hpp"
#include "edgeproof/contact/enclosure/plane_contact.hpp"
#include "edgeproof/contact/enclosure/zone_equations.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// A normal contact in ball arithmetic for slopes g' without closed forms. Each value is an
/// enclosure found by Arb's rigorous integration (johansson2018) over theta, where s = c + d
/// cos(theta) removes the singularities at the edges (docs/curved-slopes.md).
///
/// All values are valid for a g' that does not decrease; curved_slope.hpp proves this. Edges that
/// are not given are enclosed as a zone of tilt 0 (zone_equations.hpp).
class IntegratedContact : public PlaneContact {
public:
    /// Throws BudgetError where `bits` do not suffice to enclose the edges.
    /// @param profile g'(x)
    /// @param contact_modulus E* (stress)
    /// @param load the right edge (length) or the force (force/length)
    /// @param bits working precision
    IntegratedContact(const Profile& profile, const Exact& contact_modulus, const Load& load,
                      long bits);

    [[nodiscard]] Ball force() const override { return force_of(a_, b_); }
    [[nodiscard]] Ball moment() const override;
    /// The result is not finite on a knot, unless exact numbers prove that the point is the knot
    /// and that g' does not jump there.
    [[nodiscard]] Ball pressure(Edge edge, const Exact& u) const override;
    [[nodiscard]] Ball pressure(Edge edge, const Ball& u, const Exact& x) const override;
    [[nodiscard]] std::vector<Ball> expansion(Edge edge, std::size_t terms) const override;
    [[nodiscard]] Ball majorant(Edge edge, const Ball& rho) const override;
    /// Returns the radius of the disk about an edge (length).
    [[nodiscard]] Ball reach(Edge edge) const override;
    [[nodiscard]] std::size_t cost() const override { return 40; }

    /// For a wide ball p is enclosed by a disk that contains it (pressure_disk.hpp) or, if it
    /// contains a bend, by bounds of g'' near the bend. Disks are computed when they are needed,
    /// and kept.
    [[nodiscard]] Ball pressure(Edge edge, const Ball& u) const override;
    [[nodiscard]] Ball least_pressure(Edge edge, const Ball& u) const override;
    [[nodiscard]] BallSeries pressure_series(Edge edge, const Ball& u,
                                             std::size_t order) const override;

    /// The zone -b < x < a of the same profile, for any tilt that makes it a contact; a power law
    /// is integrated like every other slope. See BallContact::between.
    [[nodiscard]] IntegratedContact between(const Ball& a, const Ball& b, long bits) const;
    [[nodiscard]] ZoneValues zone_values() const;
    [[nodiscard]] Ball zone_rate(Edge edge) const; ///< of ZoneRates
    /// `known_x`: see ProvedContact::pressure.
    [[nodiscard]] Ball zone_pressure(Edge edge, const Ball& u,
                                     const std::optional<Exact>& known_x) const;
    using PlaneContact::cauchy_integral;
    [[nodiscard]] CauchyIntegral
    cauchy_integral(const Box& zeta, const std::optional<Exact>& known_x) const override;
    [[nodiscard]] CauchyDerivatives cauchy_derivatives(const Box& zeta) const override;
    [[nodiscard]] CauchyBounds cauchy_bounds(const Box& zeta) const override;
    [[nodiscard]] std::vector<Ball> edge_slope(std::size_t terms) const override;
    [[nodiscard]] Box edge_slope_rate(const Ball& radius) const override;
    [[nodiscard]] Ball gap_beyond(Edge edge, const Ball& beyond) const override;
    [[nodiscard]] SurfacePotential
    surface_potential(const Ball& x, const std::optional<Exact>& known) const override;
    [[nodiscard]] std::shared_ptr<const PlaneContact> mirror_image() const override {
        return std::make_shared<IntegratedContact>(mirrored());
    }
    [[nodiscard]] std::shared_ptr<const PlaneContact> zone(const Ball& a,
                                                           const Ball& b) const override {
        return std::make_shared<IntegratedContact>(between(a, b, bits_));
    }
    /// An initial zone of a profile whose contact is enclosed elsewhere.
    IntegratedContact(const Profile& profile, const Exact& contact_modulus, const Ball& a,
                      const Ball& b, long bits);

private:
    [[nodiscard]] IntegratedContact mirrored() const;
    /// Forgets what was kept of other edges.
    void forget();
    /// The piece at an edge; nothing if the edge may lie on a knot.
    [[nodiscard]] std::optional<std::size_t> edge_piece(Edge edge) const;
    /// The integral of g' from lo to hi (lengths), on either side of the edges. Not finite where
    /// an end may be on a knot at which g' is not analytic.
    [[nodiscard]] Ball rise(const Ball& lo, const Ball& hi) const;
    /// The lift at the distance `beyond` (length) from the right edge.
    [[nodiscard]] Ball lift_beyond(const Ball& beyond) const;
    /// The force carried between x in the contact and the right edge; `knot`: the knot at x.
    [[nodiscard]] Ball carried_inside(const Ball& x, const std::optional<std::size_t>& knot) const;
    /// A Taylor series of T about a place off the contact.
    struct Around {
        Box centre;
        Ball distance; ///< from the contact, a lower bound
        std::vector<Box> T;
    };
    /// What T and its bounds need of the whole contact.
    struct FieldData {
        Ball mean; ///< of g' over theta: 0 for a contact, the tilt of a zone with the other sign
        Ball force;
        Ball steepest;                      ///< an upper bound of g''
        mutable std::vector<Around> around; ///< the series made so far
    };
    /// Computed when first needed.
    [[nodiscard]] const FieldData& field_data() const;
    [[nodiscard]] Around series_off_contact(const Box& centre, std::size_t terms,
                                            long accuracy) const;
    [[nodiscard]] CauchyDerivatives off_contact(const Around& series, const Box& zeta) const;
    [[nodiscard]] CauchyDerivatives near_contact(const Box& zeta) const;
    /// The pieces from the right edge to the left one; pieces of one formula are one span.
    [[nodiscard]] std::vector<quadrature::ThetaSpan> piece_spans(const Ball& a,
                                                                 const Ball& b) const;
    /// The same, but half of a piece next to a branch point on a knot is given in a variable in
    /// which g' is holomorphic. `cut`: an angle theta at which a span ends.
    [[nodiscard]] std::vector<quadrature::ThetaSpan>
    spans(const Ball& a, const Ball& b, const std::optional<Ball>& cut = {}) const;
    /// The formulas used by spans().
    struct Roots {
        struct Root {
            std::size_t formula = 0;
            long root = 0; ///< 0: no branch point
        };
        std::vector<Expr> formulas;                ///< of the pieces, followed by those in roots
        std::vector<std::array<Root, 2>> of_knots; ///< to the left of the knot, to the right of it
        std::vector<bool> bends; ///< false at a knot whose two pieces are one holomorphic formula
    };
    /// The formulas, computed when first needed.
    [[nodiscard]] const Roots& roots() const;
    /// Returns the integral of f over theta for the contact -b < x < a.
    [[nodiscard]] Box over_spans(const Ball& a, const Ball& b,
                                 const SlopeOnSpan::Integrand& f) const;
    /// p at x, which is on the piece, or on the knot at its right end.
    [[nodiscard]] Ball pressure_at(const Ball& from_edge, const Ball& x, std::size_t piece,
                                   const std::optional<std::size_t>& on_knot) const;
    /// Returns the integral of g' cos(harmonic theta) over theta.
    [[nodiscard]] Ball slope_integral(const Ball& a, const Ball& b, long harmonic) const;
    /// Returns P (force/length) of the contact -b < x < a.
    [[nodiscard]] Ball force_of(const Ball& a, const Ball& b) const;
    /// Returns the Taylor series of g' about x by the formula of a piece.
    [[nodiscard]] std::vector<Ball> series_of_slope(std::size_t piece, const Ball& x,
                                                    std::size_t terms) const;
    /// Returns I_k about the right edge by a disk; empty if there is none.
    [[nodiscard]] std::vector<Ball> coefficients_by_disk(std::size_t piece,
                                                         std::size_t terms) const;
    /// Returns c_k at the right edge.
    [[nodiscard]] std::vector<Ball> right_expansion(std::size_t terms) const;
    /// The equations of the edges, by integrals of `bits` bits.
    [[nodiscard]] ZoneEquations equations(long bits) const;
    [[nodiscard]] BallZone near_edges() const;
    /// Encloses the edges that are not given.
    void enclose_edges();
    /// Returns the knot inside the contact that lies at x, if g' does not jump there.
    [[nodiscard]] std::optional<std::size_t> knot_at(const std::optional<Exact>& x) const;
    [[nodiscard]] Ball pressure_at_knot(const Ball& from_edge, std::size_t knot) const {
        return pressure_at(from_edge, slope_.knots[knot], knot, knot);
    }
    /// Returns x at the distance `u` from an edge.
    [[nodiscard]] Ball place(Edge edge, const Ball& u) const;
    [[nodiscard]] bool inside(std::size_t knot) const override;
    [[nodiscard]] bool bends(std::size_t knot) const override;
    /// Returns the last of the pieces that are one formula with this one; its formula serves all.
    [[nodiscard]] std::size_t whole_piece(std::size_t piece) const;
    /// Returns the distance from x to the next knot inside the contact, at most the length of the
    /// contact.
    [[nodiscard]] Ball gap_at(const Ball& x) const;
    /// The piece that contains all of x; nothing if x may contain a knot inside the contact.
    [[nodiscard]] std::optional<std::size_t> piece_of(const Ball& x) const;
    /// A piece that contains x, and the first Taylor coefficients of its g' about x.
    struct SlopeAt {
        std::size_t piece;
        std::vector<Ball> taylor;
    };
    /// Returns the k-th Taylor coefficient of I (pressure_disk.hpp) at x, from k + 1 coefficients
    /// of g'. On a knot two pieces contain x.
    [[nodiscard]] Ball coefficient(const Ball& x, const std::vector<SlopeAt>& here,
                                   bool from_right_edge) const;
    [[nodiscard]] Ball coefficient(std::size_t k, std::size_t piece, const Ball& x,
                                   bool from_right_edge = false) const;
    struct Disk {
        Ball u; ///< of the centre
        PressureDisk disk;
    };
    /// Returns a disk that contains u and gives `order` coefficients over it; null if there is
    /// none.
    [[nodiscard]] const Disk* disk_for(Edge edge, const Ball& u, std::size_t order) const;
    /// Returns a disk about the place at the distance `u` from an edge, or about the edge.
    [[nodiscard]] const Disk* disk_at(Edge edge, const Ball& u, std::size_t terms) const;
    [[nodiscard]] const Disk* disk_at_edge(Edge edge) const;
    /// Returns the integral over theta from one side of a knot to the other, for x within half of
    /// that range.
    [[nodiscard]] Ball near_knot(std::size_t knot, const Ball& lo, const Ball& hi,
                                 const Ball& width) const;
    /// Returns I over a ball that contains a knot. `least`: a lower bound is returned where I is
    /// infinite.
    [[nodiscard]] Ball over_knot(const Ball& x, bool least) const;
    /// Returns p from I at the distance `u` from an edge.
    [[nodiscard]] Ball with_root(const Ball& u, const Ball& I) const;
    /// The data of I, computed when first needed.
    [[nodiscard]] const SlopeOverTheta& over_theta() const;

    Load load_;
    bool zone_ = false; ///< a zone of a contact: b may differ from a even if g' is odd
    mutable std::map<Edge, std::vector<std::shared_ptr<const Disk>>> disks_;
    mutable std::shared_ptr<const SlopeOverTheta> over_theta_;
    mutable std::shared_ptr<const FieldData> field_data_;
    mutable std::shared_ptr<const Roots> roots_; ///< of the profile
};

} // namespace edgeproof::contact
