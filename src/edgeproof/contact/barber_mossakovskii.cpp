// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/instantiate.hpp"
#include "edgeproof/contact/pressure_routes.hpp"

#include <algorithm>
#include <vector>

namespace edgeproof {
namespace {

/// Where P'(s) or b(s) is not analytic in (0, a): s on a knot, or b(s) on one. Ascending.
template <Arithmetic T> std::vector<T> kinks(const ContactLaw<T>& law, const Extent<T>& e) {
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
    // P' and b(s) are not analytic at the kinks below x either: the nearest tells how close the
    // first interval lies to trouble. At the apex it is the origin itself.
    T below(0);
    std::vector<T> offsets; // from x: the first interval's lower end
    offsets.push_back(T(0));
    for (const T& s : kinks(law, e)) {
        const T offset = s - at.x;
        if (!(offset > T(0))) {
            below = s;
        } else if (offset < at.right) {
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
        const T s = at.x + from_x;
        const Extent<T> then = law.extent(s);
        const T rate = law.force_rate(then);
        return T(rate / sqrt(T(from_x * (at.x + then.b))));
    };
    const auto result =
        integrate_pieces<T>(integrand, lengths, beyond, T(0), {.target_digits = target_digits});
    return {T(result.value / pi<T>()), result.estimate, result.evaluations, result.converged};
}

#define EDGEPROOF_INSTANTIATE(T)                                                                   \
    template RoutedPressure<T> barber_mossakovskii(const ContactLaw<T>&, const Extent<T>&,         \
                                                   const Point<T>&, unsigned);
EDGEPROOF_FOR_EACH_ARITHMETIC(EDGEPROOF_INSTANTIATE)
#undef EDGEPROOF_INSTANTIATE

} // namespace edgeproof
