// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile.hpp"
#include "edgeproof/formula/environment.hpp"
#include "edgeproof/formula/evaluate.hpp"
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/series/divided_difference.hpp"
#include "edgeproof/series/functions.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace edgeproof {

/// Evaluates an expression in x over T, Series<T> or DividedDifference<T>: `lift` makes a constant
/// of that type.
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

/// g' of a Profile in the arithmetic T, at the precision of the thread that makes it.
template <Arithmetic T> class SlopeIn {
public:
    struct Piece {
        bool linear = false;
        T at_origin{}; ///< g' = at_origin + rate x if linear
        T rate{};
        Expr expression;
    };

    explicit SlopeIn(const Profile& profile) : origin_(profile.origin()) {
        for (std::size_t i = 0; i < profile.knots().size(); ++i) {
            knots_.push_back(profile.knots()[i].template to<T>());
        }
        for (const SlopePiece& piece : profile.pieces()) {
            Piece p;
            p.expression = piece.slope;
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
    /// g'(knot+) - g'(knot-), exactly 0 where there is no corner.
    [[nodiscard]] const T& jump(std::size_t knot) const { return jumps_[knot]; }

    /// g'(x) by the expression of one piece.
    [[nodiscard]] T value(std::size_t piece, const T& x) const {
        const Piece& p = pieces_[piece];
        if (p.linear) {
            return T(p.at_origin + p.rate * x);
        }
        const auto lift = [](const T& c) { return c; };
        return evaluate<T>(p.expression, SlopeEnvironment<T, T, decltype(lift)>(x, lift));
    }
    /// g'' of one piece, for x a number or a series.
    template <class U> [[nodiscard]] U rate(std::size_t piece, const U& x) const;
    /// (g'(s) - g'(x))/(s - x) by the expression of one piece, without cancellation; delta = s - x
    /// is given beside s so that both may be exact.
    [[nodiscard]] T quotient(std::size_t piece, const T& x, const T& s, const T& delta) const {
        const Piece& p = pieces_[piece];
        if (p.linear) {
            return p.rate;
        }
        using D = DividedDifference<T>;
        const auto lift = [&](const T& c) { return D::constant(c, delta); };
        const D at{x, s, T(1), delta};
        return evaluate<D>(p.expression, SlopeEnvironment<D, T, decltype(lift)>(at, lift)).q;
    }
    /// The piece that holds at x; at a knot, the one to its right.
    [[nodiscard]] std::size_t piece_at(const T& x) const {
        std::size_t i = 0;
        while (i < knots_.size() && !(x < knots_[i])) {
            ++i;
        }
        return i;
    }

private:
    std::size_t origin_;
    std::vector<T> knots_;
    std::vector<Piece> pieces_;
    std::vector<T> jumps_;
};

template <Arithmetic T> template <class U> U SlopeIn<T>::rate(std::size_t piece, const U& x) const {
    const Piece& p = pieces_[piece];
    if constexpr (std::same_as<U, T>) {
        if (p.linear) {
            return p.rate;
        }
        // Two terms of the Taylor series at x: the second is g''.
        using S = Series<T>;
        const auto lift = [](const T& c) { return S(c, 2); };
        return evaluate<S>(p.expression,
                           SlopeEnvironment<S, T, decltype(lift)>(S::variable(x, 2), lift))[1];
    } else {
        const std::size_t n = x.order();
        if (p.linear) {
            return U(p.rate, n);
        }
        // g'' along the series x(z): the Taylor series of g' at x_0, derived, composed with x -
        // x_0.
        const auto lift = [n](const T& c) { return U(c, n + 1); };
        const U taylor = evaluate<U>(
            p.expression, SlopeEnvironment<U, T, decltype(lift)>(U::variable(x[0], n + 1), lift));
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

} // namespace edgeproof
