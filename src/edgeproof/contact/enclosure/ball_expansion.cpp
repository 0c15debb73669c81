// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_contact.hpp"

#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/contact/law/law_series.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/escalate.hpp"

#include <algorithm>

namespace edgeproof::contact {

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
