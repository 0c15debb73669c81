// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/quadrature/theta_cells.hpp"

#include "edgeproof/precision/ball/arb_values.hpp"
#include "edgeproof/precision/bounded_cache.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace edgeproof::quadrature {

namespace {

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

} // namespace

std::shared_ptr<const GaussLegendreBalls> gauss_legendre_balls(std::size_t n, long bits) {
    constexpr std::size_t most_rules = 64;
    thread_local BoundedCache<std::pair<std::size_t, long>, const GaussLegendreBalls> rules(
        most_rules);
    return rules.get({n, bits},
                     [&] { return std::make_shared<const GaussLegendreBalls>(build(n, bits)); });
}

namespace {

class Cells {
public:
    Cells(const ThetaIntegrand& f, const Ball& centre, const Ball& half_length,
          const ThetaGoal& goal, long bits)
        : f_(f), centre_(centre), half_length_(half_length), goal_(goal), bits_(bits),
          rule_(gauss_legendre_balls(goal.nodes, bits)), most_(f.count()),
          value_(f.count(), Ball(0, bits)), sum_(f.count(), Ball(0, bits)) {
        // 64 M/(15 (rho - 1) rho^(2n - 1)) for an interval of length 2, rho = 4 (`trefethen2013`,
        // theorem 19.3).
        const long power = 2 * (2 * static_cast<long>(goal.nodes) - 1);
        Ball error = Ball(Rational(64, 45), 64);
        arb_mul_2exp_si(error.data(), error.data(), -power);
        rule_error_ = Magnitude(error);
    }

    void span(const ThetaSpan& span) {
        span_ = &span;
        const Ball from(span.from.midpoint(), bits_);
        const Ball to(span.to.midpoint(), bits_);
        if (certainly_less(from, to)) {
            cell(from, to, 0);
        }
        for (const Ball* limit : {&span.from, &span.to}) {
            const Magnitude radius{Ball(limit->radius(), 64)};
            if (radius.is_zero()) {
                continue;
            }
            acb_set_arb(theta_, limit->data());
            if (!bounded()) {
                failed_ = true;
                return;
            }
            for (std::size_t k = 0; k < sum_.size(); ++k) {
                sum_[k] += (most_[k] * radius).ball(bits_);
            }
        }
    }
    [[nodiscard]] std::vector<Ball> sum() {
        if (failed_) {
            for (Ball& x : sum_) {
                arb_indeterminate(x.data());
            }
        }
        return sum_;
    }

private:
    /// Bounds the integrands over theta_.
    bool bounded() {
        span_->map(s_, rate_, theta_, centre_, half_length_, bits_);
        const Magnitude rate(rate_);
        if (!rate.is_finite() || !f_.bound({*span_, theta_, s_}, most_)) {
            return false;
        }
        if (span_->root != 0) {
            for (Magnitude& most : most_) {
                most = most * rate;
            }
        }
        return true;
    }
    [[nodiscard]] bool small(const Magnitude& factor) const {
        for (std::size_t k = 0; k < most_.size(); ++k) {
            if (!(most_[k] * factor * goal_.scale[k] <= goal_.tolerance)) {
                return false;
            }
        }
        return true;
    }
    /// True if s varies over the real cell s_ by more than its uncertainty in the middle. Otherwise
    /// halving the cell does not improve the bounds.
    [[nodiscard]] bool resolved(const Ball& middle) {
        Ball width(0, 64);
        Ball known(0, 64);
        arb_get_rad_arb(width.data(), acb_realref(s_));
        acb_set_arb(theta_, middle.data());
        span_->map(s_, rate_, theta_, centre_, half_length_, bits_);
        arb_get_rad_arb(known.data(), acb_realref(s_));
        return certainly_less(known * 4, width);
    }
    void add(const Magnitude& factor) {
        for (std::size_t k = 0; k < sum_.size(); ++k) {
            sum_[k] += (most_[k] * factor).ball(bits_);
        }
    }
    void cell(const Ball& lo, const Ball& hi, int depth) {
        if (failed_) {
            return;
        }
        Ball middle = (lo + hi) / 2;
        arb_get_mid_arb(middle.data(), middle.data());
        const Ball half = (hi - lo) / 2;
        // The ellipse with rho = 4: its semi-axes are 17/8 and 15/8 of the half length
        // (`trefethen2013`, chapter 8).
        acb_set_arb(theta_, middle.data());
        arb_add_error(acb_realref(theta_), Ball(half * 17 / 8).data());
        arb_add_error(acb_imagref(theta_), Ball(half * 15 / 8).data());
        const Magnitude error = rule_error_ * Magnitude(half);
        if (bounded() && small(error)) {
            for (std::size_t j = 0; j < goal_.nodes; ++j) {
                check_interruption();
                const std::size_t mirrored = std::min(j, goal_.nodes - 1 - j);
                const Ball step = half * rule_->x[mirrored];
                const Ball theta = mirrored == j ? middle + step : middle - step;
                acb_set_arb(theta_, theta.data());
                span_->map(s_, rate_, theta_, centre_, half_length_, bits_);
                f_.value({*span_, theta_, s_}, value_);
                Ball weight = half * rule_->weight[mirrored];
                if (span_->root != 0) {
                    arb_mul(weight.data(), weight.data(), acb_realref(rate_), bits_);
                }
                for (std::size_t k = 0; k < sum_.size(); ++k) {
                    arb_addmul(sum_[k].data(), value_[k].data(), weight.data(), bits_);
                }
            }
            add(error);
            return;
        }
        const Magnitude length(Ball(hi - lo));
        acb_set_arb(theta_, Ball::hull(lo, hi).data());
        if (bounded() && (small(length) || !resolved(middle))) {
            add(length);
            return;
        }
        if (depth == goal_.depth) {
            failed_ = true;
            return;
        }
        cell(lo, middle, depth + 1);
        cell(middle, hi, depth + 1);
    }

    const ThetaIntegrand& f_;
    const Ball& centre_;
    const Ball& half_length_;
    const ThetaGoal& goal_;
    long bits_;
    std::shared_ptr<const GaussLegendreBalls> rule_;
    Magnitude rule_error_;
    std::vector<Magnitude> most_;
    std::vector<Ball> value_;
    std::vector<Ball> sum_;
    const ThetaSpan* span_ = nullptr;
    bool failed_ = false;
    AcbValue theta_;
    AcbValue s_;
    AcbValue rate_;
};

} // namespace

void ThetaSpan::map(acb_t s, acb_t rate, const acb_t t, const Ball& centre, const Ball& half_length,
                    long bits) const {
    if (root == 0) {
        acb_one(rate);
        acb_cos(s, t, bits);
        acb_mul_arb(s, s, half_length.data(), bits);
        acb_add_arb(s, s, centre.data(), bits);
        return;
    }
    // ds = side root t^(root - 1) dt, and |dtheta| = |ds|/sqrt(d^2 - (s - c)^2)
    // (docs/curved-slopes.md).
    AcbValue power;
    acb_pow_ui(power, t, static_cast<ulong>(root - 1), bits);
    acb_mul(s, power, t, bits);
    acb_mul_si(s, s, side, bits);
    acb_add_arb(s, s, knot.data(), bits);
    acb_sub_arb(rate, s, centre.data(), bits);
    acb_mul(rate, rate, rate, bits);
    acb_neg(rate, rate);
    const Ball square = half_length * half_length;
    acb_add_arb(rate, rate, square.data(), bits);
    acb_rsqrt_analytic(rate, rate, 1, bits);
    acb_mul(rate, rate, power, bits);
    acb_mul_si(rate, rate, root, bits);
}

std::vector<Ball> integrate_cells(const ThetaIntegrand& f, const std::vector<ThetaSpan>& spans,
                                  const Ball& centre, const Ball& half_length,
                                  const ThetaGoal& goal, long bits) {
    Cells cells(f, centre, half_length, goal, bits);
    for (const ThetaSpan& span : spans) {
        cells.span(span);
    }
    return cells.sum();
}

} // namespace edgeproof::quadrature
