// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/isolate_zero.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace edgeproof::contact {
namespace {

constexpr long spent_on_signs = 24; ///< bits, for the sign of a sum near its zero
constexpr long spent_on_both = 16;  ///< additional bits if an edge depends on the other one

constexpr long few_bits = 80; ///< of the search for the edges
constexpr int most_chords = 40;

struct Between {
    Ball lo;
    Ball hi;
};

/// Returns the numbers middle -+ 2^-bits |middle|.
Between narrow_range(const Ball& middle, long bits) {
    const Ball slack = abs(middle) * power_of_two(-bits, middle.bits());
    return {lower_end(middle - slack), upper_end(middle + slack)};
}

} // namespace

/// Encloses the left edge for the right edge `a`: the integral of g' over theta decreases as the
/// left edge moves outwards (docs/curved-slopes.md, "Edges").
std::optional<Ball> IntegratedContact::left_edge_near(const Ball& a, const Ball& start) const {
    for (long narrow = bits_ - spent_on_signs; narrow > 8; narrow -= bits_ / 8) {
        const Between trial = narrow_range(start, narrow);
        if (certainly_positive(trial.lo) && certainly_positive(slope_integral(a, trial.lo, 0)) &&
            certainly_negative(slope_integral(a, trial.hi, 0))) {
            return Ball::hull(trial.lo, trial.hi);
        }
    }
    return {};
}

/// Searches for the edges between brackets with few bits, then by chords. With the partial
/// derivatives P_a and P_b of P(a, b), the integral of g' over theta has the derivatives kappa P_a
/// and -kappa P_b, kappa = 4/(E* (a + b)). So b' = P_a/P_b and P' = 2 P_a along the contacts that
/// satisfy the consistency condition (docs/mechanics.md, "One measure, six kernels").
IntegratedContact::Guess IntegratedContact::guess() const {
    const bool by_force = load_.kind == Load::Kind::force;
    const bool symmetric = profile_.symmetric();
    (void)roots(); // shared by all zones
    const auto near = [&](long bits) {
        // Where an integral has no value, the edge is too far out.
        const auto or_beyond = [bits](Ball f) {
            return f.is_finite() ? std::move(f) : Ball(-1, bits);
        };
        Ball b(0, bits);
        const auto zone_at = [&](const Ball& a) {
            if (!symmetric) {
                const auto zone = [&](const Ball& x) { return between(a, x, bits); };
                b = isolate_zero(
                    [&](const Ball& x) { return or_beyond(zone(x).zone_mean_slope()); },
                    [&](const Ball& x) {
                        return zone(x).zone_rate(Edge::left) * -2 /
                               (Ball::pi(bits) * modulus_.with_bits(bits) * (a + x));
                    },
                    certainly_positive(b) ? b : a, "the left edge", {.prove = false});
            }
            return between(a, symmetric ? a : b, bits);
        };
        Ball a(a_.midpoint(), bits);
        if (by_force) {
            const Ball P = enclosed_constant(load_.value, bits);
            a = isolate_zero([&](const Ball& x) { return or_beyond(P - zone_at(x).zone_force()); },
                             [&](const Ball& x) {
                                 return -between(x, symmetric ? x : b, bits).zone_rate(Edge::right);
                             },
                             P / modulus_.with_bits(bits), "the right edge",
                             {.prove = false, .nested = !symmetric});
        }
        const IntegratedContact found = zone_at(a);
        const Ball rate = found.zone_rate(Edge::right);
        return Guess{
            found.a_.with_bits(bits_), found.b_.with_bits(bits_), rate.with_bits(bits_),
            (symmetric ? Ball(1, bits) : rate / found.zone_rate(Edge::left)).with_bits(bits_)};
    };
    Guess found = near(std::min(bits_, few_bits));
    if (!by_force) {
        found.a = a_;
    }
    const Ball P = by_force ? enclosed_constant(load_.value, bits_) : Ball(0, bits_);
    const Ball enough = found.a * power_of_two(16 - bits_, bits_);
    for (int k = 0; k < most_chords; ++k) {
        const Ball kappa = 4 / (modulus_ * (found.a + found.b));
        const Ball C = symmetric ? Ball(0, bits_) : slope_integral(found.a, found.b, 0) / kappa;
        Ball da(0, bits_);
        Ball db(0, bits_);
        if (by_force) {
            const Ball missing = P - force_of(found.a, found.b);
            da = (missing - C) / found.force_rate;
            db = symmetric ? da : (missing + C) * found.b_rate / found.force_rate;
        } else {
            db = C * 2 * found.b_rate / found.force_rate;
        }
        if (!da.is_finite() || !db.is_finite()) {
            break;
        }
        found.a = middle(found.a + da);
        found.b = middle(found.b + db);
        if (certainly_less(abs(middle(da)) + abs(middle(db)), enough)) {
            return found;
        }
    }
    return near(bits_);
}

void IntegratedContact::enclose_edges() {
    const Guess near = guess();
    const auto too_few = [&] {
        return BudgetError("ball arithmetic at " + std::to_string(bits_) +
                           " bits does not enclose an edge");
    };
    if (load_.kind == Load::Kind::right_edge) {
        const auto b = left_edge_near(a_, near.b);
        b_ = b ? *b : near.b;
        if ((!b || edge_may_be_on_knot()) && odd_within(profile_, load_.value.expr())) {
            known_b_ = load_.value;
            b_ = a_;
            find_knots_on_edges();
        } else if (!b) {
            throw too_few();
        }
        return;
    }
    const Ball P = enclosed_constant(load_.value, bits_);
    const bool symmetric = profile_.symmetric();
    // P increases with a along the contacts that satisfy the consistency condition; the left edge
    // of each is enclosed (docs/curved-slopes.md, "Edges").
    for (long narrow = bits_ - spent_on_signs - (symmetric ? 0 : spent_on_both); narrow > 8;
         narrow -= bits_ / 8) {
        const Between a = narrow_range(near.a, narrow);
        std::optional<Between> b = a;
        if (!symmetric) {
            const auto left_of = [&](const Ball& x) {
                const Ball start = near.b + near.b_rate * (x - near.a);
                return left_edge_near(x, middle(start));
            };
            const auto lo = left_of(a.lo);
            const auto hi = lo ? left_of(a.hi) : lo;
            b = lo && hi ? std::optional(Between{*lo, *hi}) : std::nullopt;
        }
        if (b && certainly_less(force_of(a.lo, b->lo), P) &&
            certainly_less(P, force_of(a.hi, b->hi))) {
            a_ = Ball::hull(a.lo, a.hi);
            b_ = symmetric ? a_ : Ball::hull(b->lo, b->hi);
            return;
        }
    }
    throw too_few();
}

} // namespace edgeproof::contact
