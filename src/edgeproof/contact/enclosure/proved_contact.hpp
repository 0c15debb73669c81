// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/law/linear_measure.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::contact {

class BallContact;

/// A contact in balls whose pressure is enclosed at points, over intervals, and with its
/// derivatives: the interface for searches that prove where an approximation is good
/// (ball_extent.hpp).
/// Lengths in one unit; pressures in the unit of the contact modulus.
class ProvedContact {
public:
    virtual ~ProvedContact() = default;

    [[nodiscard]] long bits() const { return bits_; }
    [[nodiscard]] const Ball& a() const { return a_; }
    [[nodiscard]] const Ball& b() const { return b_; }
    [[nodiscard]] Ball length() const { return a_ + b_; }
    /// E* (stress).
    [[nodiscard]] const Ball& modulus() const { return modulus_; }
    /// The distance of an edge from the origin (length), if it is given, or proved by exact algebra
    /// (exact_contact.hpp).
    [[nodiscard]] std::optional<Exact> known(Edge edge) const {
        return edge == Edge::right || profile_.symmetric() ? known_a_ : known_b_;
    }
    /// True for a profile whose contacts all have b = a.
    [[nodiscard]] bool symmetric() const { return profile_.symmetric(); }
    /// True if an edge that is not known exactly may lie on a knot at this number of bits.
    [[nodiscard]] bool edge_may_be_on_knot() const;
    /// The distances of the corners from the edge. There p is infinite.
    [[nodiscard]] std::vector<Ball> corners(Edge edge) const;
    /// The normal force P per unit length.
    [[nodiscard]] virtual Ball force() const = 0;
    /// The moment of p about the origin (moore-hills EQ22).
    [[nodiscard]] virtual Ball moment() const = 0;
    /// p at a distance from an edge that is known exactly.
    [[nodiscard]] virtual Ball pressure(Edge edge, const Exact& u) const = 0;
    /// p at the distance u from an edge. Not finite if the ball of x contains a corner.
    [[nodiscard]] virtual Ball pressure(Edge edge, const Ball& u) const = 0;
    /// The same at a place whose x is known exactly although the edge is not: also finite at a knot
    /// of a curved slope.
    [[nodiscard]] virtual Ball pressure(Edge edge, const Ball& u, const Exact& /*x*/) const {
        return pressure(edge, u);
    }
    /// A ball whose lower end is a lower bound of the pressure over u; finite also if the ball of x
    /// contains a corner.
    [[nodiscard]] virtual Ball least_pressure(Edge edge, const Ball& u) const = 0;
    /// p(u + z) in powers of z. The coefficients hold for every u of the ball, so that the last one
    /// bounds Taylor's remainder over it. Not finite if the ball of x contains a knot.
    [[nodiscard]] virtual BallSeries pressure_series(Edge edge, const Ball& u,
                                                     std::size_t order) const = 0;
    /// A distance from the edge up to which p/sqrt(u) is proved to have a power series; zero if
    /// there is no proof.
    [[nodiscard]] virtual Ball reach(Edge edge) const = 0;
    /// M with |c_k| <= M/rho^k for all k, 0 < rho < reach (docs/expansions.md).
    [[nodiscard]] virtual Ball majorant(Edge edge, const Ball& rho) const = 0;
    /// c_0 ... c_{terms-1} at an edge, each enclosed. An edge that lies on a knot exactly, as given
    /// or as proved, is expanded from inside the contact. If an edge may lie on a knot at this
    /// number of bits, the coefficients are not finite.
    [[nodiscard]] virtual std::vector<Ball> expansion(Edge edge, std::size_t terms) const = 0;

    /// The contact as one with a closed form; null for a curved slope.
    [[nodiscard]] virtual const BallContact* closed_form() const { return nullptr; }
    /// The approximate cost of one enclosure over an interval; that of a closed form is 1. The
    /// budgets of searches are in this unit.
    [[nodiscard]] virtual std::size_t cost() const { return 1; }

protected:
    ProvedContact(const Profile& profile, const Ball& modulus, long bits);
    ProvedContact(const ProvedContact&) = default;
    ProvedContact(ProvedContact&&) = default;
    ProvedContact& operator=(const ProvedContact&) = default;
    ProvedContact& operator=(ProvedContact&&) = default;

    /// True if a knot is inside the contact, as far as the bits decide.
    [[nodiscard]] virtual bool inside(std::size_t knot) const = 0;
    /// False at a knot where the formula of g' does not change (the origin of a parabola).
    [[nodiscard]] virtual bool bends(std::size_t) const { return true; }
    [[nodiscard]] Ball constant(const Expr& e) const {
        return formula::enclosed_constant(e, bits_);
    }
    /// Finds the knots that are exactly a known edge.
    void find_knots_on_edges();
    /// Makes this the zone -b < x < a, no edge of which is known exactly.
    void move_edges(const Ball& a, const Ball& b);
    /// Makes this the mirror image.
    void mirror();

    Profile profile_;
    long bits_;
    Ball modulus_;
    LinearSlope<Ball> slope_; ///< for a slope that is not piecewise linear only its knots
    /// The edge on which a knot lies exactly, if this is known; balls cannot decide it.
    std::vector<std::optional<Edge>> on_edge_;
    std::optional<Exact> known_a_;
    std::optional<Exact> known_b_;
    Ball a_;
    Ball b_;
};

/// True if a constant is proved to be zero.
[[nodiscard]] bool certainly_zero(const Expr& e);

} // namespace edgeproof::contact
