// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/linear_contact.hpp"

#include "edgeproof/contact/enclosure/fields.hpp"

namespace edgeproof::contact {
namespace {

/// Of a knot inside for some parameters of the box and outside for others: every member is
/// continuous there, that of a knot outside being that of the edge, at 0 and a + b from the edges.
/// Not so derivatives: of jets nothing is known then.
LinearContact<Ball>::Mark mark_by_an_edge(const Ball& length, Ball right, Ball left) {
    Ball& far = contains_zero(left) ? right : left;
    far = Ball::hull(far, length);
    return {right,
            left,
            (left - right) / 2,
            Field<Ball>::root(right * left),
            Field<Ball>::angle(right, left),
            false};
}

} // namespace

template <class T>
typename LinearContact<T>::Mark LinearContact<T>::right_end(const T& a, const T& b) const {
    return {constant(0), a + b, (a + b) / 2, constant(0), constant(0), true};
}
template <class T>
typename LinearContact<T>::Mark LinearContact<T>::left_end(const T& a, const T& b) const {
    return {a + b, constant(0), -((a + b) / 2), constant(0), T(Ball::pi(bits)), true};
}
template <class T>
typename LinearContact<T>::Mark LinearContact<T>::mark(const T& a, const T& b, const T& v) const {
    const T right = a - v;
    const T left = v + b;
    if (certainly_negative(value_in(right))) {
        return right_end(a, b);
    }
    if (certainly_negative(value_in(left))) {
        return left_end(a, b);
    }
    if constexpr (std::is_same_v<T, Ball>) {
        if (!certainly_positive(right) || !certainly_positive(left)) {
            return mark_by_an_edge(a + b, right, left);
        }
    }
    return {right, left, (left - right) / 2, sqrt(right * left), atan(sqrt(right / left)) * 2,
            false};
}

template <class T>
template <class AtKnot, class Between>
T LinearContact<T>::over_measure(const T& a, const T& b, const AtKnot& at_knot,
                                 const Between& between) const {
    T sum = constant(0);
    Mark previous = left_end(a, b);
    for (std::size_t i = 0; i <= knots.size(); ++i) {
        const Mark next = i < knots.size() ? mark(a, b, knots[i]) : right_end(a, b);
        sum += pieces[i].rate * between(i, previous, next);
        if (i < knots.size() && (corner[i] || i == origin)) {
            sum += at_knot(i, next);
        }
        previous = next;
    }
    return sum;
}

template <class T> T LinearContact<T>::imbalance(const T& a, const T& b) const {
    const T pi = T(Ball::pi(bits));
    return over_measure(
        a, b,
        [&](std::size_t i, const Mark& m) {
            if (i != origin) {
                return i > origin ? jumps[i] * m.h : -(jumps[i] * (pi - m.h));
            }
            // g'(0+) weighs on the right, -g'(0-) on the left.
            return pieces[i + 1].at_origin * m.h + pieces[i].at_origin * (pi - m.h);
        },
        [&](std::size_t i, const Mark& m, const Mark& n) {
            if (i > origin) {
                return n.y * n.h - m.y * m.h + m.w - n.w;
            }
            return -(n.y * (pi - n.h) - m.y * (pi - m.h) + n.w - m.w);
        });
}

template <class T> T LinearContact<T>::imbalance_rate(const T& a, const T& b) const {
    const T d = (a + b) / 2;
    const T sum = over_measure(
        a, b,
        [&](std::size_t i, const Mark& m) {
            return m.outside || !corner[i] ? constant(0) : jumps[i] * m.right / m.w;
        },
        [&](std::size_t, const Mark& m, const Mark& n) { return n.w - m.w + d * (m.h - n.h); });
    return -(sum / (a + b));
}

template <class T> T LinearContact<T>::force(const T& a, const T& b) const {
    const T d = (a + b) / 2;
    return modulus / 2 *
           over_measure(
               a, b,
               [&](std::size_t i, const Mark& m) {
                   return corner[i] ? jumps[i] * m.w : constant(0);
               },
               [&](std::size_t, const Mark& m, const Mark& n) {
                   return (n.y * n.w - m.y * m.w + d * d * (m.h - n.h)) / 2;
               });
}

template <class T> T LinearContact<T>::force_rate(const T& a, const T& b) const {
    const T d = (a + b) / 2;
    return modulus / 2 *
           over_measure(
               a, b,
               [&](std::size_t i, const Mark& m) {
                   return m.outside || !corner[i] ? constant(0) : jumps[i] * m.left / m.w;
               },
               [&](std::size_t, const Mark& m, const Mark& n) {
                   return m.w - n.w + d * (m.h - n.h);
               });
}

template <class T> T LinearContact<T>::arc(const T& a, const T& b) const {
    return over_measure(
        a, b, [&](std::size_t, const Mark&) { return constant(0); },
        [](std::size_t, const Mark& m, const Mark& n) { return m.h - n.h; });
}

template <class T>
LinearContact<T> linear_contact(const ParametricSlope& slope, const formula::Expr& contact_modulus,
                                const ParameterValues<T>& value) {
    LinearContact<T> c;
    c.bits = value.bits();
    c.origin = slope.origin;
    c.corner = slope.corner;
    c.modulus = value(contact_modulus);
    for (const formula::Expr& knot : slope.knots) {
        c.knots.push_back(value(knot));
    }
    for (const ParametricSlope::Piece& piece : slope.pieces) {
        c.pieces.push_back({value(piece.at_origin), value(piece.rate)});
    }
    for (std::size_t i = 0; i < c.knots.size(); ++i) {
        const auto at = [&](const typename LinearContact<T>::Piece& p) {
            return p.at_origin + p.rate * c.knots[i];
        };
        c.jumps.push_back(slope.corner[i] ? at(c.pieces[i + 1]) - at(c.pieces[i]) : c.constant(0));
    }
    return c;
}

template struct LinearContact<Ball>;
template struct LinearContact<Jet>;
template LinearContact<Ball> linear_contact(const ParametricSlope&, const formula::Expr&,
                                            const ParameterValues<Ball>&);
template LinearContact<Jet> linear_contact(const ParametricSlope&, const formula::Expr&,
                                           const ParameterValues<Jet>&);

} // namespace edgeproof::contact
