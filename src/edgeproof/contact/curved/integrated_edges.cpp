// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/exact_contact.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace edgeproof::contact {
namespace {

constexpr long spent_on_signs = 24; ///< bits, for the sign of a sum near its zero
constexpr long spent_on_both = 16;  ///< additional bits if an edge depends on the other one

constexpr long few_bits = 80; ///< of the search for the edges
constexpr long enough = 24;   ///< bits of accuracy, for Newton's method

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

/// With the partial derivatives P_a and P_b of P(a, b), the integral of g' over theta has the
/// derivatives kappa P_a and -kappa P_b, kappa = 4/(E* (a + b)). So b' = P_a/P_b along the contacts
/// that satisfy the consistency condition (docs/mechanics.md, "One measure, six kernels").
ZoneEquations IntegratedContact::equations(long bits) const {
    (void)roots(); // shared by all zones
    const bool by_force = load_.kind == Load::Kind::force;
    const bool symmetric = profile_.symmetric();
    const auto zone_at = [this, bits](const BallZone& zone) {
        return between(zone.a, zone.b, bits);
    };
    // Integrals that are not needed are left out.
    return {
        .values =
            [=](const BallZone& zone) {
                const IntegratedContact at = zone_at(zone);
                const Ball none(0, bits);
                return ZoneValues{by_force ? at.force() : none,
                                  symmetric ? none
                                            : at.slope_integral(at.a_, at.b_, 0) / Ball::pi(bits)};
            },
        .rates =
            [=](const BallZone& zone) {
                const IntegratedContact at = zone_at(zone);
                const Ball left = at.zone_rate(Edge::left);
                return ZoneRates{by_force && !symmetric ? at.zone_rate(Edge::right) : left, left};
            },
        .modulus = modulus_.with_bits(bits),
        .tilt = Ball(0, bits),
        .force = by_force ? std::optional(enclosed_constant(load_.value, bits)) : std::nullopt,
        .right_edge = by_force ? std::nullopt : std::optional(enclosed_constant(load_.value, bits)),
        .symmetric = symmetric};
}

/// A search with few bits, then with all; it proves nothing.
BallZone IntegratedContact::near_edges() const {
    std::optional<BallZone> zone;
    for (const long bits : {std::min(bits_, few_bits), bits_}) {
        const ZoneEquations wanted = equations(bits);
        const Ball origin(0, bits);
        const ZoneEquations::Distances afar{
            origin, origin,
            middle(wanted.force ? *wanted.force / wanted.modulus : *wanted.right_edge)};
        try {
            zone = wanted.search(zone ? BallZone{zone->a.with_bits(bits), zone->b.with_bits(bits)}
                                      : wanted.from_afar(afar, enough));
        } catch (const BudgetError&) {
            zone = wanted.from_afar(afar, bits / 2);
        }
    }
    return *zone;
}

void IntegratedContact::enclose_edges() {
    const BallZone near = near_edges();
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
    const ZoneRates rates = equations(few_bits).rates(near);
    const Ball b_rate = middle(rates.right / rates.left);
    // P increases with a along the contacts that satisfy the consistency condition; the left edge
    // of each is enclosed (docs/curved-slopes.md, "Edges").
    for (long narrow = bits_ - spent_on_signs - (symmetric ? 0 : spent_on_both); narrow > 8;
         narrow -= bits_ / 8) {
        const Between a = narrow_range(near.a, narrow);
        std::optional<Between> b = a;
        if (!symmetric) {
            const auto left_of = [&](const Ball& x) {
                const Ball start = near.b + b_rate * (x - near.a);
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
