// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/curved/pressure_disk.hpp"
#include "edgeproof/contact/curved/slope_integral.hpp"
#include "edgeproof/contact/enclosure/proved_pressure.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// A normal contact in ball arithmetic where g' has no closed form: every value is an enclosure,
/// by Arb's rigorous integration (F. Johansson, "Numerical integration in arbitrary-precision ball
/// arithmetic", 2018), the singularities substituted away: s = c + d cos theta.
///
/// All of it is of a contact in which g' does not decrease: whether that is proved,
/// slope_monotonicity.hpp tells. Edges that are not given are enclosed between two trial edges. The
/// integral of g' over theta (eqn:Consistency) falls as the left edge moves out, since g' does not
/// decrease, and the force grows with the right edge of a contact that is in balance
/// (eqn:SIEPressure by parts: every bit of dg' adds to P, and to b): opposite signs at both ends
/// prove that the edge lies between them, and no other does. Where to try comes from the routes in
/// Real, which decide nothing.
class IntegratedContact : public ProvedPressure {
public:
    /// Every piece of g' is made of what complex_taylor.hpp knows.
    [[nodiscard]] static bool handles(const Profile& profile);

    /// Throws BudgetError where so many bits do not enclose the edges.
    IntegratedContact(const Profile& profile, const formula::Exact& contact_modulus,
                      const Load& load, long bits);

    [[nodiscard]] const Ball& modulus() const { return modulus_; }
    [[nodiscard]] long bits() const override { return bits_; }
    [[nodiscard]] const Ball& a() const override { return a_; }
    [[nodiscard]] const Ball& b() const override { return b_; }
    /// The distance of an edge from the origin, where it is given, or where g' is proved to be odd
    /// in the contact.
    [[nodiscard]] std::optional<formula::Exact> known(Edge edge) const;
    /// Whether an edge that is not known so may lie on a knot, as far as the bits tell.
    [[nodiscard]] bool edge_may_be_on_knot() const;
    [[nodiscard]] Ball force() const { return force_of(a_, b_); }
    [[nodiscard]] Ball moment() const;
    /// p at the distance u from an edge. Not finite on a knot, unless exact numbers tell that u is
    /// there and g' does not jump.
    [[nodiscard]] Ball pressure(Edge edge, const formula::Exact& u) const;
    [[nodiscard]] std::vector<Ball> expansion(Edge edge, std::size_t terms) const override;
    [[nodiscard]] Ball majorant(Edge edge, const Ball& rho) const override;
    [[nodiscard]] Ball reach(Edge edge) const override;
    [[nodiscard]] std::vector<Ball> corners(Edge edge) const override;
    [[nodiscard]] std::size_t cost() const override { return 40; }

    /// Of a wide ball: by a disk that holds it (pressure_disk.hpp), or with a bend in it by bounds
    /// of g'' beside the bend. Disks are made as they are asked for, and kept.
    [[nodiscard]] Ball pressure(Edge edge, const Ball& u) const override;
    [[nodiscard]] Ball least_pressure(Edge edge, const Ball& u) const override;
    [[nodiscard]] BallSeries pressure_series(Edge edge, const Ball& u,
                                             std::size_t order) const override;

    /// The zone -b < x < a of the same profile, whatever tilt makes it a contact; a power law is
    /// integrated like any other slope here. Of it: as BallContact::between.
    [[nodiscard]] IntegratedContact between(const Ball& a, const Ball& b, long bits) const;
    [[nodiscard]] Ball zone_force() const { return force_of(a_, b_); }
    [[nodiscard]] Ball zone_mean_slope() const;
    [[nodiscard]] Ball zone_rate(Edge edge) const;
    [[nodiscard]] Ball zone_pressure(Edge edge, const Ball& u) const;
    /// A zone to begin with, of a profile whose contact other means enclose.
    IntegratedContact(const Profile& profile, const formula::Exact& contact_modulus, const Ball& a,
                      const Ball& b, long bits);

private:
    /// From the right edge to the left one, piece by piece.
    [[nodiscard]] std::vector<quadrature::ThetaSpan> piece_spans(const Ball& a,
                                                                 const Ball& b) const;
    /// The same, halves of pieces beside a branch point on a knot in a variable without it.
    [[nodiscard]] std::vector<quadrature::ThetaSpan> spans(const Ball& a, const Ball& b) const;
    /// What spans() and its formulas are made of.
    struct Roots {
        struct Root {
            std::size_t formula = 0;
            long root = 0; ///< 0: no branch point
        };
        std::vector<formula::Expr> formulas;       ///< of the pieces, then in roots
        std::vector<std::array<Root, 2>> of_knots; ///< left of it, right of it
    };
    [[nodiscard]] const Roots& roots() const;
    [[nodiscard]] SlopeIntegrand integrand(const quadrature::ThetaSpan& span, const Ball& a,
                                           const Ball& b) const;
    [[nodiscard]] Ball slope_integral(const Ball& a, const Ball& b, long harmonic) const;
    [[nodiscard]] Ball force_of(const Ball& a, const Ball& b) const;
    [[nodiscard]] std::vector<Ball> series_of_slope(std::size_t piece, const Ball& x,
                                                    std::size_t terms) const;
    [[nodiscard]] std::vector<Ball> coefficients_by_disk(std::size_t piece,
                                                         std::size_t terms) const;
    [[nodiscard]] std::vector<Ball> right_expansion(std::size_t terms) const;
    void find_knots_on_edges();
    /// Where to try; proves nothing.
    struct Guess {
        Ball a;
        Ball b;
        Ball force_rate; ///< P'(a)
        Ball b_rate;     ///< b'(a)
    };
    [[nodiscard]] Guess guess(const formula::Exact& contact_modulus) const;
    void enclose_edges(const formula::Exact& contact_modulus);
    [[nodiscard]] std::optional<Ball> left_edge_near(const Ball& a, const Ball& start) const;
    /// x at the distance u from an edge.
    [[nodiscard]] Ball place(Edge edge, const Ball& u) const;
    /// The knot has g' of another formula on its other side, and may be inside the contact.
    [[nodiscard]] bool inside(std::size_t knot) const;
    /// The piece that holds all of x; nothing where it may meet a knot inside.
    [[nodiscard]] std::optional<std::size_t> piece_of(const Ball& x) const;
    /// The k-th derivative over k! of I (pressure_disk.hpp) at x.
    [[nodiscard]] Ball coefficient(std::size_t k, std::size_t piece, const Ball& x,
                                   const std::vector<Ball>& taylor, bool from_right_edge) const;
    struct Disk {
        Ball u; ///< of its centre
        PressureDisk disk;
    };
    /// One that holds u and gives `order` coefficients over it; null: none does.
    [[nodiscard]] const Disk* disk_for(Edge edge, const Ball& u, std::size_t order) const;
    [[nodiscard]] const Disk* disk_at(Edge edge, const Ball& u, std::size_t terms) const;
    [[nodiscard]] const Disk* disk_at_edge(Edge edge) const;
    /// The integral over theta from one side of a knot to the other, for x within half of it.
    [[nodiscard]] Ball beside_knot(std::size_t knot, const Ball& lo, const Ball& hi,
                                   const Ball& width) const;
    /// I over a ball that meets a knot; `least`: a number below it, where it is infinite.
    [[nodiscard]] Ball over_knot(const Ball& x, bool least) const;
    [[nodiscard]] Ball with_root(const Ball& u, const Ball& I) const;
    [[nodiscard]] const SlopeOverTheta& over_theta() const;

    Profile profile_;
    Load load_;
    long bits_;
    Ball modulus_;
    std::vector<Ball> knots_;
    std::vector<std::optional<Edge>> on_edge_; ///< knots that are known to be an edge exactly
    Ball a_;
    Ball b_;
    bool odd_ = false;  ///< g' is odd in the contact, whatever it is beyond
    bool zone_ = false; ///< no contact, so that b may differ from a where g' is odd
    mutable std::map<Edge, std::vector<std::shared_ptr<const Disk>>> disks_;
    mutable std::shared_ptr<const SlopeOverTheta> over_theta_;
    mutable std::shared_ptr<const Roots> roots_; ///< of the profile
};

} // namespace edgeproof::contact
