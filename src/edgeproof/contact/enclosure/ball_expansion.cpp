// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_contact.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/escalate.hpp"

#include <algorithm>

namespace edgeproof::contact {
namespace {

/// A knot as the edges move; `outside` where it certainly is.
struct SeriesMark {
    BallSeries right;
    BallSeries left;
    BallSeries y;
    BallSeries w;
    BallSeries h;
    bool outside;
};

SeriesMark end_mark(const BallSeries& a, const BallSeries& b, Edge edge) {
    const long bits = a.bits();
    const std::size_t n = std::min(a.order(), b.order());
    const BallSeries zero(Ball(0, bits), n);
    const BallSeries half = (a + b) * Ball(Rational(1, 2), bits);
    if (edge == Edge::right) {
        return {zero, a + b, half, zero, zero, true};
    }
    return {a + b, zero, -half, zero, BallSeries(Ball::pi(bits), n), true};
}

SeriesMark mark_at(const BallSeries& a, const BallSeries& b, const Ball& v) {
    const BallSeries right = a + (-v);
    const BallSeries left = b + v;
    if (certainly_negative(right[0])) {
        return end_mark(a, b, Edge::right);
    }
    if (certainly_negative(left[0])) {
        return end_mark(a, b, Edge::left);
    }
    // A knot on an edge, as far as the bits tell, gives series that are not finite: said, not
    // guessed.
    return {right,
            left,
            (left - right) * Ball(Rational(1, 2), a.bits()),
            sqrt(right * left),
            atan(sqrt(right / left)) * Ball(2, a.bits()),
            false};
}

} // namespace

template <class AtKnot, class Between>
BallSeries BallContact::over_measure(const BallSeries& a, const BallSeries& b,
                                     const AtKnot& at_knot, const Between& between) const {
    BallSeries sum(Ball(0, bits_), std::min(a.order(), b.order()));
    SeriesMark previous = end_mark(a, b, Edge::left);
    for (std::size_t i = 0; i <= knots_.size(); ++i) {
        SeriesMark next = i == knots_.size() ? end_mark(a, b, Edge::right)
                          : on_edge_[i]      ? end_mark(a, b, *on_edge_[i])
                                             : mark_at(a, b, knots_[i]);
        if (!(previous.outside && next.outside && contains_zero((next.y - previous.y)[0]))) {
            sum = sum + between(i, previous, next) * pieces_[i].rate;
        }
        if (i < knots_.size() && profile_.has_corner(i) && !next.outside) {
            sum = sum + at_knot(i, next);
        }
        previous = std::move(next);
    }
    return sum;
}

BallSeries BallContact::force_rate_series(const BallSeries& a, const BallSeries& b,
                                          Edge edge) const {
    const BallSeries d = (a + b) * Ball(Rational(1, 2), bits_);
    const bool right = edge == Edge::right;
    return over_measure(
               a, b,
               [&](std::size_t i, const SeriesMark& m) {
                   return (right ? m.left : m.right) / m.w * jumps_[i];
               },
               [&](std::size_t, const SeriesMark& m, const SeriesMark& n) {
                   return (right ? m.w - n.w : n.w - m.w) + d * (m.h - n.h);
               }) *
           (modulus_ / 2);
}

BallSeries BallContact::left_edge_series(std::size_t order) const {
    const BallSeries a = BallSeries::variable(a_, order);
    if (profile_.symmetric()) {
        return a;
    }
    // Newton's step on series, exact in what it doubles: where the true b agrees with the balls to
    // k terms, the step's balls hold it to 2k. The constant term is the edge already isolated.
    const std::size_t o = profile_.origin();
    const Ball pi = Ball::pi(bits_);
    BallSeries b(b_, 1);
    for (std::size_t known = 1; known < order;) {
        known = std::min(2 * known, order);
        const BallSeries trial = b.resized(known);
        const BallSeries edge = a.resized(known);
        BallSeries gap = over_measure(
            edge, trial,
            [&](std::size_t i, const SeriesMark& m) {
                const BallSeries other = -m.h + pi;
                if (i != o) {
                    return i > o ? m.h * jumps_[i] : -(other * jumps_[i]);
                }
                return m.h * pieces_[i + 1].at_origin + other * pieces_[i].at_origin;
            },
            [&](std::size_t i, const SeriesMark& m, const SeriesMark& n) {
                if (i > o) {
                    return n.y * n.h - m.y * m.h + m.w - n.w;
                }
                return -(n.y * (-n.h + pi) - m.y * (-m.h + pi) + n.w - m.w);
            });
        gap.set(0, Ball(0, bits_)); // the edges balance: that is what b_ is
        const BallSeries rate =
            force_rate_series(edge, trial, Edge::left) * (2 / modulus_) / (edge + trial);
        b = trial + gap / rate;
        b.set(0, b_);
    }
    return b;
}

std::vector<Ball> BallContact::left_edge_derivatives(std::size_t count) const {
    const BallSeries b = left_edge_series(count);
    std::vector<Ball> all;
    Ball factorial(1, bits_);
    for (std::size_t k = 0; k < count; ++k) {
        factorial *= static_cast<long>(std::max<std::size_t>(k, 1));
        all.push_back(b[k] * factorial);
    }
    return all;
}

BallSeries BallContact::total_rate_series(std::size_t order) const {
    const BallSeries a = BallSeries::variable(a_, order);
    return power_law_ ? pow(a, exponent_) * (power_factor_ * (exponent_ + 1))
                      : force_rate_series(a, left_edge_series(order), Edge::right);
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
    const BallSeries b = left_edge_series(terms);
    const BallSeries rate = total_rate_series(terms);
    // (x + b(s))/D at s = a - u sigma, to the power -1/2: coefficients of u^n are polynomials in
    // sigma of degree n, by n y_n = sum (-j/2 - (n - j)) x_j y_{n-j}.
    using Poly = std::vector<Ball>;
    const Ball D = a_ + b_;
    const Ball zero(0, bits_);
    const auto distance = [&](std::size_t n) {
        Poly x(n + 1, zero);
        x[n] = b[n] / D * (n % 2 == 0 ? 1 : -1);
        if (n == 1) {
            x[0] -= 1 / D;
        }
        return x;
    };
    std::vector<Poly> x;
    std::vector<Poly> y;
    y.push_back({Ball(1, bits_)});
    x.push_back({Ball(1, bits_)});
    for (std::size_t n = 1; n < terms; ++n) {
        x.push_back(distance(n));
        Poly sum(n + 1, zero);
        for (std::size_t j = 1; j <= n; ++j) {
            // -j/2 - (n - j) = (j - 2n)/2, over n
            const long twice = static_cast<long>(j) - 2 * static_cast<long>(n);
            for (const std::size_t k : {std::size_t{0}, j}) {
                if (k == 0 && j != 1) {
                    continue; // only sigma^j occurs in x_j, and sigma^0 in x_1
                }
                for (std::size_t l = 0; l < y[n - j].size(); ++l) {
                    sum[k + l] += x[j][k] * y[n - j][l] * twice;
                }
            }
        }
        for (Ball& c : sum) {
            c /= 2 * static_cast<long>(n);
        }
        y.push_back(std::move(sum));
    }
    // Weights B(j+1, 1/2) of sigma^j (1 - sigma)^(-1/2).
    Poly weight{Ball(2, bits_)};
    for (std::size_t j = 1; j < terms; ++j) {
        weight.push_back(weight.back() * static_cast<long>(2 * j) / static_cast<long>(2 * j + 1));
    }
    const Ball unit = Ball::pi(bits_) * sqrt(D);
    std::vector<Ball> c;
    for (std::size_t n = 0; n < terms; ++n) {
        Ball sum = zero;
        for (std::size_t k = 0; k <= n; ++k) {
            // P' brings (-1)^k p_k sigma^k u^k
            const Ball p = rate[k] * (k % 2 == 0 ? 1 : -1);
            for (std::size_t l = 0; l < y[n - k].size(); ++l) {
                sum += p * y[n - k][l] * weight[k + l];
            }
        }
        c.push_back(sum / unit);
    }
    return c;
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
                // A coefficient that vanishes is known by its size beside its neighbours'.
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
