// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/batch/batch_power_law.hpp"

#include "edgeproof/contact/batch/batch_piece.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/quadrature/gauss_legendre.hpp"
#include "edgeproof/quadrature/holomorphic_reach.hpp"
#include "edgeproof/quadrature/tanh_sinh_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace edgeproof::contact {
namespace {

/// Closer to the apex than this the apex rule takes fewer nodes than the edge rule.
constexpr double apex_begins = 0.5;
/// Closer to the apex than this tanh-sinh integrates over ln s.
constexpr double far_begins = 1e-8;
/// With more steps of the recurrence than this, powers at the nodes cost less.
constexpr unsigned long most_steps = 200;
/// A product rule with n nodes takes n^2 steps to construct.
constexpr double most_product_nodes = 1300;
constexpr double most_nodes = 20000;
constexpr int last_level_of_a_share = 13;

long precision_of(const Real& x) { return mpfr_get_prec(raw(x)); }

void set_middle(Real& x, const Ball& ball) {
    arf_get_mpfr(raw(x), arb_midref(ball.data()), MPFR_RNDN);
}

/// Returns (m - 1)/2.
Exact exponent_of_integrand(const Exact& m) {
    return m.is_rational() ? Exact::of(Rational((m.rational() - 1) / 2))
                           : Exact((m.expr() - Expr::number(1)) / Expr::number(2));
}

/// Returns t^p (1 - t)^r; `rest` is 1 - t.
Real weight_at(const Real& t, const Real& rest, const Real& p, const Real& r) {
    const long bits = precision_of(p) + 32;
    const Ball power =
        exp(Ball(p, bits) * log(Ball(t, bits)) + Ball(r, bits) * log(Ball(rest, bits)));
    return at_working_precision(power.midpoint());
}

} // namespace

unsigned BatchPowerLaw::lost_digits(const Exact& m) {
    const Real value = m.to<Real>();
    const Real distance = abs(value - 2 * round(Real(value / 2)));
    return distance > 0 && distance < 1
               ? static_cast<unsigned>(std::ceil(-static_cast<double>(log10(distance))))
               : 0;
}

BatchPowerLaw::BatchPowerLaw(const Exact& m, const Real& rate, const Real& a, unsigned digits,
                             BatchPressure::Rule rule)
    : m_(m.to<Real>()), m_double_(static_cast<double>(m_)), scale_(rate / pi<Real>()),
      inverse_a_(1 / a), ln_tolerance_(-(static_cast<double>(digits) + 3) * std::numbers::ln10),
      rule_(rule), power_(exponent_of_integrand(m)) {
    if (!(m_double_ < 1e15)) {
        throw DomainError("a power law with an exponent as large as this has no batch route");
    }
    const Real half = floor(Real(m_ / 2));
    steps_ = static_cast<unsigned long>(half);
    n_ = m.is_rational() ? from_rational<Real>(Rational(m.rational() - 2 * Rational(steps_)))
                         : Real(m_ - 2 * half);
    b_ = (1 - n_) / 2;
    n_double_ = static_cast<double>(n_);
    if (n_ != 0 && n_ != 1) {
        const Ball n(n_, precision_of(n_) + 32);
        const Ball pi = Ball::pi(n.bits());
        // C = (sqrt(pi)/2) Gamma(-n/2)/Gamma((1 - n)/2) (DLMF 15.8.4)
        set_middle(apex_factor_, sqrt(pi) / 2 * gamma(-(n / 2)) / gamma((1 - n) / 2));
    }
}

RoutedPressure<Real> BatchPowerLaw::operator()(const Point<Real>& at) {
    // q = |x|/a, y = 1 - q^2 = (a - x)(a + x)/a^2.
    mpfr_mul(raw(q_), raw(at.x), raw(inverse_a_), MPFR_RNDN);
    mpfr_abs(raw(q_), raw(q_), MPFR_RNDN);
    mpfr_sqr(raw(square_), raw(q_), MPFR_RNDN);
    mpfr_mul(raw(y_), raw(at.right), raw(inverse_a_), MPFR_RNDN);
    mpfr_mul(raw(y_), raw(y_), raw(at.left), MPFR_RNDN);
    mpfr_mul(raw(y_), raw(y_), raw(inverse_a_), MPFR_RNDN);
    mpfr_sqrt(raw(root_), raw(y_), MPFR_RNDN);
    const double q = static_cast<double>(q_);
    const bool levels = rule_ == BatchPressure::Rule::tanh_sinh;
    Share share;
    if (q_ == 0) {
        share.value = 1 / m_; // docs/pressure.md, "The greatest pressure"

    } else if (steps_ > most_steps && q >= apex_begins) {
        share = levels ? powers_by_levels() : powers_by_rule(q);
    } else if (levels && q < far_begins) {
        share = far_by_levels();
    } else if (n_ == 1) {
        share = lifted([&] { return Share{root_}; });
    } else if (levels) {
        share = lifted([&] { return edge_by_levels(); });
    } else if (q < apex_begins) {
        share = lifted([&] { return apex_by_rule(); });
    } else {
        mpfr_div(raw(gap_), raw(square_), raw(y_), MPFR_RNDN);
        const Choice choice = choose_edge(q);
        share = choice.n == 0 ? powers_by_rule(q) : lifted([&] { return edge_by_rule(choice); });
    }
    RoutedPressure<Real> p;
    mpfr_mul(raw(p.value), raw(scale_), raw(share.value), MPFR_RNDN);
    p.estimate = quadrature::from_ln_size(share.ln_error - quadrature::ln_size(share.value));
    p.evaluations = share.nodes;
    p.converged = share.converged;
    return p;
}

template <class Base> BatchPowerLaw::Share BatchPowerLaw::lifted(const Base& base) {
    if (steps_ == 0) {
        return base();
    }
    // m I_m = W + (m - 1) q^2 I_{m-2} (docs/pressure.md, "Closed form: power laws")
    Real sum(0);
    Real factor(root_);
    Real exponent(m_);
    for (unsigned long k = 0; k < steps_; ++k) {
        mpfr_div(raw(factor), raw(factor), raw(exponent), MPFR_RNDN);
        mpfr_add(raw(sum), raw(sum), raw(factor), MPFR_RNDN);
        mpfr_sub_ui(raw(exponent), raw(exponent), 1, MPFR_RNDN);
        mpfr_mul(raw(factor), raw(factor), raw(exponent), MPFR_RNDN);
        mpfr_mul(raw(factor), raw(factor), raw(square_), MPFR_RNDN);
        mpfr_sub_ui(raw(exponent), raw(exponent), 1, MPFR_RNDN);
        // 0 <= I_n <= W for n >= 1.
        if (k + 1 < steps_ &&
            quadrature::ln_size(factor) < ln_tolerance_ - 12 + quadrature::ln_size(sum)) {
            return {sum, quadrature::ln_size(factor)};
        }
    }
    factor /= root_;
    if (quadrature::ln_size(factor) < -1e200) {
        return {sum};
    }
    Share share = base();
    mpfr_mul(raw(share.value), raw(share.value), raw(factor), MPFR_RNDN);
    mpfr_add(raw(share.value), raw(share.value), raw(sum), MPFR_RNDN);
    share.ln_error += quadrature::ln_size(factor);
    return share;
}

/// Chooses the edge rule; its integrand has its pole at the distance q^2/W^2 from t = 1.
BatchPowerLaw::Choice BatchPowerLaw::choose_edge(double q) const {
    const double gap = in_units(gap_, 0);
    const double pole_rho = (1 + q) / std::max(in_units(y_, 0) / (1 + q), 1e-300);
    const double guess = -ln_tolerance_ / std::log(pole_rho);
    const double part = 1 - 1 / (1 + guess * std::sqrt(gap / (gap + 1)));
    const double rho = quadrature::BernsteinEllipse::beyond(1, 2 * part * gap).rho;
    const double ln_M = -std::log(gap * (1 - part));
    // The error of product_rule_log_error (trefethen2013, theorem 8.2) for this number of nodes.
    const double ln_size = std::log(std::max(1e-300, std::abs(1 - n_double_)) / 3) + ln_M;
    const double needed = 2 + (std::log(8 / (rho - 1)) + ln_size - ln_tolerance_) / std::log(rho);
    const bool many = needed > most_product_nodes;
    return {many ? 0 : quadrature::rounded_up_nodes(std::max(1.0, needed)), rho, ln_M};
}

BatchPowerLaw::Share BatchPowerLaw::edge_by_rule(const Choice& choice) {
    auto found = edge_.find(choice.n);
    if (found == edge_.end()) {
        found = edge_.try_emplace(choice.n, choice.n, b_, Real(n_ / 2)).first;
    }
    const quadrature::ProductRule& rule = found->second;
    Share share{Real(0)};
    sums_.add_quotients(share.value, rule.weight, rule.from_end, gap_);
    close_edge(share);
    share.nodes = choice.n;
    share.ln_error =
        quadrature::product_rule_log_error(choice.n, choice.rho, choice.ln_M, rule.size) +
        quadrature::ln_size(root_);
    return share;
}

/// W (1 + (2b/3) times the mean) (DLMF 15.2.1, 15.6.1).
void BatchPowerLaw::close_edge(Share& share) {
    mpfr_mul(raw(share.value), raw(share.value), raw(b_), MPFR_RNDN);
    mpfr_mul_2ui(raw(share.value), raw(share.value), 1, MPFR_RNDN);
    mpfr_div_ui(raw(share.value), raw(share.value), 3, MPFR_RNDN);
    mpfr_add_ui(raw(share.value), raw(share.value), 1, MPFR_RNDN);
    mpfr_mul(raw(share.value), raw(share.value), raw(root_), MPFR_RNDN);
}

BatchPowerLaw::Share BatchPowerLaw::apex_by_rule() {
    const long bits = precision_of(n_) + 16;
    Share share;
    if (n_ == 0) {
        // I_0 = arcosh(1/q) = arsinh(W/q)
        set_middle(share.value, asinh(Ball(root_, bits) / Ball(q_, bits)));
        return share;
    }
    // The integrand over 0 < t < 1 is at most q^2/|r| where 1 - q^2 t is not close to zero.
    const double about = in_units(square_, 0);
    const double excess = 2 * (1 - about) / std::max(about, 1e-280);
    const double guess =
        -ln_tolerance_ / std::log(quadrature::BernsteinEllipse::beyond(1, excess).rho);
    const double part = 1 - 1 / (2 + 2 * guess * std::sqrt(excess / (excess + 2)));
    const double rho = quadrature::BernsteinEllipse::beyond(1, part * excess).rho;
    const double ln_M = quadrature::ln_size(square_) - std::log((1 - part) * (1 - about)) / 2;
    const double needed =
        2 + (std::log(8 / (rho - 1) / (2 - n_double_)) + ln_M - ln_tolerance_) / std::log(rho);
    const std::size_t n = quadrature::rounded_up_nodes(std::max(1.0, needed));
    auto found = apex_.find(n);
    if (found == apex_.end()) {
        found = apex_.try_emplace(n, n, Real(-n_ / 2), Real(0)).first;
    }
    const quadrature::ProductRule& rule = found->second;
    Real sum(0);
    Real r;
    for (std::size_t k = 0; k < rule.t.size(); ++k) {
        mpfr_mul(raw(below_), raw(rule.t[k]), raw(square_), MPFR_RNDN);
        mpfr_ui_sub(raw(below_), 1, raw(below_), MPFR_RNDN);
        mpfr_sqrt(raw(r), raw(below_), MPFR_RNDN);
        mpfr_add(raw(below_), raw(below_), raw(r), MPFR_RNDN);
        mpfr_div(raw(above_), raw(rule.weight[k]), raw(below_), MPFR_RNDN);
        mpfr_add(raw(sum), raw(sum), raw(above_), MPFR_RNDN);
    }
    const long more = 64; // for the power of a small number
    const Ball power = exp(Ball(n_, bits + more) * log(Ball(q_, bits + more)));
    set_middle(above_, power);
    share.value = apex_factor_ * above_ + 1 / n_ - square_ * sum / (2 - n_);
    share.nodes = n;
    share.ln_error =
        quadrature::product_rule_log_error(n, rho, ln_M, rule.size) - std::log(2 - n_double_);
    return share;
}

/// The integrand over -1 < w/W < 1, (q^2 + y (w/W)^2)^e with e = (m - 1)/2, is holomorphic except
/// at w = +-iq. Its integral over half of the interval is at least 1/max(1, m). By symmetry half of
/// the nodes suffice.
BatchPowerLaw::Share BatchPowerLaw::powers_by_rule(double q) {
    const double y = in_units(y_, 0);
    const double e = (m_double_ - 1) / 2;
    const double ln_tolerance = ln_tolerance_ - std::log(std::max(1.0, m_double_));
    const double highest = q / std::sqrt(y);
    double fewest = most_nodes;
    Share share{Real(0)};
    for (const double part : {0.3, 0.6, 0.85, 0.95, 0.99}) {
        const double h = part * highest;
        const quadrature::BernsteinEllipse ellipse{1, h + std::sqrt(h * h + 1)};
        const double ln_M =
            e * std::log(e < 0 ? q * q * (1 - part * part) : q * q + y * (h * h + 1));
        // trefethen2013, theorem 19.3.
        const double needed = gauss_legendre_nodes_needed(ellipse, ln_M, ln_tolerance);
        if (needed < fewest) {
            fewest = needed;
            share.nodes = quadrature::rounded_up_nodes(needed / 2);
            share.ln_error = gauss_legendre_log_error(ellipse, ln_M, 2 * share.nodes);
        }
    }
    if (share.nodes == 0) {
        throw BudgetError("a power law of this exponent needs too many nodes here");
    }
    add_powers(share.value, power_nodes(share.nodes));
    share.value *= root_;
    share.ln_error += quadrature::ln_size(root_);
    return share;
}

// (q^2 + y (w/W)^2)^((m - 1)/2) = (1 - from y)^((m - 1)/2).
void BatchPowerLaw::add_powers(Real& sum, const Nodes& nodes) {
    for (std::size_t k = 0; k < nodes.from.size(); ++k) {
        mpfr_mul(raw(below_), raw(nodes.from[k]), raw(y_), MPFR_RNDN);
        mpfr_ui_sub(raw(below_), 1, raw(below_), MPFR_RNDN);
        power_(above_, below_);
        mpfr_mul(raw(above_), raw(above_), raw(nodes.weight[k]), MPFR_RNDN);
        mpfr_add(raw(sum), raw(sum), raw(above_), MPFR_RNDN);
    }
}

const BatchPowerLaw::Nodes& BatchPowerLaw::power_nodes(std::size_t n) {
    auto& nodes = powers_[n];
    if (nodes.from.empty()) {
        const auto rule = quadrature::gauss_legendre_rule(2 * n, precision_of(below_));
        for (std::size_t k = 0; k < rule.x.size(); ++k) {
            nodes.from.push_back(rule.from_end[k] * (1 + rule.x[k]));
            nodes.weight.push_back(rule.weight[k]);
        }
    }
    return nodes;
}

template <class AddLevel> BatchPowerLaw::Share BatchPowerLaw::by_levels(const AddLevel& add_level) {
    Share share;
    share.converged = false;
    quadrature::LevelEstimate estimate;
    Real sum(0);
    for (int k = 0; k <= last_level_of_a_share && !share.converged; ++k) {
        share.nodes += add_level(sum, k);
        share.value = sum * quadrature::TanhSinhNodes<Real>::step(k);
        share.ln_error = estimate.next(share.value);
        share.converged =
            k > 3 && share.ln_error <= ln_tolerance_ + quadrature::ln_size(share.value);
    }
    return share;
}

const BatchPowerLaw::Nodes& BatchPowerLaw::power_level(int level) {
    auto& nodes = power_levels_[level];
    if (nodes.from.empty()) {
        const Real least = pow(Real(10), -static_cast<int>(working_digits()) - 2);
        const auto table = quadrature::tanh_sinh_nodes<Real>();
        for (const auto& node : table->level(level)) {
            if (node.near < least) {
                break;
            }
            nodes.from.push_back(node.near * (1 + node.far));
            nodes.weight.push_back(node.weight);
            if (node.t != 0) {
                nodes.from.push_back(node.far * (1 + node.near));
                nodes.weight.push_back(node.weight);
            }
        }
    }
    return nodes;
}

BatchPowerLaw::Share BatchPowerLaw::powers_by_levels() {
    Share share = by_levels([&](Real& sum, int k) {
        const Nodes& nodes = power_level(k);
        add_powers(sum, nodes);
        return nodes.from.size();
    });
    share.value *= root_;
    share.ln_error += quadrature::ln_size(root_);
    return share;
}

const BatchPowerLaw::Nodes& BatchPowerLaw::edge_level(int level) {
    auto& nodes = edge_levels_[level];
    if (nodes.from.empty()) {
        // The weight is normalised by B(b + 1, n/2 + 1), its integral (DLMF 5.12.1).
        const Ball b(b_, precision_of(b_) + 32);
        const Ball r = Ball(n_, b.bits()) / 2;
        Real norm;
        set_middle(norm, gamma(b + r + 2) / (gamma(b + 1) * gamma(r + 1)));
        const Real half_n = n_ / 2;
        const auto table = quadrature::tanh_sinh_nodes<Real>();
        for (const auto& node : table->level(level)) {
            const auto add = [&](const Real& t, const Real& rest) {
                nodes.from.push_back(rest);
                nodes.weight.push_back(node.weight * norm * weight_at(t, rest, b_, half_n));
            };
            add(node.far, node.near);
            if (node.t != 0) {
                add(node.near, node.far);
            }
        }
    }
    return nodes;
}

BatchPowerLaw::Share BatchPowerLaw::edge_by_levels() {
    mpfr_div(raw(gap_), raw(square_), raw(y_), MPFR_RNDN);
    Share share = by_levels([&](Real& sum, int k) {
        const Nodes& nodes = edge_level(k);
        sums_.add_quotients(sum, nodes.weight, nodes.from, gap_);
        return nodes.from.size();
    });
    share.ln_error += quadrature::ln_size(root_);
    close_edge(share);
    return share;
}

/// Integrates s^(m+1)/sqrt(s^2 - q^2) over s = exp(-L (1 - r)), L = ln(1/q).
BatchPowerLaw::Share BatchPowerLaw::far_by_levels() {
    const long bits = precision_of(m_) + 16;
    const Ball length = -log(Ball(q_, bits));
    const Ball m(m_, bits);
    const Real least = pow(Real(10), -2 * static_cast<int>(working_digits()) - 4);
    const auto f = [&](const Real& lo, const Real& hi) {
        // s/q - 1, and s^m/sqrt(1 - (q/s)^2).
        const Ball beyond = expm1(length * Ball(lo, bits));
        const Ball scaled = exp(-(m * length * Ball(hi, bits)));
        set_middle(above_, scaled * (beyond + 1) / sqrt(beyond * (beyond + 2)));
        return above_;
    };
    const auto table = quadrature::tanh_sinh_nodes<Real>();
    Share share = by_levels([&](Real& sum, int k) {
        std::size_t count = 0;
        for (const auto& node : table->level(k)) {
            if (node.near < least) {
                break;
            }
            sum += f(node.near, node.far) * node.weight;
            ++count;
            if (node.t != 0) {
                sum += f(node.far, node.near) * node.weight;
                ++count;
            }
        }
        return count;
    });
    set_middle(above_, length);
    share.value *= above_;
    share.ln_error += quadrature::ln_size(above_);
    return share;
}

} // namespace edgeproof::contact
