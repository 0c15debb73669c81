// SPDX-License-Identifier: GPL-3.0-or-later
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
    formula::Expr slope; ///< g' as an expression in x alone (constants are exact)

    /// g' = at_origin + rate x, where that is what `slope` comes to.
    struct Linear {
        formula::Expr at_origin; ///< dimensionless
        formula::Expr rate;      ///< 1/length
    };
    std::optional<Linear> linear;

    /// `slope` in the distance from the knot at its left or right end (slope_from_knot.hpp), where
    /// that keeps digits that x does not.
    std::optional<formula::Expr> from_left = {};
    std::optional<formula::Expr> from_right = {};
};

/// The slope g'(x) of the gap between the bodies: convex (g' does not decrease), piecewise
/// analytic, with the origin at its minimum (g' <= 0 to the left of it, >= 0 to the right).
/// Everything in it is exact. The origin always counts as a knot, with or without a corner.
class Profile {
public:
    enum class Kind {
        power_law,
        flat_and_rounded,
        tilted_wedge,
        tilted_flat_and_rounded,
        piecewise
    };

    /// g' = C sgn(x) |x|^m, m >= 0, C > 0 (moore-hills.tex, eqn:PowerLaw_Profile).
    /// Throws InputError outside that domain, as all makers do.
    [[nodiscard]] static Profile power_law(const formula::Exact& C, const formula::Exact& m);
    /// Flat of length 2t between arcs of radius R, t >= 0, R > 0 (moore-hills.tex, lines 191-198).
    [[nodiscard]] static Profile flat_and_rounded(const formula::Exact& t, const formula::Exact& R);
    /// Half-angle pi/2 - phi, tilted clockwise by alpha, |alpha| < phi (lines 289-294).
    [[nodiscard]] static Profile tilted_wedge(const formula::Exact& phi,
                                              const formula::Exact& alpha);
    /// Flat of length 2t between arcs of radius R, tilted clockwise by alpha >= 0, with the origin
    /// at the minimum (lines 339-346).
    [[nodiscard]] static Profile tilted_flat_and_rounded(const formula::Exact& alpha,
                                                         const formula::Exact& t,
                                                         const formula::Exact& R);
    /// The user's own: `slopes[i]` (in x) holds between knots[i-1] and knots[i]. Throws InputError
    /// that names the place where knots do not ascend, g' decreases, or the minimum is not at 0.
    /// The two outer pieces need to rise, or to have a value, only as far as the contact reaches.
    [[nodiscard]] static Profile piecewise(const std::vector<formula::Exact>& knots,
                                           const std::vector<formula::Expr>& slopes);
    /// The same, given for x > 0 only and continued by g'(-x) = -g'(x).
    [[nodiscard]] static Profile piecewise_symmetric(const std::vector<formula::Exact>& knots,
                                                     const std::vector<formula::Expr>& slopes);

    [[nodiscard]] Kind kind() const noexcept { return kind_; }
    /// "power-law", "flat-and-rounded", ... as in a scene file.
    [[nodiscard]] std::string kind_name() const;
    /// True if g'(-x) = -g'(x) by construction: then b = a, and nothing is solved for it.
    [[nodiscard]] bool symmetric() const noexcept { return symmetric_; }
    /// True if every piece is linear in x: then pressures have a closed form in logarithms.
    [[nodiscard]] bool piecewise_linear() const noexcept;
    /// True if the pressure has a closed form: in logarithms, or Gauss's 2F1 for a power law.
    [[nodiscard]] bool has_closed_form() const noexcept {
        return kind_ == Kind::power_law || piecewise_linear();
    }
    /// Parameters by their name in the paper (m, C, t, R, phi, alpha).
    [[nodiscard]] const std::map<std::string, formula::Exact>& parameters() const noexcept {
        return parameters_;
    }
    /// Ascending; `pieces()[i]` ends at `knots()[i]` and `pieces()[i+1]` begins there.
    [[nodiscard]] const std::vector<formula::Exact>& knots() const noexcept { return knots_; }
    [[nodiscard]] const std::vector<SlopePiece>& pieces() const noexcept { return pieces_; }
    /// Index of the origin among the knots.
    [[nodiscard]] std::size_t origin() const noexcept { return origin_; }
    /// The place, if any, up to which a user's slope rises on that side, less a millionth of its
    /// way: beyond, `slopes` ends or decreases, and g' goes on along a straight line so that
    /// contacts can be searched for. One that reaches it is refused (NormalContact).
    [[nodiscard]] const std::optional<formula::Exact>& rises_to(Edge edge) const noexcept {
        return edge == Edge::right ? right_limit_ : left_limit_;
    }
    /// Whether g' itself jumps at a knot (a corner), rather than only bends.
    [[nodiscard]] bool has_corner(std::size_t knot) const { return corner_.at(knot); }
    /// The same contact seen in a mirror: g'(x) becomes -g'(-x); right becomes left.
    [[nodiscard]] Profile reflected() const;

private:
    Profile() = default;
    void find_forms_at_knots();
    void continue_outer_pieces();
    static Profile assemble(Kind kind, std::vector<formula::Exact> knots,
                            std::vector<formula::Expr> slopes);

    Kind kind_ = Kind::piecewise;
    bool symmetric_ = false;
    std::map<std::string, formula::Exact> parameters_;
    std::vector<formula::Exact> knots_;
    std::vector<SlopePiece> pieces_;
    std::vector<bool> corner_;
    std::size_t origin_ = 0;
    std::optional<formula::Exact> left_limit_;
    std::optional<formula::Exact> right_limit_;
};

/// a + b x with a, b free of `x`, where the expression has that form by inspection of its tree.
[[nodiscard]] std::optional<SlopePiece::Linear> as_linear(const formula::Expr& e,
                                                          std::string_view x);

} // namespace edgeproof::contact
