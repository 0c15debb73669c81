// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/law/logarithmic_pressure.hpp"
#include "edgeproof/contact/routes/pressure_routes.hpp"
#include "edgeproof/precision/instantiate.hpp"

namespace edgeproof::contact {

template <Arithmetic T>
RoutedPressure<T> logarithmic_closed_form(const ContactLaw<T>& law, const Extent<T>& e,
                                          const Point<T>& at) {
    Marks<T, T> marks(e, law.slope().knots());
    return logarithmic_closed_form(law, marks, at);
}

template <Arithmetic T>
RoutedPressure<T> logarithmic_closed_form(const ContactLaw<T>& law, Marks<T, T>& marks,
                                          const Point<T>& at) {
    using std::abs;
    using std::log1p;
    using std::sqrt;
    const Extent<T>& e = marks.extent();
    const SlopeIn<T>& slope = law.slope();
    for (const auto& piece : slope.pieces()) {
        if (!piece.linear) {
            throw DomainError("only a piecewise linear g' has its pressure in logarithms");
        }
    }
    const T w_x = sqrt(T(at.right * at.left));
    const std::vector<Mark<T>>& list = marks.all();
    struct Green {
        T value;
        T moment;
    };
    const T sum = logarithmic_sum(
        slope, list.size(), T(arc_of(slope, e, list) * w_x),
        [&](std::size_t i) {
            return !list[i].end && (slope.has_corner(i) || !(slope.rate_drop(i) == T(0)));
        },
        [&](std::size_t i) {
            const Mark<T>& v = list[i];
            const T offset = at.right - v.right; // v - x as a difference of distances from one edge
            if (offset == T(0)) {
                if (slope.has_corner(i)) {
                    throw DomainError("the pressure is infinite at a corner of the profile");
                }
                return Green{T(0), T(0)};
            }
            const T excess = green_excess(v, at.right, at.left, w_x, offset > T(0) ? 1 : -1);
            // MPFR's log1p; the balls of the same formula use Arb's.
            const T G = log1p(T(excess / (e.length() * abs(offset))));
            return Green{G, T(offset * G)};
        });
    // docs/pressure.md, "Closed form: piecewise linear slopes"
    return {T(law.contact_modulus() / (T(2) * pi<T>()) * sum), T(0), 0, true};
}

#define EDGEPROOF_INSTANTIATE(T)                                                                   \
    template RoutedPressure<T> logarithmic_closed_form(const ContactLaw<T>&, const Extent<T>&,     \
                                                       const Point<T>&);                           \
    template RoutedPressure<T> logarithmic_closed_form(const ContactLaw<T>&, Marks<T, T>&,         \
                                                       const Point<T>&);
EDGEPROOF_FOR_EACH_ARITHMETIC(EDGEPROOF_INSTANTIATE)
#undef EDGEPROOF_INSTANTIATE

} // namespace edgeproof::contact
