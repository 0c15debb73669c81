// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/enclosure/power_law_integral.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace edgeproof::contact {
namespace {

constexpr double most_terms = 4e6;
constexpr double most_m = 1e12;
constexpr long spare_bits = 16;
constexpr long bits_of_rest = 64; ///< of the bound of the omitted terms

/// The interval from 0 to the upper end of x.
Ball from_zero(const Ball& x) { return Ball::from_interval(Real(0), x.upper(), x.bits()); }

/// True if x is negligible compared with `sum`, both >= 0. Only decides where a sum stops.
bool negligible(const Ball& x, const Ball& sum) {
    return arf_abs_bound_lt_2exp_si(arb_midref(x.data())) <
           arf_abs_bound_lt_2exp_si(arb_midref(sum.data())) - sum.bits() - 8;
}

/// The sum of the first `count` terms over[0]_k over[1]_k/(under[0]_k under[1]_k) x^k.
Ball first_terms(const std::array<Rational, 2>& over, const std::array<Rational, 2>& under,
                 const Ball& x, long count, long bits) {
    using Parameters = std::array<FmpqValue, 2>;
    static_assert(sizeof(Parameters) == 2 * sizeof(fmpq));
    const Parameters a{to_fmpq(over[0]), to_fmpq(over[1])};
    const Parameters b{to_fmpq(under[0]), to_fmpq(under[1])};
    Ball sum(0, bits);
    arb_hypgeom_sum_fmpq_arb(sum.data(), a[0], 2, b[0], 2, x.data(), 0, count, bits + spare_bits);
    return sum;
}

/// -log2 of the upper end of x, 0 < x < 1.
double fall_of(const Ball& x) {
    MagValue most;
    arb_get_mag(most, x.data());
    return -mag_get_d_log2_approx(most);
}

/// The number of terms after which those of edge_sum add less than 2^-bits; 0 for too many.
/// (1 + h)_k/k! is about (h + k)^(h + k)/(h^h k^k).
long terms_of_edge_sum(double h, double fall, long bits) {
    const auto size = [](double x) { return x > 0 ? x * std::log2(x) : 0.0; };
    const auto wanted = static_cast<double>(bits + spare_bits);
    double terms = 0;
    for (double next = 1; terms < next;
         next = (wanted + size(h + terms) - size(h) - size(terms)) / fall) {
        terms = next + 1;
        if (!(fall > 0 && terms < most_terms)) {
            return 0;
        }
    }
    return static_cast<long>(terms);
}

/// m - 2 steps, if it is the quotient of small integers.
std::optional<Rational> less(const Exact& m, long steps) {
    constexpr long largest = 1L << 20;
    if (!m.is_rational()) {
        return {};
    }
    const Rational n = m.rational() - 2 * steps;
    return denominator(n) <= largest && numerator(n) <= largest ? std::optional(n) : std::nullopt;
}
long steps_down(const Exact& m, double about_m) {
    if (!m.is_rational()) {
        return static_cast<long>(about_m / 2);
    }
    return static_cast<long>(Integer(numerator(m.rational()) / (2 * denominator(m.rational()))));
}

} // namespace

PowerLawIntegral::PowerLawIntegral(const Exact& m, const Ball& enclosed_m)
    : whole_{enclosed_m, less(m, 0)}, about_m_(approximate(enclosed_m)),
      steps_(about_m_ > most_m ? 0 : steps_down(m, about_m_)), left_{enclosed_m - 2 * steps_,
                                                                     less(m, steps_)},
      apex_factor_(0, enclosed_m.bits()), most_(Rational(99, 100), enclosed_m.bits()) {
    if (left_.exact && denominator(*left_.exact) == 1) {
        whole_left_ = left_.exact->convert_to<long>();
        return;
    }
    apex_factor_ =
        sqrt(Ball::pi(enclosed_m.bits())) / 2 * gamma(-(left_.n / 2)) / gamma((1 - left_.n) / 2);
}

/// sqrt(y) q^n times the sum of (1 + n/2)_k/k! y^k/(2k + 1) (DLMF 15.8.1; docs/pressure.md, "Closed
/// form: power laws"). All terms are positive, and the bound y (1 + n/2 + k)/(k + 1) of their ratio
/// falls with k, so that the rest is at most a geometric series.
Ball PowerLawIntegral::edge_sum(const Exponent& of, const Ball& q, const Ball& y,
                                const Ball& root) {
    const long bits = y.bits();
    const Ball first = of.n / 2 + 1;
    const auto with_rest = [&](const Ball& sum, const Ball& next, long k) {
        const Ball room = 1 - y * (first + k) / (k + 1);
        return certainly_positive(room) ? root * pow(q, of.n) * (sum + from_zero(next / room))
                                        : unknown_ball(bits);
    };
    if (of.exact) {
        const long count = terms_of_edge_sum(approximate(first) - 1, fall_of(y), bits);
        if (count == 0) {
            return unknown_ball(bits);
        }
        const Ball low = first.with_bits(bits_of_rest);
        const Ball next = gamma(low + count) / (gamma(low) * gamma(Ball(count + 1, bits_of_rest))) *
                          pow_int(y.with_bits(bits_of_rest), count) / (2 * count + 1);
        return with_rest(
            first_terms({*of.exact / 2 + 1, Rational(1, 2)}, {Rational(3, 2), 1}, y, count, bits),
            next, count);
    }
    Ball term(1, bits);
    Ball sum(0, bits);
    Ball share(0, bits);
    for (long k = 0; k < static_cast<long>(most_terms) && term.is_finite(); ++k) {
        // Terms that are small compared with the sum are computed with fewer bits.
        // The size of a term of midpoint 0 is no number.
        const long below = k == 0 || arf_is_zero(arb_midref(term.data())) != 0
                               ? 0
                               : arf_abs_bound_lt_2exp_si(arb_midref(sum.data())) -
                                     arf_abs_bound_lt_2exp_si(arb_midref(term.data()));
        const long here = std::clamp(bits + 16 - below, 30L, bits);
        arb_div_si(share.data(), term.data(), 2 * k + 1, here);
        if (k > 0 && negligible(share, sum) &&
            certainly_less(y * (first + k) / (k + 1), Ball(1, bits))) {
            return with_rest(sum, share, k);
        }
        sum += share;
        const Ball factor = (first + k) / (k + 1);
        arb_mul(term.data(), term.data(), y.data(), here);
        arb_mul(term.data(), term.data(), factor.data(), here);
    }
    return unknown_ball(bits);
}

/// q^n (sqrt(pi)/2) Gamma(-n/2)/Gamma((1 - n)/2) (DLMF 15.8.4; docs/pressure.md, "Closed form:
/// power laws").
Ball PowerLawIntegral::apex_power(const Ball& q) const {
    Ball power(0, q.bits());
    if (!contains_zero(q)) {
        power = pow(q, left_.n);
    } else if (!q.is_exact()) {
        const Ball top(q.upper(), q.bits());
        power = from_zero(pow(top, left_.n));
    }
    return power * apex_factor_;
}

/// I_n for 0 < n < 2, n != 1, near q = 0 (DLMF 15.8.4; docs/pressure.md): the sum of beta_k
/// q^(2k)/(n - 2k) with beta_k = (2k)!/(4^k k!^2), and apex_power.
Ball PowerLawIntegral::apex_sum(const Ball& q) const {
    const long bits = q.bits();
    const Ball square = q * q;
    const Ball& n = left_.n;
    if (left_.exact) { // beta_(k + 1)/(2k + 2 - n), whose quotients are less than 1
        const Rational half = *left_.exact / 2;
        const auto count = std::max(
            1L, static_cast<long>(static_cast<double>(bits + spare_bits) / fall_of(square)));
        const Ball sum =
            first_terms({Rational(3, 2), 1 - half}, {Rational(2), 2 - half}, square, count, bits);
        const Ball rest = from_zero(pow_int(square, count) / (1 - square));
        return 1 / n - square / (2 * (2 - n)) * (sum + rest) + apex_power(q);
    }
    Ball term(1, bits);
    Ball sum = 1 / n;
    for (long k = 1;; ++k) {
        term *= square * (2 * k - 1) / (2 * k);
        if (k > 2 && (negligible(term, sum) || k > 4 * bits)) {
            // 2k - n > 1, so that the rest is at most a geometric series.
            const Ball rest = from_zero(abs(term) / (1 - square));
            sum += rest * Ball::from_interval(Real(-1), Real(1), bits);
            break;
        }
        sum += term / (n - 2 * k);
    }
    return sum + apex_power(q);
}

Ball PowerLawIntegral::rest(const Ball& q, const Ball& y, const Ball& root) const {
    if (whole_left_ == 1) {
        return root;
    }
    if (whole_left_ == 0) {
        // acosh(1/q) = ln((1 + sqrt(y))/q) as log1p, since the logarithm is small near the edge.
        return log1p((root + y / (1 + q)) / q);
    }
    // For a wide ball neither series may converge.
    const bool by_apex = certainly_less(q, most_);
    // The series at the apex has a higher fixed cost.
    constexpr double most_y = 0.6;
    if ((approximate(y) <= most_y || !by_apex) && certainly_less(y, most_)) {
        return edge_sum(left_, q, y, root);
    }
    return by_apex ? apex_sum(q) : unknown_ball(q.bits());
}

/// m I_m = sqrt(y) + (m - 1) q^2 I_{m-2} (docs/pressure.md, "Closed form: power laws"), from the
/// smallest exponent upwards.
Ball PowerLawIntegral::few_by_parts(const Ball& q, const Ball& y, const Ball& root) const {
    const long bits = root.bits();
    const Ball square = q * q;
    const long over = numerator(*left_.exact).convert_to<long>();
    const long under = denominator(*left_.exact).convert_to<long>();
    Ball sum = rest(q, y, root);
    for (long k = 1; k <= steps_; ++k) {
        const long p = over + 2 * k * under;
        arb_mul(sum.data(), sum.data(), square.data(), bits);
        arb_mul_si(sum.data(), sum.data(), p - under, bits);
        arb_addmul_si(sum.data(), root.data(), under, bits);
        arb_div_si(sum.data(), sum.data(), p, bits);
    }
    return sum;
}

/// The same recurrence from m downwards, until the terms are negligible: 0 <= I_n <= sqrt(y) for
/// n >= 1.
Ball PowerLawIntegral::by_parts(const Ball& q, const Ball& y, const Ball& root) const {
    const long bits = root.bits();
    const Ball square = q * q;
    Ball sum(0, bits);
    Ball factor(1, bits); ///< the product of (n - 1)/n, without the powers of q
    Ball power(1, bits);
    Ball n = whole_.n;
    for (long k = 0; k < steps_; ++k) {
        if (k > 0 && negligible(factor * power, sum)) {
            return sum + from_zero(factor * power * root);
        }
        sum += factor * power * root / n;
        factor *= (n - 1) / n;
        if (k + 1 < steps_) {
            power *= square;
        }
        n -= 2;
    }
    if (whole_left_ == 0 && contains_zero(q)) {
        // q^2 asinh(sqrt(y)/q) < q^2 ln(2/q), which grows with q.
        const Ball top(q.upper(), bits);
        const Ball last = q.is_exact() ? Ball(0, bits) : from_zero(top * top * log(2 / top));
        return sum + factor * power * last;
    }
    return sum + factor * power * square * rest(q, y, root);
}

Ball PowerLawIntegral::operator()(const Ball& q, const Ball& y) const {
    const long bits = std::max(q.bits(), y.bits());
    if (about_m_ > most_m) {
        return unknown_ball(bits);
    }
    const Ball root = Field<Ball>::root(y);
    if (steps_ == 0) {
        return rest(q, y, root);
    }
    const double about_y = approximate(y);
    const double digits = static_cast<double>(bits);
    // Estimates of the number of terms of each method.
    const double near_edge =
        about_y < 1 ? digits + (1.6 * about_m_ * about_y + 1.5 * digits) / (1 - about_y) : 1e300;
    const double downwards = std::min(static_cast<double>(steps_), 0.7 * digits / about_y);
    if (std::min(near_edge, downwards) > most_terms) {
        return unknown_ball(bits);
    }
    if (near_edge < downwards && certainly_less(y, Ball(1, bits))) {
        return edge_sum(whole_, q, y, root);
    }
    constexpr long few = 16;
    return steps_ <= few && left_.exact && !contains_zero(q) ? few_by_parts(q, y, root)
                                                             : by_parts(q, y, root);
}

} // namespace edgeproof::contact
