// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/quadrature/gauss_legendre.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/bounded_cache.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <cmath>
#include <mutex>
#include <utility>

namespace edgeproof::quadrature {
namespace {

Real rounded(const Ball& x, long bits) {
    Real r;
    mpfr_set_prec(r.backend().data(), bits);
    arf_get_mpfr(r.backend().data(), arb_midref(x.data()), MPFR_RNDN);
    return r;
}

GaussLegendreBalls build(std::size_t n, long bits) {
    GaussLegendreBalls rule;
    for (std::size_t k = 0; 2 * k < n; ++k) {
        check_interruption();
        Ball x(0, bits);
        Ball w(0, bits);
        // `johansson-mezzarobba2018`
        arb_hypgeom_legendre_p_ui_root(x.data(), w.data(), n, k, bits);
        rule.x.push_back(std::move(x));
        rule.weight.push_back(std::move(w));
    }
    return rule;
}

/// One slot for each table, so that threads that need another table do not wait while one is built.
struct Slot {
    std::once_flag once;
    GaussLegendreBalls rule;
};

struct Tables {
    std::mutex guard;
    BoundedCache<std::pair<std::size_t, long>, Slot> slots{most_gauss_legendre_tables};
};
Tables& tables() {
    static Tables all;
    return all;
}

} // namespace

std::shared_ptr<const GaussLegendreBalls> gauss_legendre_balls(std::size_t n, long bits) {
    std::shared_ptr<Slot> slot;
    {
        const std::lock_guard lock(tables().guard);
        slot = tables().slots.get({n, bits}, [] { return std::make_shared<Slot>(); });
    }
    std::call_once(slot->once, [&] { slot->rule = build(n, bits); });
    return {slot, &slot->rule};
}

std::size_t gauss_legendre_tables() {
    const std::lock_guard lock(tables().guard);
    return tables().slots.size();
}

GaussLegendreRule gauss_legendre_rule(std::size_t n, long bits) {
    // 1 - x is about 2.9/n^2 at the outermost node, and loses as many bits.
    long guard = 16;
    for (std::size_t k = n; k > 1; k /= 2) {
        guard += 2;
    }
    const auto balls = gauss_legendre_balls(n, bits + guard);
    GaussLegendreRule rule;
    for (std::size_t k = 0; k < balls->x.size(); ++k) {
        rule.x.push_back(rounded(balls->x[k], bits));
        rule.from_end.push_back(rounded(1 - balls->x[k], bits));
        rule.weight.push_back(rounded(balls->weight[k], bits));
    }
    return rule;
}

namespace {

/// (2k + 1) times the mean of P_k(2t - 1). The logarithmic derivative of the weight is rational
/// (Pearson's equation), which gives a recurrence of three terms; both its solutions grow or fall
/// only like powers of k.
std::vector<Real> moments(std::size_t n, const Real& p, const Real& r) {
    std::vector<Real> mean{Real(1)};
    const Real difference = p - r;
    const Real sum = p + r;
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const auto k = static_cast<long>(i);
        Real next = difference * (2 * k + 1) * mean[i];
        if (i > 0) {
            next += (k - 1 - sum) * k * mean[i - 1];
        }
        mean.push_back(next / ((sum + (k + 2)) * (k + 1)));
    }
    for (std::size_t i = 0; i < mean.size(); ++i) {
        mean[i] *= 2 * static_cast<long>(i) + 1;
    }
    return mean;
}

/// The sum of c_k P_k(x), by the recurrence of the Legendre polynomials (DLMF 14.10.3).
class LegendreSeries {
public:
    explicit LegendreSeries(std::vector<Real> c) : c_(std::move(c)) {}
    Real operator()(const Real& x) {
        mpfr_set_ui(raw(before_), 1, MPFR_RNDN);
        mpfr_set(raw(now_), raw(x), MPFR_RNDN);
        Real sum = c_[0];
        for (std::size_t i = 1; i < c_.size(); ++i) {
            mpfr_mul(raw(term_), raw(c_[i]), raw(now_), MPFR_RNDN);
            mpfr_add(raw(sum), raw(sum), raw(term_), MPFR_RNDN);
            // (i + 1) P_(i+1) = (2i + 1) x P_i - i P_(i-1)
            mpfr_mul(raw(term_), raw(now_), raw(x), MPFR_RNDN);
            mpfr_mul_ui(raw(term_), raw(term_), 2 * i + 1, MPFR_RNDN);
            mpfr_mul_ui(raw(before_), raw(before_), i, MPFR_RNDN);
            mpfr_sub(raw(before_), raw(term_), raw(before_), MPFR_RNDN);
            mpfr_div_ui(raw(before_), raw(before_), i + 1, MPFR_RNDN);
            mpfr_swap(raw(before_), raw(now_));
        }
        return sum;
    }

private:
    std::vector<Real> c_;
    Real before_;
    Real now_;
    Real term_;
};

} // namespace

ProductRule::ProductRule(std::size_t n, const Real& p, const Real& r) {
    const unsigned digits = working_digits();
    // The recurrences lose digits only like a power of n.
    const PrecisionScope scope(digits + 8 +
                               static_cast<unsigned>(3 * std::log10(static_cast<double>(n) + 1)));
    const Real one(1);
    const auto rule = gauss_legendre_rule(n, mpfr_get_prec(raw(one)));
    LegendreSeries density(moments(n, p, r));
    const auto add = [&](const Real& x, const Real& from_0, const Real& from_1, const Real& w) {
        const Real here = w / 2 * density(x);
        size += std::abs(static_cast<double>(here));
        const PrecisionScope back(digits);
        t.push_back(at_working_precision(from_0));
        from_end.push_back(at_working_precision(from_1));
        weight.push_back(at_working_precision(here));
    };
    for (std::size_t k = 0; k < rule.x.size(); ++k) {
        const Real near = rule.from_end[k] / 2;
        const Real far = (1 + rule.x[k]) / 2;
        add(rule.x[k], far, near, rule.weight[k]);
        if (rule.x[k] != 0) {
            add(Real(-rule.x[k]), near, far, rule.weight[k]);
        }
    }
}

double product_rule_log_error(std::size_t n, double rho, double ln_M, double size) {
    // `trefethen2013`, theorem 8.2, with degree n - 1
    return std::log(2 * (1 + size) / (rho - 1)) + ln_M -
           (static_cast<double>(n) - 1) * std::log(rho);
}

} // namespace edgeproof::quadrature
