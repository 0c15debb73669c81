// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scene/axisymmetric/abel_quadrature.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgeproof::validation {
namespace {

long bits_now() { return mpfr_get_prec(Real().backend().data()); }

/// The nodes that leave an error of 10^-digits of an integrand that is analytic in the ellipse
/// `rho`: it decreases as rho^(-2n) (`trefethen2013`, theorem 19.3).
std::size_t nodes_for(unsigned digits, double rho) {
    return static_cast<std::size_t>(digits * 1.1513 / std::log(rho)) + 4; // ln(10)/2
}
// The ellipses with the foci 0 and 1 through sqrt(2), and through i.
constexpr double rho_of_slope = 3.36;
constexpr double rho_of_width = 4.61;

constexpr double rho_of_part = 31.9; // through 16 i, the foci are -1 and 1
constexpr int parts_of_octave = 8;

/// The polynomial, in powers of t, that interpolates f at n Chebyshev points of -1 < t < 1.
template <class F> std::vector<Real> interpolate(std::size_t n, const F& f) {
    std::vector<Real> t;
    std::vector<Real> c; // Newton's divided differences (DLMF 3.3(iv))
    for (std::size_t j = 0; j < n; ++j) {
        t.push_back(cos(Real(pi<Real>() * (2 * j + 1) / (2 * n))));
        c.push_back(f(t.back()));
    }
    for (std::size_t order = 1; order < n; ++order) {
        for (std::size_t j = n; j-- > order;) {
            c[j] = (c[j] - c[j - 1]) / (t[j] - t[j - order]);
        }
    }
    std::vector<Real> powers(n, Real(0));
    for (std::size_t j = n; j-- > 0;) {
        for (std::size_t k = n - 1; k > 0; --k) {
            powers[k] = powers[k - 1] - powers[k] * t[j];
        }
        powers[0] = c[j] - powers[0] * t[j];
    }
    return powers;
}

/// The integral of f over from < x < from + width.
template <class F>
Real integral_by(const quadrature::GaussLegendreRule& rule, const Real& from, const Real& width,
                 const F& f) {
    Real sum = 0;
    for (std::size_t i = 0; i < rule.x.size(); ++i) {
        const Real near = rule.from_end[i] / 2;
        sum += rule.weight[i] * f(Real(from + width * near));
        if (rule.x[i] != 0) {
            sum += rule.weight[i] * f(Real(from + width * (1 - near)));
        }
    }
    return sum * width / 2;
}

/// The integral of sin^m over a quarter of the circle.
Real sine_power(const Real& m) {
    const Real quarter = pi<Real>() / 2;
    return quarter * quadrature::tanh_sinh<Real>([&](const Real& lo, const Real&) {
                         return Real(pow(sin(Real(quarter * lo)), m));
                     }).value;
}

bool is_curved(const scene::Scene& scene) {
    return !scene.round->law && !scene.round->profile.piecewise_linear();
}

/// A number of a scene at the working precision of the thread.
Real number(const formula::Exact& x) { return x.to<Real>(); }

} // namespace

AbelQuadrature::AbelQuadrature(const scene::Scene& scene, Real a, unsigned digits)
    : slope_(scene.round->profile), a_(std::move(a)), modulus_(number(scene.contact_modulus)),
      first_piece_(slope_.origin() + 1),
      inner_(quadrature::gauss_legendre_rule(
          nodes_for(digits, rho_of_slope) * (is_curved(scene) ? 2 : 1), bits_now())),
      outer_(quadrature::gauss_legendre_rule(
          nodes_for(digits, rho_of_width) * (is_curved(scene) ? 2 : 1), bits_now())),
      table_nodes_(2 * nodes_for(digits, rho_of_part) * (is_curved(scene) ? 2 : 1)) {
    if (scene.round->law) {
        const auto& parameters = scene.round->profile.parameters();
        power_ = number(parameters.at("m"));
        factor_ = number(parameters.at("C"));
        kappa_ = factor_ * sine_power(*power_);
    }
    knots_.emplace_back(0);
    jump_at_.emplace_back(0); // a jump on the axis has no term of its own
    for (std::size_t i = slope_.origin() + 1; i < slope_.knots().size() && !power_; ++i) {
        knots_.push_back(slope_.knots()[i]);
        jump_at_.push_back(slope_.jump(i) * knots_.back());
    }
}

/// The integral of f(piece, r)/sqrt(s^2 - r^2) over 0 < r < s; `beyond` are the positive s - v.
template <class F>
Real AbelQuadrature::over_slope(const std::vector<Real>& beyond, const Real& s, const F& f) const {
    Real sum = 0;
    for (std::size_t i = 0; i < beyond.size(); ++i) {
        const Real from = i + 1 < beyond.size() ? Real(sqrt(beyond[i + 1])) : Real(0);
        sum += integral_by(inner_, from, Real(sqrt(beyond[i]) - from), [&](const Real& y) {
            const Real y2 = y * y;
            return Real(2 * f(first_piece_ + i, Real(s - y2)) / sqrt(Real(2 * s - y2)));
        });
    }
    return sum;
}

Real AbelQuadrature::h_rate_by_integrals(const Real& A, const Real& w2, std::size_t except) const {
    const Real s = sqrt(Real(A * A + w2));
    std::vector<Real> beyond;
    Real sum = 0;
    for (std::size_t i = 0; i < knots_.size() && knots_[i] <= A; ++i) {
        const Real apart = (A - knots_[i]) * (A + knots_[i]) + w2; // s^2 - v^2
        beyond.push_back(apart / (s + knots_[i]));
        if (jump_at_[i] != 0 && i < except) {
            sum += jump_at_[i] / sqrt(apart);
        }
    }
    return sum + over_slope(beyond, s, [&](std::size_t piece, const Real& r) {
               return slope_.pieces()[piece].linear
                          ? Real(slope_.pieces()[piece].at_origin +
                                 2 * slope_.pieces()[piece].rate * r)
                          : Real(slope_.value(piece, r) + r * slope_.rate(piece, r));
           });
}

Real AbelQuadrature::h_rate(const Real& A, const Real& w2) const {
    if (power_) {
        return (*power_ + 1) * kappa_ * pow(sqrt(Real(A * A + w2)), *power_);
    }
    if (tables_.empty()) {
        return h_rate_by_integrals(A, w2, knots_.size());
    }
    std::size_t i = 0;
    while (i + 1 < tables_.size() && knots_[i + 1] <= A) {
        ++i;
    }
    const RateTable& table = tables_[i];
    const Real y = sqrt(Real((A - knots_[i]) * (A + knots_[i]) + w2));
    Real part = y / table.end; // in the octave, from 1/2 to 1
    int octave = 0;
    while (octave < table.octaves && part < Real(0.5)) {
        part *= 2;
        ++octave;
    }
    part = (octave < table.octaves ? Real(2 * part - 1) : part) * parts_of_octave;
    const int which =
        std::clamp(static_cast<int>(part.convert_to<double>()), 0, parts_of_octave - 1);
    const Real t = 2 * (part - which) - 1;
    Real sum = 0;
    const auto& powers = table.parts[static_cast<std::size_t>(octave * parts_of_octave + which)];
    for (auto c = powers.rbegin(); c != powers.rend(); ++c) {
        sum *= t;
        sum += *c;
    }
    return jump_at_[i] != 0 ? Real(sum + jump_at_[i] / y) : sum;
}

/// The distance of the singularities of h' and of the kernel, in w = sqrt(s^2 - A^2), at most the
/// width of the range.
Real AbelQuadrature::nearest_singularity(const Real& A, const Real& from_r2,
                                         const Real& width2) const {
    Real nearest = width2;
    const auto meet = [&](const Real& apart) {
        if (apart > 0 && apart < nearest) {
            nearest = apart;
        }
    };
    meet(A * A);
    meet(from_r2);
    for (std::size_t i = 0; i < knots_.size() && knots_[i] < A; ++i) {
        meet((A - knots_[i]) * (A + knots_[i]));
    }
    return sqrt(nearest);
}

void AbelQuadrature::tabulate() {
    std::vector<RateTable> rate_tables;
    for (std::size_t i = 0; !power_ && i < knots_.size() && knots_[i] < a_; ++i) {
        const Real& v = knots_[i];
        const Real& to = i + 1 < knots_.size() && knots_[i + 1] < a_ ? knots_[i + 1] : a_;
        const Real end2 = (to - v) * (to + v);
        const Real nearest = nearest_singularity(v, Real(0), end2);
        RateTable table{sqrt(end2), 0, {}};
        Real width = table.end;
        const auto add = [&](const Real& from, const Real& range) {
            for (int k = 0; k < parts_of_octave; ++k) {
                const Real half = range / (2 * parts_of_octave);
                table.parts.push_back(interpolate(table_nodes_, [&](const Real& t) {
                    const Real y = from + half * (2 * k + 1 + t);
                    return h_rate_by_integrals(v, Real(y * y), i);
                }));
            }
        };
        for (; width > nearest; width /= 2, ++table.octaves) {
            add(Real(width / 2), Real(width / 2));
        }
        add(Real(0), width);
        rate_tables.push_back(std::move(table));
    }
    tables_ = std::move(rate_tables);
}

/// The integral of h'(s)/sqrt(s^2 - r^2) over A < s < sqrt(A^2 + width2), r <= A.
Real AbelQuadrature::over_width(const Real& A, const Real& width2, const Real& r) const {
    const Real from_r = A == r ? Real(0) : Real((A - r) * (A + r));
    const Real nearest = nearest_singularity(A, from_r, width2);
    const auto integrand = [&](const Real& w) {
        const Real w2 = w * w;
        const Real rate = h_rate(A, w2);
        const Real s2 = A * A + w2;
        return Real(A == r ? rate / sqrt(s2) : rate * w / sqrt(Real(s2 * (w2 + from_r))));
    };
    Real sum = 0;
    Real width = sqrt(width2);
    for (; width > nearest; width /= 2) {
        sum += integral_by(outer_, Real(width / 2), Real(width / 2), integrand);
    }
    return sum + integral_by(outer_, Real(0), width, integrand);
}

Real AbelQuadrature::approach() const {
    if (power_) {
        return kappa_ * pow(a_, Real(*power_ + 1));
    }
    std::vector<Real> beyond;
    for (std::size_t i = 0; i < knots_.size() && knots_[i] < a_; ++i) {
        beyond.push_back(a_ - knots_[i]);
    }
    return a_ * over_slope(beyond, a_, [&](std::size_t piece, const Real& r) {
               return slope_.value(piece, r);
           });
}

Real AbelQuadrature::force() const {
    if (power_) {
        return 2 * modulus_ * factor_ * pow(a_, Real(*power_ + 2)) * sine_power(*power_ + 2);
    }
    std::vector<Real> beyond;
    for (std::size_t i = 0; i < knots_.size() && knots_[i] < a_; ++i) {
        beyond.push_back(a_ - knots_[i]);
    }
    return 2 * modulus_ * over_slope(beyond, a_, [&](std::size_t piece, const Real& r) {
               return Real(slope_.value(piece, r) * r * r);
           });
}

Real AbelQuadrature::pressure(const Real& u) const {
    Real r = abs(Real(a_ - u));
    if (power_ && r == 0) {
        throw DomainError("a power law is not integrated on the axis");
    }
    const Real same = ldexp(a_, static_cast<int>(8 - bits_now()));
    for (const Real& v : knots_) {
        r = abs(Real(r - v)) < same ? v : r;
    }
    std::vector<Real> ends{r};
    for (const Real& v : knots_) {
        if (v > r && v < a_) {
            ends.push_back(v);
        }
    }
    Real sum = 0;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const bool last = i + 1 == ends.size();
        const Real width2 = last && i == 0 ? Real(u * (2 * a_ - u))
                            : last         ? Real((a_ - ends[i]) * (a_ + ends[i]))
                                   : Real((ends[i + 1] - ends[i]) * (ends[i + 1] + ends[i]));
        sum += over_width(ends[i], width2, r);
    }
    return modulus_ / pi<Real>() * sum;
}

namespace {

/// The step of the divided differences is this many decades below the radius of convergence.
constexpr unsigned step_decades = 12;
/// Additional digits for a coefficient far below its natural size.
constexpr unsigned digits_cancelled = 25;

} // namespace

unsigned difference_digits(std::size_t n, unsigned digits) {
    return digits + digits_cancelled + step_decades * static_cast<unsigned>(n) + 40;
}

Real coefficient_by_differences(std::size_t n, unsigned digits, const Real& radius,
                                const std::function<Real(const Real& u)>& pressure) {
    const auto k = static_cast<unsigned>(n);
    const unsigned count = k + (digits + digits_cancelled + 15) / (step_decades - 1) + 2;
    const PrecisionScope scope(difference_digits(n, digits) + 60);
    const Real delta = radius * pow(Real(10), -static_cast<int>(step_decades));
    std::vector<Real> f;
    for (unsigned j = 1; j <= count; ++j) {
        const Real u = delta * j;
        f.push_back(pressure(u) / sqrt(u));
    }
    for (unsigned order = 1; order < count; ++order) {
        for (unsigned j = count; j-- > order;) {
            f[j] = (f[j] - f[j - 1]) / order;
        }
    }
    std::vector<Real> polynomial{f[count - 1]}; // in t = u/delta, by Horner at t = j
    for (unsigned j = count - 1; j-- > 0;) {
        polynomial.insert(polynomial.begin(), Real(0));
        for (std::size_t i = 0; i + 1 < polynomial.size(); ++i) {
            polynomial[i] -= polynomial[i + 1] * (j + 1);
        }
        polynomial[0] += f[j];
    }
    return polynomial[n] / pow(delta, static_cast<int>(n));
}

} // namespace edgeproof::validation
