// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/validation/textbook_formula.hpp"

#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/error.hpp"
#include "lab/validation/plain_tanh_sinh.hpp"
#include "lab/validation/stress_formula.hpp"
#include "lab/validation/value_routes.hpp"

#include <boost/math/special_functions/gamma.hpp>

#include <algorithm>

namespace edgeproof::validation {
namespace {

constexpr int most_halvings = 20000;
constexpr int most_doublings = 4000;
constexpr int scan_points = 400; // of an extent, 50 per decade

template <Arithmetic T> T gamma_of(const T& x) {
    if constexpr (std::same_as<T, Real>) {
        Real y;
        mpfr_gamma(y.backend().data(), x.backend().data(), MPFR_RNDN);
        return y;
    } else {
        return boost::math::tgamma(x);
    }
}

/// Finds the zero of an increasing f by bisection, until no number lies between the ends.
template <Arithmetic T, class F> T bisect(const F& f, T lo, T hi) {
    for (int i = 0; i < most_halvings; ++i) {
        const T middle = (lo + hi) / T(2);
        if (!(lo < middle && middle < hi)) {
            break;
        }
        (f(middle) < T(0) ? lo : hi) = middle;
    }
    return hi;
}

/// Finds the zero from a guess of its size.
template <Arithmetic T, class F> T bisect_from(const F& f, const T& guess) {
    T lo = guess;
    T hi = guess;
    for (int i = 0; i < most_doublings && !(f(hi) > T(0)); ++i) {
        lo = hi;
        hi *= T(2);
    }
    for (int i = 0; i < most_doublings && f(lo) > T(0); ++i) {
        lo /= T(2);
    }
    return bisect<T>(f, lo, hi);
}

/// The integral of sin^n over a right angle.
template <Arithmetic T> T wallis(const T& n) {
    using std::sqrt;
    return sqrt(pi<T>()) / T(2) * gamma_of<T>(T((n + T(1)) / T(2))) /
           gamma_of<T>(T((n + T(2)) / T(2)));
}

/// Places s = c + d cos(angle) of a contact -b < s < a; w = sqrt((a - s)(s + b)) = d sin(angle).
template <Arithmetic T> struct OnCircle {
    const T& a;
    const T& b;
    T c = (a - b) / T(2);
    T d = (a + b) / T(2);

    /// Places that roundoff has moved outside the contact are moved to its edges.
    [[nodiscard]] T angle(const T& s) const {
        using std::acos;
        const T ratio = (s - c) / d;
        return ratio > T(1) ? T(0) : ratio < T(-1) ? pi<T>() : T(acos(ratio));
    }
    [[nodiscard]] T w(const T& s) const {
        using std::abs;
        using std::sqrt;
        return T(sqrt(T(abs((a - s) * (s + b)))));
    }
};

} // namespace

template <Arithmetic T>
TextbookFormula<T>::TextbookFormula(const scene::Scene& scene)
    : scene_(scene), modulus_(scene.contact_modulus.template to<T>()) {
    if (!scene.profile) {
        throw DomainError("no published formula holds for an unknown tilt");
    }
    const contact::Profile& profile = *scene.profile;
    if (profile.kind() == contact::Profile::Kind::power_law) {
        power_ = true;
        m_ = profile.parameters().at("m").template to<T>();
        C_ = profile.parameters().at("C").template to<T>();
    } else {
        slope_.emplace(profile);
        if (!std::ranges::all_of(slope_->pieces(), [](const auto& p) { return p.linear; })) {
            throw DomainError("no published formula holds for a curved g'");
        }
    }
    if (scene.shear) {
        Q_ = scene.shear->Q.template to<T>();
        sigma_ = scene.shear->bulk_tension.template to<T>();
    }
    const T given = scene.load.value.template to<T>();
    if (scene.load.kind == contact::Load::Kind::right_edge) {
        a_ = given;
    } else {
        a_ = bisect_from<T>([&](const T& a) { return T(force(a, left_edge(a)) - given); }, T(1));
    }
    b_ = left_edge(a_);
}

template <Arithmetic T>
std::vector<typename TextbookFormula<T>::Span> TextbookFormula<T>::spans(const T& a,
                                                                         const T& b) const {
    std::vector<Span> list;
    const std::vector<T>& knots = slope_->knots();
    for (std::size_t i = 0; i <= knots.size(); ++i) {
        const T lo = i == 0 || knots[i - 1] < -b ? T(-b) : knots[i - 1];
        const T hi = i == knots.size() || knots[i] > a ? a : knots[i];
        if (lo < hi) {
            list.push_back({lo, hi, slope_->pieces()[i].at_origin, slope_->pieces()[i].rate});
        }
    }
    return list;
}

/// The integral of g'(s)/sqrt((a - s)(s + b)) (eqn:Consistency), s = c + d cos h.
template <Arithmetic T> T TextbookFormula<T>::imbalance(const T& a, const T& b) const {
    const OnCircle<T> on{a, b};
    T sum(0);
    for (const Span& p : spans(a, b)) {
        const T turn = on.angle(p.lo) - on.angle(p.hi);
        sum += p.at_origin * turn + p.rate * (on.c * turn + on.w(p.lo) - on.w(p.hi));
    }
    return sum;
}

/// E*/2 times the integral of g'(s) (s - c)/sqrt((a - s)(s + b)) (eqn:AppliedNormalForce_NonSym).
template <Arithmetic T> T TextbookFormula<T>::force(const T& a, const T& b) const {
    using std::pow;
    if (power_) {
        return modulus_ * C_ * pow(a, T(m_ + T(1))) * wallis<T>(T(m_ + T(1)));
    }
    const OnCircle<T> on{a, b};
    T sum(0);
    for (const Span& p : spans(a, b)) {
        const T drop = on.w(p.lo) - on.w(p.hi);
        const T turn = on.angle(p.lo) - on.angle(p.hi);
        const T moment = ((p.lo - on.c) * on.w(p.lo) - (p.hi - on.c) * on.w(p.hi)) / T(2);
        sum += p.at_origin * drop + p.rate * (on.c * drop + on.d * on.d * turn / T(2) + moment);
    }
    return modulus_ / T(2) * sum;
}

template <Arithmetic T> T TextbookFormula<T>::left_edge(const T& a) const {
    using std::cos;
    using std::sin;
    if (scene_.symmetric()) {
        return a;
    }
    if (scene_.profile->kind() == contact::Profile::Kind::tilted_wedge) {
        // For phi, alpha: h = pi (phi + alpha)/(2 phi) is the angle of the apex, b = a cot^2(h/2).
        const T right = slope_->pieces()[1].at_origin;
        const T left = -slope_->pieces()[0].at_origin;
        const T half = pi<T>() * left / (right + left) / T(2);
        return a * cos(half) * cos(half) / (sin(half) * sin(half));
    }
    return bisect_from<T>([&](const T& b) { return T(-imbalance(a, b)); }, a);
}

template <Arithmetic T> T TextbookFormula<T>::power_pressure(const T& x) const {
    using std::acosh;
    using std::pow;
    using std::sqrt;
    const T scale = modulus_ * C_;
    const T y = x < T(0) ? T(-x) : x;
    if (m_ == T(0)) {
        return scale / pi<T>() * acosh(T(a_ / y));
    }
    if (m_ == T(1)) {
        return scale / T(2) * sqrt(T(a_ * a_ - y * y));
    }
    const T rate = scale * (m_ + T(1)) * wallis<T>(T(m_ + T(1)));
    const auto f = [&](const T& s) { return T(pow(s, m_) / sqrt(T(s * s - y * y))); };
    return rate / pi<T>() * plain_tanh_sinh<T>(f, y, a_).value;
}

template <Arithmetic T> T TextbookFormula<T>::linear_pressure(const T& x) const {
    using std::abs;
    using std::acos;
    using std::log;
    using std::sqrt;
    // p = E* w(x)/(2 pi) times the principal value of the integral of g'(s)/((s - x) w(s)); for a
    // piece g' = A + B s this is (A + B x) [-G(x, s)/w(x)] + B [-acos].
    const T c = (a_ - b_) / T(2);
    const T d = (a_ + b_) / T(2);
    const T w_x = sqrt(T((a_ - x) * (x + b_)));
    const auto angle = [&](const T& s) {
        const T ratio = (s - c) / d;
        return ratio > T(1) ? T(0) : ratio < T(-1) ? pi<T>() : T(acos(ratio));
    };
    const auto green = [&](const T& s) {
        const T one = sqrt(T(abs((a_ - x) * (b_ + s))));
        const T other = sqrt(T(abs((a_ - s) * (b_ + x))));
        return T(log(T(abs((one + other) / (one - other)))));
    };
    const auto list = spans(a_, b_);
    T sum(0);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Span& p = list[i];
        const T at_x = p.at_origin + p.rate * x;
        const T lower = i == 0 ? T(0) : green(p.lo);
        const T upper = i + 1 == list.size() ? T(0) : green(p.hi);
        sum += at_x * (lower - upper) + p.rate * w_x * (angle(p.lo) - angle(p.hi));
    }
    return modulus_ / (T(2) * pi<T>()) * sum;
}

template <Arithmetic T> T TextbookFormula<T>::pressure(const T& x) const {
    return power_ ? power_pressure(x) : linear_pressure(x);
}

template <Arithmetic T> T TextbookFormula<T>::shear(const T& x) const {
    using std::sqrt;
    return (Q_ / pi<T>() + sigma_ * (T(2) * x + b_ - a_) / T(8)) / sqrt(T((a_ - x) * (x + b_)));
}

template <Arithmetic T>
std::vector<T> TextbookFormula<T>::series(contact::Edge edge, std::size_t terms) const {
    const contact::ContactLaw<T> law(*scene_.profile, modulus_);
    return edge_expansion<T>(law, contact::Extent<T>{a_, b_}, edge, terms);
}

template <Arithmetic T> T TextbookFormula<T>::coefficient(contact::Edge edge, std::size_t k) const {
    using std::acos;
    using std::pow;
    using std::sqrt;
    const bool flat = scene_.profile->kind() == contact::Profile::Kind::flat_and_rounded;
    if (k > 1 || !(power_ || flat)) {
        return series(edge, k + 1)[k];
    }
    T first(0);  // P'(a)
    T second(0); // P''(a)
    if (power_) {
        const T scale = modulus_ * C_ * (m_ + T(1)) * wallis<T>(T(m_ + T(1)));
        first = scale * pow(a_, m_);
        second = scale * m_ * pow(a_, T(m_ - T(1)));
    } else {
        const T t = scene_.profile->parameters().at("t").template to<T>();
        const T R = scene_.profile->parameters().at("R").template to<T>();
        const T angle = acos(T(t / a_));
        first = modulus_ * a_ / R * angle;
        second = modulus_ / R * (angle + t / sqrt(T(a_ * a_ - t * t)));
    }
    const T root = sqrt(T(2));
    return k == 0 ? T(root * first / (pi<T>() * sqrt(a_)))
                  : T(T(2) * root / (T(3) * a_ * sqrt(a_) * pi<T>()) *
                      (T(5) * first / T(8) - a_ * second));
}

template <Arithmetic T>
T TextbookFormula<T>::shear_coefficient(contact::Edge edge, std::size_t k) const {
    using std::pow;
    using std::sqrt;
    // The coefficients of (1 - z)^(-1/2) = sum beta_k z^k.
    const T D = a_ + b_;
    const T side = edge == contact::Edge::right ? T(1) : T(-1);
    T beta(1);
    T before(0);
    for (std::size_t j = 1; j <= k; ++j) {
        before = beta;
        beta *= T(static_cast<int>(2 * j - 1)) / T(static_cast<int>(2 * j));
    }
    const T bracket =
        (Q_ / pi<T>() + side * sigma_ * D / T(8)) * beta - side * sigma_ * D / T(4) * before;
    return bracket / (sqrt(D) * pow(D, T(static_cast<int>(k))));
}

/// Searches a grid of points, as for drawing a curve, then uses bisection.
template <Arithmetic T> T TextbookFormula<T>::first_exit(const scene::AskedValue& asked) const {
    using std::abs;
    using std::pow;
    using std::sqrt;
    const T tolerance = asked.tolerance->template to<T>();
    const std::vector<T> c = series(asked.edge, asked.k);
    const auto excess = [&](const T& u) {
        T sum(0);
        for (std::size_t k = c.size(); k-- > 0;) {
            sum = sum * u + c[k];
        }
        const T x = asked.edge == contact::Edge::right ? T(a_ - u) : T(u - b_);
        return T(abs(T(T(1) - sum * sqrt(u) / pressure(x))) - tolerance);
    };
    const T length = a_ + b_;
    T before = length * pow(T(10), T(-8));
    const T ratio = pow(T(10), T(T(1) / T(50)));
    for (int i = 0; i < scan_points; ++i) {
        const T u = before * ratio;
        if (excess(u) > T(0)) {
            return bisect<T>(excess, before, u);
        }
        before = u;
    }
    throw DomainError("the approximation stays within the tolerance");
}

template <Arithmetic T> T TextbookFormula<T>::value(const scene::AskedValue& asked) const {
    using std::pow;
    using std::sqrt;
    const auto place = [&] {
        const T u = asked.u->template to<T>();
        return asked.edge == contact::Edge::right ? T(a_ - u) : T(u - b_);
    };
    switch (asked.quantity) {
    case scene::Quantity::p:
        return pressure(place());
    case scene::Quantity::c:
        return coefficient(asked.edge, asked.k);
    case scene::Quantity::residual: {
        const T u = asked.u->template to<T>();
        const std::vector<T> c = series(asked.edge, asked.k);
        T sum(0);
        for (std::size_t k = 0; k < c.size(); ++k) {
            sum += c[k] * pow(u, T(static_cast<int>(k))) * sqrt(u);
        }
        return T(1) - sum / pressure(place());
    }
    case scene::Quantity::q:
        return shear(place());
    case scene::Quantity::s:
        return shear_coefficient(asked.edge, asked.k);
    case scene::Quantity::P:
        return force();
    case scene::Quantity::b:
        return b_;
    case scene::Quantity::tilt_difference: {
        const scene::Scene other = upright(scene_);
        scene::AskedValue plain = asked;
        plain.quantity = scene::Quantity::p;
        return pressure(place()) - TextbookFormula(other).value(plain);
    }
    case scene::Quantity::extent:
        return first_exit(asked);
    case scene::Quantity::sxx:
    case scene::Quantity::szz:
    case scene::Quantity::sxz:
        return textbook_stress<T>(scene_, asked);
    default:
        break;
    }
    throw DomainError("no published formula gives a " + std::string(row_of(asked.quantity).name));
}

#define EDGEPROOF_INSTANTIATE(T) template class TextbookFormula<T>;
EDGEPROOF_FOR_EACH_ARITHMETIC(EDGEPROOF_INSTANTIATE)
#undef EDGEPROOF_INSTANTIATE

} // namespace edgeproof::validation
