// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_marks.hpp"
#include "edgeproof/contact/law/logarithmic_pressure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/escalate.hpp"

namespace edgeproof::contact {

/// The point x by its distances from both edges, and v - x for each knot v.
struct BallContact::Place {
    Ball right;
    Ball left;
    std::vector<Ball> offsets;
};

void BallContact::fix() {
    fixed_ = {};
    fixed_.length = a_ + b_;
    const auto exactly = [&](const formula::Expr& e) {
        const Rational* q = e.rational();
        return q != nullptr ? std::optional<Rational>(*q) : std::nullopt;
    };
    for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
        fixed_.insets.push_back(a_ - slope_.knots[i]);
        fixed_.outsets.push_back(b_ + slope_.knots[i]);
        std::optional<Rational> inset;
        std::optional<Rational> outset;
        if (known_a_) {
            inset = exactly(known_a_->expr() - profile_.knots()[i].expr());
        }
        if (const auto& b = known(Edge::left)) {
            outset = exactly(b->expr() + profile_.knots()[i].expr());
        }
        fixed_.exact_insets.push_back(std::move(inset));
        fixed_.exact_outsets.push_back(std::move(outset));
    }
    if (power_) {
        // p = (P'(a)/pi) I_m(|x|/a): moore-hills EQ03 with s/a for s.
        fixed_.factor = power_->force_rate(a_) / Ball::pi(bits_);
        return;
    }
    // docs/pressure.md, "Closed form: piecewise linear slopes"
    fixed_.factor = modulus_ / (Ball::pi(bits_) * 2);
    fixed_.marks = marks(Extent<Ball>{a_, b_});
    fixed_.arc = arc_of(slope_, Extent<Ball>{a_, b_}, fixed_.marks);
    for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
        fixed_.bends.push_back(!fixed_.marks[i].end && bends(i));
    }
}

BallContact::Place BallContact::place(Edge edge, const Ball& u) const {
    const Ball other = fixed_.length - u;
    if (certainly_negative(u) || certainly_negative(other)) {
        throw DomainError("a point lies outside the contact");
    }
    // Only the part of a ball inside the contact counts.
    Place at{
        clamped(edge == Edge::right ? u : other), clamped(edge == Edge::right ? other : u), {}};
    at.offsets.reserve(slope_.knots.size());
    for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
        at.offsets.push_back(edge == Edge::right ? u - fixed_.insets[i] : fixed_.outsets[i] - u);
    }
    return at;
}

Ball BallContact::pressure(Edge edge, const formula::Exact& u) const {
    Place at = place(edge, constant(u.expr()));
    if (const auto& distance_of_edge = known(edge)) {
        // x is known exactly: exact algebra decides whether it lies on a knot, and gives its
        // distance from the knot.
        const Rational* distance = u.expr().rational();
        for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
            if (at.offsets[i].relative_accuracy_bits() >= bits_ - 8) {
                continue;
            }
            const auto& exact =
                edge == Edge::right ? fixed_.exact_insets[i] : fixed_.exact_outsets[i];
            if (exact && distance != nullptr) {
                const Rational offset = edge == Edge::right ? Rational(*distance - *exact)
                                                            : Rational(*exact - *distance);
                at.offsets[i] = Ball(offset, bits_);
            } else if (contains_zero(at.offsets[i])) {
                const formula::Expr& a = distance_of_edge->expr();
                const formula::Expr x = edge == Edge::right ? a - u.expr() : u.expr() - a;
                const formula::Expr offset = profile_.knots()[i].expr() - x;
                if (certainly_zero(offset)) {
                    at.offsets[i] = Ball(0, bits_);
                }
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
    if (power_) {
        const Ball y = at.right * at.left / (a_ * a_);
        return fixed_.factor * (*power_law_integral_)(abs(at.offsets[0]) / a_, y);
    }
    const Ball w_x = Field<Ball>::root(at.right * at.left);
    return logarithmic_sum(
               slope_, slope_.knots.size(), fixed_.arc * w_x,
               [&](std::size_t i) { return fixed_.bends[i]; },
               [&](std::size_t i) {
                   BallGreen green = ball_green(fixed_.marks[i], at.right, at.left, w_x,
                                                fixed_.length, at.offsets[i]);
                   if (least) {
                       green.value = green.least;
                   }
                   return green;
               }) *
           fixed_.factor;
}

Ball enclosed_pressure(const Profile& profile, const formula::Exact& contact_modulus,
                       const Load& load, Edge edge, const formula::Exact& u, unsigned digits) {
    const long wanted = static_cast<long>(static_cast<double>(digits + 2) * 3.3219281) + 2;
    return escalate(
        [&](long bits) {
            try {
                return BallContact(profile, contact_modulus, load, bits).pressure(edge, u);
            } catch (const BudgetError&) {
                // Too few bits to isolate an edge: the pressure is unknown.
                Ball unknown(1, bits);
                arb_indeterminate(unknown.data());
                return unknown;
            }
        },
        [&](const Ball& p) { return p.is_finite() && p.relative_accuracy_bits() >= wanted; },
        {wanted + 64, 1L << 18});
}

} // namespace edgeproof::contact
