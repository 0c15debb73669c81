// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/edge.hpp"
#include "edgeproof/contact/normal_contact.hpp"
#include "edgeproof/precision/ball.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof {

/// A normal contact in ball arithmetic where g' has no closed form: every value is an enclosure,
/// by Arb's rigorous integration (F. Johansson, "Numerical integration in arbitrary-precision ball
/// arithmetic", 2018), the singularities substituted away: s = c + d cos theta.
///
/// A left edge that is not given is enclosed between two trial edges: the integral of g' over theta
/// (eqn:Consistency) falls as the left edge moves out, since g' does not decrease, so that opposite
/// signs at both prove that the edge lies between them. Where to try comes from the routes in Real,
/// which decide nothing.
class IntegratedContact {
public:
    /// Every piece of g' is made of what complex_taylor.hpp knows, and the load is one that is
    /// handled here: the right edge, or the force on a symmetric contact.
    [[nodiscard]] static bool handles(const Profile& profile, const Load& load);

    /// Throws BudgetError where so many bits do not enclose the edges.
    IntegratedContact(const Profile& profile, const Exact& contact_modulus, const Load& load,
                      long bits);

    [[nodiscard]] const Ball& a() const noexcept { return a_; }
    [[nodiscard]] const Ball& b() const noexcept { return b_; }
    [[nodiscard]] Ball force() const { return force_of(a_, b_); }
    [[nodiscard]] Ball moment() const;
    /// p at the distance u from an edge. Not finite on a knot, unless exact numbers tell that u is
    /// there and g' does not jump.
    [[nodiscard]] Ball pressure(Edge edge, const Exact& u) const;
    /// c_0 ... c_{terms-1} at an edge. Not finite where the edge may be on a knot.
    [[nodiscard]] std::vector<Ball> expansion(Edge edge, std::size_t terms) const;

private:
    struct Span;
    [[nodiscard]] std::vector<Span> spans(const Ball& a, const Ball& b) const;
    [[nodiscard]] Ball slope_integral(const Ball& a, const Ball& b, long harmonic) const;
    [[nodiscard]] Ball force_of(const Ball& a, const Ball& b) const;
    [[nodiscard]] std::vector<Ball> slope_series(std::size_t piece, const Ball& x,
                                                 std::size_t terms) const;
    [[nodiscard]] std::vector<Ball> right_expansion(std::size_t terms) const;
    void enclose_edges(const Exact& contact_modulus);

    Profile profile_;
    Load load_;
    long bits_;
    Ball modulus_;
    std::vector<Ball> knots_;
    Ball a_;
    Ball b_;
};

} // namespace edgeproof
