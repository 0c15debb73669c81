// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/validation/axisymmetric_formula.hpp"

#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"
#include "edgeproof/scene/run_scene.hpp"
#include "lab/validation/plain_tanh_sinh.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

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

namespace {

constexpr unsigned digits_spare = 40;

class NestedIntegrals {
public:
    NestedIntegrals(const scene::Scene& scene, Real a) : a_(std::move(a)) {
        const contact::Profile& profile = scene.round->profile;
        if (scene.round->law) {
            power_ = profile.parameters().at("m").to<Real>();
            parts_.push_back({Real(0), profile.parameters().at("C").to<Real>(), Real(0)});
        } else {
            parts_ = slope_parts<Real>(profile);
        }
    }

    /// h(s)/s, or h'(s), is the integral of g', or of g' + r g'', over an angle f, r = s cos f, and
    /// a sum over the jumps of g'.
    [[nodiscard]] Real h_over_s(const Real& s) { return over_angle(s, 1); }
    [[nodiscard]] Real h_rate(const Real& s) {
        Real sum = over_angle(s, 2);
        for (std::size_t i = 1; i < parts_.size() && parts_[i].lo < s; ++i) {
            const Real& v = parts_[i].lo;
            const Real jump = parts_[i].at_origin - parts_[i - 1].at_origin +
                              (parts_[i].rate - parts_[i - 1].rate) * v;
            sum += jump * v / sqrt((s - v) * (s + v));
        }
        return sum;
    }
    /// The integral of f(s, s - from) over from < s < a, split at the bends.
    [[nodiscard]] Real over_radius(const Real& from,
                                   const std::function<Real(const Real&, const Real&)>& f) {
        std::vector<Real> ends{from};
        for (const auto& part : parts_) {
            if (part.lo > from && part.lo < a_) {
                ends.push_back(part.lo);
            }
        }
        ends.push_back(a_);
        Real sum = 0;
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            const Real width = ends[i + 1] - ends[i];
            sum += width * added(quadrature::tanh_sinh<Real>([&](const Real& lo, const Real&) {
                       const Real beyond = width * lo;
                       return f(ends[i] + beyond, ends[i] - from + beyond);
                   }));
        }
        return sum;
    }
    [[nodiscard]] const Real& error() const { return error_; } ///< relative

private:
    [[nodiscard]] Real added(const quadrature::QuadratureResult<Real>& result) {
        error_ = std::max(error_, result.estimate);
        return result.value;
    }
    [[nodiscard]] Real over_angle(const Real& s, int rate_factor) {
        Real sum = 0;
        Real until = pi<Real>() / 2; // the angle at the inner end of a part
        for (std::size_t i = 0; i < parts_.size() && parts_[i].lo < s; ++i) {
            const bool last = i + 1 == parts_.size() || !(parts_[i + 1].lo < s);
            Real begin = 0;
            if (!last) {
                const Real& v = parts_[i + 1].lo;
                begin = atan2(sqrt((s - v) * (s + v)), v);
            }
            const Real width = until - begin;
            sum += width * added(quadrature::tanh_sinh<Real>([&](const Real& lo, const Real& hi) {
                       // sin of the distance from the axis, where r = 0
                       const Real r = until * 2 == pi<Real>() ? Real(s * sin(width * hi))
                                                              : Real(s * cos(begin + width * lo));
                       return power_ ? Real(parts_[i].at_origin * pow(r, *power_) *
                                            (rate_factor == 2 ? Real(1 + *power_) : Real(1)))
                                     : Real(parts_[i].at_origin + rate_factor * parts_[i].rate * r);
                   }));
            until = begin;
        }
        return sum;
    }

    Real a_;
    std::optional<Real> power_;
    std::vector<SlopePart<Real>> parts_;
    Real error_ = 0;
};

} // namespace

SecondRoute by_nested_integrals(const scene::Scene& scene, const scene::AskedValue& asked,
                                unsigned digits) {
    // Distances from a bend and from the edge are differences.
    unsigned working = digits + digits_spare;
    if (asked.u) {
        const PrecisionScope scope(30);
        const Real small = -log10(asked.u->to<Real>());
        working += small > 0 ? 2 * static_cast<unsigned>(ceil(small)) : 0;
    }
    const scene::AskedValue radius{scene::Quantity::a};
    const Ball known = scene::SceneValues(scene, {radius}, {working, Rounding::nearest, false})
                           .value(radius)
                           .value;
    const PrecisionScope scope(working + 10);
    const Real a = known.midpoint();
    const Real modulus = scene.contact_modulus.to<Real>();
    NestedIntegrals of(scene, a);
    Real value = 0;
    if (asked.quantity == scene::Quantity::p) {
        const Real r = a - asked.u->to<Real>();
        value = modulus / pi<Real>() * of.over_radius(r, [&](const Real& s, const Real& beyond) {
            return Real(of.h_rate(s) / sqrt(beyond * (s + r)));
        });
    } else if (asked.quantity == scene::Quantity::P) {
        value = 2 * modulus *
                (a * a * of.h_over_s(a) - of.over_radius(Real(0), [&](const Real& s, const Real&) {
                    return Real(s * of.h_over_s(s));
                }));
    } else {
        value = a * of.h_over_s(a);
    }
    return {"nested-integrals", value, Real(abs(value) * of.error())};
}

} // namespace edgeproof::validation
