// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/linear_contact.hpp"

#include <algorithm>
#include <functional>
#include <iterator>

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

template <class T> T LinearContact<T>::imbalance(const Extent<T>& e) const {
    return linear_imbalance(slope, e, marks(e));
}

template <class T> T LinearContact<T>::imbalance_rate(const Extent<T>& e) const {
    return -(over_linear_measure<LeftRateKernel>(slope, e, marks(e)) / e.length());
}

template <class T> T LinearContact<T>::force(const Extent<T>& e) const {
    return modulus / 2 * over_linear_measure<ForceKernel>(slope, e, marks(e));
}

template <class T> T LinearContact<T>::force_rate(const Extent<T>& e) const {
    return modulus / 2 * over_linear_measure<RightRateKernel>(slope, e, marks(e));
}

template <class T>
LinearContact<T>::LinearContact(const ParametricSlope& of, const Expr& contact_modulus,
                                const ParameterValues<T>& value)
    : modulus(value(contact_modulus)), bits(value.bits()) {
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

template struct LinearContact<Ball>;
template struct LinearContact<Jet>;

namespace {

constexpr int most_bracket_steps = 80;
constexpr int most_newton_steps = 60;
constexpr int most_inflations = 24;
constexpr int most_narrowings = 12;
constexpr int most_direct_steps = 8;

using BallFunction = std::function<Ball(const Ball&)>;

/// Applies Newton's method to a start that may be good. Returns nothing if it does not converge at
/// once.
std::optional<Ball> zero_near(const BallFunction& f, const BallFunction& rate, Ball x) {
    const Ball small = power_of_two(-40, x.bits());
    for (int k = 0; k < most_direct_steps; ++k) {
        const Ball step = middle(f(x) / rate(x));
        if (!step.is_finite()) {
            return {};
        }
        x = middle(x - step);
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
            x = middle(x * Ball(Rational(1021, 1000), x.bits()));
            continue;
        }
        if (certainly_positive(value)) {
            lo = x;
            x = middle(x * 2);
        } else {
            hi = x;
            x = middle(x / 2);
        }
    }
    if (!lo || !hi) {
        return {};
    }
    x = middle((*lo + *hi) / 2);
    for (int k = 0; k < most_newton_steps; ++k) {
        const Ball value = f(x);
        if (!value.is_finite()) {
            x = middle((*lo * 3 + *hi * 2) / 5);
            continue;
        }
        (certainly_positive(value) ? lo : hi) = x;
        const Ball step = middle(value / rate(x));
        Ball next = step.is_finite() ? middle(x - step) : *lo;
        if (!step.is_finite() || !certainly_less(*lo, next) || !certainly_less(next, *hi)) {
            next = middle((*lo + *hi) / 2);
        }
        const Ball near = abs(x) * power_of_two(-40, x.bits());
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
        const Ball m = middle(x);
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
        const Ball slack = upper_end(abs(image - about) / 4 +
                                     abs(about) * power_of_two(8 - about.bits(), about.bits()));
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
std::optional<Ball> approximate_left_edge(const LinearContact<Ball>& in_middle, const Ball& right,
                                          const Ball& start) {
    return approximate_zero(
        [&](const Ball& b) {
            return in_middle.imbalance({right, b});
        },
        [&](const Ball& b) {
            return in_middle.imbalance_rate({right, b});
        },
        start);
}

} // namespace

std::optional<Extent<Ball>> solve_edges(const LinearContact<Ball>& contact,
                                        const LinearContact<Ball>& in_middle, bool symmetric,
                                        const std::optional<Ball>& a,
                                        const std::optional<Ball>& P) {
    std::optional<Ball> last; // the last left edge, the start for the next one
    // Encloses the left edge for a right edge that may itself be a ball.
    const auto left = [&](const Ball& right) -> Ball {
        if (symmetric) {
            return right;
        }
        const Ball x = middle(right);
        const auto about = approximate_left_edge(in_middle, x, last ? *last : x);
        const auto b = about ? enclosed_zero(
                                   [&](const Ball& y) {
                                       return contact.imbalance({right, y});
                                   },
                                   [&](const Ball& y) {
                                       return contact.imbalance_rate({right, y});
                                   },
                                   *about)
                             : about;
        return b ? *b : unknown_ball(right.bits());
    };
    const auto edges_to = [&](const Ball& right) {
        const Extent<Ball> e{right, left(right)};
        return symmetric || e.b.is_finite() ? std::optional(e) : std::nullopt;
    };
    if (a) {
        return edges_to(*a);
    }
    const Ball load = middle(*P);
    const auto to_left_in_middle = [&](const Ball& right) {
        if (symmetric) {
            return Extent<Ball>{right, right};
        }
        const auto b = approximate_left_edge(in_middle, right, last ? *last : right);
        if (b) {
            last = *b;
        }
        return Extent<Ball>{right, b ? *b : unknown_ball(right.bits())};
    };
    const auto about = approximate_zero(
        [&](const Ball& x) { return load - in_middle.force(to_left_in_middle(x)); },
        [&](const Ball& x) { return -in_middle.force_rate(to_left_in_middle(x)); },
        middle(load / in_middle.modulus));
    const auto right = about ? enclosed_zero(
                                   [&](const Ball& x) {
                                       return *P - contact.force({x, left(x)});
                                   },
                                   [&](const Ball& x) {
                                       return -contact.force_rate({x, left(x)});
                                   },
                                   *about)
                             : about;
    return right ? edges_to(*right) : std::nullopt;
}

Extent<Jet> differentiated_edges(const LinearContact<Jet>& contact, const Extent<Ball>& edges,
                                 bool symmetric, const std::optional<Jet>& a,
                                 const std::optional<Jet>& P) {
    // Implicit function theorem: the first derivatives follow from the residual at a constant
    // unknown, the second ones from the residual at an unknown with these first derivatives.
    const auto implicit = [](Jet x, const auto& residual, const Ball& rate) {
        const Jet first = residual(x);
        std::ranges::transform(first.g, x.g.begin(), [&](const Ball& g) { return -(g / rate); });
        const Jet second = residual(x);
        std::ranges::transform(second.h, x.h.begin(), [&](const Ball& h) { return -(h / rate); });
        return x;
    };
    const Extent<Jet> constant{Jet(edges.a), Jet(edges.b)};
    const auto to_left = [&](const Jet& right) -> Extent<Jet> {
        if (symmetric) {
            return {right, right};
        }
        return {right, implicit(
                           constant.b,
                           [&](const Jet& b) {
                               return contact.imbalance({right, b});
                           },
                           contact.imbalance_rate(constant).v)};
    };
    if (a) {
        return to_left(*a);
    }
    return to_left(implicit(
        constant.a, [&](const Jet& x) { return contact.force(to_left(x)) - *P; },
        contact.force_rate(constant).v));
}

/// The errors over a box in which no value can be enclosed.
static ErrorOverBox unknown_errors(long bits) {
    const Ball unknown = unknown_ball(bits);
    Jet jet(unknown);
    jet.g.fill(unknown);
    jet.h.fill(unknown);
    return {[unknown](const Ball&) { return unknown; }, [jet](const Ball&) { return jet; },
            unknown};
}

// The closed form of LinearError (docs/pressure.md).
std::unique_ptr<ErrorFamily> linear_slope_errors(const ParametricSlope& slope,
                                                 const ParametricLoad& load,
                                                 const ErrorQuestion& question) {
    const auto n = static_cast<double>(question.terms);
    const auto over = [=](const Ball& parameter) {
        const ParameterValues<Ball> value(question.name, parameter);
        const LinearContact<Ball> contact(slope, load.contact_modulus, value);
        const LinearContact<Ball> in_middle(
            slope, load.contact_modulus, ParameterValues<Ball>(question.name, middle(parameter)));
        const auto edges =
            solve_edges(contact, in_middle, slope.symmetric, value(load.a), value(load.P));
        if (!edges) {
            return unknown_errors(value.bits());
        }
        LinearError<Ball> balls(contact, *edges, question);
        Ball whole = balls.fraction ? Ball(1, balls.bits) : balls.length;
        return ErrorOverBox{
            [balls = std::move(balls)](const Ball& u) { return balls.error(u); },
            [&slope, &load, &question, parameter, edges = *edges,
             jets = std::optional<LinearError<Jet>>()](const Ball& u) mutable {
                if (!jets) { // made on first use
                    const ParameterValues<Jet> at(question.name, parameter);
                    const LinearContact<Jet> moving(slope, load.contact_modulus, at);
                    jets.emplace(moving,
                                 differentiated_edges(moving, edges, slope.symmetric, at(load.a),
                                                      at(load.P)),
                                 question);
                }
                return jets->error(Jet::variable(u, 0));
            },
            std::move(whole)};
    };
    return std::make_unique<ErrorFamily>(
        ErrorFamily{{(load.P ? 800 : 130) + n * n * n, 10, 130}, over});
}

} // namespace edgeproof::contact
