// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/edge_sum.hpp"
#include "edgeproof/contact/design/error_family.hpp"
#include "edgeproof/precision/ball/acb_include.hpp"

namespace edgeproof::contact {
namespace {

constexpr std::size_t most_parameters_of_a_series = 2;

/// An array of Arb's polynomials.
class PolyArray {
public:
    PolyArray() {
        for (acb_poly_struct& p : all_) {
            acb_poly_init(&p);
        }
    }
    ~PolyArray() {
        for (acb_poly_struct& p : all_) {
            acb_poly_clear(&p);
        }
    }
    PolyArray(const PolyArray&) = delete;
    PolyArray& operator=(const PolyArray&) = delete;
    void set(std::size_t i, const Ball& constant) {
        acb_t c;
        acb_init(c);
        arb_set(acb_realref(c), constant.data());
        acb_poly_set_acb(&all_[i], c);
        acb_clear(c);
    }
    [[nodiscard]] acb_poly_struct* data() { return all_; }

private:
    acb_poly_struct all_[most_parameters_of_a_series]{};
};

/// 2F1(1 + k, b + k; 3/2 + k; y), 0 <= y < 1, and its derivatives by b, divided by factorials,
/// `count` numbers. Arb's sum of power series bounds what it leaves out.
std::vector<Ball> series_by_b(const Ball& b, const Ball& y, long k, std::size_t count) {
    const long bits = y.bits();
    PolyArray over;
    PolyArray under;
    PolyArray in;
    over.set(0, b + k);
    acb_poly_set_coeff_si(over.data(), 1, 1);
    under.set(0, Ball(Rational(3, 2), bits) + k);
    over.set(1, Ball(1 + k, bits));
    under.set(1, Ball(1, bits));
    in.set(0, y);
    // With k = 0 the last two cancel.
    const slong pairs = k == 0 ? 1 : 2;
    acb_hypgeom_pfq_series_direct(in.data() + 1, over.data(), pairs, under.data(), pairs, in.data(),
                                  0, -1, static_cast<slong>(count), bits);
    std::vector<Ball> coefficients;
    acb_t c;
    acb_init(c);
    for (std::size_t i = 0; i < count; ++i) {
        acb_poly_get_coeff_acb(c, in.data() + 1, static_cast<slong>(i));
        Ball real(0, bits);
        arb_set(real.data(), acb_realref(c));
        coefficients.push_back(std::move(real));
    }
    acb_clear(c);
    return coefficients;
}

/// One polynomial of Arb's.
struct Poly {
    Poly() { acb_poly_init(p); }
    ~Poly() { acb_poly_clear(p); }
    Poly(const Poly&) = delete;
    Poly& operator=(const Poly&) = delete;
    acb_poly_t p{};
};

void set_linear(Poly& p, const Ball& constant, long rate) {
    acb_t c;
    acb_init(c);
    arb_set(acb_realref(c), constant.data());
    acb_poly_set_acb(p.p, c);
    acb_poly_set_coeff_si(p.p, 1, rate);
    acb_clear(c);
}

std::vector<Ball> coefficients_of(const Poly& p, std::size_t count, long bits) {
    std::vector<Ball> coefficients;
    acb_t c;
    acb_init(c);
    for (std::size_t i = 0; i < count; ++i) {
        acb_poly_get_coeff_acb(c, p.p, static_cast<slong>(i));
        Ball real(0, bits);
        arb_set(real.data(), acb_realref(c));
        coefficients.push_back(std::move(real));
    }
    acb_clear(c);
    return coefficients;
}

/// F(y, b + t) in powers of t, for y near 1, by F = 2F1(1, b; b + 1/2; 1 - y)/m + y^(-1/2)
/// (1 - y)^(m/2) (sqrt(pi)/2) Gamma(-m/2)/Gamma(b), m = 1 - 2b (DLMF 15.8.4). Not finite for even
/// m.
std::vector<Ball> series_by_far_end(const Ball& b, const Ball& y, std::size_t count) {
    const long bits = y.bits();
    const auto len = static_cast<slong>(count);
    const Ball half(Rational(1, 2), bits);
    const Ball rest = 1 - y;
    PolyArray over;
    PolyArray under;
    over.set(0, b);
    under.set(0, b + half);
    acb_poly_set_coeff_si(over.data(), 1, 1);
    acb_poly_set_coeff_si(under.data(), 1, 1);
    Poly z;
    Poly sum;
    Poly part;
    Poly other;
    acb_t c;
    acb_init(c);
    arb_set(acb_realref(c), rest.data());
    acb_poly_set_acb(z.p, c);
    acb_hypgeom_pfq_series_direct(sum.p, over.data(), 1, under.data(), 1, z.p, 0, -1, len, bits);
    set_linear(part, 1 - b * 2, -2);
    acb_poly_div_series(sum.p, sum.p, part.p, len, bits);
    set_linear(part, b - half, 1);
    acb_poly_gamma_series(part.p, part.p, len, bits);
    set_linear(other, b, 1);
    acb_poly_rgamma_series(other.p, other.p, len, bits);
    acb_poly_mullow(part.p, part.p, other.p, len, bits);
    const Ball logarithm = log(rest);
    set_linear(other, (half - b) * logarithm, 0);
    arb_neg(acb_realref(c), logarithm.data());
    acb_poly_set_coeff_acb(other.p, 1, c);
    acb_poly_exp_series(other.p, other.p, len, bits);
    acb_poly_mullow(part.p, part.p, other.p, len, bits);
    const Ball factor = sqrt(Ball::pi(bits) / y) / 2;
    arb_set(acb_realref(c), factor.data());
    acb_poly_scalar_mul(part.p, part.p, c, bits);
    acb_poly_add(sum.p, sum.p, part.p, bits);
    acb_clear(c);
    return coefficients_of(sum, count, bits);
}

Ball lower_end(const Ball& x) { return {x.lower(), x.bits()}; }
Ball upper_end(const Ball& x) { return {x.upper(), x.bits()}; }

/// Beyond, the series in 1 - y converges faster.
bool near_far_end(const Ball& y) {
    return certainly_less(Ball(Rational(3, 4), y.bits()), y) &&
           certainly_less(y, Ball(1, y.bits()));
}

/// F(y, b) = 2F1(1, b; 3/2; y) and its derivatives by b, divided by factorials. With b = (1 - m)/2
/// it is I_m(q)/sqrt(y), y = 1 - q^2, I_m the integral of s^m/sqrt(s^2 - q^2) over q < s < 1 (DLMF
/// 15.6.1): every derivative by b is positive, so that values at both ends of b enclose those
/// between.
std::vector<Ball> edge_series(const Ball& y, const Ball& b, std::size_t count) {
    thread_local EdgeSum sum;
    const auto at = [&](const Ball& end) {
        if (const auto value = count == 1 ? sum(end, y) : std::nullopt) {
            return std::vector<Ball>{*value};
        }
        if (near_far_end(y)) {
            std::vector<Ball> f = series_by_far_end(end, y, count);
            if (f.back().is_finite()) {
                return f;
            }
        }
        return series_by_b(end, y, 0, count);
    };
    if (!y.is_finite() || !certainly_less(y, Ball(1, y.bits()))) {
        return std::vector<Ball>(count, unknown_ball(b.bits()));
    }
    std::vector<Ball> f = at(lower_end(b));
    if (b.is_exact()) {
        return f;
    }
    const std::vector<Ball> high = at(upper_end(b));
    for (std::size_t i = 0; i < f.size(); ++i) {
        f[i] = f[i].is_finite() && high[i].is_finite() ? Ball::hull(f[i], high[i])
                                                       : unknown_ball(b.bits());
    }
    return f;
}

Ball edge_function(const Ball& y, const Ball& b) { return edge_series(y, b, 1)[0]; }

Jet edge_function(const Jet& y, const Jet& b) {
    const std::vector<Ball> f = edge_series(y.v, b.v, 3);
    Ball f_y = f[0];
    Ball f_yb = f[0];
    Ball f_yy = f[0];
    if (near_far_end(y.v)) {
        // From y (1 - y) F' + (1/2 - b y) F = 1/2, which the series satisfies.
        const long bits = y.v.bits();
        const Ball half(Rational(1, 2), bits);
        const Ball weight = half - b.v * y.v;
        const Ball scale = y.v * (1 - y.v);
        f_y = (half - weight * f[0]) / scale;
        f_yb = (y.v * f[0] - weight * f[1]) / scale;
        f_yy = (b.v * f[0] - (weight + 1 - y.v * 2) * f_y) / scale;
    } else {
        // d^k/dy^k 2F1(1, b; 3/2; y) = (1)_k (b)_k/(3/2)_k 2F1(1 + k, b + k; 3/2 + k; y):
        // DLMF 15.5.2.
        const std::vector<Ball> first = series_by_b(b.v, y.v, 1, 2);
        f_y = b.v * first[0] * 2 / 3;
        f_yb = (first[0] + b.v * first[1]) * 2 / 3;
        f_yy = b.v * (b.v + 1) * series_by_b(b.v, y.v, 2, 1)[0] * 8 / 15;
    }
    const Ball f_bb = f[2] * 2;
    Jet r(f[0]);
    for (std::size_t i = 0; i < Jet::variables; ++i) {
        r.g[i] = f_y * y.g[i] + f[1] * b.g[i];
        for (std::size_t j = i; j < Jet::variables; ++j) {
            const std::size_t k = Jet::second(i, j);
            r.h[k] = f_y * y.h[k] + f[1] * b.h[k] + f_yy * y.g[i] * y.g[j] +
                     f_yb * (y.g[i] * b.g[j] + y.g[j] * b.g[i]) + f_bb * b.g[i] * b.g[j];
        }
    }
    return r;
}

} // namespace

/// With z = u/(2a), p is proportional to sqrt(z (1 - z)) F(4z (1 - z), (1 - m)/2).
template <class T> struct PowerLawError {
    T b; ///< (1 - m)/2
    T length;
    std::size_t terms;
    bool fraction;

    /// Of c_k D^(k+1/2), c_0 being 1: from F's own series and that of (1 - z)^(j+1/2).
    [[nodiscard]] T coefficient(std::size_t k) const {
        const long bits = value_in(b).bits();
        T sum = T(Ball(0, bits));
        T t = T(Ball(1, bits)); // (b)_j/(3/2)_j 4^j
        for (std::size_t j = 0; j <= k; ++j) {
            Rational binomial(1);
            for (std::size_t i = 0; i < k - j; ++i) {
                binomial *= -(Rational(2 * static_cast<long>(j) + 1, 2) - static_cast<long>(i)) /
                            Rational(static_cast<long>(i) + 1);
            }
            sum += t * T(Ball(binomial, bits));
            t *= b + static_cast<long>(j);
            t *= T(Ball(Rational(8, 2 * static_cast<long>(j) + 3), bits));
        }
        return sum;
    }
    [[nodiscard]] T error(const T& u) const {
        const T z = fraction ? u : u / length;
        T sum = coefficient(terms - 1);
        for (std::size_t k = terms - 1; k-- > 0;) {
            sum = sum * z + coefficient(k);
        }
        return sum / (sqrt(1 - z) * edge_function(z * (1 - z) * 4, b)) - 1;
    }
};

namespace {

class PowerLawFamily : public ErrorFamily {
public:
    PowerLawFamily(formula::Expr m, std::optional<formula::Expr> half_width, ErrorQuestion question)
        : m_(std::move(m)), half_width_(std::move(half_width)), question_(std::move(question)) {}
    [[nodiscard]] std::unique_ptr<ErrorOverBox>
    over(const std::vector<Ball>& parameters) const override {
        return std::make_unique<ClosedFormOverBox<PowerLawError>>(law<Ball>(parameters),
                                                                  law<Jet>(parameters));
    }

private:
    template <class T> [[nodiscard]] PowerLawError<T> law(const std::vector<Ball>& at) const {
        const ParameterValues<T> value(question_.names, at);
        const T one = value.number(Rational(1));
        return {(one - value(m_)) / 2, half_width_ ? T(value(*half_width_) * 2) : one,
                question_.terms, question_.unit == ReachUnit::fraction};
    }
    formula::Expr m_;
    std::optional<formula::Expr> half_width_;
    ErrorQuestion question_;
};

} // namespace

std::unique_ptr<ErrorFamily> power_law_errors(const formula::Expr& m,
                                              const std::optional<formula::Expr>& half_width,
                                              const ErrorQuestion& question) {
    return std::make_unique<PowerLawFamily>(m, half_width, question);
}

} // namespace edgeproof::contact
