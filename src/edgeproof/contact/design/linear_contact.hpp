// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/design/error_family.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/law/linear_measure.hpp"

#include <optional>
#include <vector>

namespace edgeproof::contact {

/// A contact on a piecewise linear slope whose knots, slopes and edges are balls or series. The
/// integrals are those of contact/law over these types. A result is not finite if an edge may lie
/// on a knot.
template <class T> struct LinearContact {
    LinearSlope<T> slope;
    T modulus; ///< E*

    LinearContact(const ParametricSlope& of, const Expr& contact_modulus,
                  const ParameterValues<T>& value);
    /// Positive if the left edge must lie further out (moore-hills EQ20).
    [[nodiscard]] T imbalance(const Extent<T>& e) const;
    /// The derivative of the imbalance with respect to b.
    [[nodiscard]] T imbalance_rate(const Extent<T>& e) const;
    /// The normal force P per unit length (moore-hills EQ22).
    [[nodiscard]] T force(const Extent<T>& e) const;
    /// dP/da along the family of contacts.
    [[nodiscard]] T force_rate(const Extent<T>& e) const;
    /// The marks of the knots.
    [[nodiscard]] std::vector<Mark<T>> marks(const Extent<T>& e) const;
};

extern template struct LinearContact<Ball>;
extern template struct LinearContact<BallSeries>;

/// Encloses the edges over a box of parameters by interval Newton, which proves that for each
/// parameter of the box an edge lies in the ball and is the only one there. Throws BudgetError if
/// the box is too wide, or if an edge may lie on a knot, DomainError if there is no contact.
/// `in_middle`: the contact in the middle of the box.
[[nodiscard]] Extent<Ball> solve_edges(const LinearContact<Ball>& contact,
                                       const LinearContact<Ball>& in_middle, bool symmetric,
                                       const std::optional<Ball>& a, const std::optional<Ball>& P);
/// The edges as series, by the implicit function theorem, from edges that are enclosed.
[[nodiscard]] Extent<BallSeries> moving_edges(const LinearContact<BallSeries>& contact,
                                              const Extent<Ball>& edges, bool symmetric,
                                              const std::optional<BallSeries>& a,
                                              const std::optional<BallSeries>& P);

/// artanh(sqrt(x))/sqrt(x), 0 <= x < 1. It increases, since its power series has positive terms.
inline Ball arc_over_root(const Ball& x) {
    const auto at = [&](const Real& end) {
        const Ball e(end, x.bits());
        if (!certainly_positive(e)) {
            return Ball(1, x.bits());
        }
        const Ball root = sqrt(e);
        return atanh(root) / root;
    };
    return Ball::hull(at(x.lower()), at(x.upper()));
}

/// p/sqrt(u) at an edge, times 2 pi/E*: the sum of arc sqrt(D - u) and of (jump + drop (v - x))
/// G/sqrt(u) over the knots inside, where G = ln((1 + s)/|1 - s|), s^2 = u (D - u_v)/((D - u) u_v),
/// u_v the distance of a knot from the edge (docs/pressure.md).
template <class T> struct LinearError {
    struct Knot {
        T distance; ///< u_v
        T jump;
        T drop; ///< the decrease of g'' across the knot, times the sign of v - x beyond it
        bool corner;
    };
    T length;
    T arc;
    std::vector<Knot> knots;
    std::vector<T> inverse_powers; ///< powers of 1/length
    std::vector<T> coefficients;   ///< c_k times 2 pi/E*
    bool fraction = true;
    Ball one; ///< at the working precision

    LinearError(const LinearContact<T>& contact, const Extent<T>& edges,
                const ErrorQuestion& question)
        : length(edges.length()), arc(arc_of(contact.slope, edges, contact.marks(edges))),
          fraction(question.unit == ReachUnit::fraction), one(1, value_in(length).bits()) {
        const bool right = question.edge == Edge::right;
        for (std::size_t i = 0; i < contact.slope.knots.size(); ++i) {
            const T from_right = edges.a - contact.slope.knots[i];
            const T from_left = edges.b + contact.slope.knots[i];
            if (certainly_negative(value_in(from_right)) ||
                certainly_negative(value_in(from_left))) {
                continue;
            }
            const T drop = contact.slope.rate_drop(i);
            knots.push_back({right ? from_right : from_left, contact.slope.jump(i),
                             right ? drop : T(-drop), contact.slope.has_corner(i)});
        }
        inverse_powers = {length * number(0) + one};
        for (std::size_t k = 0; k < question.terms; ++k) {
            coefficients.push_back(coefficient(k));
            inverse_powers.push_back(inverse_powers.back() / length);
        }
    }

    /// The coefficient of w^i in (1 - w)^(-s), s = j + half.
    [[nodiscard]] static Rational rising(const Rational& s, std::size_t i) {
        Rational q(1);
        for (std::size_t k = 0; k < i; ++k) {
            q *= (s + static_cast<long>(k)) / Rational(static_cast<long>(k) + 1);
        }
        return q;
    }
    [[nodiscard]] Ball number(const Rational& q) const { return {q, one.bits()}; }
    [[nodiscard]] static T twice(const T& x) { return x + x; }
    /// The coefficient of u^k in G/sqrt(u), which is 2 sqrt(kappa) times the sum of kappa^j (1 -
    /// u/D)^(-j-1/2) u^j/(2j + 1), kappa = (D - u_v)/(D u_v).
    [[nodiscard]] T green_coefficient(const Knot& knot, std::size_t k) const {
        const T kappa = kappa_of(knot);
        T sum = kappa * Ball(0, one.bits());
        T kappa_j = sum + one;
        for (std::size_t j = 0; j <= k; ++j) {
            const Rational s(2 * static_cast<long>(j) + 1, 2);
            sum = sum + kappa_j * number(rising(s, k - j) / (2 * s)) * inverse_powers[k - j];
            kappa_j = kappa_j * kappa;
        }
        return twice(sum * Field<T>::root(kappa));
    }
    [[nodiscard]] T kappa_of(const Knot& knot) const {
        return (length - knot.distance) / (length * knot.distance);
    }
    [[nodiscard]] T coefficient(std::size_t k) const {
        // sqrt(D - u) = sqrt(D) (1 - u/D)^(1/2)
        T sum = arc * sqrt(length) * number(rising(Rational(-1, 2), k)) * inverse_powers[k];
        for (const Knot& knot : knots) {
            if (k == 0) { // u_v sqrt(kappa), which is small for a knot near the edge
                sum = sum - twice(knot.drop * Field<T>::root(knot.distance *
                                                             (length - knot.distance) / length));
                if (knot.corner) {
                    sum = sum + twice(knot.jump * Field<T>::root(kappa_of(knot)));
                }
                continue;
            }
            sum = sum + (knot.jump - knot.drop * knot.distance) * green_coefficient(knot, k) +
                  knot.drop * green_coefficient(knot, k - 1);
        }
        return sum;
    }

    [[nodiscard]] T error(const T& given) const {
        const T u = fraction ? given * length : given;
        T sum = arc * sqrt(length - u);
        for (const Knot& knot : knots) {
            sum = sum + part_of(knot, u);
        }
        return horner(coefficients, u) / sum + -one;
    }

private:
    [[nodiscard]] T part_of(const Knot& knot, const T& u) const {
        const T offset = u - knot.distance;
        const T weight = knot.jump + knot.drop * offset;
        const T knot_in = (length - u) * knot.distance;
        // s, or 1/s beyond the knot
        const auto by_logarithm = [&](const T& s) {
            return T(weight * log1p(twice(s) / (-s + one)) / sqrt(u));
        };
        if (certainly_positive(value_in(offset))) {
            return by_logarithm(Field<T>::root(knot_in / ((length - knot.distance) * u)));
        }
        const T ratio = (length - knot.distance) / knot_in;
        const T z = ratio * u;
        if constexpr (std::is_same_v<T, Ball>) {
            if (certainly_less(z, number(Rational(1, 4)))) {
                return weight * Field<T>::root(ratio) * arc_over_root(clamped(z)) * 2;
            }
            if (contains_zero(offset) && !knot.corner) {
                return knot.drop *
                       moment_across(knot.distance * (length - u), u * (length - knot.distance),
                                     length, offset) /
                       sqrt(u);
            }
        }
        return by_logarithm(Field<T>::root(z));
    }
};

} // namespace edgeproof::contact
