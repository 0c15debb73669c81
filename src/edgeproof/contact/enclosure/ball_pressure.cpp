// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/contact/law/linear_measure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/escalate.hpp"

#include <algorithm>
#include <iterator>

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
    for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
        fixed_.insets.push_back(a_ - slope_.knots[i]);
        fixed_.outsets.push_back(b_ + slope_.knots[i]);
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
        if (fixed_.bends[i]) {
            fixed_.inside.push_back(i);
        }
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

Ball BallContact::pressure(Edge edge, const Exact& u) const {
    Place at = place(edge, constant(u.expr()));
    if (const auto& distance_of_edge = known(edge)) {
        // x is known exactly: exact algebra decides whether it lies on a knot, and gives its
        // distance from the knot.
        const Expr& a = distance_of_edge->expr();
        for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
            if (at.offsets[i].relative_accuracy_bits() < bits_ - 8) {
                const Expr x = edge == Edge::right ? a - u.expr() : u.expr() - a;
                const Expr offset = profile_.knots()[i].expr() - x;
                at.offsets[i] = contains_zero(at.offsets[i]) && certainly_zero(offset)
                                    ? Ball(0, bits_)
                                    : constant(offset);
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

Ball enclosed_pressure(const Profile& profile, const Exact& contact_modulus, const Load& load,
                       Edge edge, const Exact& u, unsigned digits) {
    const long wanted = static_cast<long>(static_cast<double>(digits + 2) * 3.3219281) + 2;
    return escalate(
        [&](long bits) {
            try {
                return BallContact(profile, contact_modulus, load, bits).pressure(edge, u);
            } catch (const BudgetError&) {
                // Too few bits to isolate an edge: the pressure is unknown.
                return unknown_ball(bits);
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
    if (about_origin()) {
        return a;
    }
    // Newton's step is exact in the terms that it doubles: if the balls contain the true b to k
    // terms, the balls after the step contain it to 2k terms. The constant term is the edge that
    // was isolated before.
    return left_edge_by_newton(
        a, b_,
        [&](const Extent<BallSeries>& e) {
            // A tilt, which is constant along the family, adds a constant.
            return zone_ ? slope_over_angle(slope_, e, marks(e))
                         : linear_imbalance(slope_, e, marks(e));
        },
        [&](const Extent<BallSeries>& e) {
            return over_linear_measure<LeftRateKernel>(slope_, e, marks(e));
        });
}

namespace {

/// f, f', f'', ... (`count` values) from the power series of f: f^(k) is k! times the coefficient
/// of z^k.
std::vector<Ball> derivatives(const BallSeries& f, std::size_t count) {
    std::vector<Ball> all;
    Ball factorial(1, f.bits());
    for (std::size_t k = 0; k < count; ++k) {
        factorial *= static_cast<long>(std::max<std::size_t>(k, 1));
        all.push_back(f[k] * factorial);
    }
    return all;
}

} // namespace

std::vector<Ball> BallContact::left_edge_derivatives(std::size_t count) const {
    return derivatives(left_edge_series(count), count);
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
        std::ranges::copy(derivatives(total_rate_series(count - 1), count - 1),
                          std::back_inserter(all));
    }
    return all;
}

std::vector<Ball> BallContact::right_expansion(std::size_t terms) const {
    // docs/expansions.md, "The right edge"
    const LawSeries<BallSeries> law{total_rate_series(terms), left_edge_series(terms)};
    return coefficients_of(right_edge_brackets(law, a_), Ball(a_ + b_));
}

std::vector<Ball> BallContact::expansion(Edge edge, std::size_t terms) const {
    if (terms == 0) {
        return {};
    }
    return edge == Edge::right || about_origin() ? right_expansion(terms)
                                                 : mirrored().right_expansion(terms);
}

namespace {

BallSeries integral(const BallSeries& s, const Ball& constant) {
    BallSeries r(constant, s.order());
    for (std::size_t k = 0; k + 1 < s.order(); ++k) {
        r.set(k + 1, s[k] / static_cast<long>(k + 1));
    }
    return r;
}

} // namespace

BallSeries BallContact::pressure_series(Edge edge, const Ball& u, std::size_t order) const {
    const Ball D = a_ + b_;
    const BallSeries from = BallSeries::variable(u.with_bits(bits_), order);
    const BallSeries other = -from + D;
    if (!certainly_positive(u) || !certainly_positive(other[0])) {
        return unknown_series(order, bits_);
    }
    if (power_) {
        const Ball x = a_ - u;
        if (contains_zero(x)) {
            return unknown_series(order, bits_);
        }
        const Ball q = abs(x) / a_;
        const Ball y = u * other[0] / (a_ * a_);
        // q I' = m I - 1/sqrt(1 - q^2) (docs/pressure.md, "Closed form: power laws"), term by term.
        const BallSeries at = BallSeries::variable(q, order);
        BallSeries s = -(at * at) + Ball(1, bits_);
        s.set(0, y);
        s = BallSeries(Ball(1, bits_), order) / sqrt(s);
        std::vector<Ball> I{(*power_law_integral_)(q, y)};
        for (std::size_t k = 0; k + 1 < order; ++k) {
            const long n = static_cast<long>(k);
            I.push_back(((power_->exponent - n) * I[k] - s[k]) / (q * (n + 1)));
        }
        const Ball rate = certainly_positive(x) ? -(1 / a_) : 1 / a_;
        Ball scale = fixed_.factor;
        for (Ball& c : I) {
            c *= scale;
            scale *= rate;
        }
        return BallSeries(I);
    }
    const bool right = edge == Edge::right;
    const Ball& right_x = right ? u : other[0];
    const Ball& left_x = right ? other[0] : u;
    const BallSeries w_x = sqrt(from * other);
    const BallSeries zero(Ball(0, bits_), order);
    struct Green {
        BallSeries value;
        BallSeries moment;
    };
    bool on_knot = false;
    const BallSeries sum = logarithmic_sum(
        slope_, slope_.knots.size(), w_x * fixed_.arc,
        [&](std::size_t i) { return fixed_.bends[i] && !on_knot; },
        [&](std::size_t i) {
            const Ball& knot = slope_.knots[i];
            const BallSeries offset = right ? from + (knot - a_) : -from + (b_ + knot); // v - x
            if (contains_zero(offset[0])) {
                on_knot = true;
                return Green{zero, zero};
            }
            // dG/du = w(v)/(w(x) (distance of v - u)) (docs/pressure.md, "Closed form: piecewise
            // linear slopes").
            const Mark<Ball>& v = fixed_.marks[i];
            const BallSeries rate = BallSeries(v.w, order) / (w_x * (right ? -offset : offset));
            BallSeries G =
                integral(rate, ball_green(v, right_x, left_x, w_x[0], D, offset[0]).value);
            BallSeries moment = offset * G;
            return Green{std::move(G), std::move(moment)};
        });
    return on_knot ? unknown_series(order, bits_) : sum * fixed_.factor;
}

Ball BallContact::reach(Edge edge) const {
    Ball least = a_ + b_;
    if (power_) {
        // docs/expansions.md: the majorant of a power law holds for rho < a/(m + 4)
        return a_ / (power_->exponent + 4);
    }
    for (const std::size_t i : fixed_.inside) {
        least = min(least, edge == Edge::right ? fixed_.marks[i].right : fixed_.marks[i].left);
    }
    return least;
}

Ball BallContact::majorant(Edge edge, const Ball& rho) const {
    // docs/expansions.md: the size of each coefficient is at most that of the majorant, so that
    // |c_k| rho^k <= M.
    const Ball D = a_ + b_;
    const Ball pi = Ball::pi(bits_);
    if (power_) {
        // p/sqrt(u) = (P'/(pi a)) sqrt(2a - u) 2F1(1, (1 - m)/2; 3/2; y) is bounded with 2 sqrt(2a)
        // for the root and (1 - Y)^(-|1 - m|/2) for 2F1, Y = 2 rho/a + (rho/a)^2.
        const Ball eta = rho / a_;
        const Ball rate = power_->force_rate(a_);
        return rate / (pi * a_) * sqrt(a_ * 2) * 2 *
               pow(1 - eta * 2 - eta * eta, -(abs(1 - power_->exponent) / 2));
    }
    // With z = u (D - u_v)/((D - u) u_v), G = 2 artanh sqrt(z) = 2 (z^(1/2) + z^(3/2)/3 + ...), and
    // G/sqrt(u) has no negative coefficient. The sizes of the coefficients of sqrt(D - u), times
    // rho^k, sum to less than 2 sqrt(D).
    const bool right = edge == Edge::right;
    const Ball other = D - rho;
    const Ball w_x = Field<Ball>::root(rho * other);
    Ball sum(0, bits_);
    for (const std::size_t i : fixed_.inside) {
        const Mark<Ball>& v = fixed_.marks[i];
        const Ball distance = right ? v.right : v.left;
        const Ball offset = right ? rho - distance : distance - rho;
        const Ball G =
            ball_green(v, right ? rho : other, right ? other : rho, w_x, D, offset).value /
            sqrt(rho);
        sum += abs(slope_.rate_drop(i)) * (rho + distance) * G;
        if (profile_.has_corner(i)) {
            sum += abs(slope_.jump(i)) * G;
        }
    }
    return modulus_ / (pi * 2) * (sum + abs(fixed_.arc) * sqrt(D) * 2);
}

} // namespace edgeproof::contact
