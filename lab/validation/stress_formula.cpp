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

/// The integrand of a stress, without -2/pi, for the tractions p and q at the distance d = x - s.
template <Arithmetic T>
T stress_kernel(Quantity quantity, const T& p, const T& q, const T& d, const T& z) {
    const T r2 = d * d + z * z;
    const T along = (p * z + q * d) / (r2 * r2);
    return quantity == Quantity::sxx   ? T(along * d * d)
           : quantity == Quantity::szz ? T(along * z * z)
                                       : T(along * z * d);
}

/// A contact, and the part of its pressure that is q. In partial slip q is a difference of
/// such parts of two contacts under P and P - |Q|/f (docs/partial-slip.md).
struct SlidingPart {
    scene::Scene scene;
    formula::Exact ratio;
    bool normal; ///< its pressure is p
};
std::vector<SlidingPart> sliding_parts(const scene::Scene& scene) {
    if (!scene.slips()) {
        return {{scene, formula::Exact(), true}};
    }
    const contact::ShearSpec& shear = *scene.shear;
    const bool forwards = shear.Q.sign() > 0;
    const formula::Expr f = shear.friction->expr();
    const formula::Expr loss = shear.Q.expr() / f;
    const formula::Expr P = scene.load.value.expr();
    scene::Scene inner = scene;
    inner.load = contact::Load::force(formula::Exact(forwards ? P - loss : P + loss));
    return {{scene, formula::Exact(forwards ? f : -f), true},
            {inner, formula::Exact(forwards ? -f : f), false}};
}

template <Arithmetic T> T bulk_stress(const scene::Scene& scene, Quantity quantity) {
    return scene.shear && quantity == Quantity::sxx ? scene.shear->bulk_A.template to<T>() : T(0);
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
        parameters.at("m").template to<T>() == T(1) && !scene.shear) {
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
    T sum(0);
    for (const SlidingPart& part : sliding_parts(scene)) {
        const TextbookFormula<T> own(part.scene);
        const T ratio = part.ratio.template to<T>();
        const bool sticks = scene.shear && !scene.slips();
        const T normal(part.normal ? 1 : 0);
        const std::vector<T> at = divisions<T>(part.scene, own.a(), own.b(), x);
        for (std::size_t i = 0; i + 1 < at.size(); ++i) {
            sum +=
                plain_tanh_sinh<T>(
                    [&](const T& s) {
                        const T p = own.pressure(s);
                        return stress_kernel<T>(asked.quantity, T(normal * p),
                                                sticks ? own.shear(s) : T(ratio * p), T(x - s), z);
                    },
                    at[i], at[i + 1])
                    .value;
        }
    }
    return T(-2) / pi<T>() * sum + bulk_stress<T>(scene, asked.quantity);
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

/// The integral of the kernel over a contact.
Real pressure_integral(const SlidingPart& part, const scene::AskedValue& asked, unsigned target) {
    const TextbookFormula<Real> contact(part.scene);
    const Real ratio = part.ratio.to<Real>();
    const bool sticks = part.scene.shear && !part.scene.slips();
    const Real Q = sticks ? part.scene.shear->Q.to<Real>() : Real(0);
    const Real tension = sticks ? part.scene.shear->bulk_tension.to<Real>() : Real(0);
    const Real x = asked.in_body->x.to<Real>();
    const Real z = asked.in_body->z.to<Real>();
    const std::vector<Real> at = divisions<Real>(part.scene, contact.a(), contact.b(), x);
    // The printed pressure has no value where x is rounded to a knot.
    const Real least = pow(Real(10), -static_cast<int>(working_digits() / 2));
    Real sum(0);
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        // s is counted from the end with the nearer pole of the kernel, as sinh of the variable.
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
            Real q = ratio * p;
            if (sticks) { // eqn:Shear_Adhered in the distances from the edges
                const Real& from_lo = end == 0 ? off : left;
                const Real& from_hi = end == 0 ? left : off;
                const Real right = contact.a() - at[i + 1] + from_hi;
                const Real other = at[i] + contact.b() + from_lo;
                q = (Q / pi<Real>() + tension * (other - right) / 8) / sqrt(Real(right * other));
            }
            const Real d = x - at[i + end] - inwards * off;
            return Real(stress_kernel<Real>(asked.quantity, part.normal ? p : Real(0), q, d, z) *
                        near[end] * cosh(Real(most * lo)) * most);
        };
        sum += quadrature::tanh_sinh<Real>(f, {.target_digits = target}).value;
    }
    return sum;
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
        Real sum(0);
        for (const SlidingPart& part : sliding_parts(scene)) {
            sum += pressure_integral(part, asked, target);
        }
        return Real(-2 / pi<Real>() * sum + bulk_stress<Real>(scene, asked.quantity));
    });
}

namespace {

/// The Cauchy integrals of the tractions of a contact, and their derivatives.
struct CauchyIntegrals {
    Complex P;
    Complex P_rate;
    Complex T;
    Complex T_rate;
};

CauchyIntegrals slope_integrals(const SlidingPart& part, const scene::AskedValue& asked,
                                unsigned target) {
    const scene::Scene& scene = part.scene;
    const TextbookFormula<Real> contact(scene);
    const Real& a = contact.a();
    const Real& b = contact.b();
    const Real x = asked.in_body->x.to<Real>();
    const Real z = asked.in_body->z.to<Real>();
    const Real c = (a - b) / 2;
    const Real d = (a + b) / 2;
    const bool sticks = scene.shear && !scene.slips();
    const Real Q = sticks ? scene.shear->Q.to<Real>() : Real(0);
    const Real tension = sticks ? scene.shear->bulk_tension.to<Real>() : Real(0);
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
            const Real size =
                parameters.at("C").to<Real>() * pow(Real(abs(s)), parameters.at("m").to<Real>());
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
    // Re and Im of the integrals of g'/(zeta - s) and g'/(zeta - s)^2, and of w q instead of g'
    series::Series<Real> sum(Real(0), 8);
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        // The angle is counted from the end with the nearer pole, as sinh of the variable.
        const Real near[] = {pole(i), pole(i + 1)};
        const std::size_t end = near[1] < near[0] ? 1 : 0;
        const Real from = angle(at[i + end]);
        const Real width = (angle(at[i + 1]) - angle(at[i])) * (end == 0 ? 1 : -1);
        const Real most = asinh(Real(abs(width) / near[end]));
        const Real scale = width < 0 ? Real(-near[end]) : near[end];
        const auto integral = quadrature::tanh_sinh<Real>(
            [&](const Real& lo, const Real&) {
                const Real off = scale * sinh(Real(most * lo));
                // cos t - cos u = -2 sin((t + u)/2) sin((t - u)/2)
                const Real to_end = 2 * d * sin(Real(from + off / 2)) * sin(Real(off / 2));
                const Real s = at[i + end] - to_end;
                const Complex over = Complex{Real(x - at[i + end] + to_end), z}.inverse();
                const Real weight = abs(scale) * cosh(Real(most * lo)) * most;
                const Complex once = over * weight;
                const Complex twice = once * over;
                const Real values[] = {once.re, once.im, twice.re, twice.im};
                const Real traction = Q / pi<Real>() + tension * (s - c) / 4;
                const Real height = slope(i, s);
                series::Series<Real> f(Real(0), 8);
                for (std::size_t k = 0; k < 4; ++k) {
                    f[k] = values[k] * height;
                    f[k + 4] = values[k] * traction;
                }
                return f;
            },
            {.target_digits = target});
        sum += integral.value;
    }
    const Complex first{sum[0], sum[1]};
    const Complex second{sum[2], sum[3]};
    const Complex W = Complex{x - a, z}.root() * Complex{x + b, z}.root();
    const Real half = scene.contact_modulus.to<Real>() / 2;
    const Complex P = W * first * half;
    const Complex rate = (Complex{x - c, z} * W.inverse() * first - W * second) * half;
    if (sticks) {
        return {P, rate, {sum[4], sum[5]}, {Real(-sum[6]), Real(-sum[7])}};
    }
    const Real ratio = part.ratio.to<Real>();
    const Real normal = part.normal ? 1 : 0;
    return {P * normal, rate * normal, P * ratio, rate * ratio};
}

} // namespace

SecondRoute by_slope_integrals(const scene::Scene& scene, const scene::AskedValue& asked,
                               unsigned digits) {
    const unsigned working = digits + lost_digits(*asked.in_body) + 40;
    return with_digits("slope-integrals", digits, working, [&] {
        const Real z = asked.in_body->z.to<Real>();
        Real sum(0);
        for (const SlidingPart& part : sliding_parts(scene)) {
            const auto [P, P_rate, T, T_rate] = slope_integrals(part, asked, working - 30);
            sum += asked.quantity == Quantity::sxx
                       ? Real(P.im + z * P_rate.re - 2 * T.re + z * T_rate.im)
                   : asked.quantity == Quantity::szz ? Real(P.im - z * P_rate.re - z * T_rate.im)
                                                     : Real(T.im + z * T_rate.re - z * P_rate.im);
        }
        return Real(sum / pi<Real>() + bulk_stress<Real>(scene, asked.quantity));
    });
}

} // namespace edgeproof::validation
