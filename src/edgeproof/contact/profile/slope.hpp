// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/series/divided_difference.hpp"
#include "edgeproof/series/functions.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// The environment in which an expression in x is evaluated over T, Series<T> or
/// DividedDifference<T>. `lift` makes a constant of that type.
template <class U, class T, class Lift> class SlopeEnvironment {
public:
    SlopeEnvironment(const U& x, const Lift& lift) : x_(x), lift_(lift) {}
    [[nodiscard]] U number(const Rational& q) const { return lift_(from_rational<T>(q)); }
    [[nodiscard]] U pi() const { return lift_(edgeproof::pi<T>()); }
    [[nodiscard]] U symbol(std::string_view) const { return x_; }

private:
    const U& x_;
    const Lift& lift_;
};

/// g' of a Profile (dimensionless; x is a length) in the arithmetic T, at the precision of the
/// thread that constructs it.
template <Arithmetic T> class SlopeIn {
public:
    struct Piece {
        bool linear = false;
        T at_origin{}; ///< g' = at_origin + rate x if linear
        T rate{};
        Expr expression;
        std::optional<Expr>
            from_left; ///< in the distance from the knot at the left end (profile.hpp)
        std::optional<Expr> from_right;
    };
    /// A place on a piece that is near the knot at one end of it; the distance from this knot has
    /// more digits than x.
    struct NearKnot {
        std::size_t knot;
        T away; ///< x - knot
    };

    explicit SlopeIn(const Profile& profile) : origin_(profile.origin()) {
        for (std::size_t i = 0; i < profile.knots().size(); ++i) {
            knots_.push_back(profile.knots()[i].template to<T>());
        }
        for (const SlopePiece& piece : profile.pieces()) {
            Piece p;
            p.expression = piece.slope;
            p.from_left = piece.from_left;
            p.from_right = piece.from_right;
            if (piece.linear) {
                p.linear = true;
                p.at_origin = Exact(piece.linear->at_origin).template to<T>();
                p.rate = Exact(piece.linear->rate).template to<T>();
            }
            pieces_.push_back(std::move(p));
        }
        for (std::size_t i = 0; i < knots_.size(); ++i) {
            jumps_.push_back(
                profile.has_corner(i) ? T(value(i + 1, knots_[i]) - value(i, knots_[i])) : T(0));
        }
    }

    [[nodiscard]] const std::vector<T>& knots() const noexcept { return knots_; }
    [[nodiscard]] const std::vector<Piece>& pieces() const noexcept { return pieces_; }
    [[nodiscard]] std::size_t origin() const noexcept { return origin_; }
    /// g'(knot+) - g'(knot-); exactly 0 where there is no corner.
    [[nodiscard]] const T& jump(std::size_t knot) const { return jumps_[knot]; }
    [[nodiscard]] bool has_corner(std::size_t knot) const { return !(jumps_[knot] == T(0)); }
    /// g'' of a linear piece (1/length), and its decrease across a knot between two linear pieces.
    [[nodiscard]] const T& rate(std::size_t piece) const { return pieces_[piece].rate; }
    [[nodiscard]] T rate_drop(std::size_t knot) const { return T(rate(knot) - rate(knot + 1)); }

    /// g'(x) by the expression of one piece.
    [[nodiscard]] T value(std::size_t piece, const T& x) const {
        const Piece& p = pieces_[piece];
        if (p.linear) {
            return T(p.at_origin + p.rate * x);
        }
        const auto lift = [](const T& c) { return c; };
        return evaluate<T>(p.expression, SlopeEnvironment<T, T, decltype(lift)>(x, lift));
    }
    /// g'' of one piece (1/length); x is a number or a series.
    template <class U> [[nodiscard]] U rate(std::size_t piece, const U& x) const;
    /// (g'(s) - g'(x))/(s - x) by the expression of one piece, without cancellation
    /// (docs/pressure.md, "The singular integral, and how its pole is taken out"). delta = s - x is
    /// a parameter of its own so that both s and delta may be exact.
    [[nodiscard]] T quotient(std::size_t piece, const T& x, const T& s, const T& delta) const {
        const Piece& p = pieces_[piece];
        if (p.linear) {
            return p.rate;
        }
        return quotient_of(p.expression, x, s, delta);
    }
    /// value() of a piece that begins or ends at the knot of `place`.
    [[nodiscard]] T value(std::size_t piece, const T& x, const NearKnot& place) const {
        const Expr* form = form_at(piece, place.knot);
        const auto lift = [](const T& c) { return c; };
        return form == nullptr
                   ? value(piece, x)
                   : evaluate<T>(*form, SlopeEnvironment<T, T, decltype(lift)>(place.away, lift));
    }
    /// rate() of a piece that begins or ends at the knot; x is a number or a series, away = x -
    /// knot.
    template <class U>
    [[nodiscard]] U rate(std::size_t piece, const U& x, std::size_t knot, const U& away) const {
        const Expr* form = form_at(piece, knot);
        return form == nullptr ? rate(piece, x) : rate_of(*form, away);
    }
    /// quotient() of a piece that begins or ends at the knot of `place`, which gives s - knot.
    [[nodiscard]] T quotient(std::size_t piece, const T& x, const T& s, const T& delta,
                             const NearKnot& place) const {
        const Expr* form = form_at(piece, place.knot);
        if (form == nullptr) {
            return quotient(piece, x, s, delta);
        }
        return quotient_of(*form, T(x - knots_[place.knot]), place.away, delta);
    }
    /// The piece that contains x; at a knot, the one to its right.
    [[nodiscard]] std::size_t piece_at(const T& x) const {
        std::size_t i = 0;
        while (i < knots_.size() && !(x < knots_[i])) {
            ++i;
        }
        return i;
    }

private:
    /// The form in the distance from the knot; null if the form in x is as accurate.
    [[nodiscard]] const Expr* form_at(std::size_t piece, std::size_t knot) const {
        const auto& form = piece == knot ? pieces_[piece].from_right : pieces_[piece].from_left;
        return form ? &*form : nullptr;
    }
    [[nodiscard]] static T quotient_of(const Expr& g, const T& x, const T& s, const T& delta) {
        using D = series::DividedDifference<T>;
        const auto lift = [&](const T& c) { return D::constant(c, delta); };
        const D at{x, s, T(1), delta};
        return evaluate<D>(g, SlopeEnvironment<D, T, decltype(lift)>(at, lift)).q;
    }
    template <class U> [[nodiscard]] static U rate_of(const Expr& g, const U& x);

    std::size_t origin_;
    std::vector<T> knots_;
    std::vector<Piece> pieces_;
    std::vector<T> jumps_;
};

template <Arithmetic T> template <class U> U SlopeIn<T>::rate(std::size_t piece, const U& x) const {
    const Piece& p = pieces_[piece];
    if constexpr (std::same_as<U, T>) {
        return p.linear ? p.rate : rate_of(p.expression, x);
    } else {
        return p.linear ? U(p.rate, x.order()) : rate_of(p.expression, x);
    }
}

template <Arithmetic T> template <class U> U SlopeIn<T>::rate_of(const Expr& g, const U& x) {
    if constexpr (std::same_as<U, T>) {
        // Two terms of the Taylor series at x: the second is g''.
        using S = series::Series<T>;
        const auto lift = [](const T& c) { return S(c, 2); };
        return evaluate<S>(g, SlopeEnvironment<S, T, decltype(lift)>(S::variable(x, 2), lift))[1];
    } else {
        const std::size_t n = x.order();
        // g'' along the series x(z): the derivative of the Taylor series of g' at x_0, composed
        // with x - x_0 by Horner's rule.
        const auto lift = [n](const T& c) { return U(c, n + 1); };
        const U taylor =
            evaluate<U>(g, SlopeEnvironment<U, T, decltype(lift)>(U::variable(x[0], n + 1), lift));
        const U second = derivative(taylor);
        U result(second[n - 1], n);
        for (std::size_t k = n - 1; k-- > 0;) {
            U shift = x;
            shift[0] = T(0);
            result = result * shift;
            result[0] += second[k];
        }
        return result;
    }
}

/// Returns a slope g'(x) as a function of the distance x - knot; the symbol of the distance is x
/// again. Parts that are linear in x and vanish at the knot lose their constant exactly. So (x -
/// 1/5)^(3/2) keeps its digits at any distance from 1/5.
[[nodiscard]] Expr slope_from_knot(const Expr& slope, const Expr& knot);

/// Returns the same function with polynomials of rational coefficients multiplied out. Returns
/// nothing where no part of the slope vanishes at the knot, or where the knot is 0: then x itself
/// has all digits.
[[nodiscard]] std::optional<Expr> slope_near_zero(const Expr& slope, const Expr& knot);

/// A slope near a knot that is a branch point of it, written without the branch point. With
/// w^root = |x - knot|, (x - knot)^(3/2) becomes w^3 for root = 2 (docs/curved-slopes.md, "What is
/// integrated").
struct SlopeAtRoot {
    Expr slope;    ///< as a function of w >= 0; the symbol is called x
    long root = 1; ///< the least common denominator of the exponents of x - knot
};

/// Returns this form for the side to the right or to the left of the knot. Returns nothing if no
/// power of a multiple of x - knot has a rational exponent that is not an integer, or if the common
/// denominator is greater than 24.
[[nodiscard]] std::optional<SlopeAtRoot> slope_at_root(const Expr& slope, const Expr& knot,
                                                       bool to_the_right);

/// Checks a profile given by the user: the knots ascend, g' does not decrease, g' <= 0 left of the
/// origin and g' >= 0 right of it. Returns which knots are corners. Throws an InputError that names
/// the place.
/// On a piece between two knots that is not linear, g' is only *sampled* here (64 points); the
/// contact proves that it rises for every value that is called proved (curved_slope.hpp).
/// Linear pieces and all knots are decided exactly. rising_limit checks the outer pieces.
[[nodiscard]] std::vector<bool> checked_corners(const Profile& profile);

/// The place where an outer piece stops rising.
struct RisingLimit {
    Exact at;      ///< the place, moved back by a millionth of its distance from the last knot
    Rational rate; ///< the rate of the straight line that continues g', > 0, 1/length
    Expr slope;    ///< the slope of the piece
};

/// Returns the place where the outermost piece on a side stops rising or stops having a value. The
/// piece is sampled at distances of 2^-30 to 2^30 from its knot. Returns nothing if neither
/// happens, or if the piece is linear. Throws InputError if it happens at the knot.
[[nodiscard]] std::optional<RisingLimit> rising_limit(const Profile& profile, Edge edge);

/// Throws InputError if the contact reaches a place beyond which the profile does not rise. `a` and
/// `b` are enclosures of the edges.
void check_reach(const Profile& profile, const Ball& a, const Ball& b);

/// Throws InputError if 64 samples of a piece inside the contact -b < x < a show that g' decreases.
void sample_slope(const Profile& profile, const SlopeIn<Real>& slope, const Real& a, const Real& b);

} // namespace edgeproof::contact
