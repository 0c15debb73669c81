// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/formula/expr.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::contact {

/// One analytic piece of g'.
struct SlopePiece {
    Expr slope; ///< g' as an expression in x alone (constants are exact)

    /// g' = at_origin + rate x. Present if `slope` has this form.
    struct Linear {
        Expr at_origin; ///< dimensionless
        Expr rate;      ///< 1/length
    };
    std::optional<Linear> linear;
};

/// The slope g'(x) of the gap between the bodies (dimensionless). It does not decrease, it is
/// piecewise analytic, and the origin is at its minimum (g' <= 0 to the left of it, >= 0 to the
/// right). All numbers in it are exact. The origin always counts as a knot, with or without a
/// corner.
class Profile {
public:
    enum class Kind {
        power_law,
        flat_and_rounded,
        tilted_wedge,
        tilted_flat_and_rounded,
        piecewise
    };

    /// g' = C sgn(x) |x|^m, m >= 0, C > 0 (moore-hills EQ10). C: 1/length^m; m: dimensionless.
    /// Throws InputError outside that domain, as all these functions do.
    [[nodiscard]] static Profile power_law(const Exact& C, const Exact& m);
    /// A flat of length 2t between arcs of radius R, t >= 0, R > 0 (moore-hills EQ16). t, R:
    /// lengths.
    [[nodiscard]] static Profile flat_and_rounded(const Exact& t, const Exact& R);
    /// A wedge of half-angle pi/2 - phi, tilted clockwise by alpha, |alpha| < phi (moore-hills
    /// EQ26). phi, alpha: slopes, dimensionless.
    [[nodiscard]] static Profile tilted_wedge(const Exact& phi, const Exact& alpha);
    /// A flat of length 2t between arcs of radius R, tilted clockwise by alpha >= 0, with the
    /// origin at the minimum (moore-hills EQ33). alpha: slope, dimensionless; t, R: lengths.
    [[nodiscard]] static Profile tilted_flat_and_rounded(const Exact& alpha, const Exact& t,
                                                         const Exact& R);
    /// A profile given by the user: `slopes[i]` (in x) holds between knots[i-1] and knots[i]
    /// (lengths). Throws an InputError that names the place where the knots do not ascend, g'
    /// decreases, or the minimum is not at 0.
    /// A piece has analytic functions only; hypot and atan2 are written with sqrt and atan.
    /// The two outer pieces need to rise, and to have a value, only as far as the contact reaches.
    [[nodiscard]] static Profile piecewise(const std::vector<Exact>& knots,
                                           const std::vector<Expr>& slopes);
    /// A profile given by the user for x > 0 only and continued by g'(-x) = -g'(x).
    [[nodiscard]] static Profile piecewise_symmetric(const std::vector<Exact>& knots,
                                                     const std::vector<Expr>& slopes);

    [[nodiscard]] Kind kind() const noexcept { return kind_; }
    /// The name of the kind in a scene file: "power-law", "flat-and-rounded", ...
    [[nodiscard]] std::string kind_name() const;
    /// True if g'(-x) = -g'(x) by construction: then b = a, and nothing is solved for it.
    [[nodiscard]] bool symmetric() const noexcept { return symmetric_; }
    /// True if every piece is linear in x: then pressures have a closed form in logarithms.
    [[nodiscard]] bool piecewise_linear() const noexcept;
    /// True if the pressure has a closed form: in logarithms, or Gauss's 2F1 for a power law.
    [[nodiscard]] bool has_closed_form() const noexcept {
        return !axisymmetric_ && (kind_ == Kind::power_law || piecewise_linear());
    }
    /// The knot at which a flat minimum, g' = 0 from the origin on, ends on that side; nothing if
    /// there is none.
    [[nodiscard]] std::optional<std::size_t> flat_end(Edge edge) const;
    /// The same slope as that of a body of revolution, x for the radius r. The profile must be
    /// symmetric.
    [[nodiscard]] Profile revolved() const {
        Profile p(*this);
        p.axisymmetric_ = true;
        return p;
    }
    [[nodiscard]] bool axisymmetric() const noexcept { return axisymmetric_; }
    /// The parameters by their names in the paper (m, C, t, R, phi, alpha).
    [[nodiscard]] const std::map<std::string, Exact>& parameters() const noexcept {
        return parameters_;
    }
    /// The knots in ascending order; `pieces()[i]` ends at `knots()[i]` and `pieces()[i+1]` begins
    /// there.
    [[nodiscard]] const std::vector<Exact>& knots() const noexcept { return knots_; }
    [[nodiscard]] const std::vector<SlopePiece>& pieces() const noexcept { return pieces_; }
    /// The index of the origin among the knots.
    [[nodiscard]] std::size_t origin() const noexcept { return origin_; }
    /// The place up to which a user's slope rises on that side, moved back by a millionth of its
    /// distance from the last knot; empty if there is no such limit. Beyond it the given slope ends
    /// or decreases, and g' continues as a straight line so that contacts can be searched for. A
    /// contact that reaches this place is refused (check_reach).
    [[nodiscard]] const std::optional<Exact>& rises_to(Edge edge) const noexcept {
        return edge == Edge::right ? right_limit_ : left_limit_;
    }
    /// True if g' itself jumps at a knot (a corner); false if g' only bends there.
    [[nodiscard]] bool has_corner(std::size_t knot) const { return corner_.at(knot); }
    /// The mirror image of the profile: g'(x) becomes -g'(-x); right becomes left.
    [[nodiscard]] Profile reflected() const;

private:
    Profile() = default;
    void continue_outer_pieces();
    static Profile assemble(Kind kind, std::vector<Exact> knots, std::vector<Expr> slopes);

    Kind kind_ = Kind::piecewise;
    bool symmetric_ = false;
    bool axisymmetric_ = false;
    std::map<std::string, Exact> parameters_;
    std::vector<Exact> knots_;
    std::vector<SlopePiece> pieces_;
    std::vector<bool> corner_;
    std::size_t origin_ = 0;
    std::optional<Exact> left_limit_;
    std::optional<Exact> right_limit_;
};

/// Returns a + b x with a, b free of `x` if the expression tree has that form, else nothing.
[[nodiscard]] std::optional<SlopePiece::Linear> as_linear(const Expr& e, std::string_view x);

} // namespace edgeproof::contact
