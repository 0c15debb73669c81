// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/validation/stress_formula.hpp"

#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"
#include "edgeproof/series/truncated.hpp"
#include "lab/validation/plain_tanh_sinh.hpp"
#include "lab/validation/textbook_formula.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace edgeproof::validation {
namespace {

using scene::Quantity;

/// The integrand of a stress, without -2/pi, for the pressure p at the distance d = x - s:
/// johnson1985, eqs. (2.23) without traction.
template <Arithmetic T> T stress_kernel(Quantity quantity, const T& p, const T& d, const T& z) {
    const T r2 = d * d + z * z;
    const T scaled = p * z / (r2 * r2);
    return quantity == Quantity::sxx   ? T(scaled * d * d)
           : quantity == Quantity::szz ? T(scaled * z * z)
                                       : T(scaled * z * d);
}

/// The places in -b < x < a at which the integrals are divided, and both edges, in order.
template <Arithmetic T>
std::vector<T> divisions(const scene::Scene& scene, const T& a, const T& b, const T& x) {
    std::vector<T> all{T(-b), a, x};
    for (const formula::Exact& knot : scene.profile->knots()) {
        all.push_back(knot.template to<T>());
    }
    if (scene.profile->kind() == contact::Profile::Kind::power_law) {
        all.push_back(T(0));
    }
    std::erase_if(all, [&](const T& s) { return s < -b || s > a; });
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

} // namespace

template <Arithmetic T>
T textbook_stress(const scene::Scene& scene, const scene::AskedValue& asked) {
    using std::abs;
    using std::sqrt;
    const TextbookFormula<T> contact(scene);
    const T& a = contact.a();
    const T x = asked.in_body->x.template to<T>();
    const T z = asked.in_body->z.template to<T>();
    const auto& parameters = scene.profile->parameters();
    if (scene.profile->kind() == contact::Profile::Kind::power_law &&
        parameters.at("m").template to<T>() == T(1)) {
        // The stresses below a Hertzian contact: johnson1985, eqs. (4.49) and (4.50).
        const T sum = a * a - x * x + z * z;
        const T root = sqrt(T(sum * sum + T(4) * x * x * z * z));
        const T m = sqrt(T((root + sum) / T(2)));
        const T size_of_n = sqrt(T((root - sum) / T(2)));
        const T n = x < T(0) ? T(-size_of_n) : size_of_n;
        const T quotient = (z * z + n * n) / (m * m + n * n);
        const T scale = -contact.pressure(T(0)) / a;
        return asked.quantity == Quantity::sxx   ? T(scale * (m * (T(1) + quotient) - T(2) * z))
               : asked.quantity == Quantity::szz ? T(scale * m * (T(1) - quotient))
                                                 : T(scale * n * (m * m - z * z) / (m * m + n * n));
    }
    const std::vector<T> at = divisions<T>(scene, a, contact.b(), x);
    T sum(0);
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        sum += plain_tanh_sinh<T>(
                   [&](const T& s) {
                       return stress_kernel<T>(asked.quantity, contact.pressure(s), T(x - s), z);
                   },
                   at[i], at[i + 1])
                   .value;
    }
    return T(-2) / pi<T>() * sum;
}

#define EDGEPROOF_INSTANTIATE(T)                                                                   \
    template T textbook_stress<T>(const scene::Scene&, const scene::AskedValue&);
EDGEPROOF_FOR_EACH_ARITHMETIC(EDGEPROOF_INSTANTIATE)
#undef EDGEPROOF_INSTANTIATE

namespace {

/// The decades that a point loses to cancellation: its depth, and its distance from the contact.
unsigned lost_digits(const scene::BodyPoint& point) {
    const PrecisionScope scope(50);
    const Real z = log10(point.z.to<Real>());
    const Real x = log10(Real(abs(point.x.to<Real>()) + 1));
    return static_cast<unsigned>(ceil(std::max(Real(-2 * z), Real(4 * std::max(z, x)))));
}

SecondRoute with_digits(const char* route, unsigned digits, unsigned working,
                        const std::function<Real()>& value) {
    const PrecisionScope scope(working);
    const Real now = value();
    return {route, now, Real(abs(now) * pow(Real(10), -static_cast<int>(digits)))};
}

/// Re and Im of a + i b.
struct Complex {
    Real re;
    Real im;
    friend Complex operator*(const Complex& x, const Complex& y) {
        return {x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
    }
    friend Complex operator*(const Complex& x, const Real& y) { return {x.re * y, x.im * y}; }
    friend Complex operator+(const Complex& x, const Complex& y) {
        return {x.re + y.re, x.im + y.im};
    }
    friend Complex operator-(const Complex& x, const Complex& y) {
        return {x.re - y.re, x.im - y.im};
    }
    [[nodiscard]] Complex inverse() const {
        const Real size = re * re + im * im;
        return {re / size, -im / size};
    }
    /// The root in the first quadrant, for im > 0.
    [[nodiscard]] Complex root() const {
        const Real size = sqrt(Real(re * re + im * im));
        return {sqrt(Real((size + re) / 2)), sqrt(Real((size - re) / 2))};
    }
};

} // namespace

SecondRoute by_pressure_integrals(const scene::Scene& scene, const scene::AskedValue& asked,
                                  unsigned digits) {
    // At the nodes nearest to the edges the printed pressure has half of its digits.
    const unsigned target = digits + lost_digits(*asked.in_body) / 2 + 10;
    return with_digits("pressure-integrals", digits, 2 * target + 40, [&] {
        const TextbookFormula<Real> contact(scene);
        const Real x = asked.in_body->x.to<Real>();
        const Real z = asked.in_body->z.to<Real>();
        const std::vector<Real> at = divisions<Real>(scene, contact.a(), contact.b(), x);
        // The printed pressure has no value where x is rounded to a knot.
        const Real least = pow(Real(10), -static_cast<int>(working_digits() / 2));
        Real sum(0);
        for (std::size_t i = 0; i + 1 < at.size(); ++i) {
            // s is counted from the end with the nearer pole of the kernel, as sinh of the
            // variable.
            const Real near[] = {hypot(Real(x - at[i]), z), hypot(Real(x - at[i + 1]), z)};
            const std::size_t end = near[1] < near[0] ? 1 : 0;
            const Real length = at[i + 1] - at[i];
            const Real most = asinh(Real(length / near[end]));
            const Real inwards = end == 0 ? 1 : -1;
            const auto f = [&](const Real& lo, const Real& hi) {
                const Real off = near[end] * sinh(Real(most * lo));
                // length - off, as a difference of two values of sinh
                const Real left =
                    2 * near[end] * cosh(Real(most * (1 + lo) / 2)) * sinh(Real(most * hi / 2));
                const Real p = contact.pressure(
                    off < left
                        ? Real(at[i + end] + inwards * std::max(off, Real(length * least)))
                        : Real(at[i + 1 - end] - inwards * std::max(left, Real(length * least))));
                const Real d = x - at[i + end] - inwards * off;
                return Real(stress_kernel<Real>(asked.quantity, p, d, z) * near[end] *
                            cosh(Real(most * lo)) * most);
            };
            sum += quadrature::tanh_sinh<Real>(f, {.target_digits = target}).value;
        }
        return Real(-2 / pi<Real>() * sum);
    });
}

SecondRoute by_slope_integrals(const scene::Scene& scene, const scene::AskedValue& asked,
                               unsigned digits) {
    const unsigned working = digits + lost_digits(*asked.in_body) + 40;
    return with_digits("slope-integrals", digits, working, [&] {
        const TextbookFormula<Real> contact(scene);
        const Real& a = contact.a();
        const Real& b = contact.b();
        const Real x = asked.in_body->x.to<Real>();
        const Real z = asked.in_body->z.to<Real>();
        const Real c = (a - b) / 2;
        const Real d = (a + b) / 2;
        std::vector<Real> at = divisions<Real>(scene, a, b, x);
        std::reverse(at.begin(), at.end()); // by the angle
        const auto angle = [&](const Real& s) {
            return s == a ? Real(0) : s == -b ? pi<Real>() : Real(acos(Real((s - c) / d)));
        };
        const bool power_law = scene.profile->kind() == contact::Profile::Kind::power_law;
        std::optional<contact::SlopeIn<Real>> g;
        if (!power_law) {
            g.emplace(*scene.profile);
        }
        const auto slope = [&](std::size_t i, const Real& s) {
            const Real inside = (at[i] + at[i + 1]) / 2;
            if (power_law) {
                const auto& parameters = scene.profile->parameters();
                const Real size = parameters.at("C").to<Real>() *
                                  pow(Real(abs(s)), parameters.at("m").to<Real>());
                return inside < 0 ? Real(-size) : size;
            }
            return g->value(g->piece_at(inside), s);
        };
        // 1/(zeta - s) has a pole at about this angle from an end of a part.
        const auto pole = [&](std::size_t i) {
            const Real size = hypot(Real(x - at[i]), z);
            const Real w = sqrt(Real(abs(Real((a - at[i]) * (at[i] + b)))));
            return Real(2 * size / (w + sqrt(Real(w * w + 2 * d * size))));
        };
        // Re and Im of the integrals of g'/(zeta - s) and g'/(zeta - s)^2
        series::Series<Real> sum(Real(0), 4);
        for (std::size_t i = 0; i + 1 < at.size(); ++i) {
            // The angle is counted from the end with the nearer pole, as sinh of the variable.
            const Real near[] = {pole(i), pole(i + 1)};
            const std::size_t end = near[1] < near[0] ? 1 : 0;
            const Real from = angle(at[i + end]);
            const Real width = (angle(at[i + 1]) - angle(at[i])) * (end == 0 ? 1 : -1);
            const Real most = asinh(Real(abs(width) / near[end]));
            const Real scale = width < 0 ? Real(-near[end]) : near[end];
            const auto part = quadrature::tanh_sinh<Real>(
                [&](const Real& lo, const Real&) {
                    const Real off = scale * sinh(Real(most * lo));
                    // cos t - cos u = -2 sin((t + u)/2) sin((t - u)/2)
                    const Real to_end = 2 * d * sin(Real(from + off / 2)) * sin(Real(off / 2));
                    const Real s = at[i + end] - to_end;
                    const Complex over = Complex{Real(x - at[i + end] + to_end), z}.inverse();
                    const Real weight = slope(i, s) * abs(scale) * cosh(Real(most * lo)) * most;
                    const Complex once = over * weight;
                    const Complex twice = once * over;
                    series::Series<Real> f(once.re, 4);
                    f[1] = once.im;
                    f[2] = twice.re;
                    f[3] = twice.im;
                    return f;
                },
                {.target_digits = working - 30});
            sum += part.value;
        }
        const Complex first{sum[0], sum[1]};
        const Complex second{sum[2], sum[3]};
        const Complex W = Complex{x - a, z}.root() * Complex{x + b, z}.root();
        const Real half = scene.contact_modulus.to<Real>() / 2;
        const Complex P = W * first * half;
        const Complex rate = (Complex{x - c, z} * W.inverse() * first - W * second) * half;
        const Real scaled = asked.quantity == Quantity::sxx   ? Real(P.im + z * rate.re)
                            : asked.quantity == Quantity::szz ? Real(P.im - z * rate.re)
                                                              : Real(-z * rate.im);
        return Real(scaled / pi<Real>());
    });
}

} // namespace edgeproof::validation
