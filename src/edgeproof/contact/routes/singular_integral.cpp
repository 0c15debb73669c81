// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/routes/pressure_routes.hpp"
#include "edgeproof/precision/arithmetic.hpp"

#include <optional>
#include <vector>

namespace edgeproof::contact {

template <Arithmetic T>
RoutedPressure<T> singular_integral(const ContactLaw<T>& law, const Extent<T>& e,
                                    const Point<T>& at, unsigned target_digits) {
    using std::sqrt;
    const SlopeIn<T>& slope = law.slope();
    // The integral is cut at both edges, at every knot inside and at x. Each cut has its distances
    // from both edges; piece_of holds the piece of g' that begins there.
    struct Cut {
        T right;
        T left;
        T x;
        bool is_point;
        std::optional<std::size_t> knot = {};
    };
    std::vector<Cut> cuts;
    cuts.push_back({e.length(), T(0), T(-e.b), false});
    std::vector<std::size_t> piece_of;
    std::size_t piece = 0;
    bool placed = false;
    const auto place_point = [&] {
        cuts.push_back({at.right, at.left, at.x, true});
        piece_of.push_back(piece);
        placed = true;
    };
    std::size_t piece_of_x = 0;
    for (std::size_t i = 0; i < slope.knots().size(); ++i) {
        const T& knot = slope.knots()[i];
        const T left = e.b + knot;
        const T right = e.a - knot;
        if (!(left > T(0))) {
            piece = i + 1;
            continue;
        }
        if (!(right > T(0))) {
            break;
        }
        if (!placed && !(at.x > knot)) {
            piece_of_x = piece;
            if (at.x < knot) {
                place_point();
            }
            placed = true;
        }
        cuts.push_back({right, left, knot, at.x == knot, i});
        piece_of.push_back(piece);
        piece = i + 1;
    }
    if (!placed) {
        piece_of_x = piece;
        place_point();
    }
    cuts.push_back({T(0), e.length(), e.a, false});
    piece_of.push_back(piece);

    std::vector<T> lengths;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        // The difference of the distances from the nearer edge, which cancels less.
        lengths.push_back(cuts[i].left < cuts[i + 1].right ? T(cuts[i + 1].left - cuts[i].left)
                                                           : T(cuts[i].right - cuts[i + 1].right));
    }
    std::size_t point_cut = 0;
    while (!cuts[point_cut].is_point) {
        ++point_cut;
    }
    std::vector<T> gap(lengths.size(), T(0)); // distance from x to the nearer end of each interval
    for (std::size_t i = point_cut + 1; i < lengths.size(); ++i) {
        gap[i] = gap[i - 1] + lengths[i - 1];
    }
    for (std::size_t i = point_cut; i-- > 1;) {
        gap[i - 1] = gap[i] + lengths[i];
    }
    const T at_x = slope.value(piece_of_x, at.x);
    const auto integrand = [&](std::size_t i, const T& lo, const T& hi) {
        const T right = cuts[i + 1].right + hi;
        const T left = cuts[i].left + lo;
        // s - x as a sum of lengths. Their roundoff is the same at every node, so that the
        // integrand is smooth.
        const T delta = i < point_cut ? T(-(hi + gap[i])) : T(lo + gap[i]);
        const T w = sqrt(T(right * left));
        // s from the nearer cut. Near the origin, where |s|^m is steep, s is equal to that
        // distance.
        const T s = lo < hi ? T(cuts[i].x + lo) : T(cuts[i + 1].x - hi);
        const auto& knot = lo < hi ? cuts[i].knot : cuts[i + 1].knot;
        const T away = lo < hi ? lo : T(-hi); // the distance from that cut
        if (piece_of[i] == piece_of_x) {
            return T((knot ? slope.quotient(piece_of_x, at.x, s, delta, {*knot, away})
                           : slope.quotient(piece_of_x, at.x, s, delta)) /
                     w);
        }
        const T at_s =
            knot ? slope.value(piece_of[i], s, {*knot, away}) : slope.value(piece_of[i], s);
        // docs/pressure.md, "The singular integral, and how its pole is taken out"
        return T((at_s - at_x) / (delta * w));
    };
    const auto result = quadrature::integrate_pieces<T>(integrand, lengths, T(0), T(0),
                                                        {.target_digits = target_digits});
    // moore-hills EQ01
    const T factor = law.contact_modulus() / (T(2) * pi<T>()) * sqrt(T(at.right * at.left));
    return {T(factor * result.value), result.estimate, result.evaluations, result.converged};
}

#define EDGEPROOF_INSTANTIATE(T)                                                                   \
    template RoutedPressure<T> singular_integral(const ContactLaw<T>&, const Extent<T>&,           \
                                                 const Point<T>&, unsigned);
EDGEPROOF_FOR_EACH_ARITHMETIC(EDGEPROOF_INSTANTIATE)
#undef EDGEPROOF_INSTANTIATE

} // namespace edgeproof::contact
