// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/design/error_family.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/enclosure/zone_equations.hpp"
#include "edgeproof/contact/law/linear_measure.hpp"

#include <optional>
#include <type_traits>
#include <vector>

namespace edgeproof::contact {
namespace {

/// The mark of a knot that is not certainly outside. If it is inside for some parameters of the box
/// and outside for others, every member is continuous there, since a knot outside has the mark of
/// the edge, at the distances 0 and a + b from the edges. Derivatives are not continuous: a series
/// is then not finite.
Mark<Ball> mark_inside(const Ball& length, Ball right, Ball left) {
    if (!certainly_positive(right) || !certainly_positive(left)) {
        Ball& far = contains_zero(left) ? right : left;
        far = Ball::hull(far, length);
    }
    return mark_between(right, left);
}
Mark<BallSeries> mark_inside(const BallSeries& /*length*/, const BallSeries& right,
                             const BallSeries& left) {
    return mark_between(right, left);
}

/// A contact on a piecewise linear slope whose knots, slopes and edges are balls or series. The
/// integrals are those of contact/law over these types. A result is not finite if an edge may lie
/// on a knot.
template <class T> struct LinearContact {
    LinearSlope<T> slope;
    T modulus; ///< E*

    LinearContact(const ParametricSlope& of, const Expr& contact_modulus,
                  const ParameterValues<T>& value)
        : modulus(value(contact_modulus)) {
        for (const Expr& knot : of.knots) {
            slope.knots.push_back(value(knot));
        }
        for (const ParametricSlope::Piece& piece : of.pieces) {
            slope.pieces.push_back({value(piece.at_origin), value(piece.rate)});
        }
        slope.corners = of.corners;
        slope.origin = of.origin;
        slope.find_jumps();
    }
    /// Positive if the left edge must lie further out (moore-hills EQ20).
    [[nodiscard]] T imbalance(const Extent<T>& e) const {
        return linear_imbalance(slope, e, marks(e));
    }
    /// The derivative of the imbalance with respect to b.
    [[nodiscard]] T imbalance_rate(const Extent<T>& e) const {
        return -(over_linear_measure<LeftRateKernel>(slope, e, marks(e)) / e.length());
    }
    /// The normal force P per unit length (moore-hills EQ22).
    [[nodiscard]] T force(const Extent<T>& e) const {
        return Field<T>::over(modulus, 2) * over_linear_measure<ForceKernel>(slope, e, marks(e));
    }
    /// dP/da along the family of contacts.
    [[nodiscard]] T force_rate(const Extent<T>& e) const {
        return Field<T>::over(modulus, 2) *
               over_linear_measure<RightRateKernel>(slope, e, marks(e));
    }
    /// The marks of the knots.
    [[nodiscard]] std::vector<Mark<T>> marks(const Extent<T>& e) const {
        std::vector<Mark<T>> all;
        for (const T& knot : slope.knots) {
            const T right = e.a - knot;
            const T left = e.b + knot;
            if (certainly_negative(value_in(right))) {
                all.push_back(right_end(e));
            } else if (certainly_negative(value_in(left))) {
                all.push_back(left_end(e));
            } else {
                all.push_back(mark_inside(e.length(), right, left));
            }
        }
        return all;
    }
};

/// Encloses the edges over a box of parameters by interval Newton, which proves that for each
/// parameter of the box an edge lies in the ball and is the only one there. Throws BudgetError if
/// the box is too wide, or if an edge may lie on a knot, DomainError if there is no contact.
/// `in_middle`: the contact in the middle of the box.
Extent<Ball> solve_edges(const LinearContact<Ball>& contact, const LinearContact<Ball>& in_middle,
                         bool symmetric, const std::optional<Ball>& a,
                         const std::optional<Ball>& P) {
    constexpr long enough = 24; // bits, for Newton's method
    if (a && symmetric) {
        return {*a, *a};
    }
    const auto equations = [&](const LinearContact<Ball>& of) -> ZoneEquations {
        return {
            .values =
                [&of](const BallZone& zone) {
                    const Extent<Ball> e{zone.a, zone.b};
                    return ZoneValues{of.force(e), of.imbalance(e) / Ball::pi(of.modulus.bits())};
                },
            .rates =
                [&of](const BallZone& zone) {
                    const Extent<Ball> e{zone.a, zone.b};
                    return ZoneRates{of.force_rate(e),
                                     of.imbalance_rate(e) * e.length() * of.modulus / -2};
                },
            .modulus = of.modulus,
            .tilt = Ball(0, of.modulus.bits()),
            .force = P,
            .right_edge = a,
            .symmetric = symmetric};
    };
    ZoneEquations narrow = equations(in_middle);
    narrow.force = P ? std::optional(middle(*P)) : P;
    const Ball origin(0, in_middle.modulus.bits());
    const Ball first = middle(a ? *a : *P / in_middle.modulus);
    const BallZone found = narrow.search(narrow.from_afar({origin, origin, first}, enough));
    const BallZone zone = equations(contact).proved(found);
    return {zone.a, zone.b};
}

/// The edges as series, by the implicit function theorem, from edges that are enclosed.
Extent<BallSeries> moving_edges(const LinearContact<BallSeries>& contact, const Extent<Ball>& edges,
                                bool symmetric, const std::optional<BallSeries>& a,
                                const std::optional<BallSeries>& P) {
    // Each step adds a term, since the rate is known to its first term.
    const auto implicit = [](const Ball& start, const auto& residual, const Ball& rate) {
        BallSeries x(start, jet_terms);
        for (std::size_t k = 1; k < jet_terms; ++k) {
            x.set(k, x[k] - residual(x)[k] / rate);
        }
        return x;
    };
    const Extent<BallSeries> constant{BallSeries(edges.a, jet_terms),
                                      BallSeries(edges.b, jet_terms)};
    const auto to_left = [&](const BallSeries& right) -> Extent<BallSeries> {
        if (symmetric) {
            return {right, right};
        }
        const auto residual = [&](const BallSeries& b) { return contact.imbalance({right, b}); };
        return {right, implicit(edges.b, residual, contact.imbalance_rate(constant)[0])};
    };
    if (a) {
        return to_left(*a);
    }
    const auto missing = [&](const BallSeries& x) { return contact.force(to_left(x)) - *P; };
    return to_left(implicit(edges.a, missing, contact.force_rate(constant)[0]));
}

/// artanh(sqrt(x))/sqrt(x), 0 <= x < 1. It increases, since its power series has positive terms.
Ball arc_over_root(const Ball& x) {
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

/// The errors over a box in which no value can be enclosed.
ErrorOverBox unknown_errors(long bits) {
    const Ball unknown = unknown_ball(bits);
    return {[unknown](const Ball&) { return unknown; },
            [bits](const Ball&, Along) { return unknown_series(jet_terms, bits); }, unknown};
}

/// The closed form of LinearError (docs/pressure.md) for values of either type.
struct LinearForm {
    const ParametricSlope& slope;
    const ParametricLoad& load;
    const ErrorQuestion& question;
    Extent<Ball> edges;

    template <class T>
    [[nodiscard]] LinearError<T> operator()(const ParameterValues<T>& value) const {
        const LinearContact<T> contact(slope, load.contact_modulus, value);
        if constexpr (std::is_same_v<T, Ball>) {
            return {contact, edges, question};
        } else {
            return {contact,
                    moving_edges(contact, edges, slope.symmetric, value(load.a), value(load.P)),
                    question};
        }
    }
};

} // namespace

ErrorFamily linear_slope_errors(const ParametricSlope& slope, const ParametricLoad& load,
                                const ErrorQuestion& question) {
    const auto n = static_cast<double>(question.terms);
    const auto over = [=](const Ball& parameter) {
        const ParameterValues<Ball> value{parameter};
        const ParameterValues<Ball> in_middle{middle(parameter)};
        try {
            const Extent<Ball> edges =
                solve_edges(LinearContact<Ball>(slope, load.contact_modulus, value),
                            LinearContact<Ball>(slope, load.contact_modulus, in_middle),
                            slope.symmetric, value(load.a), value(load.P));
            const bool fraction = question.unit == ReachUnit::fraction;
            return closed_form_error(parameter, LinearForm{slope, load, question, edges},
                                     fraction ? Ball(1, parameter.bits()) : edges.length());
        } catch (const BudgetError&) {
        } catch (const DomainError&) {
        }
        return unknown_errors(parameter.bits());
    };
    return {{(load.P ? 800 : 130) + n * n * n, 10, 60}, over};
}

} // namespace edgeproof::contact
