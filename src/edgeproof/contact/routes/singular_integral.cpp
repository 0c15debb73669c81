// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/routes/pressure_routes.hpp"
#include "edgeproof/precision/arithmetic.hpp"

#include <optional>
#include <vector>

namespace edgeproof::contact {

RoutedPressure singular_integral(const ContactLaw<Real>& law, const Extent<Real>& e,
                                 const Point<Real>& at, unsigned target_digits) {
    const SlopeIn<Real>& slope = law.slope();
    // The integral is cut at both edges, at every knot inside and at x. Each cut has its distances
    // from both edges; piece_of holds the piece of g' that begins there.
    struct Cut {
        Real right;
        Real left;
        Real x;
        bool is_point;
        std::optional<std::size_t> knot = {};
    };
    std::vector<Cut> cuts;
    cuts.push_back({e.length(), Real(0), Real(-e.b), false});
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
        const Real& knot = slope.knots()[i];
        const Real left = e.b + knot;
        const Real right = e.a - knot;
        if (!(left > Real(0))) {
            piece = i + 1;
            continue;
        }
        if (!(right > Real(0))) {
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
    cuts.push_back({Real(0), e.length(), e.a, false});
    piece_of.push_back(piece);

    std::vector<Real> lengths;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        // The difference of the distances from the nearer edge, which cancels less.
        lengths.push_back(cuts[i].left < cuts[i + 1].right
                              ? Real(cuts[i + 1].left - cuts[i].left)
                              : Real(cuts[i].right - cuts[i + 1].right));
    }
    std::size_t point_cut = 0;
    while (!cuts[point_cut].is_point) {
        ++point_cut;
    }
    std::vector<Real> gap(lengths.size(),
                          Real(0)); // distance from x to the nearer end of each interval
    for (std::size_t i = point_cut + 1; i < lengths.size(); ++i) {
        gap[i] = gap[i - 1] + lengths[i - 1];
    }
    for (std::size_t i = point_cut; i-- > 1;) {
        gap[i - 1] = gap[i] + lengths[i];
    }
    const Real at_x = slope.value(piece_of_x, at.x);
    const auto integrand = [&](std::size_t i, const Real& lo, const Real& hi) {
        const Real right = cuts[i + 1].right + hi;
        const Real left = cuts[i].left + lo;
        // s - x as a sum of lengths. Their roundoff is the same at every node, so that the
        // integrand is smooth.
        const Real delta = i < point_cut ? Real(-(hi + gap[i])) : Real(lo + gap[i]);
        const Real w = sqrt(Real(right * left));
        // s from the nearer cut. Near the origin, where |s|^m is steep, s is equal to that
        // distance.
        const Real s = lo < hi ? Real(cuts[i].x + lo) : Real(cuts[i + 1].x - hi);
        const auto& knot = lo < hi ? cuts[i].knot : cuts[i + 1].knot;
        const Real away = lo < hi ? lo : Real(-hi); // the distance from that cut
        if (piece_of[i] == piece_of_x) {
            return Real((knot ? slope.quotient(piece_of_x, at.x, s, delta, {*knot, away})
                              : slope.quotient(piece_of_x, at.x, s, delta)) /
                        w);
        }
        const Real at_s =
            knot ? slope.value(piece_of[i], s, {*knot, away}) : slope.value(piece_of[i], s);
        // docs/pressure.md, "The singular integral, and how its pole is taken out"
        return Real((at_s - at_x) / (delta * w));
    };
    const auto result = quadrature::integrate_pieces<Real>(integrand, lengths, Real(0), Real(0),
                                                           {.target_digits = target_digits});
    // moore-hills EQ01
    const Real factor =
        law.contact_modulus() / (Real(2) * pi<Real>()) * sqrt(Real(at.right * at.left));
    return {Real(factor * result.value), result.estimate, result.evaluations, result.converged};
}

} // namespace edgeproof::contact
