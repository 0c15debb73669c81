// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/power_law_integral.hpp"

#include "edgeproof/contact/ball_marks.hpp"
#include "edgeproof/precision/ratio_series.hpp"

#include <algorithm>
#include <optional>

namespace edgeproof {
namespace {

constexpr double most_terms = 4e6;

Ball unknown(long bits) {
    Ball x(0, bits);
    arb_indeterminate(x.data());
    return x;
}

/// Everything from 0 to the upper end of x.
Ball from_zero(const Ball& x) { return Ball::from_interval(Real(0), x.upper(), x.bits()); }

/// Whether x matters no more beside `sum`, both >= 0. Decides only where to stop.
bool negligible(const Ball& x, const Ball& sum) {
    return arf_abs_bound_lt_2exp_si(arb_midref(x.data())) <
           arf_abs_bound_lt_2exp_si(arb_midref(sum.data())) - sum.bits() - 8;
}

/// n = p/q, where that is made of small numbers.
struct Words {
    long p;
    long q;
};
std::optional<Words> words_of(const std::optional<Rational>& n) {
    constexpr long largest = 1L << 20;
    if (!n || denominator(*n) > largest || numerator(*n) > largest) {
        return std::nullopt;
    }
    return Words{numerator(*n).convert_to<long>(), denominator(*n).convert_to<long>()};
}

/// 1 + n/2 + k over k + 1, times x, in place.
void to_next_term(Ball& x, const Ball& first, const std::optional<Rational>& n, long k, long bits) {
    // A quotient of small numbers: no division of balls.
    if (n && denominator(*n) < (1 << 20)) {
        const long q = denominator(*n).convert_to<long>();
        const long p = numerator(*n).convert_to<long>();
        arb_mul_si(x.data(), x.data(), p + 2 * q * (k + 1), bits);
        arb_div_si(x.data(), x.data(), 2 * q * (k + 1), bits);
        return;
    }
    const Ball factor = (first + k) / (k + 1);
    arb_mul(x.data(), x.data(), factor.data(), bits);
}

/// sqrt(y) q^n times the sum of (1 + n/2)_k/k! y^k/(2k + 1) (Euler's transformation of 2F1, DLMF
/// 15.8.1): all terms are positive, and from where their ratio is below 1 on it falls on.
Ball edge_series(const Ball& n, const std::optional<Rational>& exactly, const Ball& q,
                 const Ball& y) {
    const long bits = y.bits();
    if (const auto w = words_of(exactly)) {
        const RatioSeries series{{{{2 * w->q, w->p + 2 * w->q, 2 * w->q}, {2, 1, 3}}}};
        if (const auto sum = series.sum(y, bits)) {
            return root(y) * pow(q, n) * *sum;
        }
    }
    const Ball first = n / 2 + 1;
    Ball term(1, bits);
    Ball sum(0, bits);
    Ball share(0, bits);
    for (long k = 0; k < static_cast<long>(most_terms); ++k) {
        // A term counts for what it is beside the sum: small ones are made of fewer bits.
        const long below = k == 0 ? 0
                                  : arf_abs_bound_lt_2exp_si(arb_midref(sum.data())) -
                                        arf_abs_bound_lt_2exp_si(arb_midref(term.data()));
        const long here = std::clamp(bits + 16 - below, 30L, bits);
        arb_div_si(share.data(), term.data(), 2 * k + 1, here);
        if (k > 0 && negligible(share, sum)) {
            Ball ratio = y;
            to_next_term(ratio, first, exactly, k, bits);
            if (certainly_less(ratio, Ball(1, bits))) {
                const Ball factor = pow(q, n);
                return root(y) * factor * (sum + from_zero(share / (1 - ratio)));
            }
        }
        sum += share;
        arb_mul(term.data(), term.data(), y.data(), here);
        to_next_term(term, first, exactly, k, here);
        if (!term.is_finite()) {
            break;
        }
    }
    return unknown(bits);
}

/// q^n (sqrt(pi)/2) Gamma(-n/2)/Gamma((1 - n)/2).
Ball apex_power(const Ball& n, const Ball& q) {
    const long bits = q.bits();
    Ball power(0, bits);
    if (!contains_zero(q)) {
        power = pow(q, n);
    } else if (!q.is_exact()) {
        const Ball top(q.upper(), bits);
        power = from_zero(pow(top, n));
    }
    return power * sqrt(Ball::pi(bits)) / 2 * gamma(-(n / 2)) / gamma((1 - n) / 2);
}

/// 0 < n < 2, n != 1, near q = 0: the sum of beta_k q^(2k)/(n - 2k), beta_k = (2k)!/(4^k k!^2), and
/// q^n (sqrt(pi)/2) Gamma(-n/2)/Gamma((1 - n)/2).
Ball apex_series(const Ball& n, const std::optional<Rational>& exactly, const Ball& q) {
    const long bits = q.bits();
    const Ball square = q * q;
    const auto w = words_of(exactly);
    const RatioSeries series{
        w ? RatioSeries{{{{2, 3, 4}, {2 * w->q, 2 * w->q - w->p, 4 * w->q - w->p}}}}
          : RatioSeries{}};
    if (const auto rest = w ? series.sum(square, bits) : std::nullopt) {
        return 1 / n - square / (2 * (2 - n)) * *rest + apex_power(n, q);
    }
    Ball term(1, bits);
    Ball sum = 1 / n;
    for (long k = 1;; ++k) {
        term *= square * (2 * k - 1) / (2 * k);
        if (k > 2 && (negligible(term, sum) || k > 4 * bits)) {
            // 2k - n > 1: the rest is at most a geometric series.
            const Ball rest = from_zero(abs(term) / (1 - square));
            sum += rest * Ball::from_interval(Real(-1), Real(1), bits);
            break;
        }
        sum += term / (n - 2 * k);
    }
    return sum + apex_power(n, q);
}

double approximate(const Ball& x) { return arf_get_d(arb_midref(x.data()), ARF_RND_NEAR); }

} // namespace

Ball power_law_integral(const Exact& m, const Ball& enclosed_m, const Ball& q, const Ball& y) {
    const long bits = std::max(q.bits(), y.bits());
    const double about_m = approximate(enclosed_m);
    const double about_y = approximate(y);
    if (about_m > 1e12) {
        return unknown(bits);
    }
    // How many times m goes down by 2 to 0 <= n < 2.
    const long steps =
        m.is_rational()
            ? static_cast<long>(Integer(numerator(m.rational()) / (2 * denominator(m.rational()))))
            : static_cast<long>(about_m / 2);
    const Ball root = edgeproof::root(y);
    // Of a wide ball neither series may converge.
    const Ball most(Rational(99, 100), bits);
    const bool by_edge = certainly_less(y, most);
    const auto few = [&](const Ball& n) {
        const Rational left = m.is_rational() ? Rational(m.rational() - 2 * steps) : Rational(1, 3);
        const auto exactly = m.is_rational() ? std::optional(left) : std::nullopt;
        if (left == 1) {
            return root;
        }
        if (left == 0) {
            return asinh(root / q);
        }
        // With few words both series take as long for a term; the one at the apex has more around
        // it.
        const bool few_words = exactly && denominator(*exactly) <= 64;
        if (by_edge && (about_y <= (few_words ? 0.55 : 0.75) || !certainly_less(q, most))) {
            return edge_series(n, exactly, q, y);
        }
        return certainly_less(q, most) ? apex_series(n, exactly, q) : unknown(bits);
    };
    if (steps == 0) {
        return few(enclosed_m);
    }
    const double digits = static_cast<double>(bits);
    const double near_edge =
        about_y < 1 ? digits + (1.6 * about_m * about_y + 1.5 * digits) / (1 - about_y) : 1e300;
    const double downwards = std::min(static_cast<double>(steps), 0.7 * digits / about_y);
    if (std::min(near_edge, downwards) > most_terms) {
        return unknown(bits);
    }
    if (near_edge < downwards && certainly_less(y, Ball(1, bits))) {
        return edge_series(enclosed_m, m.is_rational() ? std::optional(m.rational()) : std::nullopt,
                           q, y);
    }
    // m I_m = sqrt(y) + (m - 1) q^2 I_{m-2}, by parts; and 0 <= I_n <= sqrt(y) for n >= 1.
    const Ball square = q * q;
    Ball sum(0, bits);
    Ball factor(1, bits); ///< without its powers of q
    Ball power(1, bits);
    Ball n = enclosed_m;
    for (long k = 0; k < steps; ++k) {
        if (k > 0 && negligible(factor * power, sum)) {
            return sum + from_zero(factor * power * root);
        }
        sum += factor * power * root / n;
        factor *= (n - 1) / n;
        if (k + 1 < steps) {
            power *= square;
        }
        n -= 2;
    }
    if (m.is_rational() && m.rational() == 2 * steps && contains_zero(q)) {
        // q^2 asinh(sqrt(y)/q) < q^2 ln(2/q), which grows with q.
        const Ball top(q.upper(), bits);
        const Ball last = q.is_exact() ? Ball(0, bits) : from_zero(top * top * log(2 / top));
        return sum + factor * power * last;
    }
    return sum + factor * power * square * few(n);
}

} // namespace edgeproof
