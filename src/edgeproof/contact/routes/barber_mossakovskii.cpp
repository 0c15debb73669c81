// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/routes/pressure_routes.hpp"
#include "edgeproof/precision/arithmetic.hpp"

#include <algorithm>
#include <type_traits>
#include <vector>

namespace edgeproof::contact {
namespace {

/// Adds digits while it exists, in an arithmetic that supports it. Beyond a corner of the profile
/// P'(s) grows like (s - knot)^(-1/2), so that s needs the digits of s - knot.
template <Arithmetic T> class MoreDigits {
public:
    explicit MoreDigits(unsigned) {}
};
template <> class MoreDigits<Real> {
public:
    explicit MoreDigits(unsigned more) : scope_(working_digits() + more) {}

private:
    PrecisionScope scope_;
};

/// The number of decimal digits by which part is smaller than s; 0 if it is not smaller.
template <Arithmetic T> unsigned digits_lost(const T& s, const T& part) {
    if constexpr (std::is_same_v<T, Real>) {
        constexpr double digits_a_bit = 0.30103;
        const auto bits = mpfr_get_exp(s.backend().data()) - mpfr_get_exp(part.backend().data());
        return bits > 0 && part > 0
                   ? static_cast<unsigned>(digits_a_bit * static_cast<double>(bits)) + 1
                   : 0;
    } else {
        return 0;
    }
}

/// The places in (0, a) where P'(s) or b(s) is not analytic, since s or -b(s) is a knot, in
/// ascending order. Places that are solved for have twice the digits of the thread.
template <Arithmetic T> std::vector<T> kinks(const ContactLaw<T>& law, const Extent<T>& e) {
    const MoreDigits<T> twice(working_digits());
    std::vector<T> s;
    for (const T& knot : law.slope().knots()) {
        if (knot > T(0) && knot < e.a) {
            s.push_back(knot);
        } else if (knot < T(0) && -knot < e.b && !law.symmetric()) {
            s.push_back(law.right_edge(T(-knot)));
        }
    }
    std::sort(s.begin(), s.end());
    return s;
}

} // namespace

template <Arithmetic T>
RoutedPressure<T> barber_mossakovskii(const ContactLaw<T>& law, const Extent<T>& e,
                                      const Point<T>& at, unsigned target_digits) {
    using std::sqrt;
    if (at.x < T(0)) {
        throw DomainError("the right branch of Barber-Mossakovskii holds for x >= 0");
    }
    // P' and b(s) are not analytic at the kinks below x either: the nearest one gives the distance
    // of a singularity from the first interval. At the apex it is the origin itself.
    T below(0);
    std::vector<T> starts{at.x};
    std::vector<T> offsets{T(0)}; // distances of the starts from x
    for (const T& s : kinks(law, e)) {
        const T offset = s - at.x;
        if (!(offset > T(0))) {
            below = s;
        } else if (offset < at.right) {
            starts.push_back(s);
            offsets.push_back(offset);
        }
    }
    const T beyond = at.x - below;
    std::vector<T> lengths;
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        lengths.push_back((i + 1 < offsets.size() ? offsets[i + 1] : at.right) - offsets[i]);
    }
    const auto integrand = [&](std::size_t i, const T& lo, const T&) {
        const T from_x = offsets[i] + lo;
        const MoreDigits<T> near_the_kink(i > 0 ? digits_lost(starts[i], lo) : 0);
        const T s = starts[i] + lo;
        const Extent<T> then = law.extent(s);
        const T rate = law.force_rate(then);
        // moore-hills EQ21, first branch
        return T(rate / sqrt(T(from_x * (at.x + then.b))));
    };
    const auto result = quadrature::integrate_pieces<T>(integrand, lengths, beyond, T(0),
                                                        {.target_digits = target_digits});
    return {T(result.value / pi<T>()), result.estimate, result.evaluations, result.converged};
}

#define EDGEPROOF_INSTANTIATE(T)                                                                   \
    template RoutedPressure<T> barber_mossakovskii(const ContactLaw<T>&, const Extent<T>&,         \
                                                   const Point<T>&, unsigned);
EDGEPROOF_FOR_EACH_ARITHMETIC(EDGEPROOF_INSTANTIATE)
#undef EDGEPROOF_INSTANTIATE

} // namespace edgeproof::contact
