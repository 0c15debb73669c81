// SPDX-License-Identifier: BSD-3-Clause
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
constexpr long few_bits = 80;       ///< of the search for the edges
constexpr long enough = 24;         ///< bits of accuracy, for Newton's method

} // namespace

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
    const bool by_force = load_.kind == Load::Kind::force;
    const BallZone near = near_edges();
    bool enclosed = true;
    try {
        const BallZone zone = equations(bits_).proved(near);
        a_ = by_force ? zone.a : a_;
        b_ = zone.b;
    } catch (const BudgetError&) {
        enclosed = false;
        b_ = near.b;
    }
    // Where the only unknown edge may be on a bend, the rates are not known, but the signs of a
    // function that falls as the edge moves out.
    const auto falling = [&](const Ball& edge) {
        return by_force ? enclosed_constant(load_.value, bits_) - force_of(edge, edge)
                        : slope_integral(a_, edge, 0);
    };
    for (long k = bits_ - spent_on_signs; !enclosed && (!by_force || profile_.symmetric()) && k > 8;
         k -= bits_ / 8) {
        const Ball slack = abs(near.b) * power_of_two(-k, bits_);
        const Ball lo = lower_end(near.b - slack);
        const Ball hi = upper_end(near.b + slack);
        if (certainly_positive(lo) && certainly_positive(falling(lo)) &&
            certainly_negative(falling(hi))) {
            enclosed = true;
            b_ = Ball::hull(lo, hi);
            a_ = by_force ? b_ : a_;
        }
    }
    if (!by_force && (!enclosed || edge_may_be_on_knot()) &&
        odd_within(profile_, load_.value.expr())) {
        known_b_ = load_.value;
        b_ = a_;
        find_knots_on_edges();
    } else if (!enclosed) {
        throw BudgetError("ball arithmetic at " + std::to_string(bits_) +
                          " bits does not enclose an edge");
    }
}

} // namespace edgeproof::contact
