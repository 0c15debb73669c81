// SPDX-License-Identifier: GPL-3.0-or-later
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
    using std::sqrt;
    const Extent<T>& e = marks.extent();
    const SlopeIn<T>& slope = law.slope();
    for (const auto& piece : slope.pieces()) {
        if (!piece.linear) {
            throw DomainError("only a piecewise linear g' has its pressure in logarithms");
        }
    }
    const T w_x = sqrt(T(at.right * at.left));
    // G(x, v) = ln |(z_v + z_x)/(z_v - z_x)| with the roots cleared of the difference:
    // (sqrt(r_v l_x) + sqrt(r_x l_v))^2 / (D |v - x|), where r_v l_x - r_x l_v = D (x - v).
    const auto green = [&](const T& right, const T& left, const T& w, const T& distance) {
        const T p = right * at.left;
        const T q = at.right * left;
        const T root = T(2) * w * w_x;
        const T gap = e.length() * distance;
        const T smaller = p < q ? p : q;
        // ln((p + q + 2 sqrt(pq))/|p - q|): near an edge the argument is near 1.
        return log_of_one_plus(T((T(2) * smaller + root) / gap));
    };
    T sum(0);
    T previous_h = pi<T>();
    T previous_moment(0); // (v - x) G at the last mark; 0 at the left edge
    const auto& knots = slope.knots();
    std::size_t piece = 0;
    for (std::size_t i = 0; i <= knots.size(); ++i) {
        const bool edge = i == knots.size() || !(knots[i] < e.a);
        T h(0);
        T moment(0);
        if (!edge) {
            if (!(-knots[i] < e.b)) {
                piece = i + 1;
                continue;
            }
            const Mark<T>& m = marks.at(i);
            const T right = e.a - knots[i];
            const T offset = right < at.right || right > at.right
                                 ? T(at.right - right) // v - x, from the same edge
                                 : T(0);
            h = m.h;
            const T distance = abs(offset);
            if (distance == T(0)) {
                if (!(slope.jump(i) == T(0))) {
                    throw DomainError("the pressure is infinite at a corner of the profile");
                }
            } else {
                const T G = green(right, T(e.b + knots[i]), m.w, distance);
                moment = offset * G;
                sum += slope.jump(i) * G;
            }
        }
        sum += slope.pieces()[piece].rate * (moment - previous_moment + w_x * (previous_h - h));
        previous_h = h;
        previous_moment = moment;
        piece = i + 1;
        if (edge) {
            break;
        }
    }
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
