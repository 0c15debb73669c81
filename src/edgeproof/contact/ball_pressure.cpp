// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/ball_contact.hpp"
#include "edgeproof/contact/ball_marks.hpp"
#include "edgeproof/contact/power_law_integral.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/escalate.hpp"

namespace edgeproof {

/// x = a - u or u - b by its distances from both edges, and v - x for each knot v.
struct BallContact::Place {
    Ball right;
    Ball left;
    std::vector<Ball> offsets;
};

BallContact::Place BallContact::place(Edge edge, const Ball& u) const {
    const Ball other = a_ + b_ - u;
    if (certainly_negative(u) || certainly_negative(other)) {
        throw DomainError("a point lies outside the contact");
    }
    // A ball that reaches beyond an edge stands for its part inside.
    Place at{
        clamped(edge == Edge::right ? u : other), clamped(edge == Edge::right ? other : u), {}};
    for (const Ball& knot : knots_) {
        at.offsets.push_back(edge == Edge::right ? u - (a_ - knot) : b_ + knot - u);
    }
    return at;
}

Ball BallContact::pressure(Edge edge, const Exact& u) const {
    Place at = place(edge, constant(u.expr()));
    if (given_a_ && (edge == Edge::right || profile_.symmetric())) {
        // x is known exactly: so is whether it is on a knot, and how far from it.
        const Expr& a = given_a_->expr();
        const Expr x = edge == Edge::right ? a - u.expr() : u.expr() - a;
        for (std::size_t i = 0; i < knots_.size(); ++i) {
            const Expr offset = profile_.knots()[i].expr() - x;
            if (const Rational* q = offset.rational()) {
                at.offsets[i] = Ball(*q, bits_);
            } else if (contains_zero(at.offsets[i]) && is_zero(offset)) {
                at.offsets[i] = Ball(0, bits_);
            }
        }
    }
    return pressure(at);
}

Ball BallContact::pressure(Edge edge, const Ball& u) const { return pressure(place(edge, u)); }

Ball BallContact::least_pressure(Edge edge, const Ball& u) const {
    return pressure(place(edge, u), true);
}

Ball BallContact::pressure(const Place& at, bool least) const {
    if (power_law_) {
        // p = (P'(a)/pi) I_m(|x|/a): eqn:MossakovskiiPressure with s/a for s.
        const Ball rate = power_factor_ * (exponent_ + 1) * pow(a_, exponent_);
        const Ball y = at.right * at.left / (a_ * a_);
        return rate / Ball::pi(bits_) *
               power_law_integral(profile_.parameters().at("m"), exponent_, abs(at.offsets[0]) / a_,
                                  y);
    }
    const Ball w_x = root(at.right * at.left);
    Ball sum(0, bits_);
    BallMark previous = BallMark::left_end(a_, b_);
    Ball previous_moment(0, bits_);
    for (std::size_t i = 0; i <= knots_.size(); ++i) {
        const bool edge_here = i == knots_.size();
        const BallMark next = edge_here ? BallMark::right_end(a_, b_) : mark(a_, b_, i);
        Ball moment(0, bits_); // (v - x) G(x, v)
        if (!edge_here && !next.outside && bends(i)) {
            const BallGreen green = ball_green(next, at.right, at.left, a_ + b_, at.offsets[i]);
            moment = green.moment;
            if (profile_.has_corner(i)) {
                sum += jumps_[i] * (least ? green.least : green.value);
            }
        }
        sum += pieces_[i].rate * (moment - previous_moment + w_x * (previous.h - next.h));
        previous = next;
        previous_moment = moment;
    }
    return modulus_ / (Ball::pi(bits_) * 2) * sum;
}

Ball enclosed_pressure(const Profile& profile, const Exact& contact_modulus, const Load& load,
                       Edge edge, const Exact& u, unsigned digits) {
    const long wanted = static_cast<long>(static_cast<double>(digits + 2) * 3.3219281) + 2;
    return escalate(
        [&](long bits) {
            try {
                return BallContact(profile, contact_modulus, load, bits).pressure(edge, u);
            } catch (const BudgetError&) {
                // Too few bits to isolate an edge: everything is possible yet.
                Ball unknown(1, bits);
                arb_indeterminate(unknown.data());
                return unknown;
            }
        },
        [&](const Ball& p) { return p.is_finite() && p.relative_accuracy_bits() >= wanted; },
        {wanted + 64, 1L << 18});
}

} // namespace edgeproof
