// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/routes/cycle_energy.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/quadrature/near_singularity.hpp"

#include <algorithm>
#include <vector>

namespace edgeproof::contact {
namespace {

/// The places of the right edge between `from` and `to` at which an edge is on a knot, and both
/// ends, in ascending order.
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
    // P - L and L - L_s are of the order of tau P. Near a knot that an edge passes, the rates
    // behave like a root of the edge's distance from the knot, at a corner like the inverse of a
    // root; this distance has only the digits of the edge itself.
    const Real decades = -log10(slip.load_ratio());
    const unsigned wanted =
        2 * (contact.digits() + guard) + (decades > 0 ? static_cast<unsigned>(ceil(decades)) : 0);
    const PrecisionScope scope(wanted + guard);
    const Real modulus = contact.contact_modulus().to<Real>();
    const ContactLaw<Real> law(contact.profile(), modulus, wanted);
    const Real a = contact.a();
    const Real P = law.force(law.extent(a));
    const Real least = P * (1 - slip.load_ratio());
    const std::vector<Real> cuts =
        knots_passed(law, contact.profile(), Real(a - slip.size(Edge::right)), a);
    std::vector<Real> lengths;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        lengths.push_back(Real(cuts[i + 1] - cuts[i]));
    }
    const auto f = [&](std::size_t i, const Real& lo, const Real& /*hi*/) {
        check_interruption();
        const Extent<Real> e = law.extent(Real(cuts[i] + lo));
        const Real L = law.force(e);
        const Real growth = 1 + law.force_rate(e) / law.left_force_rate(e); // dD/da
        // docs/partial-slip.md, "The energy of a cycle"
        return Real((P - L) * (L - least) * growth / e.length());
    };
    const auto sum = quadrature::integrate_pieces<Real>(
        f, lengths, Real(0), Real(0), {.target_digits = contact.digits() + guard / 2});
    if (!sum.converged) {
        throw BudgetError("the quadrature for the energy of a cycle did not converge");
    }
    const Real f_s = friction.to<Real>();
    return 8 * f_s * f_s / (pi<Real>() * modulus) * sum.value;
}

} // namespace edgeproof::contact
