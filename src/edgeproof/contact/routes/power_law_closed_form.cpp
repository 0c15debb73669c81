// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/law/linear_measure.hpp"
#include "edgeproof/contact/routes/pressure_routes.hpp"
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/quadrature/near_singularity.hpp"

#include <algorithm>
#include <cmath>

namespace edgeproof::contact {
namespace {

/// If Gauss's series would lose more digits than this, the quadrature is cheaper.
constexpr double most_cancelled_digits = 300;
constexpr double digits_of_e = 0.4343; // log10 e
constexpr double most_m = 1e12;

mpfr_ptr data_of(Real& x) { return x.backend().data(); }
mpfr_srcptr data_of(const Real& x) { return x.backend().data(); }

/// True if x is less than 2^-bits times the roundoff of `sum`, at the precision of `sum`.
bool below_roundoff(const Real& x, const Real& sum, long bits) {
    return mpfr_zero_p(data_of(x)) != 0 ||
           (mpfr_regular_p(data_of(sum)) != 0 &&
            mpfr_get_exp(data_of(x)) + bits + mpfr_get_prec(data_of(sum)) <
                mpfr_get_exp(data_of(sum)));
}

} // namespace

PowerLawIntegralInReal::PowerLawIntegralInReal(const Exact& m, unsigned target_digits)
    : m_(m.to<Real>()), about_m_(static_cast<double>(m_)), target_digits_(target_digits) {
    if (!(m_ > 0)) {
        throw DomainError("the exponent of a power law in closed form is not positive");
    }
    if (about_m_ > most_m) {
        throw BudgetError("the closed form of a power law is not evaluated for m beyond 1e12");
    }
    const PrecisionScope scope(working_digits() + digits_of_m());
    m_ = m.to<Real>();
    constexpr long largest = 1L << 20;
    if (m.is_rational() && numerator(m.rational()) < largest &&
        denominator(m.rational()) < largest) {
        words_ = Words{numerator(m.rational()).convert_to<long>(),
                       denominator(m.rational()).convert_to<long>()};
    }
}

unsigned PowerLawIntegralInReal::digits_of_m() const {
    return about_m_ > 1 ? static_cast<unsigned>(std::log10(about_m_)) + 2 : 1;
}
/// Divides x by m - k, k an integer.
void PowerLawIntegralInReal::over_m_less(Real& x, long k) const {
    if (words_) {
        x *= words_->under;
        x /= words_->over - k * words_->under;
    } else {
        x /= Real(m_ - k);
    }
}
/// Multiplies x by k - m, k an integer.
void PowerLawIntegralInReal::times_less_m(Real& x, long k) const {
    if (words_) {
        x *= k * words_->under - words_->over;
        x /= words_->under;
    } else {
        x *= Real(k - m_);
    }
}

PowerLawIntegralInReal::Value PowerLawIntegralInReal::near_edge(const Real& y) const {
    // The sizes of the series' terms add up to at most (1 + y)^((m-1)/2), and the sum is about
    // 1/(m y) if that is small.
    const double m = about_m_;
    const auto share = static_cast<double>(y);
    const double cancelled =
        m > 1 ? (m - 1) / 2 * std::log1p(share) * digits_of_e + std::log10(1 + m * share) : 0;
    return cancelled > most_cancelled_digits ? by_euler(y)
                                             : by_gauss(y, static_cast<unsigned>(cancelled) + 1);
}

/// Gauss's series (DLMF 15.2.1) with additional digits for the cancellation.
PowerLawIntegralInReal::Value PowerLawIntegralInReal::by_gauss(const Real& y,
                                                               unsigned more_digits) const {
    const PrecisionScope scope(working_digits() + more_digits);
    const Real ratio = at_working_precision(y);
    const auto share = static_cast<double>(y);
    // Where the terms fall, each is at most 3/4 of the one before.
    constexpr long bits_of_the_rest = 3;
    Real term(1);
    Real sum(1);
    for (unsigned k = 0;; ++k) {
        // The ratio of terms is y ((1 - m)/2 + k)/(3/2 + k). For odd m the series ends.
        term *= ratio;
        times_less_m(term, 2L * k + 1);
        term /= 2 * k + 3;
        sum += term;
        const bool falls = (about_m_ - 1 - 2.0 * k) * share < k + 1.5; // to a half or less
        if (falls && below_roundoff(term, sum, bits_of_the_rest)) {
            break;
        }
        if (k % 1024 == 1023) {
            check_interruption();
        }
    }
    return {Real(sqrt(ratio) * sum), Real(0)};
}

/// Euler's integral (DLMF 15.6.1).
PowerLawIntegralInReal::Value PowerLawIntegralInReal::by_euler(const Real& y) const {
    // q^2 + y t^2 = 1 - y d (2 - d) with d = 1 - t; its power (m - 1)/2 as an exponential.
    const PrecisionScope scope(working_digits() + digits_of_m());
    const Real half = (at_working_precision(m_) - 1) / 2;
    const Real share = at_working_precision(y);
    // Where (1 - y d)^half <= exp(-half y d) = 10^-digits, the integrand is negligible.
    const Real far = Real(working_digits() + 2) / Real(digits_of_e) / (half * share);
    const Real length = far < 1 ? far : Real(1);
    const auto result = quadrature::integrate_one_sided<Real>(
        [&](const Real& d, const Real&) {
            return Real(exp(half * log1p(Real(-share * d * (2 - d)))));
        },
        length, Real(0), true, {.target_digits = target_digits_});
    return {Real(sqrt(share) * result.value), result.estimate, result.evaluations,
            result.converged};
}

PowerLawIntegralInReal::Value PowerLawIntegralInReal::operator()(const Real& q, const Real& y) {
    if (q == 0) {
        return {Real(1 / m_), Real(0)};
    }
    if (2 * y <= 1) {
        return near_edge(y);
    }
    const PrecisionScope scope(working_digits() + digits_of_m()); // for the digits that h^m loses
    // q/h = 2^(-halvings/2): h = 2q needs fewer terms, but for q >= 1/2 only h = sqrt(2) q is below
    // 1.
    const long halvings = 2 * q < 1 ? 2 : 1;
    auto& at_cut = at_cut_[static_cast<std::size_t>(halvings - 1)];
    if (!at_cut) {
        at_cut = near_edge(Real(1 - ldexp(Real(1), static_cast<int>(-halvings))));
    }
    const Real square = at_working_precision(q) * at_working_precision(q);
    const Real log_h = log(ldexp(square, static_cast<int>(halvings))) / 2;
    const auto about_log = static_cast<double>(log_h);
    const long bits_of_log = std::max(0L, static_cast<long>(mpfr_get_exp(data_of(log_h))));
    const Real power = exp(Real(m_ * log_h)); // h^m
    Real above(1);                            // beta_k q^(2k)
    Real below(power);                        // beta_k h^m (q/h)^(2k)
    Real sum(0);
    Real term;
    for (unsigned k = 0;; ++k) {
        const double left = about_m_ - 2.0 * k;
        if (std::abs(left * about_log) < 0.5) {
            // Both terms are nearly equal: their difference by expm1.
            const Real n = m_ - 2 * k;
            sum += n == 0 ? Real(-above * log_h) : Real(-above * expm1(Real(n * log_h)) / n);
        } else {
            mpfr_sub(data_of(term), data_of(above), data_of(below), MPFR_RNDN);
            over_m_less(term, 2L * k);
            sum += term;
        }
        // |(1 - h^n)/n| is at most |log h|.
        if (below_roundoff(above, sum, bits_of_log + 3) &&
            below_roundoff(below, sum, bits_of_log + 3)) {
            break;
        }
        above *= square;
        above *= 2 * k + 1;
        above /= 2 * k + 2;
        below *= 2 * k + 1;
        below /= (2 * k + 2) << static_cast<unsigned>(halvings);
    }
    Value found = *at_cut;
    found.value = power * found.value + sum;
    return found;
}

PowerLawPressure::PowerLawPressure(const Exact& m, const ContactLaw<Real>& law,
                                   const Extent<Real>& e, unsigned target_digits)
    : a_(e.a), factor_(law.force_rate(e) / pi<Real>()), integral_(m, target_digits) {}

RoutedPressure PowerLawPressure::operator()(const Point<Real>& at) {
    const auto I = integral_(Real(abs(at.x) / a_), Real(at.right * at.left / (a_ * a_)));
    return {at_working_precision(Real(factor_ * I.value)), I.estimate, I.evaluations, I.converged};
}

RoutedPressure logarithmic_closed_form(const ContactLaw<Real>& law, const Extent<Real>& e,
                                       const Point<Real>& at) {
    Marks<Real, Real> marks(e, law.slope().knots());
    return logarithmic_closed_form(law, marks, at);
}

RoutedPressure logarithmic_closed_form(const ContactLaw<Real>& law, Marks<Real, Real>& marks,
                                       const Point<Real>& at) {
    const Extent<Real>& e = marks.extent();
    const SlopeIn<Real>& slope = law.slope();
    for (const auto& piece : slope.pieces()) {
        if (!piece.linear) {
            throw DomainError("only a piecewise linear g' has its pressure in logarithms");
        }
    }
    const Real w_x = sqrt(Real(at.right * at.left));
    const std::vector<Mark<Real>>& list = marks.all();
    struct Green {
        Real value;
        Real moment;
    };
    const Real sum = logarithmic_sum(
        slope, list.size(), Real(arc_of(slope, e, list) * w_x),
        [&](std::size_t i) {
            return !list[i].end && (slope.has_corner(i) || !(slope.rate_drop(i) == Real(0)));
        },
        [&](std::size_t i) {
            const Mark<Real>& v = list[i];
            const Real offset =
                at.right - v.right; // v - x as a difference of distances from one edge
            if (offset == Real(0)) {
                if (slope.has_corner(i)) {
                    throw DomainError("the pressure is infinite at a corner of the profile");
                }
                return Green{Real(0), Real(0)};
            }
            const Real excess = green_excess(v, at.right, at.left, w_x, offset > Real(0) ? 1 : -1);
            // MPFR's log1p; the balls of the same formula use Arb's.
            const Real G = log1p(Real(excess / (e.length() * abs(offset))));
            return Green{G, Real(offset * G)};
        });
    // docs/pressure.md, "Closed form: piecewise linear slopes"
    return {Real(law.contact_modulus() / (Real(2) * pi<Real>()) * sum), Real(0), 0, true};
}

} // namespace edgeproof::contact
