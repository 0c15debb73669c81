// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/stress/surface_gap.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"
#include "edgeproof/contact/law/linear_measure.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace edgeproof::contact {
namespace {

bool is_real(const Box& x) { return arb_is_zero(acb_imagref(x.get())) != 0; }

/// The principal logarithm of 1 + x; not finite where it may meet the cut.
Box principal_log1p(const Box& x) {
    return certainly_positive(x.real() + 1) || !x.may_be_real() ? log1p(x) : unknown_box(x.bits());
}

/// The one of two enclosures of a number with the smaller radius of the real part.
Box narrower(Box one, Box other) {
    return mag_cmp(arb_radref(acb_realref(one.get())), arb_radref(acb_realref(other.get()))) < 0
               ? one
               : other;
}

/// The right slip zone, between the right edges of two contacts.
class RightZone {
public:
    RightZone(const BallContact& inner, const BallContact& outer, const Ball& pressure,
              const Ball& punch)
        : inner_(inner), outer_(outer), bits_(inner.bits()), width_(clamped(outer.a() - inner.a())),
          root_(sqrt(width_)),
          slope_at_edge_(over_linear_measure<LeftBalanceKernel>(
              inner.slope(), Extent<Ball>{inner.a(), inner.b()}, inner.knot_marks())),
          pressure_(pressure), punch_(punch) {
        const Ball reach = power_of_two(spare_bits_for_ends - bits_, bits_);
        for (std::size_t i = 0; i < outer.slope().knots.size(); ++i) {
            const Ball& v = outer.slope().knots[i];
            const Ball beyond = v - inner.a();
            if (!outer.bends_inside(i) || certainly_negative(beyond)) {
                continue;
            }
            const Ball t = atan2(Field<Ball>::root(clamped(beyond)),
                                 Field<Ball>::root(outer.knot_marks()[i].right)) *
                           2 / Ball::pi(bits_);
            // Near the neighbourhood, no logarithm may meet its cut.
            const Ball around = reach + Ball(t.radius(), bits_) * 256;
            knots_.push_back({i, beyond, lower_end(t - around), upper_end(t + around)});
        }
        const auto may_meet_edge = [&](const BallContact& contact) {
            return std::ranges::any_of(contact.slope().knots, [&](const Ball& v) {
                return contains_zero(v - contact.a()) || contains_zero(v + contact.b());
            });
        };
        // The root of the distance of a knot from an edge, which may be 0, has half of the bits.
        accuracy_ = may_meet_edge(inner) || may_meet_edge(outer) ? bits_ * 3 / 8 : bits_ * 7 / 8;
    }

    [[nodiscard]] Ball integral() const {
        const Ball none(0, bits_);
        const Ball all(1, bits_);
        Ball sum = none;
        Ball from = none;
        for (std::size_t i = 0; i < knots_.size(); ++i) {
            // Near knots that are close together there is one neighbourhood.
            Ball to = knots_[i].to;
            const Ball begin = max(knots_[i].from, none);
            const std::size_t passed = i;
            while (i + 1 < knots_.size() && !certainly_less(to, knots_[i + 1].from)) {
                to = max(to, knots_[++i].to);
            }
            to = min(to, all);
            sum += smooth_part(from, begin, passed) + near_knots(begin, to, i + 1);
            from = to;
        }
        return sum + smooth_part(from, all, knots_.size());
    }

private:
    static constexpr long spare_bits_for_ends = 16;
    /// A knot in the slip zone, and the neighbourhood in t on which p is bounded by its size.
    struct Knot {
        std::size_t index;
        Ball beyond; ///< its distance from a_i, which may be 0
        Ball from;
        Ball to;
    };
    /// A place in the slip zone; all but the roots are lengths.
    struct Place {
        Box sine; ///< sin(pi t/2), and the cosine
        Box cosine;
        Box beyond;  ///< x - a_i
        Box inwards; ///< a - x
        Box left;    ///< x + b
        Box root_left;
    };
    [[nodiscard]] Place place(const Box& t) const {
        Place at;
        at.sine = Box(bits_);
        at.cosine = Box(bits_);
        acb_mul_2exp_si(at.sine.get(), t.get(), -1);
        acb_sin_cos_pi(at.sine.get(), at.cosine.get(), at.sine.get(), bits_);
        at.beyond = at.sine * at.sine * width_;
        at.inwards = at.cosine * at.cosine * width_;
        at.left = at.beyond + (inner_.a() + outer_.b());
        at.root_left = principal_root(at.left);
        return at;
    }

    /// The integral over a part in t without knots, beyond the first `passed` of them.
    [[nodiscard]] Ball smooth_part(const Ball& from, const Ball& to, std::size_t passed) const {
        const Ball length = to - from;
        if (!certainly_positive(length)) {
            return {0, bits_};
        }
        // p has logarithms at the knots: t = end + u^4 makes the integrand small there, so that
        // less of it has to be divided. Both halves begin at their end.
        const auto half = [&](const Ball& end, const Ball& step) {
            const auto integrand = [&](const Box& u) {
                const Box u3 = u * u * u;
                const Place at = place(u3 * u * step + end);
                const Box dx = at.sine * at.cosine * (width_ * Ball::pi(bits_));     // dx/dt
                const Box rest = at.sine * (root_ * Ball::pi(bits_)) / at.root_left; // over w
                return u3 * gap(at, passed) *
                       (dx * pressure(at, passed) * pressure_ + rest * punch_);
            };
            return integral_of(integrand, {bits_, accuracy_, Ball(0, bits_), Ball(1, bits_)}) *
                   abs(step) * 4;
        };
        return half(from, length / 2) + half(to, -length / 2);
    }

    /// h, for an x beyond the first `passed` knots of the zone.
    [[nodiscard]] Box gap(const Place& at, std::size_t passed) const {
        const Ball length = inner_.a() + inner_.b();
        const Ball half = length / 2;
        BeyondEdge<Box> x{at.beyond, Box(bits_), Box(bits_), Box(bits_)};
        x.root = at.sine * root_ * principal_root(at.beyond + length);
        const Box grown = (x.beyond + x.root) / half;
        x.log_omega = principal_log1p(grown);
        x.omega = Box(Ball(1, bits_)) / (grown + 1);
        const Box contact =
            gap_of_contact(inner_, slope_at_edge_, x, [&](const Mark<Ball>& v) -> Box {
                if (is_real(x.omega)) {
                    const Ball omega = x.omega.real();
                    return Box(atan2(omega * v.w / half, 1 - omega * v.y / half) * 2);
                }
                const Box e(v.y / half, v.w / half);
                return times_i(principal_log1p(-(x.omega * e)) -
                               principal_log1p(-(x.omega * conj(e))));
            });
        return contact + gap_of_profile(at.beyond, passed);
    }

    /// The integral of g'(y) - g'(a_i) from the inner edge. A knot that may be on that edge counts
    /// as inside; if it is beyond, the error is at most that of its distance.
    [[nodiscard]] Box gap_of_profile(const Box& beyond, std::size_t passed) const {
        const LinearSlope<Ball>& slope = inner_.slope();
        Box sum(bits_);
        Ball rate = slope.rate(knots_.empty() ? piece_at_edge() : knots_.front().index);
        for (std::size_t i = 0; i < passed; ++i) {
            const Ball& jump = slope.jump(knots_[i].index);
            const Ball drop = slope.rate_drop(knots_[i].index);
            if (inner_.knot_marks()[knots_[i].index].end == Edge::right) {
                const Box distance = beyond - clamped(knots_[i].beyond);
                sum = sum + distance * jump - distance * distance * (drop / 2);
            } else {
                rate = slope.rate(knots_[i].index + 1);
                sum = sum + Box(up_to(abs(knots_[i].beyond) * (abs(jump) + abs(drop) * width_)));
            }
        }
        return sum + beyond * beyond * (rate / 2);
    }
    [[nodiscard]] std::size_t piece_at_edge() const {
        std::size_t i = 0;
        while (i < inner_.slope().knots.size() &&
               certainly_negative(inner_.slope().knots[i] - inner_.a())) {
            ++i;
        }
        return i;
    }

    /// p, for an x beyond the first `passed` knots of the zone (docs/pressure.md, "Closed form:
    /// piecewise linear slopes").
    [[nodiscard]] Box pressure(const Place& at, std::size_t passed) const {
        const LinearSlope<Ball>& slope = outer_.slope();
        const Ball length = outer_.a() + outer_.b();
        const std::size_t next = passed < knots_.size() ? knots_[passed].index : slope.knots.size();
        const Box w = at.cosine * root_ * at.root_left;
        Box sum = w * outer_.arc();
        for (const std::size_t i : outer_.bends_inside()) {
            const Mark<Ball>& v = outer_.knot_marks()[i];
            const Box offset = narrower(at.inwards - v.right,
                                        Box(slope.knots[i] - inner_.a()) - at.beyond); // v - x
            const bool beyond = i >= next;                                             // v > x
            const Box product = beyond ? at.left * v.right : at.inwards * v.left;
            const Box excess = (product + w * v.w) * Ball(2, bits_) /
                               (beyond ? offset * length : -offset * length);
            const Box green = principal_log1p(excess);
            sum = sum + green * slope.jump(i) + offset * green * slope.rate_drop(i);
        }
        return sum * outer_.pressure_factor();
    }

    /// Bounds the integral over a small part in t that contains knots, the last ones of `passed`.
    [[nodiscard]] Ball near_knots(const Ball& from, const Ball& to, std::size_t passed) const {
        const Place at = place(Box(Ball::hull(from, to)));
        const LinearSlope<Ball>& slope = outer_.slope();
        const Ball length = outer_.a() + outer_.b();
        const Ball inwards = clamped(at.inwards.real());
        const Ball left = clamped(at.left.real());
        const Ball w = Field<Ball>::root(inwards * left);
        const Ball rate = abs(at.sine.real() * at.cosine.real()) * width_ * Ball::pi(bits_);
        const Ball dx = rate * (to - from);
        Ball sum = w * abs(outer_.arc()) * dx;
        for (const std::size_t i : outer_.bends_inside()) {
            const Mark<Ball>& v = outer_.knot_marks()[i];
            const Ball offset = inwards - v.right;
            const BallGreen green = ball_green(v, inwards, left, w, length, offset);
            // |v - x| G is at most 2 (.)/D, since ln(1 + y) <= y; for a knot on the edge.
            const Ball most_moment = (max(left * v.right, inwards * v.left) + w * v.w) * 2 / length;
            sum += abs((green.moment.is_finite() ? green.moment : up_to(most_moment)) *
                       slope.rate_drop(i)) *
                   dx;
            if (slope.has_corner(i) && contains_zero(offset)) {
                // G <= ln(C/|v - x|) with C = 4 D
                const Ball r = upper_end(abs(offset));
                sum += abs(slope.jump(i)) * r * 2 * (log(length * 4 / r) + 1);
            } else if (slope.has_corner(i)) {
                sum += abs(slope.jump(i) * green.value) * dx;
            }
        }
        // h increases with the distance.
        const Place end = place(Box(to));
        const Ball most = abs(gap(end, passed).real());
        const Ball rest = abs(at.sine.real()) * root_ * Ball::pi(bits_) /
                          sqrt(Ball(left.lower(), bits_)) * (to - from);
        return up_to(most * (sum * outer_.pressure_factor() * abs(pressure_) + rest * abs(punch_)));
    }

    const BallContact& inner_;
    const BallContact& outer_;
    long bits_;
    long accuracy_ = 0; ///< of the integrals, in bits
    Ball width_;        ///< a - a_i
    Ball root_;         ///< sqrt(a - a_i)
    Ball slope_at_edge_;
    const Ball& pressure_;
    const Ball& punch_;
    std::vector<Knot> knots_;
};

} // namespace

Ball gap_integral(const BallContact& inner, const BallContact& outer, const Ball& pressure,
                  const Ball& punch) {
    const Ball right = RightZone(inner, outer, pressure, punch).integral();
    if (inner.symmetric()) {
        return right * 2;
    }
    return right + RightZone(inner.mirrored(), outer.mirrored(), pressure, punch).integral();
}

} // namespace edgeproof::contact
