// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/linear_contact.hpp"
#include "edgeproof/contact/law/logarithmic_pressure.hpp"

#include <functional>

namespace edgeproof::contact {
namespace {

/// The mark of a knot that is not certainly outside. If it is inside for some parameters of the box
/// and outside for others, every member is continuous there, since a knot outside has the mark of
/// the edge, at the distances 0 and a + b from the edges. Derivatives are not continuous: a jet is
/// then not finite.
Mark<Ball> mark_inside(const Ball& length, Ball right, Ball left) {
    if (!certainly_positive(right) || !certainly_positive(left)) {
        Ball& far = contains_zero(left) ? right : left;
        far = Ball::hull(far, length);
    }
    return mark_between(right, left);
}
Mark<Jet> mark_inside(const Jet& /*length*/, const Jet& right, const Jet& left) {
    return mark_between(right, left);
}

} // namespace

template <class T> std::vector<Mark<T>> LinearContact<T>::marks(const Extent<T>& e) const {
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

template <class T>
template <class Kernel>
T LinearContact<T>::over_measure(const Extent<T>& e) const {
    return over_linear_measure<Kernel>(slope, e, marks(e));
}

template <class T> T LinearContact<T>::imbalance(const T& a, const T& b) const {
    const Extent<T> e{a, b};
    T sum = linear_imbalance(slope, e, marks(e));
    if (!slope.has_corner(slope.origin)) {
        // g'(0) is not 0 in a tilted corrective contact; the integral of 1/w is pi.
        sum += slope.pieces[slope.origin].at_origin * Field<T>::pi(a);
    }
    return sum;
}

template <class T> T LinearContact<T>::imbalance_rate(const T& a, const T& b) const {
    return -(over_measure<LeftRateKernel>({a, b}) / (a + b));
}

template <class T> T LinearContact<T>::force(const T& a, const T& b) const {
    return modulus / 2 * over_measure<ForceKernel>({a, b});
}

template <class T> T LinearContact<T>::force_rate(const T& a, const T& b) const {
    return modulus / 2 * over_measure<RightRateKernel>({a, b});
}

template <class T> T LinearContact<T>::arc(const T& a, const T& b) const {
    const Extent<T> e{a, b};
    return arc_of(slope, e, marks(e));
}

template <class T>
LinearContact<T> linear_contact(const ParametricSlope& slope, const formula::Expr& contact_modulus,
                                const ParameterValues<T>& value) {
    LinearContact<T> c;
    c.bits = value.bits();
    c.modulus = value(contact_modulus);
    for (const formula::Expr& knot : slope.knots) {
        c.slope.knots.push_back(value(knot));
    }
    for (const ParametricSlope::Piece& piece : slope.pieces) {
        c.slope.pieces.push_back({value(piece.at_origin), value(piece.rate)});
    }
    c.slope.corners = slope.corner;
    c.slope.origin = slope.origin;
    c.slope.find_jumps();
    return c;
}

template struct LinearContact<Ball>;
template struct LinearContact<Jet>;
template LinearContact<Ball> linear_contact(const ParametricSlope&, const formula::Expr&,
                                            const ParameterValues<Ball>&);
template LinearContact<Jet> linear_contact(const ParametricSlope&, const formula::Expr&,
                                           const ParameterValues<Jet>&);

namespace {

constexpr int most_bracket_steps = 80;
constexpr int most_newton_steps = 60;
constexpr int most_inflations = 24;
constexpr int most_narrowings = 12;
constexpr int most_direct_steps = 8;

Ball centre(const Ball& x) { return {x.midpoint(), x.bits()}; }

using BallFunction = std::function<Ball(const Ball&)>;

/// Applies Newton's method to a start that may be good. Returns nothing if it does not converge at
/// once.
std::optional<Ball> zero_near(const BallFunction& f, const BallFunction& rate, Ball x) {
    const Ball small(Rational(1, Integer(1) << 40), x.bits());
    for (int k = 0; k < most_direct_steps; ++k) {
        const Ball step = centre(f(x) / rate(x));
        if (!step.is_finite()) {
            return {};
        }
        x = centre(x - step);
        if (!certainly_positive(x)) {
            return {};
        }
        if (certainly_less(abs(step), abs(x) * small)) {
            return x;
        }
    }
    return {};
}

/// Estimates the zero of f, which decreases on the positive axis, by doubling, halving and then
/// Newton's method on midpoints. Nothing is proved.
std::optional<Ball> approximate_zero(const BallFunction& f, const BallFunction& rate, Ball x) {
    if (auto near = zero_near(f, rate, x)) {
        return near;
    }
    std::optional<Ball> lo;
    std::optional<Ball> hi;
    for (int k = 0; k < most_bracket_steps && !(lo && hi); ++k) {
        const Ball value = f(x);
        if (!value.is_finite()) { // on a knot: the next place is tried
            x = centre(x * Ball(Rational(1021, 1000), x.bits()));
            continue;
        }
        if (certainly_positive(value)) {
            lo = x;
            x = centre(x * 2);
        } else {
            hi = x;
            x = centre(x / 2);
        }
    }
    if (!lo || !hi) {
        return {};
    }
    x = centre((*lo + *hi) / 2);
    for (int k = 0; k < most_newton_steps; ++k) {
        const Ball value = f(x);
        if (!value.is_finite()) {
            x = centre((*lo * 3 + *hi * 2) / 5);
            continue;
        }
        (certainly_positive(value) ? lo : hi) = x;
        const Ball step = centre(value / rate(x));
        Ball next = step.is_finite() ? centre(x - step) : *lo;
        if (!step.is_finite() || !certainly_less(*lo, next) || !certainly_less(next, *hi)) {
            next = centre((*lo + *hi) / 2);
        }
        const Ball near = abs(x) * Ball(Rational(1, Integer(1) << 40), x.bits());
        const bool done = certainly_less(abs(next - x), near); // the enclosure starts from there
        x = next;
        if (done) {
            break;
        }
    }
    return x;
}

/// Encloses the only zero in x, as narrowly as the box and the bits allow, by interval Newton
/// (moore-kearfott-cloud2009).
Ball narrowed_zero(const BallFunction& f, const BallFunction& rate, Ball x) {
    for (int k = 0; k < most_narrowings; ++k) {
        const Ball m = centre(x);
        const Ball image = m - f(m) / rate(x);
        Ball next = x;
        if (!image.is_finite() ||
            arb_intersection(next.data(), x.data(), image.data(), x.bits()) == 0 ||
            !certainly_less(Ball(next.radius(), x.bits()) * 2, Ball(x.radius(), x.bits()))) {
            break;
        }
        x = next;
    }
    return x;
}

/// Encloses the zero of f over a box, from an estimate of the zero in the middle of the box.
std::optional<Ball> enclosed_zero(const BallFunction& f, const BallFunction& rate,
                                  const Ball& about) {
    const Ball value = f(about);
    Ball image = about - value / rate(about);
    for (int k = 0; k < most_inflations; ++k) {
        if (!image.is_finite()) {
            return {};
        }
        const Ball slack =
            Ball(Ball(abs(image - about) / 4 +
                      abs(about) *
                          Ball(Rational(1, Integer(1) << static_cast<unsigned>(about.bits() - 8)),
                               about.bits()))
                     .upper(),
                 about.bits());
        const Ball trial = Ball::hull(image - slack, image + slack);
        const Ball next = about - value / rate(trial);
        if (!next.is_finite() || !certainly_positive(next)) {
            return {};
        }
        if (contains(trial, next)) {
            return narrowed_zero(f, rate, next);
        }
        image = Ball::hull(image, next);
    }
    return {};
}

/// Estimates the left edge for a given right edge.
std::optional<Ball> approximate_left_edge(const LinearContact<Ball>& middle, const Ball& right,
                                          const Ball& start) {
    return approximate_zero([&](const Ball& b) { return middle.imbalance(right, b); },
                            [&](const Ball& b) { return middle.imbalance_rate(right, b); }, start);
}

/// Encloses the left edge for a right edge that may itself be a ball.
std::optional<Ball> left_edge(const LinearContact<Ball>& contact, const LinearContact<Ball>& middle,
                              const Ball& a, const Ball& start) {
    const auto about = approximate_left_edge(middle, centre(a), start);
    if (!about) {
        return {};
    }
    return enclosed_zero([&](const Ball& b) { return contact.imbalance(a, b); },
                         [&](const Ball& b) { return contact.imbalance_rate(a, b); }, *about);
}

} // namespace

std::optional<LinearEdges<Ball>> solve_edges(const LinearContact<Ball>& contact,
                                             const LinearContact<Ball>& middle, bool symmetric,
                                             const std::optional<Ball>& a,
                                             const std::optional<Ball>& P,
                                             const LinearEdges<Ball>* start) {
    std::optional<Ball> last; // the last left edge, the start for the next one
    if (start != nullptr) {
        last = start->b;
    }
    const auto left = [&](const Ball& right) {
        return symmetric ? std::optional(right)
                         : left_edge(contact, middle, right, last ? *last : centre(right));
    };
    if (a) {
        const auto b = left(*a);
        return b ? std::optional(LinearEdges<Ball>{*a, *b}) : std::nullopt;
    }
    const Ball load = centre(*P);
    const auto left_in_middle = [&](const Ball& right) {
        if (symmetric) {
            return right;
        }
        const auto b = approximate_left_edge(middle, right, last ? *last : right);
        if (b) {
            last = *b;
        }
        return b ? *b : unknown_ball(right.bits());
    };
    const auto about =
        approximate_zero([&](const Ball& x) { return load - middle.force(x, left_in_middle(x)); },
                         [&](const Ball& x) { return -middle.force_rate(x, left_in_middle(x)); },
                         start != nullptr ? start->a : centre(load / middle.modulus));
    if (!about) {
        return {};
    }
    const auto left_or_unknown = [&](const Ball& right) {
        const auto b = left(right);
        return b ? *b : unknown_ball(right.bits());
    };
    const auto right = enclosed_zero(
        [&](const Ball& x) { return *P - contact.force(x, left_or_unknown(x)); },
        [&](const Ball& x) { return -contact.force_rate(x, left_or_unknown(x)); }, *about);
    if (!right) {
        return {};
    }
    const auto b = left(*right);
    return b ? std::optional(LinearEdges<Ball>{*right, *b}) : std::nullopt;
}

LinearEdges<Jet> differentiated_edges(const LinearContact<Jet>& contact,
                                      const LinearEdges<Ball>& edges, bool symmetric,
                                      const std::optional<Jet>& a, const std::optional<Jet>& P) {
    // Implicit function theorem: the first derivatives follow from the residual at a constant
    // unknown, the second ones from the residual at an unknown with these first derivatives.
    const auto implicit = [](Jet x, const auto& residual, const Ball& rate) {
        const Jet first = residual(x);
        for (std::size_t i = 0; i < x.g.size(); ++i) {
            x.g[i] = -(first.g[i] / rate);
        }
        const Jet second = residual(x);
        for (std::size_t i = 0; i < x.h.size(); ++i) {
            x.h[i] = -(second.h[i] / rate);
        }
        return x;
    };
    const auto left = [&](const Jet& right) {
        if (symmetric) {
            return right;
        }
        return implicit(
            Jet(edges.b), [&](const Jet& b) { return contact.imbalance(right, b); },
            contact.imbalance_rate(Jet(edges.a), Jet(edges.b)).v);
    };
    if (a) {
        return {*a, left(*a)};
    }
    const Jet right = implicit(
        Jet(edges.a), [&](const Jet& x) { return contact.force(x, left(x)) - *P; },
        contact.force_rate(Jet(edges.a), Jet(edges.b)).v);
    return {right, left(right)};
}

} // namespace edgeproof::contact
