// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/fast_power_law.hpp"

#include "edgeproof/contact/fast_sums.hpp"
#include "edgeproof/precision/ball.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/quadrature/bernstein.hpp"
#include "edgeproof/quadrature/gauss_legendre.hpp"
#include "edgeproof/quadrature/level_estimate.hpp"
#include "edgeproof/quadrature/tanh_sinh_nodes.hpp"

#include <algorithm>
#include <cmath>

namespace edgeproof {
namespace {

/// From here inwards the integral over t costs less than that over w.
constexpr double apex_begins = 0.62;
/// Of tanh-sinh: from here inwards over ln s.
constexpr double far_begins = 0.05;
constexpr double ln_10 = 2.302585092994046;
constexpr std::size_t most_nodes = 20000;
constexpr int last_level = 12;

mpfr_ptr raw(Real& x) { return x.backend().data(); }
mpfr_srcptr raw(const Real& x) { return x.backend().data(); }
long precision_of(const Real& x) { return mpfr_get_prec(raw(x)); }

Real middle_of(const Ball& x) { return at_working_precision(x.midpoint()); }

Exact half_less_one(const Exact& m) {
    return Exact((m.expr() - Expr::number(1)) / Expr::number(2));
}
Exact exponent_of_integrand(const Exact& m) {
    return m.is_rational() ? Exact::of(Rational((m.rational() - 1) / 2)) : half_less_one(m);
}

} // namespace

unsigned FastPowerLaw::lost_digits(const Exact& m) {
    const double about = static_cast<double>(m.to<Real>());
    if (about > 1e9) {
        throw DomainError("a power law of this exponent has no fast route");
    }
    const double nearest = 2 * std::round(about / 2);
    const double distance = std::abs(static_cast<double>(Real(m.to<Real>() - Real(nearest))));
    return distance > 0 && distance < 1 ? static_cast<unsigned>(std::ceil(-std::log10(distance)))
                                        : 0;
}

FastPowerLaw::FastPowerLaw(const Exact& m, Real rate, Real a, unsigned digits,
                           FastPressure::Rule rule)
    : m_(m), m_real_(m.to<Real>()), m_double_(static_cast<double>(m_real_)),
      scale_(rate / pi<Real>()), a_(std::move(a)), digits_(digits), rule_(rule),
      power_(exponent_of_integrand(m)),
      steps_(static_cast<unsigned long>(static_cast<double>(floor(Real(m_real_ / 2))))),
      n_(m_real_ - 2 * Real(steps_)), n_double_(static_cast<double>(n_)) {
    if (m.is_rational()) {
        n_exact_ = m.rational() - 2 * Rational(steps_);
    }
    if (n_ != 0 && n_ != 1) {
        const long bits = precision_of(n_) + 32;
        const Ball n(n_, bits);
        apex_factor_ = middle_of(sqrt(Ball::pi(bits)) / 2 * gamma(-(n / 2)) / gamma((1 - n) / 2));
    }
}

RoutedPressure<Real> FastPowerLaw::operator()(const Point<Real>& at) {
    const Real q = at_working_precision(Real(abs(at.x) / a_));
    const Real y = at_working_precision(Real(at.right * at.left / (a_ * a_)));
    const Real root = sqrt(y);
    const double about_q = static_cast<double>(q);
    Share share;
    if (q == 0) {
        share.value = 1 / m_real_;
    } else if (rule_ == FastPressure::Rule::tanh_sinh) {
        share = about_q < far_begins ? by_tanh_sinh_far(q) : by_tanh_sinh(root, y);
    } else {
        // A polynomial of low degree is summed exactly wherever the point is.
        const bool odd = n_ == 1 && m_double_ < 40;
        share = about_q < apex_begins && !odd ? near_apex(root, q) : by_gauss(root, y, about_q);
    }
    RoutedPressure<Real> p;
    p.value = scale_ * share.value;
    p.estimate = exp(Real(std::max(share.ln_error - ln_size(share.value), -1e15)));
    p.evaluations = share.nodes;
    p.converged = share.converged;
    return p;
}

/// The fewest nodes over all ellipses, or with `n` given the least error; for the integrand over
/// -1 < w/W < 1, q^2 + y (w/W)^2 to the power e, whose integral over half of that is at least
/// 1/max(1, m).
double FastPowerLaw::gauss_nodes_needed(double q, double y, double* ln_error, std::size_t n) const {
    const double e = (m_double_ - 1) / 2;
    if (n_ == 1) {
        // Of degree 2 e: exact from here on.
        const double exact = std::ceil((2 * e + 1) / 2);
        if (ln_error != nullptr) {
            *ln_error = static_cast<double>(n) >= exact ? -1e300 : *ln_error;
        } else if (exact < 40) {
            return exact;
        }
    }
    const double ln_tolerance =
        -(static_cast<double>(digits_) + 3) * ln_10 - std::log(std::max(1.0, m_double_));
    const double highest = q / std::sqrt(y);
    double fewest = 1e300;
    for (const double part : {0.5, 0.7, 0.82, 0.9, 0.95, 0.975, 0.99}) {
        const double b = part * highest;
        const double rho = b + std::sqrt(b * b + 1);
        const double a2 = b * b + 1;
        const double ln_M = e * std::log(e < 0 ? q * q * (1 - part * part) : q * q + y * a2);
        const BernsteinEllipse ellipse{1, rho};
        if (ln_error != nullptr) {
            *ln_error = std::min(*ln_error, gauss_legendre_log_error(ellipse, ln_M, n));
        } else {
            fewest = std::min(fewest, gauss_legendre_nodes_needed(ellipse, ln_M, ln_tolerance));
        }
    }
    return fewest;
}

FastPowerLaw::Share FastPowerLaw::by_gauss(const Real& root, const Real& y, double q) {
    // The sum over half of an even integrand: half of the rule's nodes.
    const double about_y = static_cast<double>(y);
    const double needed = gauss_nodes_needed(q, about_y, nullptr, 0) / 2;
    if (!(needed < most_nodes)) {
        throw BudgetError("a power law asks for too many nodes here");
    }
    const std::size_t n = rounded_up_nodes(needed);
    Real sum(0);
    add_powers(sum, gauss(n), y);
    double ln_error = 1e300;
    (void)gauss_nodes_needed(q, about_y, &ln_error, 2 * n);
    Share share;
    share.value = root * sum;
    share.ln_error = ln_error + ln_size(root);
    share.nodes = n;
    return share;
}

void FastPowerLaw::add_powers(Real& sum, const MiddleNodes& nodes, const Real& y) {
    for (std::size_t k = 0; k < nodes.c.size(); ++k) {
        mpfr_mul(raw(below_), raw(nodes.c[k]), raw(y), MPFR_RNDN);
        mpfr_ui_sub(raw(below_), 1, raw(below_), MPFR_RNDN);
        power_(above_, below_);
        mpfr_mul(raw(above_), raw(above_), raw(nodes.weight[k]), MPFR_RNDN);
        mpfr_add(raw(sum), raw(sum), raw(above_), MPFR_RNDN);
    }
}

const FastPowerLaw::MiddleNodes& FastPowerLaw::gauss(std::size_t n) {
    auto& nodes = gauss_[n];
    if (nodes.c.empty()) {
        const auto rule = gauss_legendre_rule(2 * n, precision_of(below_));
        for (std::size_t k = 0; k < rule->x.size(); ++k) {
            nodes.c.push_back(rule->from_end[k] * (1 + rule->x[k]));
            nodes.weight.push_back(rule->weight[k]);
        }
    }
    return nodes;
}

const FastPowerLaw::MiddleNodes& FastPowerLaw::level(int level) {
    auto& nodes = levels_[level];
    if (nodes.c.empty()) {
        const Real least = pow(Real(10), -static_cast<int>(working_digits()) - 2);
        for (const auto& node : tanh_sinh_nodes<Real>().level(level)) {
            if (node.near < least) {
                break;
            }
            nodes.c.push_back(node.near * (1 + node.far));
            nodes.weight.push_back(node.weight);
            if (node.t != 0) {
                nodes.c.push_back(node.far * (1 + node.near));
                nodes.weight.push_back(node.weight);
            }
        }
    }
    return nodes;
}

FastPowerLaw::Share FastPowerLaw::by_tanh_sinh(const Real& root, const Real& y) {
    Share share;
    share.converged = false;
    const double ln_tolerance = -(static_cast<double>(digits_) + 3) * ln_10;
    LevelEstimate estimate;
    Real sum(0);
    for (int k = 0; k <= last_level && !share.converged; ++k) {
        const MiddleNodes& nodes = level(k);
        add_powers(sum, nodes, y);
        share.nodes += nodes.c.size();
        share.value = sum * TanhSinhNodes<Real>::step(k);
        share.ln_error = estimate.next(share.value);
        share.converged = k > 3 && share.ln_error <= ln_tolerance + ln_size(share.value);
    }
    share.value *= root;
    share.ln_error += ln_size(root);
    return share;
}

/// Over s = exp(-L (1 - r)), L = ln(1/q): of s^(m+1)/sqrt(s^2 - q^2).
FastPowerLaw::Share FastPowerLaw::by_tanh_sinh_far(const Real& q) {
    Share share;
    share.converged = false;
    const double ln_tolerance = -(static_cast<double>(digits_) + 3) * ln_10;
    const long bits = precision_of(n_) + 16;
    const Ball length = -log(Ball(q, bits));
    const Ball m(m_real_, bits);
    LevelEstimate estimate;
    Real sum(0);
    const auto add = [&](const Real& lo, const Real& hi, const Real& weight) {
        // s/q - 1, and s^m/sqrt(1 - (q/s)^2).
        const Ball beyond = expm1(length * Ball(lo, bits));
        const Ball scaled = exp(-(m * length * Ball(hi, bits)));
        const Ball f = scaled * (beyond + 1) / sqrt(beyond * (beyond + 2));
        arf_get_mpfr(raw(above_), arb_midref(f.data()), MPFR_RNDN);
        mpfr_mul(raw(above_), raw(above_), raw(weight), MPFR_RNDN);
        mpfr_add(raw(sum), raw(sum), raw(above_), MPFR_RNDN);
        ++share.nodes;
    };
    const Real least = pow(Real(10), -2 * static_cast<int>(working_digits()) - 4);
    for (int k = 0; k <= last_level && !share.converged; ++k) {
        for (const auto& node : tanh_sinh_nodes<Real>().level(k)) {
            if (node.near < least) {
                break;
            }
            add(node.near, node.far, node.weight);
            if (node.t != 0) {
                add(node.far, node.near, node.weight);
            }
        }
        share.value = sum * TanhSinhNodes<Real>::step(k);
        share.ln_error = estimate.next(share.value);
        share.converged = k > 3 && share.ln_error <= ln_tolerance + ln_size(share.value);
    }
    const Real factor = middle_of(length);
    share.value *= factor;
    share.ln_error += ln_size(factor);
    return share;
}

FastPowerLaw::Share FastPowerLaw::near_apex(const Real& root, const Real& q) {
    const Real square = q * q;
    if (steps_ == 0) {
        return base_near_apex(root, q, square);
    }
    Share share;
    Real factor(1);
    Real exponent = m_real_;
    const double ln_least = -(static_cast<double>(digits_) + 8) * ln_10;
    share.value = 0;
    for (unsigned long k = 0; k < steps_; ++k) {
        const Real term = factor * root / exponent;
        share.value += term;
        factor *= (exponent - 1) / exponent * square;
        exponent -= 2;
        // 0 <= I_n <= root/n for n >= 1; and m of these terms are left.
        if (factor == 0) {
            return share;
        }
        if (ln_size(factor) < ln_least + ln_size(share.value) && k + 1 < steps_) {
            share.ln_error = ln_size(Real(factor * root));
            return share;
        }
    }
    const Share base = base_near_apex(root, q, square);
    share.value += factor * base.value;
    share.ln_error = base.ln_error + ln_size(factor);
    share.nodes = base.nodes;
    return share;
}

FastPowerLaw::Share FastPowerLaw::base_near_apex(const Real& root, const Real& q,
                                                 const Real& square) {
    Share share;
    if (n_ == 1) {
        share.value = root;
        return share;
    }
    const long bits = precision_of(n_) + 16;
    if (n_ == 0) {
        share.value = middle_of(asinh(Ball(root, bits) / Ball(q, bits)));
        return share;
    }
    share.value = 1 / n_;
    // The integrand over 0 < t < 1 is at most q^2/|r| where 1 - q^2 t stays off zero.
    const double about = static_cast<double>(square);
    const double end = 2 / std::max(about, 1e-290) - 1;
    double fewest = 1e300;
    BernsteinEllipse best{1, 2};
    double best_ln_M = 0;
    const double ln_tolerance = -(static_cast<double>(digits_) + 3) * ln_10;
    for (const double part : {0.5, 0.8, 0.92, 0.97}) {
        const BernsteinEllipse ellipse = BernsteinEllipse::beyond(1, part * (end - 1));
        const double ln_M = ln_size(square) - std::log((1 - part) * (1 - about)) / 2;
        const double needed =
            1 + (std::log(4 / (1 - n_double_ / 2)) + ln_M - ln_tolerance) / std::log(ellipse.rho);
        if (needed < fewest) {
            fewest = needed;
            best = ellipse;
            best_ln_M = ln_M;
        }
    }
    const std::size_t n = rounded_up_nodes(fewest);
    const ApexNodes& nodes = apex(n);
    Real sum(0);
    Real r;
    for (std::size_t k = 0; k < n; ++k) {
        mpfr_mul(raw(below_), raw(nodes.t[k]), raw(square), MPFR_RNDN);
        mpfr_ui_sub(raw(below_), 1, raw(below_), MPFR_RNDN);
        mpfr_sqrt(raw(r), raw(below_), MPFR_RNDN);
        mpfr_add(raw(below_), raw(below_), raw(r), MPFR_RNDN);
        mpfr_div(raw(above_), raw(nodes.weight[k]), raw(below_), MPFR_RNDN);
        mpfr_add(raw(sum), raw(sum), raw(above_), MPFR_RNDN);
    }
    share.value -= square * sum / 2;
    const long far = 64;
    const Ball power = exp(Ball(n_, bits + far) * log(Ball(q, bits + far)));
    share.value += apex_factor_ * middle_of(power);
    share.nodes = n;
    // What the best polynomial of degree n - 1 leaves (Trefethen, theorem 8.2), integrated and
    // summed.
    share.ln_error = std::log(2 / (best.rho - 1)) + best_ln_M + nodes.ln_size -
                     (static_cast<double>(n) - 1) * std::log(best.rho);
    return share;
}

const FastPowerLaw::ApexNodes& FastPowerLaw::apex(std::size_t n) {
    auto& nodes = apex_[n];
    if (!nodes.t.empty()) {
        return nodes;
    }
    const unsigned digits = working_digits();
    const PrecisionScope scope(digits + 12);
    const auto rule = gauss_legendre_rule(n, precision_of(n_) + 64);
    // Of P_k over t^(-n/2): a product, by Rodrigues' formula.
    const Real alpha = -n_ / 2;
    std::vector<Real> moments{Real(1 / (alpha + 1))};
    for (std::size_t k = 1; k < n; ++k) {
        const auto j = static_cast<long>(k);
        moments.push_back(moments.back() * (alpha - j + 1) / (alpha + j + 1));
    }
    Real size(0);
    const auto add = [&](const Real& x, const Real& t, const Real& weight) {
        Real before(1);
        Real now = x;
        Real sum = moments[0];
        for (std::size_t k = 1; k < n; ++k) {
            const auto j = static_cast<long>(k);
            sum += (2 * j + 1) * moments[k] * now;
            Real next = ((2 * j + 1) * x * now - j * before) / (j + 1);
            before = std::move(now);
            now = std::move(next);
        }
        const Real w = weight / 2 * sum;
        size += abs(w);
        const PrecisionScope back(digits);
        nodes.t.push_back(at_working_precision(t));
        nodes.weight.push_back(at_working_precision(w));
    };
    for (std::size_t k = 0; k < rule->x.size(); ++k) {
        const Real& x = rule->x[k];
        add(x, Real((1 + x) / 2), rule->weight[k]);
        if (x != 0) {
            add(Real(-x), Real(rule->from_end[k] / 2), rule->weight[k]);
        }
    }
    nodes.ln_size = ln_size(Real(size + moments[0]));
    return nodes;
}

} // namespace edgeproof
