// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/routes/partial_slip.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/quadrature/near_singularity.hpp"

#include <algorithm>
#include <vector>

namespace edgeproof::contact {
namespace {

constexpr unsigned coarse_slip_digits = 15;
constexpr unsigned slip_guard_digits = 10;
constexpr int most_slip_steps = 60;

InputError beyond(const std::string& what, const std::string& instead) { return {what, instead}; }

} // namespace

PartialSlip::PartialSlip(const NormalContact& contact, const ShearSpec& shear)
    : contact_(contact), shear_(shear) {
    const PrecisionScope scope(contact.digits() + 2 * slip_guard_digits);
    if (!(load_ratio() < 1)) {
        throw beyond("|Q| is not below f P: the contact slides",
                     "give |Q| < f P, or leave friction out");
    }
    // First with few digits and in parts of the load, so that each start is near its solution.
    const NormalContact coarse(Profile(contact.profile()), contact.contact_modulus(),
                               contact.load(), coarse_slip_digits);
    Zones d{Real(0), Real(0)};
    {
        const PrecisionScope few(coarse_slip_digits + 2 * slip_guard_digits);
        Asked at = asked(coarse);
        const Real whole = at.force;
        const Real c_right = coarse.expansion(Edge::right, 1)[0];
        const Real c_left = coarse.expansion(Edge::left, 1)[0];
        // the first terms of the series: d_1 (docs/partial-slip.md, "The series")
        const Real lead = 2 * whole / (pi<Real>() * sqrt(at.D));
        const Zones first{Real(lead * (1 + at.turn * at.D) / c_right),
                          Real(lead * (1 - at.turn * at.D) / c_left)};
        Real part(0);
        for (const char* next : {"0.1", "0.3", "0.6", "1"}) {
            const Real to(next);
            at.force = whole * to;
            const Real scale = part > 0 ? Real(to / part) : Real(1);
            d = part > 0 ? Zones{Real(d.right * scale), Real(d.left * scale)}
                         : Zones{Real(first.right * to), Real(first.left * to)};
            const Real most = at.D * Real("0.98");
            const Real sum = d.right + d.left;
            if (sum > most) {
                d.right *= most / sum;
                d.left *= most / sum;
            }
            d = solve(at, d);
            part = to;
        }
    }
    d_ = solve(asked(contact), {Real(d.right), Real(d.left)});
}

PartialSlip::Asked PartialSlip::asked(const NormalContact& contact) const {
    return {contact, Real(contact.a() + contact.b()),
            Real(abs(shear_.Q.to<Real>()) / shear_.friction->to<Real>()),
            Real(pi<Real>() * shear_.bulk_tension.to<Real>() / shear_.Q.to<Real>() / 8),
            contact.digits() + slip_guard_digits / 2};
}

/// The integral of p kernel(u, d - u) over a slip zone, cut at the knots in the zone.
template <class F>
Real PartialSlip::over_zone(const Asked& at, Edge edge, const Real& d, const F& kernel) {
    std::vector<Real> cuts{Real(0)};
    for (const Exact& knot : at.contact.profile().knots()) {
        const Real v = knot.to<Real>();
        const Real u = edge == Edge::right ? Real(at.contact.a() - v) : Real(at.contact.b() + v);
        if (u > 0 && u < d) {
            cuts.push_back(u);
        }
    }
    cuts.push_back(d);
    std::sort(cuts.begin(), cuts.end());
    std::vector<Real> lengths;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        lengths.push_back(Real(cuts[i + 1] - cuts[i]));
    }
    // At a corner p grows like a logarithm. Nodes nearer to it than this take the pressure at this
    // distance.
    const Real near = at.D * pow(Real(10), -static_cast<int>(at.target));
    const auto f = [&](std::size_t i, const Real& lo, const Real& hi) {
        const Real least = std::min(near, Real(lengths[i] / 2));
        const bool last = i + 2 == cuts.size();
        Real u = cuts[i] + lo;
        const Real rest = last ? hi : Real(d - cuts[i + 1] + hi);
        const Real weight = kernel(u, rest);
        if (i > 0 && lo < least) {
            u = cuts[i] + least;
        } else if (!last && hi < least) {
            u = cuts[i + 1] - least;
        }
        return Real(at.contact.pressure(edge, u).value * weight);
    };
    const auto sum = quadrature::integrate_pieces<Real>(f, lengths, Real(0), Real(0),
                                                        {.target_digits = at.target});
    if (!sum.converged) {
        throw BudgetError("the quadrature over a slip zone did not converge");
    }
    return sum.value;
}

/// The residuals of the two equations of the header, divided by |Q|/f.
PartialSlip::Balance PartialSlip::off(const Asked& at, const Zones& d) {
    check_interruption();
    const Real stick = at.D - d.right - d.left;
    const auto side = [&](Edge edge) {
        const Real& near = edge == Edge::right ? d.right : d.left;
        const Real& far = edge == Edge::right ? d.left : d.right;
        const Real here = over_zone(at, edge, near, [&](const Real& /*u*/, const Real& rest) {
            return Real(sqrt(Real((stick + rest) / rest)));
        });
        const Real there =
            over_zone(at, opposite(edge), far, [&](const Real& /*u*/, const Real& rest) {
                return Real(sqrt(Real(rest / (stick + rest))));
            });
        const Real turn = edge == Edge::right ? at.turn : Real(-at.turn);
        return Real((here + there) / (at.force) - (1 + turn * stick));
    };
    return {side(Edge::right), side(Edge::left)};
}

/// Solves the two equations by Broyden's method (`broyden1965`); the first matrix is by
/// differences.
PartialSlip::Zones PartialSlip::solve(const Asked& at, Zones d) {
    const Real tiny = pow(Real(10), -static_cast<int>(at.contact.digits() + 2));
    const Real step("1e-6");
    Balance f = off(at, d);
    const Balance by_right = off(at, {Real(d.right * (1 + step)), d.left});
    const Balance by_left = off(at, {d.right, Real(d.left * (1 + step))});
    // The derivatives with respect to the logarithms of the sizes.
    Real rr = (by_right.right - f.right) / step;
    Real lr = (by_right.left - f.left) / step;
    Real rl = (by_left.right - f.right) / step;
    Real ll = (by_left.left - f.left) / step;
    for (int k = 0; k < most_slip_steps; ++k) {
        const Real determinant = rr * ll - rl * lr;
        Real x = -(f.right * ll - f.left * rl) / determinant;
        Real y = -(f.left * rr - f.right * lr) / determinant;
        const Real most = std::max(Real(abs(x)), Real(abs(y)));
        if (most > Real("0.5")) {
            x /= 2 * most;
            y /= 2 * most;
        }
        const Zones next{Real(d.right * (1 + x)), Real(d.left * (1 + y))};
        if (!(next.right + next.left < at.D) || !(most == most)) {
            break;
        }
        d = next;
        if (most < tiny) {
            return d;
        }
        const Balance g = off(at, d);
        // Broyden's update of the matrix
        const Real size = x * x + y * y;
        const Real u = (g.right - f.right - rr * x - rl * y) / size;
        const Real v = (g.left - f.left - lr * x - ll * y) / size;
        rr += u * x;
        rl += u * y;
        lr += v * x;
        ll += v * y;
        f = g;
    }
    throw BudgetError("no slip zones were found in the pressure: the stick zone may reach an edge "
                      "of the contact");
}

Real PartialSlip::load_ratio() const {
    return abs(shear_.Q.to<Real>()) / (shear_.friction->to<Real>() * contact_.force());
}

Real PartialSlip::size(Edge edge) const { return edge == Edge::right ? d_.right : d_.left; }

Real PartialSlip::estimate() const { return pow(Real(10), -static_cast<int>(contact_.digits())); }

bool PartialSlip::sticks(Edge edge, const Real& u) const {
    const Real D = contact_.a() + contact_.b();
    return u > size(edge) && D - u > size(opposite(edge));
}

Real PartialSlip::traction(Edge edge, const Exact& u) const {
    const PrecisionScope scope(contact_.digits() + 2 * slip_guard_digits);
    const Real from = u.to<Real>();
    const Real f = shear_.friction->to<Real>() * shear_.Q.sign();
    if (!sticks(edge, from)) {
        return f * contact_.pressure(edge, u).value;
    }
    const Asked at = asked(contact_);
    const Real stick = at.D - d_.right - d_.left;
    const Real near = from - size(edge); // distance from this end of the stick zone
    const Real far = stick - near;
    const auto side = [&](Edge zone) {
        const Real& gap = zone == edge ? near : far;
        return over_zone(at, zone, size(zone), [&](const Real& /*u*/, const Real& rest) {
            return Real(1 / (sqrt(Real(rest * (stick + rest))) * (gap + rest)));
        });
    };
    // docs/partial-slip.md, "The second route"
    return f * sqrt(Real(near * far)) / pi<Real>() * (side(Edge::right) + side(Edge::left));
}

SlipSeries<Real> PartialSlip::series(std::size_t terms) const {
    const Real D = contact_.a() + contact_.b();
    const Real P = contact_.force();
    const Real ratio = shear_.bulk_tension.to<Real>() / shear_.Q.to<Real>();
    return slip_series<Real>(
        contact_.expansion(Edge::right, terms), contact_.expansion(Edge::left, terms), D,
        Real(2 * P / (pi<Real>() * sqrt(D))), Real(P * ratio / (4 * sqrt(D))), terms, Real(1));
}

namespace {

/// The places of the right edge between `from` and `to` at which an edge is on a knot, and both
/// ends, in ascending order.
std::vector<Real> knots_passed(const ContactLaw<Real>& law, const Profile& profile,
                               const Real& from, const Real& to) {
    std::vector<Real> cuts{from, to};
    const Real far = law.left_edge(to);
    for (const Exact& knot : profile.knots()) {
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

Real cycle_energy(const NormalContact& contact, const PartialSlip& slip, const Exact& friction) {
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
