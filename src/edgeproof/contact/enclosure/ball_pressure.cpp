// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_marks.hpp"
#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/contact/law/logarithmic_pressure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/escalate.hpp"

#include <algorithm>

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

/// The marks of the knots for edges that are series.
std::vector<Mark<BallSeries>> BallContact::marks(const Extent<BallSeries>& e) const {
    std::vector<Mark<BallSeries>> list;
    for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
        const BallSeries right = e.a + (-slope_.knots[i]);
        const BallSeries left = e.b + slope_.knots[i];
        list.push_back(on_edge_[i]                    ? end_mark(e, *on_edge_[i])
                       : certainly_negative(right[0]) ? right_end(e)
                       : certainly_negative(left[0])  ? left_end(e)
                                                      : mark_between(right, left));
    }
    return list;
}

BallSeries BallContact::left_edge_series(std::size_t order) const {
    const BallSeries a = BallSeries::variable(a_, order);
    if (profile_.symmetric()) {
        return a;
    }
    // Newton's step is exact in the terms that it doubles: if the balls contain the true b to k
    // terms, the balls after the step contain it to 2k terms. The constant term is the edge that
    // was isolated before.
    return left_edge_by_newton(
        a, b_, [&](const Extent<BallSeries>& e) { return linear_imbalance(slope_, e, marks(e)); },
        [&](const Extent<BallSeries>& e) {
            return over_linear_measure<LeftRateKernel>(slope_, e, marks(e));
        });
}

std::vector<Ball> BallContact::left_edge_derivatives(std::size_t count) const {
    const BallSeries b = left_edge_series(count);
    std::vector<Ball> all;
    Ball factorial(1, bits_);
    // b^(k)(a) is k! times the coefficient of z^k.
    for (std::size_t k = 0; k < count; ++k) {
        factorial *= static_cast<long>(std::max<std::size_t>(k, 1));
        all.push_back(b[k] * factorial);
    }
    return all;
}

BallSeries BallContact::total_rate_series(std::size_t order) const {
    const BallSeries a = BallSeries::variable(a_, order);
    if (power_) {
        return power_->force_rate_series(a);
    }
    const Extent<BallSeries> e{a, left_edge_series(order)};
    return over_linear_measure<RightRateKernel>(slope_, e, marks(e)) * (modulus_ / 2);
}

std::vector<Ball> BallContact::force_derivatives(std::size_t count) const {
    std::vector<Ball> all{force()};
    if (count > 1) {
        const BallSeries rate = total_rate_series(count - 1);
        Ball factorial(1, bits_);
        for (std::size_t k = 0; k + 1 < count; ++k) {
            factorial *= static_cast<long>(std::max<std::size_t>(k, 1));
            all.push_back(rate[k] * factorial);
        }
    }
    return all;
}

std::vector<Ball> BallContact::right_expansion(std::size_t terms) const {
    const auto series = [&](const BallSeries& s) {
        std::vector<Ball> c;
        for (std::size_t k = 0; k < terms; ++k) {
            c.push_back(s[k]);
        }
        return series::Series<Ball>(std::move(c));
    };
    // docs/expansions.md, "The right edge"
    const LawSeries<Ball> law{series(total_rate_series(terms)), series(left_edge_series(terms))};
    return coefficients_of(right_edge_brackets(law, a_), Ball(a_ + b_));
}

std::vector<Ball> BallContact::expansion(Edge edge, std::size_t terms) const {
    if (terms == 0) {
        return {};
    }
    return edge == Edge::right || profile_.symmetric() ? right_expansion(terms)
                                                       : mirrored().right_expansion(terms);
}

std::vector<Ball> enclosed_expansion(const Profile& profile, const formula::Exact& contact_modulus,
                                     const Load& load, Edge edge, std::size_t terms,
                                     unsigned digits) {
    const long wanted = static_cast<long>(static_cast<double>(digits + 2) * 3.3219281) + 2;
    for (long bits = wanted + 64 + 4 * static_cast<long>(terms);; bits *= 2) {
        try {
            const BallContact contact(profile, contact_modulus, load, bits);
            std::vector<Ball> c = contact.expansion(edge, terms);
            const Ball length = contact.a() + contact.b();
            Ball natural = terms > 0 ? abs(c[0]) : Ball(0, bits);
            bool enough = true;
            for (const Ball& coefficient : c) {
                const bool relative = coefficient.relative_accuracy_bits() >= wanted;
                // A coefficient that vanishes is compared with the natural size of its neighbours.
                const Ball small =
                    natural /
                    Ball(Rational(Integer(Integer(1) << static_cast<unsigned>(wanted))), bits);
                const bool vanishing =
                    contains_zero(coefficient) && certainly_less(abs(coefficient), small);
                enough = enough && coefficient.is_finite() && (relative || vanishing);
                natural /= length;
            }
            if (enough) {
                return c;
            }
        } catch (const BudgetError&) {
            // too few bits to isolate an edge
        }
        if (bits > (1L << 17)) {
            throw BudgetError("the enclosures of the expansion are still too wide at " +
                              std::to_string(bits) + " bits");
        }
    }
}

} // namespace edgeproof::contact
