// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/exact_edges.hpp"
#include "edgeproof/precision/error.hpp"

#include <optional>

namespace edgeproof::contact {
namespace {

constexpr long spent_on_signs = 24; ///< bits, for the sign of a sum near its zero
constexpr long spent_on_both = 16;  ///< additional bits if an edge depends on the other one

constexpr unsigned first_digits = 10;
constexpr int most_chords = 40;

struct Between {
    Ball lo;
    Ball hi;
};

/// Returns the numbers middle -+ 2^-bits |middle|.
Between narrow_range(const Ball& middle, long bits) {
    const Ball slack =
        abs(middle) * Ball(Rational(1, Integer(1) << static_cast<unsigned>(bits)), middle.bits());
    return {Ball(Ball(middle - slack).lower(), middle.bits()),
            Ball(Ball(middle + slack).upper(), middle.bits())};
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

/// Approximates the edges by the routes in Real with a few digits, then by chords. With the partial
/// derivatives P_a and P_b of P(a, b), the integral of g' over theta has the derivatives kappa P_a
/// and -kappa P_b, kappa = 4/(E* (a + b)). So b' = P_a/P_b and P' = 2 P_a along the contacts that
/// satisfy the consistency condition (docs/mechanics.md, "One measure, six kernels").
IntegratedContact::Guess IntegratedContact::guess(const formula::Exact& contact_modulus) const {
    const bool by_force = load_.kind == Load::Kind::force;
    const bool symmetric = profile_.symmetric();
    const auto near = [&](unsigned digits) {
        const NormalContact contact(Profile(profile_), contact_modulus, Load(load_), digits);
        const Ball b_rate(symmetric ? Real(1) : contact.left_edge_derivative(1), bits_);
        const Ball rate(contact.force_derivative(1), bits_);
        return Guess{Ball(contact.a(), bits_), Ball(contact.b(), bits_), rate, b_rate};
    };
    const auto middle = [](const Ball& x) { return Ball(x.midpoint(), x.bits()); };
    Guess found = near(first_digits);
    if (!by_force) {
        found.a = a_;
    }
    const Ball P = by_force ? enclosed_constant(load_.value, bits_) : Ball(0, bits_);
    const Ball enough =
        found.a * Ball(Rational(1, Integer(1) << static_cast<unsigned>(bits_ - 16)), bits_);
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
    return near(static_cast<unsigned>(bits_ * 3 / 10));
}

void IntegratedContact::enclose_edges(const formula::Exact& contact_modulus) {
    const Guess near = guess(contact_modulus);
    const auto too_few = [&] {
        return BudgetError("ball arithmetic at " + std::to_string(bits_) +
                           " bits does not enclose an edge");
    };
    if (load_.kind == Load::Kind::right_edge) {
        const auto b = left_edge_near(a_, near.b);
        b_ = b ? *b : near.b;
        if ((!b || edge_may_be_on_knot()) && odd_within(profile_, load_.value.expr())) {
            odd_ = true;
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
                return left_edge_near(x, Ball(start.midpoint(), bits_));
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
