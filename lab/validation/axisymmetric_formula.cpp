// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/validation/axisymmetric_formula.hpp"

#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/precision/error.hpp"
#include "lab/validation/plain_tanh_sinh.hpp"

#include <cmath>

namespace edgeproof::validation {
namespace {

/// A piece of g': at_origin + rate r, or C r^m, from lo on.
template <Arithmetic T> struct SlopePart {
    T lo;
    T at_origin;
    T rate;
};
template <Arithmetic T> std::vector<SlopePart<T>> slope_parts(const contact::Profile& profile) {
    const contact::SlopeIn<T> slope(profile);
    std::vector<SlopePart<T>> parts;
    for (std::size_t i = slope.origin(); i < slope.knots().size(); ++i) {
        const auto& piece = slope.pieces()[i + 1];
        parts.push_back({slope.knots()[i], piece.at_origin, piece.rate});
    }
    return parts;
}

/// The zero of an increasing f by bisection, until no number lies between the ends.
template <Arithmetic T, class F> T halved(const F& f) {
    T hi(1);
    while (!(f(hi) > T(0))) {
        hi *= T(2);
    }
    T lo = hi / T(2);
    while (f(lo) > T(0)) {
        lo /= T(2);
    }
    for (T middle = (lo + hi) / T(2); lo < middle && middle < hi; middle = (lo + hi) / T(2)) {
        (f(middle) < T(0) ? lo : hi) = middle;
    }
    return hi;
}

} // namespace

template <Arithmetic T>
AxisymmetricFormula<T>::AxisymmetricFormula(const scene::Scene& scene)
    : modulus_(scene.contact_modulus.template to<T>()) {
    using Kind = contact::Load::Kind;
    if (scene.round->law) {
        power_ = true;
        m_ = formula::Exact(scene.round->law->m).template to<T>();
        kappa_ = formula::Exact(scene.round->law->kappa).template to<T>();
    } else {
        T at_origin(0);
        T rate(0);
        for (const SlopePart<T>& part : slope_parts<T>(scene.round->profile)) {
            const T jump = part.at_origin - at_origin + (part.rate - rate) * part.lo;
            bends_.push_back({part.lo, jump, part.rate - rate});
            at_origin = part.at_origin;
            rate = part.rate;
        }
    }
    const contact::Load& load = scene.round->load;
    const T given = load.value.template to<T>();
    a_ = load.kind == Kind::right_edge ? given : halved<T>([&](const T& a) {
        return T((load.kind == Kind::force ? force(a) : approach(a)) - given);
    });
}

template <Arithmetic T>
template <class F>
T AxisymmetricFormula<T>::over_bends(const T& s, const F& f) const {
    using std::acos;
    using std::sqrt;
    T sum(0);
    for (const Bend& bend : bends_) {
        if (bend.v < s) {
            sum += f(bend, T(sqrt(T(s * s - bend.v * bend.v))), T(acos(T(bend.v / s))));
        }
    }
    return sum;
}

// docs/axisymmetric.md, "Power laws" and "Piecewise linear slopes" (`sneddon1965`)
template <Arithmetic T> T AxisymmetricFormula<T>::approach(const T& s) const {
    using std::pow;
    return power_ ? T(kappa_ * pow(s, T(m_ + T(1))))
                  : s * over_bends(s, [](const Bend& bend, const T& y, const T& A) {
                        return T(bend.jump * A + bend.rate * (y - bend.v * A));
                    });
}

template <Arithmetic T> T AxisymmetricFormula<T>::force(const T& a) const {
    using std::pow;
    return power_ ? T(T(2) * modulus_ * (m_ + T(1)) / (m_ + T(2)) * kappa_ * pow(a, T(m_ + T(2))))
                  : modulus_ * over_bends(a, [&](const Bend& bend, const T& y, const T& A) {
                        const T moment = a * a * A - bend.v * y;
                        return T(bend.jump * (a * a * A + bend.v * y) +
                                 bend.rate * (T(4) * y * y * y / T(3) - bend.v * moment));
                    });
}

// docs/axisymmetric.md, "What is integrated"
template <Arithmetic T> T AxisymmetricFormula<T>::pressure(const T& r) const {
    using std::atan;
    using std::pow;
    using std::sqrt;
    const T scale = modulus_ / pi<T>();
    const T W2 = (a_ - r) * (a_ + r);
    const auto place = [&](const T& t) { return T(sqrt(T(r * r + W2 * t * t))); };
    if (power_) {
        return scale * sqrt(W2) *
               plain_tanh_sinh<T>(
                   [&](const T& t) {
                       return T((m_ + T(1)) * kappa_ * pow(place(t), T(m_ - T(1))));
                   },
                   T(0), T(1))
                   .value;
    }
    T sum(0);
    for (const Bend& bend : bends_) {
        const T& v = bend.v;
        if (v >= a_) {
            continue;
        }
        const T y2 = v < r ? W2 : T((a_ - v) * (a_ + v));
        const T from = v < r ? T((r - v) * (r + v)) : T((v - r) * (v + r));
        sum += sqrt(y2) *
               plain_tanh_sinh<T>(
                   [&](const T& t) {
                       const T y = sqrt(T(v < r ? T(from + y2 * t * t) : y2 * t * t));
                       const T A = v > T(0) ? T(atan(T(y / v))) : T(pi<T>() / T(2));
                       const T steep = v > T(0) ? T(v / y) : T(0);
                       const T rate = bend.jump * (A + steep) + bend.rate * (T(2) * y - v * A);
                       return v < r ? T(rate / place(t))
                                    : T(rate * y / sqrt(T(v * v + y * y)) / sqrt(T(from + y * y)));
                   },
                   T(0), T(1))
                   .value;
    }
    return scale * sum;
}

template <Arithmetic T> T AxisymmetricFormula<T>::value(const scene::AskedValue& asked) const {
    switch (asked.quantity) {
    case scene::Quantity::p:
        return pressure(T(a_ - asked.u.value().template to<T>()));
    case scene::Quantity::P:
        return force(a_);
    case scene::Quantity::delta:
        return approach(a_);
    default:
        throw DomainError("there is no formula for a " + std::string(row_of(asked.quantity).name) +
                          " of an axisymmetric contact");
    }
}

#define EDGEPROOF_INSTANTIATE(T) template class AxisymmetricFormula<T>;
EDGEPROOF_FOR_EACH_ARITHMETIC(EDGEPROOF_INSTANTIATE)
#undef EDGEPROOF_INSTANTIATE

} // namespace edgeproof::validation
