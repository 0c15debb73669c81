// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/routes/pressure_routes.hpp"
#include "edgeproof/precision/arithmetic.hpp"

#include <algorithm>
#include <vector>

namespace edgeproof::contact {
namespace {

/// The number of decimal digits by which part is smaller than s; 0 if it is not smaller.
unsigned digits_lost(const Real& s, const Real& part) {
    constexpr double digits_a_bit = 0.30103;
    const auto bits = mpfr_get_exp(s.backend().data()) - mpfr_get_exp(part.backend().data());
    return bits > 0 && part > 0
               ? static_cast<unsigned>(digits_a_bit * static_cast<double>(bits)) + 1
               : 0;
}

/// The places in (0, a) where P'(s) or b(s) is not analytic, since s or -b(s) is a knot, in
/// ascending order. Places that are solved for have twice the digits of the thread.
std::vector<Real> kinks(const ContactLaw<Real>& law, const Extent<Real>& e) {
    const PrecisionScope twice(2 * working_digits());
    std::vector<Real> s;
    for (const Real& knot : law.slope().knots()) {
        if (knot > Real(0) && knot < e.a) {
            s.push_back(knot);
        } else if (knot < Real(0) && -knot < e.b && !law.symmetric()) {
            s.push_back(law.right_edge(Real(-knot)));
        }
    }
    std::sort(s.begin(), s.end());
    return s;
}

} // namespace

RoutedPressure barber_mossakovskii(const ContactLaw<Real>& law, const Extent<Real>& e,
                                   const Point<Real>& at, unsigned target_digits) {
    if (at.x < Real(0)) {
        throw DomainError("the right branch of Barber-Mossakovskii holds for x >= 0");
    }
    // P' and b(s) are not analytic at the kinks below x either: the nearest one gives the distance
    // of a singularity from the first interval. At the apex it is the origin itself.
    Real below(0);
    std::vector<Real> starts{at.x};
    std::vector<Real> offsets{Real(0)}; // distances of the starts from x
    for (const Real& s : kinks(law, e)) {
        const Real offset = s - at.x;
        if (!(offset > Real(0))) {
            below = s;
        } else if (offset < at.right) {
            starts.push_back(s);
            offsets.push_back(offset);
        }
    }
    const Real beyond = at.x - below;
    std::vector<Real> lengths;
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        lengths.push_back((i + 1 < offsets.size() ? offsets[i + 1] : at.right) - offsets[i]);
    }
    const auto integrand = [&](std::size_t i, const Real& lo, const Real&) {
        const Real from_x = offsets[i] + lo;
        // Beyond a corner P'(s) grows like (s - knot)^(-1/2): s needs the digits of s - knot.
        const PrecisionScope near_the_kink(working_digits() +
                                           (i > 0 ? digits_lost(starts[i], lo) : 0));
        const Real s = starts[i] + lo;
        const Extent<Real> then = law.extent(s);
        const Real rate = law.force_rate(then);
        // moore-hills EQ21, first branch
        return Real(rate / sqrt(Real(from_x * (at.x + then.b))));
    };
    const auto result = quadrature::integrate_pieces<Real>(integrand, lengths, beyond, Real(0),
                                                           {.target_digits = target_digits});
    return {Real(result.value / pi<Real>()), result.estimate, result.evaluations, result.converged};
}

} // namespace edgeproof::contact
