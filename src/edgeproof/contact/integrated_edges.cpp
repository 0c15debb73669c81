// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/ball_contact.hpp"
#include "edgeproof/contact/integrated_contact.hpp"
#include "edgeproof/precision/error.hpp"

#include <optional>

namespace edgeproof {
namespace {

constexpr long spent_on_signs = 24; ///< bits, for the sign of a sum beside its zero
constexpr long spent_on_both = 16;  ///< bits more where an edge rests on the other one

struct Between {
    Ball lo;
    Ball hi;
};

/// The numbers middle -+ 2^-bits |middle|.
Between beside(const Ball& middle, long bits) {
    const Ball slack =
        abs(middle) * Ball(Rational(1, Integer(1) << static_cast<unsigned>(bits)), middle.bits());
    return {Ball(Ball(middle - slack).lower(), middle.bits()),
            Ball(Ball(middle + slack).upper(), middle.bits())};
}

} // namespace

/// The left edge where the right one is at a: the integral of g' over theta falls as the left edge
/// moves out.
std::optional<Ball> IntegratedContact::left_edge_near(const Ball& a, const Ball& start) const {
    for (long narrow = bits_ - spent_on_signs; narrow > 8; narrow -= bits_ / 8) {
        const Between trial = beside(start, narrow);
        if (certainly_positive(trial.lo) && certainly_positive(slope_integral(a, trial.lo, 0)) &&
            certainly_negative(slope_integral(a, trial.hi, 0))) {
            return Ball::hull(trial.lo, trial.hi);
        }
    }
    return {};
}

void IntegratedContact::enclose_edges(const Exact& contact_modulus) {
    const auto digits = static_cast<unsigned>(bits_ * 3 / 10);
    const NormalContact guess(Profile(profile_), contact_modulus, Load(load_), digits);
    const BudgetError too_few("ball arithmetic at " + std::to_string(bits_) +
                              " bits does not enclose an edge");
    if (load_.kind == Load::Kind::right_edge) {
        const auto b = left_edge_near(a_, Ball(guess.b(), bits_));
        if (!b) {
            throw too_few;
        }
        b_ = *b;
        return;
    }
    const Ball P = enclosed_constant(load_.value, bits_);
    const Ball middle(guess.a(), bits_);
    const bool symmetric = profile_.symmetric();
    // P grows with a along the contacts that are in balance, each with its left edge enclosed.
    for (long narrow = bits_ - spent_on_signs - (symmetric ? 0 : spent_on_both); narrow > 8;
         narrow -= bits_ / 8) {
        const Between a = beside(middle, narrow);
        std::optional<Between> b = a;
        if (!symmetric) {
            const Ball near(guess.b(), bits_);
            const Ball rate(guess.left_edge_derivative(1), bits_);
            const auto left_of = [&](const Ball& x) {
                const Ball start = near + rate * (x - middle);
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
    throw too_few;
}

} // namespace edgeproof
