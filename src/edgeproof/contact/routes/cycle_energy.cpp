// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/routes/cycle_energy.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/quadrature/near_singularity.hpp"

#include <algorithm>
#include <vector>

namespace edgeproof::contact {
namespace {

/// Places of the right edge between `from` and `to` at which one of the edges is on a knot, and
/// both ends.
std::vector<Real> knots_passed(const ContactLaw<Real>& law, const Profile& profile,
                               const Real& from, const Real& to) {
    std::vector<Real> cuts{from, to};
    const Real far = law.left_edge(to);
    for (const formula::Exact& knot : profile.knots()) {
        const Real v = knot.to<Real>();
        if (v > from && v < to) {
            cuts.push_back(v);
        }
        if (!law.symmetric() && v < 0 && -v < far) {
            const Real a = law.right_edge(Real(-v));
            if (a > from && a < to) {
                cuts.push_back(a);
            }
        }
    }
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

} // namespace

Real cycle_energy(const NormalContact& contact, const PartialSlip& slip,
                  const formula::Exact& friction) {
    constexpr unsigned guard = 10;
    const PrecisionScope scope(contact.digits() + 2 * guard);
    const Real modulus = contact.contact_modulus().to<Real>();
    const ContactLaw<Real> law(contact.profile(), modulus, contact.digits() + guard);
    const Real P = contact.force();
    const Real least = P * (1 - slip.load_ratio());
    const Real mean = (P + least) / 2;
    const Real D = contact.a() + contact.b();
    const std::vector<Real> cuts = knots_passed(
        law, contact.profile(), Real(contact.a() - slip.size(Edge::right)), contact.a());
    std::vector<Real> lengths;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        lengths.push_back(Real(cuts[i + 1] - cuts[i]));
    }
    const auto f = [&](std::size_t i, const Real& lo, const Real& /*hi*/) {
        check_interruption();
        const Extent<Real> e = law.extent(Real(cuts[i] + lo));
        return Real((law.force(e) - mean) * log(Real((e.a + e.b) / D)) * law.force_rate(e));
    };
    const auto sum = quadrature::integrate_pieces<Real>(
        f, lengths, Real(0), Real(0), {.target_digits = contact.digits() + guard / 2});
    if (!sum.converged) {
        throw BudgetError("the quadrature for the energy of a cycle did not converge");
    }
    const Real f_s = friction.to<Real>();
    return 16 * f_s * f_s / (pi<Real>() * modulus) * sum.value;
}

} // namespace edgeproof::contact
