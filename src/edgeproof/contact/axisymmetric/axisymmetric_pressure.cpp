// SPDX-License-Identifier: BSD-3-Clause
// The pressure of an axisymmetric contact, and its series.
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace edgeproof::contact {
namespace {

constexpr long bits_of_searches = 48;
constexpr long lost_by_ranges = 16;       ///< bits: a ball that has lost fewer is a place
constexpr long fewest_bits_of_place = 12; ///< a complex place with fewer is a range

/// t^2 for 0 <= t <= 1, which is not negative, and for complex t.
Box square(const Box& t) {
    if (acb_is_real(t.get()) == 0) {
        return t * t;
    }
    const Ball lo = max(lower_end(t.real()), Ball(0, t.bits()));
    const Ball hi = upper_end(t.real());
    return Box(Ball::hull(lo * lo, hi * hi));
}

} // namespace

/// The radius by its distances from the edge, r = a - u, and from the opposite edge.
struct AxisymmetricContact::Place {
    Ball u;                        ///< from the nearer edge
    Ball other;                    ///< 2a - u
    Ball r;                        ///< not negative
    std::optional<std::size_t> on; ///< the ring on which r is known to be exactly
    [[nodiscard]] Ball W() const { return Field<Ball>::root(clamped(u) * clamped(other)); }
};

AxisymmetricContact::Place AxisymmetricContact::place_of(Edge /*edge*/, const Ball& u) const {
    return {u, a_ * 2 - u, abs(a_ - u), {}};
}

AxisymmetricContact::Place AxisymmetricContact::on_ring(Place at, const Exact& x) const {
    for (std::size_t i = 0; i < rings_.size(); ++i) {
        const Expr v = profile_.knots()[rings_[i].knot].expr();
        if (overlaps(at.r, rings_[i].v) &&
            (certainly_zero(x.expr() - v) || certainly_zero(x.expr() + v))) {
            at.on = i;
            at.r = rings_[i].v;
        }
    }
    return at;
}

Ball AxisymmetricContact::pressure(Edge edge, const Exact& u) const {
    const Place at = place_of(edge, enclosed_constant(u, bits_));
    const auto a = known(edge);
    return pressure(a ? on_ring(at, Exact(a->expr() - u.expr())) : at, false);
}

Ball AxisymmetricContact::pressure(Edge edge, const Ball& u, const Exact& x) const {
    return pressure(on_ring(place_of(edge, u), x), false);
}

Ball AxisymmetricContact::outer_moment(const Ball& r, const std::optional<Exact>& known) const {
    const Place at{a_ - r, a_ + r, r, {}};
    return over_widths(known ? on_ring(at, *known) : at, Box(r), true, false).real();
}

Ball AxisymmetricContact::pressure(Edge edge, const Ball& u) const {
    return pressure(place_of(edge, u), false);
}

Ball AxisymmetricContact::least_pressure(Edge edge, const Ball& u) const {
    return pressure(place_of(edge, u), true);
}

Ball AxisymmetricContact::pressure(const Place& at, bool least) const {
    if (certainly_negative(at.u) || certainly_negative(at.other)) {
        throw DomainError("a point lies outside the contact");
    }
    const Ball scale = modulus_ / Ball::pi(bits_);
    if (linear_) {
        return scale * over_bends(at, least);
    }
    if (at.r.relative_accuracy_bits() < bits_ - lost_by_ranges && !at.on) {
        if (const auto ratio = over_root(at.r, 1); !ratio.empty()) {
            return ratio[0] * at.W();
        }
    }
    return scale * over_widths(at, Box(at.r), false, least).real();
}

// Beyond the last ring it is a mean of h'(s)/s over s^2 = r^2 + (a^2 - r^2) t^2, also beyond the
// edge.
Box AxisymmetricContact::pressure_over_root(const Box& r) const {
    const Box W2 = (a_ - r) * (r + a_);
    std::size_t before = 0;
    while (before < rings_.size() && inside(rings_[before].knot) &&
           certainly_less(rings_[before].v, r.real())) {
        ++before;
    }
    const Ball scale = modulus_ / Ball::pi(bits_);
    if (before < rings_.size() && inside(rings_[before].knot)) {
        const Place at{a_ - r.real(), a_ + r.real(), r.real(), {}};
        return over_widths(at, r, false, false) * scale / principal_root(W2);
    }
    return integral_or_range(
               [&](const Box& t) {
                   const Radius at = radius_beyond(r, before, square(t) * W2);
                   return approach_rate(at, {}) / at.s;
               },
               is_narrow(r), bits_) *
           scale;
}

std::vector<Ball> AxisymmetricContact::over_root(const Ball& r, std::size_t order) const {
    Ball widest = middle(r) * 2 / 3; // of r^2 the real part is positive
    for (const Ring& ring : rings_) {
        if (inside(ring.knot)) {
            widest = min(widest, abs(middle(r) - ring.v));
        }
    }
    std::vector<Ball> ratio;
    if (certainly_positive(lower_end(widest))) {
        for (const Box& c : pressures_->at([&](const Box& z) { return pressure_over_root(z); },
                                           Box(r), order, lower_end(widest))) {
            ratio.push_back(c.real());
        }
    }
    check_interruption();
    return ratio;
}

// docs/axisymmetric.md, "What is integrated"
Ball AxisymmetricContact::over_bends(const Place& at, bool least) const {
    const Ball W = at.W();
    Ball sum(0, bits_);
    const auto series = [](const Ball& x) { return BallSeries(x, 1); };
    for (std::size_t i = 0; i < rings_.size(); ++i) {
        const Ring& bend = rings_[i];
        if (on_axis(i)) { // h' = (pi/2) jump + 2 rate s
            sum += bend.rate * W * 2;
            if (!contains_zero(bend.jump)) {
                // p is infinite at the apex; the least one in the ball is that of its far end
                const Ball r = least && contains_zero(at.r) ? upper_end(at.r) : at.r;
                sum += bend.jump * Ball::pi(bits_) / 2 * asinh(W / r);
            }
            continue;
        }
        if (!inside(bend.knot)) {
            continue;
        }
        const Ball& v = bend.v;
        const Ball beyond = at.r - v;
        const long known = std::min(at.on == i ? bits_ : beyond.relative_accuracy_bits(),
                                    W.relative_accuracy_bits());
        const long accuracy = useful_accuracy(known, bits_);
        const IntegralGoal goal{std::min(bits_, accuracy + 64), accuracy,
                                abs(bend.jump) / v + abs(bend.rate), abs(beyond)};
        const auto outside = [&](const RingBend& of, const Ball& r, const Ball& width, bool on) {
            const Ball d2 = on ? Ball(0, bits_) : (r - v) * (r + v);
            return part_of_bend(of, true, series(d2), series(width), goal)[0];
        };
        const Ball Y = Field<Ball>::root(clamped(a_ - v) * (a_ + v));
        const auto within = [&](const RingBend& of, const Ball& r) {
            return part_of_bend(of, false, series((v - r) * (v + r)), series(Y), goal)[0];
        };
        const RingBend whole{v, bend.jump, bend.rate};
        const bool corner = !contains_zero(bend.jump);
        if (at.on == i && corner) {
            return unknown_ball(bits_);
        }
        if (at.on == i || certainly_positive(beyond)) {
            sum += outside(whole, at.on == i ? v : at.r, W, at.on == i);
        } else if (certainly_negative(beyond)) {
            sum += within(whole, at.r);
        } else if (corner && !least) {
            return unknown_ball(bits_);
        } else {
            // The ball of r contains the bend. Its part increases up to it, and beyond it h'/s
            // increases with s for a change of the rate, and decreases for a jump
            // (docs/axisymmetric.md, "Near a bend").
            const Ball lo(max(at.r, Ball(0, bits_)).lower(), bits_);
            const Ball hi(at.r.upper(), bits_);
            const Ball W_hi = Field<Ball>::root(clamped(a_ - hi) * (a_ + hi));
            const Ball zero(0, bits_);
            const Ball one(1, bits_);
            const auto before = [&](const RingBend& of, const Ball& otherwise) {
                return certainly_less(lo, v) ? within(of, lo) : otherwise;
            };
            const RingBend bent{v, zero, one};
            const Ball after = outside(bent, v, W_hi, true);
            const Ball highest =
                certainly_less(v, hi) ? outside(bent, hi, Y, false) : outside(bent, v, Y, true);
            sum += bend.rate *
                   Ball::hull(min(lower_end(before(bent, after)), lower_end(after)), highest);
            if (corner) {
                const RingBend jump{v, one, zero};
                const Ball beyond_it =
                    certainly_less(v, hi) ? outside(jump, hi, W_hi, false) : unknown_ball(bits_);
                sum += bend.jump * min(before(jump, beyond_it), beyond_it);
            }
        }
    }
    return sum;
}

Box AxisymmetricContact::over_width(const Box& r, const Box& A, std::optional<std::size_t> on,
                                    bool from_r, const Box& W, bool moment) const {
    const Box apart = (A - r) * (A + r);
    const long known = std::min({acb_rel_accuracy_bits(W.get()), acb_rel_accuracy_bits(A.get()),
                                 acb_rel_accuracy_bits((from_r ? r : apart).get())});
    const bool range = known < fewest_bits_of_place && acb_is_real(r.get()) == 0;
    const bool axis = from_r && on && on_axis(*on);
    const auto f = [&](const Box& t) {
        const Box w = t * W;
        if (axis && contains_zero(rings_[0].jump)) {
            return rate_over_radius_at(w);
        }
        const Radius at = radius(A, on, w);
        if (from_r) {
            const Box rate = approach_rate(at, {}) / at.s;
            return moment ? rate * w * w : rate;
        }
        const Box rate = (approach_rate(at, on) * w + rings_[*on].jump * rings_[*on].v) / at.s;
        const Box root = principal_root((range ? square(t) * W * W : w * w) + apart);
        return moment ? rate * root : rate / root;
    };
    if (range) {
        return W * integral_or_range(f, false, bits_);
    }
    return W * inner_integral_of(
                   f, {bits_, useful_accuracy(known, bits_), Ball(0, bits_), Ball(1, bits_)});
}

// p where r may be a place at which h' bends: pi/E* times p is the integral of h'(s)/s over
// 0 < w < W. For the first w the integrand is enclosed over all s.
Ball AxisymmetricContact::over_start(const Ball& r, std::size_t end, const Ball& W,
                                     bool least) const {
    const Ball most = upper_end(abs(r));
    const std::size_t ring = end - 1;
    const bool axis = on_axis(ring) && contains_zero(rings_[ring].jump);
    const Ball lowest = max(lower_end(r), Ball(0, bits_));
    const Ball breadth = upper_end(axis ? most : sqrt((most - lowest) * (most + lowest)));
    const Ball tiny = middle(W) * power_of_two(-bits_ / 2, bits_);
    const Ball first =
        axis ? Ball(middle(sqrt(most * W)) + most * 2 + tiny) : Ball(middle(breadth * 2) + tiny);
    if (!certainly_less(first, W)) {
        return unknown_ball(bits_);
    }
    Ball begin(0, bits_); // not negative
    if (axis) {
        begin = first * rate_over_radius_at(Box(Ball::hull(Ball(0, bits_), first + most))).real();
    } else if (contains_zero(rings_[ring].jump)) {
        const Ball s = Ball::hull(lowest, upper_end(sqrt(most * most + first * first)));
        begin = first * (smooth_rate(radius(s)) / Box(s)).real();
    } else if (!least) {
        return unknown_ball(bits_); // infinite at a corner
    }
    const Ball width = W - first;
    const IntegralGoal goal{bits_, useful_accuracy(W.relative_accuracy_bits(), bits_),
                            Ball(0, bits_), Ball(1, bits_)};
    return begin + width * integral_of(
                               [&](const Box& t) {
                                   const Box w = t * width + first;
                                   if (axis) {
                                       return rate_over_radius_at(principal_root(w * w + r * r));
                                   }
                                   const Radius at = radius_beyond(Box(r), end, w * w);
                                   return approach_rate(at, {}) / at.s;
                               },
                               goal);
}

Box AxisymmetricContact::over_widths(const Place& place, const Box& r, bool moment,
                                     bool least) const {
    std::optional<std::size_t> on = place.on;
    const bool real = acb_is_real(r.get()) != 0;
    Box sum(bits_);
    Box A = on ? Box(rings_[*on].v) : r;
    bool from_r = true;
    bool met = false; // r may lie on the ring before
    for (std::size_t i = on ? *on + 1 : 0;; ++i) {
        const bool last = i == rings_.size() || !inside(rings_[i].knot);
        if (!last && !certainly_less(A.real(), rings_[i].v)) {
            if (certainly_less(rings_[i].v, A.real())) {
                continue; // before r
            }
            if (met || !from_r || moment || !real) {
                return unknown_box(bits_);
            }
            met = true;
            continue;
        }
        const Box W = !last     ? principal_root((rings_[i].v - A) * (A + rings_[i].v))
                      : !from_r ? Box(Field<Ball>::root(clamped(a_ - A.real()) * (a_ + A.real())))
                      : real    ? Box(Field<Ball>::root(clamped(place.u) * clamped(place.other)))
                                : principal_root((a_ - r) * (r + a_));
        if (on && !contains_zero(rings_[*on].jump) && from_r) {
            return unknown_box(bits_); // infinite at a corner
        }
        if (!is_flat_before(i)) {
            sum = sum + (met ? Box(over_start(r.real(), i, W.real(), least))
                             : over_width(r, A, on, from_r, W, moment));
        }
        if (last) {
            check_interruption();
            return sum;
        }
        A = Box(rings_[i].v);
        on = i;
        from_r = false;
        met = false;
    }
}

namespace {

// |c_k| <= M/rho^k: the omitted terms are bounded by those of M x^n/(1 - x), x = (u + z)/rho, whose
// coefficients are positive and grow with u.
/// The pressure series by the expansion at the edge; nothing if u is not well within its reach.
std::optional<BallSeries> series_near_edge(const AxisymmetricContact& contact, const Ball& u,
                                           std::size_t order) {
    constexpr double most_terms = 500;
    const Ball rho = lower_end(contact.reach(Edge::right)) * 9 / 10;
    if (!certainly_positive(u) || !certainly_less(u * 10, rho * 7)) {
        return {};
    }
    const double bits_of_a_term = -std::log2(approximate(upper_end(u / rho)));
    const double wanted = (static_cast<double>(contact.bits()) + 8) / bits_of_a_term + 2;
    const Ball M = contact.majorant(Edge::right, rho);
    if (!(wanted < most_terms) || !M.is_finite()) {
        return {};
    }
    const auto terms = static_cast<std::size_t>(wanted);
    const std::vector<Ball> c = contact.expansion(Edge::right, terms);
    const BallSeries at = BallSeries::variable(u, order);
    BallSeries sum(c.back(), order);
    for (std::size_t k = terms - 1; k-- > 0;) {
        sum = sum * at + c[k];
    }
    const BallSeries x = BallSeries::variable(upper_end(u), order) * (1 / rho);
    const BallSeries tail =
        pow(x, Ball(static_cast<long>(terms), contact.bits())) / (-x + Ball(1, contact.bits())) * M;
    for (std::size_t k = 0; k < order; ++k) {
        sum.set(k, sum[k] + Ball::hull(-tail[k], tail[k]));
    }
    return sum * sqrt(at);
}

} // namespace

BallSeries AxisymmetricContact::pressure_series(Edge /*edge*/, const Ball& u,
                                                std::size_t order) const {
    if (linear_) {
        if (auto near = series_near_edge(*this, u.with_bits(bits_), order)) {
            return *near;
        }
        if (auto near = series_near_edge(*this, a_ * 2 - u, order)) { // from the opposite edge
            for (std::size_t k = 1; k < order; k += 2) {
                near->set(k, -(*near)[k]);
            }
            return *near;
        }
    }
    const BallSeries from = BallSeries::variable(u.with_bits(bits_), order);
    const BallSeries other = -from + a_ * 2;
    const BallSeries r = -from + a_; // its sign does not matter off the origin
    if (!certainly_positive(u) || !certainly_positive(other[0])) {
        return unknown_series(order, bits_);
    }
    if (!linear_) {
        std::vector<Ball> ratio = over_root(abs(r[0]), order);
        for (std::size_t k = 1; k < ratio.size() && certainly_positive(r[0]); k += 2) {
            ratio[k] = -ratio[k]; // r decreases as u grows
        }
        return ratio.empty() ? unknown_series(order, bits_)
                             : BallSeries(ratio) * sqrt(from * other);
    }
    const BallSeries r2 = r * r;
    const BallSeries W = sqrt(from * other);
    BallSeries sum(Ball(0, bits_), order);
    for (const Ring& bend : rings_) {
        if (arb_is_zero(bend.v.data()) != 0) {
            sum = sum + W * (bend.rate * 2);
            if (contains_zero(bend.jump)) {
                continue;
            }
            if (contains_zero(r[0])) {
                return unknown_series(order, bits_);
            }
            // d asinh(W/r)/dr = -a/(r W), dr/du = -1
            const BallSeries rate = BallSeries(a_, order) / (r * W);
            BallSeries angle(asinh(W[0] / abs(r[0])), order);
            for (std::size_t k = 0; k + 1 < order; ++k) {
                angle.set(k + 1, rate[k] / static_cast<long>(k + 1));
            }
            sum = sum + angle * (bend.jump * Ball::pi(bits_) / 2);
            continue;
        }
        if (!inside(bend.knot)) {
            continue;
        }
        const Ball beyond = abs(r[0]) - bend.v;
        if (contains_zero(beyond)) {
            return unknown_series(order, bits_);
        }
        const bool outside = certainly_positive(beyond);
        BallSeries d2 = r2 + -(bend.v * bend.v);
        d2 = outside ? d2 : -d2;
        d2.set(0, abs(beyond) * (abs(r[0]) + bend.v));
        // Long series serve searches, which need few digits.
        const long accuracy =
            useful_accuracy(beyond.relative_accuracy_bits(), order > 3 ? bits_of_searches : bits_);
        const IntegralGoal goal{std::min(bits_, accuracy + 64), accuracy,
                                abs(bend.jump) / bend.v + abs(bend.rate), abs(beyond)};
        const Ball Y = Field<Ball>::root(clamped(a_ - bend.v) * (a_ + bend.v));
        sum = sum + part_of_bend({bend.v, bend.jump, bend.rate}, outside, d2,
                                 outside ? W : BallSeries(Y, order), goal);
    }
    return sum * (modulus_ / Ball::pi(bits_));
}

} // namespace edgeproof::contact
