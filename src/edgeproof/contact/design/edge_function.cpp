// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/design/error_family.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/precision/ball/arb_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace edgeproof::contact {
namespace {

/// Sets p = constant + rate t.
void set_linear(acb_poly_struct* p, const Ball& constant, long rate) {
    AcbValue c;
    acb_set_arb(c, constant.data());
    acb_poly_set_acb(p, c);
    acb_poly_set_coeff_si(p, 1, rate);
}

std::vector<Ball> coefficients_of(const acb_poly_struct* p, std::size_t count, long bits) {
    std::vector<Ball> coefficients;
    AcbValue c;
    for (std::size_t i = 0; i < count; ++i) {
        acb_poly_get_coeff_acb(c, p, static_cast<slong>(i));
        coefficients.emplace_back(0, bits);
        arb_set(coefficients.back().data(), acb_realref(c));
    }
    return coefficients;
}

/// F(y, b + t) in powers of t, 0 <= y < 1, `count` numbers. Arb's sum of power series bounds its
/// remainder.
std::vector<Ball> series_by_b(const Ball& b, const Ball& y, std::size_t count) {
    const long bits = y.bits();
    AcbPolyValue over;
    AcbPolyValue under;
    AcbPolyValue in;
    AcbPolyValue sum;
    set_linear(over, b, 1);
    set_linear(under, Ball(Rational(3, 2), bits), 0);
    set_linear(in, y, 0);
    acb_hypgeom_pfq_series_direct(sum, over, 1, under, 1, in, 0, -1, static_cast<slong>(count),
                                  bits);
    return coefficients_of(sum, count, bits);
}

/// F(y, b + t) in powers of t, for y near 1, by F = 2F1(1, b; b + 1/2; 1 - y)/m + y^(-1/2)
/// (1 - y)^(m/2) (sqrt(pi)/2) Gamma(-m/2)/Gamma(b), m = 1 - 2b (DLMF 15.8.4). Not finite for even
/// m.
std::vector<Ball> series_by_far_end(const Ball& b, const Ball& y, std::size_t count) {
    const long bits = y.bits();
    const auto len = static_cast<slong>(count);
    const Ball half(Rational(1, 2), bits);
    const Ball rest = 1 - y;
    AcbPolyValue over;
    AcbPolyValue under;
    AcbPolyValue z;
    AcbPolyValue sum;
    AcbPolyValue part;
    AcbPolyValue other;
    set_linear(over, b, 1);
    set_linear(under, b + half, 1);
    set_linear(z, rest, 0);
    acb_hypgeom_pfq_series_direct(sum, over, 1, under, 1, z, 0, -1, len, bits);
    set_linear(part, 1 - b * 2, -2);
    acb_poly_div_series(sum, sum, part, len, bits);
    set_linear(part, b - half, 1);
    acb_poly_gamma_series(part, part, len, bits);
    set_linear(other, b, 1);
    acb_poly_rgamma_series(other, other, len, bits);
    acb_poly_mullow(part, part, other, len, bits);
    const Ball logarithm = log(rest);
    set_linear(other, (half - b) * logarithm, 0);
    AcbValue c;
    acb_set_arb(c, (-logarithm).data());
    acb_poly_set_coeff_acb(other, 1, c);
    acb_poly_exp_series(other, other, len, bits);
    acb_poly_mullow(part, part, other, len, bits);
    acb_set_arb(c, (sqrt(Ball::pi(bits) / y) / 2).data());
    acb_poly_scalar_mul(part, part, c, bits);
    acb_poly_add(sum, sum, part, bits);
    return coefficients_of(sum, count, bits);
}

/// True if the series in 1 - y converges faster.
bool near_far_end(const Ball& y) {
    return certainly_less(Ball(Rational(3, 4), y.bits()), y) &&
           certainly_less(y, Ball(1, y.bits()));
}

Ball both(const Ball& x, const Ball& y) {
    return x.is_finite() && y.is_finite() ? Ball::hull(x, y) : unknown_ball(x.bits());
}

/// F(y, b), the sum of c_k y^k with c_k = (b)_k/(3/2)_k (DLMF 15.2.1), at many places for one b:
/// the c_k of the last b are kept.
class EdgeSum {
public:
    /// Encloses F and its derivatives by y, divided by factorials, `count` numbers, for all numbers
    /// of both balls, 0 <= y < 1. Returns nothing if b may reach 1, if b + k is still negative
    /// after the few terms that are needed, or if another series needs fewer terms.
    [[nodiscard]] std::optional<std::vector<Ball>> operator()(const Ball& b, const Ball& y,
                                                              std::size_t count) {
        constexpr double most_terms_a_bit = 8;
        const long bits = y.bits();
        const Ball size = abs(y);
        const double ratio = size.upper().convert_to<double>();
        const double terms = std::ceil(static_cast<double>(bits) / -std::log2(ratio)) + 1;
        if (!(ratio < 1 && terms < most_terms_a_bit * static_cast<double>(bits)) ||
            !certainly_less(b, Ball(1, bits))) {
            return std::nullopt;
        }
        const auto n = std::max(static_cast<long>(terms), static_cast<long>(count));
        if (!certainly_positive(b + n)) {
            return std::nullopt;
        }
        carry(b, n, bits, count);
        std::vector<Ball> sums;
        for (std::size_t d = 0; d < count; ++d) {
            const auto order = static_cast<long>(d);
            Ball sum(0, bits);
            _arb_poly_evaluate_rectangular(sum.data(), c_[d][0], n - order, y.data(), bits);
            // Each term after the n-th is less than y (n + 1)/(n + 1 - d) times the one before,
            // since 0 < b + k < 3/2 + k.
            const Ball room = 1 - size * Ball(Rational(n + 1, n + 1 - order), bits);
            if (!certainly_positive(room)) {
                return std::nullopt;
            }
            Ball rest = pow_int(size, n - order) / room;
            arb_mul(rest.data(), rest.data(), c_[d][static_cast<std::size_t>(n - order)], bits);
            arb_add_error(sum.data(), rest.data());
            sums.push_back(std::move(sum));
        }
        return sums;
    }

private:
    // Both types have the same memory layout.
    static_assert(sizeof(ArbValue) == sizeof(arb_struct));

    /// Computes c_0 ... c_n and the coefficients of `count` - 1 derivatives.
    void carry(const Ball& b, long n, long bits, std::size_t count) {
        if (bits != bits_ || arb_equal(b.data(), b_) == 0) {
            bits_ = bits;
            arb_set(b_, b.data());
            c_.assign(1, std::vector<ArbValue>(1));
            arb_one(c_[0][0]);
        }
        for (auto k = static_cast<long>(c_[0].size()) - 1; k < n; ++k) {
            ArbValue next;
            arb_mul(next, c_[0].back(), ((b + k) * 2).data(), bits);
            arb_div_si(next, next, 2 * k + 3, bits);
            c_[0].push_back(std::move(next));
        }
        c_.resize(std::max(c_.size(), count));
        for (std::size_t d = 1; d < count; ++d) {
            const auto order = static_cast<long>(d);
            for (auto k = static_cast<long>(c_[d].size()); k + order <= n; ++k) {
                ArbValue next;
                arb_mul_si(next, c_[d - 1][static_cast<std::size_t>(k) + 1], k + 1, bits);
                arb_div_si(next, next, order, bits);
                c_[d].push_back(std::move(next));
            }
        }
    }

    ArbValue b_;
    long bits_ = 0;
    std::vector<std::vector<ArbValue>> c_; ///< c_[d][k] = C(k + d, d) c_(k + d)
};

thread_local EdgeSum edge_sum; // searches need many places for one b

/// F(y, b) and its derivatives by b, divided by factorials, for an exact b.
std::vector<Ball> edge_series_at(const Ball& b, const Ball& y, std::size_t count) {
    const long bits = y.bits();
    if (const auto value = count == 1 ? edge_sum(b, y, 1) : std::nullopt) {
        return *value;
    }
    if (near_far_end(y)) {
        std::vector<Ball> f = series_by_far_end(b, y, count);
        if (f.back().is_finite()) {
            return f;
        }
        // Both terms have a pole at even m. Values at both sides of it enclose the value.
        const Ball near = power_of_two(-bits, 3 * bits);
        f = series_by_far_end(b - near, y.with_bits(3 * bits), count);
        const std::vector<Ball> high = series_by_far_end(b + near, y.with_bits(3 * bits), count);
        for (std::size_t i = 0; i < count; ++i) {
            f[i] = both(f[i], high[i]).with_bits(bits);
        }
        if (f.back().is_finite()) {
            return f;
        }
    }
    if (certainly_less(y, Ball(1, bits))) {
        return series_by_b(b, y, count);
    }
    // F(1, b) = 1/(1 - 2b): DLMF 15.4.20.
    const Ball m = 1 - b * 2;
    std::vector<Ball> f(count, unknown_ball(bits));
    for (std::size_t i = 0; i < count && arb_is_one(y.data()) != 0 && certainly_positive(m); ++i) {
        f[i] = pow_int(Ball(2, bits) / m, static_cast<long>(i)) / m;
    }
    return f;
}

/// The same for all numbers of the ball b.
std::vector<Ball> edge_series(const Ball& y, const Ball& b, std::size_t count) {
    std::vector<Ball> f = edge_series_at(lower_end(b), y, count);
    if (!b.is_exact()) {
        const std::vector<Ball> high = edge_series_at(upper_end(b), y, count);
        for (std::size_t i = 0; i < count; ++i) {
            f[i] = both(f[i], high[i]);
        }
    }
    return f;
}

Ball argument(const Ball& z) { return z * (1 - z) * 4; }
bool certainly_zero(const Ball& x) { return arb_is_zero(x.data()) != 0; }

/// 1/F for exact arguments, y <= 1; 0 where F is infinite: y = 1 and m <= 0.
Ball reciprocal_at(const Ball& b, const Ball& y) {
    const Ball m = 1 - b * 2;
    return arb_is_one(y.data()) != 0 && !certainly_positive(m) ? Ball(0, y.bits())
                                                               : 1 / edge_series_at(b, y, 1)[0];
}

} // namespace

Ball reciprocal_edge_function(const Ball& z, const Ball& b) {
    const long bits = z.bits();
    const Ball one(1, bits);
    const Ball low = argument(lower_end(z));
    const Ball high = argument(upper_end(z));
    if (!low.is_finite() || !high.is_finite() || !b.is_finite()) {
        return unknown_ball(bits);
    }
    const Ball least = lower_end(min(low, high));
    Ball most = upper_end(max(low, high));
    if (contains(z, Rational(1, 2)) || !certainly_less(most, one)) {
        most = one;
    }
    const Ball b_low = lower_end(b);
    const Ball b_high = upper_end(b);
    const Ball greatest = reciprocal_at(b_low, certainly_negative(b_low) ? most : least);
    return both(greatest, reciprocal_at(b_high, certainly_negative(b_high) ? least : most));
}

BallSeries reciprocal_edge_function(const BallSeries& z, const BallSeries& b) {
    const long bits = z.bits();
    const Ball one(1, bits);
    const Ball y = argument(z[0]);
    const Ball b0 = b[0];
    const bool by_b = !certainly_zero(b[1]) || !certainly_zero(b[2]);
    BallSeries dy = z * (-z + one) * Ball(4, bits);
    dy.set(0, Ball(0, bits));
    if (const auto by_y = by_b || !b0.is_exact() ? std::nullopt : edge_sum(b0, y, 3)) {
        const std::vector<Ball>& d = *by_y;
        return BallSeries(one, z.order()) / (dy * dy * d[2] + dy * d[1] + d[0]);
    }
    BallSeries F(edge_series(y, b0, by_b ? z.order() : 1)); // in powers of the change of b
    const bool moves = !certainly_zero(z[1]) || !certainly_zero(z[2]);
    if (moves && !certainly_less(y, one)) { // the pressure need not have a derivative at the middle
        return unknown_series(z.order(), bits);
    }
    if (by_b) {
        BallSeries db = b;
        db.set(0, Ball(0, bits));
        F = db * db * F[2] + db * F[1] + F[0];
    } else {
        F = BallSeries(F[0], z.order());
    }
    BallSeries sum = F;
    if (moves) { // y (1 - y) F' + (1/2 - b y) F = 1/2
        const BallSeries weight = -(b * y) + Ball(Rational(1, 2), bits);
        const Ball scale = 1 / (y * (1 - y));
        const BallSeries by_y = (-(weight * F) + Ball(Rational(1, 2), bits)) * scale;
        const BallSeries twice = (b * F - (weight + (1 - y * 2)) * by_y) * scale;
        sum = sum + dy * by_y + dy * dy * twice * Ball(Rational(1, 2), bits);
    }
    return BallSeries(one, z.order()) / sum;
}

} // namespace edgeproof::contact
