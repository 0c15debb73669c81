// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/witness/witness.hpp"

#include "edgeproof/contact/witness/edge_equations.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace edgeproof::contact {

using witness::EdgeEquations;
using witness::Ends;
using witness::Integral;
using witness::Place;

namespace {

constexpr unsigned guard_digits = 20;
/// A point is separated from a knot down to this many decades below roundoff.
constexpr unsigned knot_decades = 400;
constexpr unsigned curved_knot_decades = 60; ///< for curved slopes, which need quadratures
/// An edge that is solved for and lies this many decades nearer to a knot than the contact's length
/// is taken to be on the knot.
constexpr unsigned edge_decades = 60;
constexpr unsigned most_lost = 100000;

/// The number of decades by which |x| lies below `scale`; 0 if it does not.
unsigned decades_below(const Real& x, const Real& scale) {
    if (x == 0 || !(abs(x) < scale)) {
        return 0;
    }
    return static_cast<unsigned>(ceil(log10(Real(scale / abs(x)))));
}

Place place_at(const Ends& e, Edge edge, const Real& u) {
    const Real other = e.length() - u;
    if (!(u > 0) || !(other > 0)) {
        throw DomainError("a point lies outside the contact");
    }
    return edge == Edge::right ? Place{u, other, Real(e.a - u)} : Place{other, u, Real(u - e.b)};
}

/// Barber-Mossakovskii for x >= 0 (moore-hills EQ21, first branch; for b = a it is EQ03):
/// superposed flat punches of extent (-b(s), s). `mirror`: the equations of the mirrored profile.
Integral mossakovskii(const EdgeEquations& law, const EdgeEquations& mirror, bool symmetric,
                      const Ends& e, const Place& at, unsigned target_digits) {
    // The places in (0, a) where P'(s) or b(s) is not analytic, since s or -b(s) is a knot. Those
    // that are solved for have twice the digits.
    std::vector<Real> kinks;
    {
        const PrecisionScope twice(2 * working_digits());
        for (const Real& knot : law.slope().knots()) {
            if (knot > 0 && knot < e.a) {
                kinks.push_back(knot);
            } else if (knot < 0 && -knot < e.b && !symmetric) {
                kinks.push_back(mirror.ends_at(Real(-knot)).b);
            }
        }
    }
    std::sort(kinks.begin(), kinks.end());
    // The nearest kink below x gives the distance of a singularity from the first interval. At the
    // apex it is the origin itself.
    Real below(0);
    std::vector<Real> starts{at.x};
    std::vector<Real> offsets{Real(0)}; // distances of the starts from x
    for (const Real& s : kinks) {
        const Real offset = s - at.x;
        if (!(offset > 0)) {
            below = s;
        } else if (offset < at.right) {
            starts.push_back(s);
            offsets.push_back(offset);
        }
    }
    std::vector<Real> lengths;
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        lengths.push_back((i + 1 < offsets.size() ? offsets[i + 1] : at.right) - offsets[i]);
    }
    const auto integrand = [&](std::size_t i, const Real& lo, const Real&) {
        const Real from_x = offsets[i] + lo;
        // Beyond a corner P'(s) grows like (s - knot)^(-1/2): s needs the digits of s - knot.
        const PrecisionScope scope(working_digits() +
                                   (i > 0 ? witness::digits_lost(starts[i], lo) : 0));
        const Ends then = law.ends_at(Real(starts[i] + lo));
        return Real(law.rate(then, Edge::right) / sqrt(Real(from_x * (at.x + then.b))));
    };
    return quadrature::integrate_pieces(integrand, lengths, Real(at.x - below), Real(0),
                                        {.target_digits = target_digits});
}

} // namespace

std::string route_name(Route route) {
    return route == Route::singular_integral ? "singular-integral" : "barber-mossakovskii";
}

/// The contact solved at one working precision.
struct Witness::Solved {
    Solved(const Profile& profile, const Exact& modulus, const Load& load)
        : law(profile, modulus), mirror(profile.reflected(), modulus), ends(law.ends(load)) {}
    EdgeEquations law;
    EdgeEquations mirror;
    Ends ends;
};

Witness::~Witness() = default;
Witness::Witness(Witness&&) noexcept = default;
Witness& Witness::operator=(Witness&&) noexcept = default;

Witness::Witness(Profile profile, Exact contact_modulus, Load load, unsigned digits)
    : profile_(std::move(profile)), modulus_(std::move(contact_modulus)), load_(std::move(load)),
      digits_(digits) {
    if (modulus_.sign() <= 0) {
        throw InputError("the contact modulus " + modulus_.text() + " is not positive",
                         "give E* > 0");
    }
    if (load_.value.sign() <= 0) {
        const bool by_force = load_.kind == Load::Kind::force;
        throw InputError(
            std::string(by_force ? "the normal force P = " : "the contact half-width a = ") +
                load_.value.text() + " is not positive",
            by_force ? "give P > 0" : "give a > 0");
    }
    // The precision is raised until the smallest gap between an edge and a knot has enough digits.
    base_working_ = digits_ + guard_digits;
    for (unsigned needed = base_working_;;) {
        base_working_ = needed;
        const PrecisionScope scope(base_working_);
        const Solved& s = at(base_working_);
        bool taken = false;
        unsigned lost = 0;
        for (std::size_t i = 0; i < s.law.slope().knots().size(); ++i) {
            const Real& knot = s.law.slope().knots()[i];
            for (const Edge edge : {Edge::right, Edge::left}) {
                auto& on_knot = edge == Edge::right ? a_on_knot_ : b_on_knot_;
                const Real gap =
                    edge == Edge::right ? Real(s.ends.a - knot) : Real(s.ends.b + knot);
                if (on_knot == i || (gap == 0 && !solved_for(edge))) {
                    continue;
                }
                const unsigned decades =
                    gap == 0 ? base_working_ : decades_below(gap, s.ends.length());
                if (solved_for(edge) && decades >= edge_decades &&
                    decades + guard_digits >= base_working_) {
                    on_knot = i;
                    taken = true;
                }
                lost = std::max(lost, decades);
            }
        }
        if (taken) {
            solved_.clear();
            needed = digits_ + guard_digits;
            continue;
        }
        needed = digits_ + guard_digits + 2 * lost;
        if (needed <= base_working_) {
            return;
        }
        if (lost > most_lost) {
            throw BudgetError("an edge lies within 1e-100000 of a knot");
        }
    }
}

bool Witness::solved_for(Edge edge) const {
    return load_.kind == Load::Kind::force || (edge == Edge::left && !profile_.symmetric());
}

bool Witness::exactly_on(std::size_t knot, Edge edge, const Exact& u) const {
    if (solved_for(edge)) {
        return false;
    }
    const Expr& x = profile_.knots()[knot].expr();
    const Expr& a = load_.value.expr();
    try {
        return Exact((edge == Edge::right ? a - x : a + x) - u.expr()).sign() == 0;
    } catch (const BudgetError&) {
        return false;
    }
}

Witness::Solved& Witness::at(unsigned working) const {
    auto& slot = solved_[working];
    if (!slot) {
        const PrecisionScope scope(working);
        slot = std::make_unique<Solved>(profile_, modulus_, load_);
        if (a_on_knot_) {
            slot->ends.a = slot->law.slope().knots()[*a_on_knot_];
        }
        if (b_on_knot_) {
            slot->ends.b = -slot->law.slope().knots()[*b_on_knot_];
        }
    }
    return *slot;
}

Real Witness::a() const { return at(base_working_).ends.a; }
Real Witness::b() const { return at(base_working_).ends.b; }
Real Witness::force() const {
    const PrecisionScope scope(base_working_);
    const Solved& s = at(base_working_);
    return s.law.force(s.ends);
}
Real Witness::moment() const {
    const PrecisionScope scope(base_working_);
    const Solved& s = at(base_working_);
    return s.law.moment(s.ends);
}

Witness::Pressure Witness::pressure(Edge edge, const Exact& u, Route route) const {
    // The nearest knot, and the digits that x - knot loses.
    std::optional<std::size_t> on_knot;
    unsigned lost = 0;
    const unsigned closer = profile_.piecewise_linear() ? knot_decades : curved_knot_decades;
    for (const unsigned working : {base_working_, base_working_ + closer}) {
        const PrecisionScope scope(working);
        const Solved& s = at(working);
        const Place place = place_at(s.ends, edge, u.to<Real>());
        on_knot.reset();
        lost = 0;
        for (std::size_t i = 0; i < s.law.slope().knots().size(); ++i) {
            const Real& knot = s.law.slope().knots()[i];
            const Real gap = edge == Edge::right ? Real(s.ends.a - knot - place.right)
                                                 : Real(s.ends.b + knot - place.left);
            const unsigned decades = decades_below(gap, s.ends.length());
            lost = std::max(lost, decades);
            if (gap == 0 || decades + 7 >= working) {
                on_knot = i;
            }
        }
        if (!on_knot || exactly_on(*on_knot, edge, u)) {
            break;
        }
    }
    // In steps of 16 digits, so that neighbouring points share a solved contact.
    const unsigned working = base_working_ + (on_knot || lost <= 3 ? 0 : (2 * lost + 15) / 16 * 16);
    const PrecisionScope scope(working);
    Solved& s = at(working);
    Place place = place_at(s.ends, edge, u.to<Real>());
    if (on_knot) {
        if (profile_.has_corner(*on_knot)) {
            throw DomainError("the pressure is infinite at a corner of the profile");
        }
        const Real& knot = s.law.slope().knots()[*on_knot];
        place = {Real(s.ends.a - knot), Real(s.ends.b + knot), knot};
    }
    const unsigned target = digits_ + guard_digits / 2;
    Integral p;
    if (route == Route::singular_integral) {
        p = s.law.difference_integral(s.ends, place, target);
        p.value *= s.law.modulus() / 2 * sqrt(Real(place.right * place.left));
    } else if (place.x < 0) {
        // moore-hills EQ21, second branch: the first branch of the mirrored problem.
        p = mossakovskii(s.mirror, s.law, profile_.symmetric(), {s.ends.b, s.ends.a},
                         {place.left, place.right, Real(-place.x)}, target);
    } else {
        p = mossakovskii(s.law, s.mirror, profile_.symmetric(), s.ends, place, target);
    }
    if (!p.converged) {
        throw BudgetError("the quadrature of " + route_name(route) +
                          " did not converge within its levels");
    }
    // The working precision has made up for the digits lost in gaps.
    const Real roundoff = pow(Real(10), -static_cast<int>(target));
    return {Real(p.value / pi<Real>()), std::max(p.estimate, roundoff), p.evaluations, working};
}

} // namespace edgeproof::contact
