// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/routes/normal_contact.hpp"

#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/contact/routes/pressure_routes.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace edgeproof::contact {

namespace {

/// An edge that is solved for, and lies this many decades nearer to a knot than the contact's
/// length, is taken to be on the knot.
constexpr unsigned edge_decades = 300;
constexpr unsigned curved_edge_decades = 60; ///< for curved slopes, which need quadratures

/// The number of decades by which x lies below `scale`; 0 if it does not.
unsigned decades_below(const Real& x, const Real& scale) {
    if (!(x > 0) || !(x < scale)) {
        return 0;
    }
    // Some integrals call this at every node; the logarithm in binary64 is accurate enough.
    long of_x = 0;
    long of_scale = 0;
    const double leading = mpfr_get_d_2exp(&of_scale, scale.backend().data(), MPFR_RNDN) /
                           mpfr_get_d_2exp(&of_x, x.backend().data(), MPFR_RNDN);
    return static_cast<unsigned>(
        std::ceil(std::log10(leading) + static_cast<double>(of_scale - of_x) * std::log10(2.0)));
}

} // namespace

inline constexpr unsigned guard_digits = 20;
/// A point given exactly is separated from a knot down to this many decades below roundoff.
inline constexpr unsigned knot_decades = 400;

/// The contact solved at one working precision. The mirrored law serves points left of the origin.
struct NormalContact::Solved {
    Solved(const Profile& profile, const Exact& modulus, const Load& load, unsigned target)
        : target_digits(target), roundoff(pow(Real(10), -static_cast<int>(target))),
          law(profile, modulus.to<Real>(), target), extent{} {
        const Real value = load.value.to<Real>();
        extent = law.extent(load.kind == Load::Kind::right_edge ? value
                                                                : law.right_edge_for_force(value));
    }
    /// The marks of the knots (kernels.hpp), computed at the first use.
    Marks<Real, Real>& marks() {
        if (!known_marks) {
            known_marks.emplace(extent, law.slope().knots());
        }
        return *known_marks;
    }
    PowerLawPressure& power_law(const Exact& m) {
        if (!known_power_law) {
            known_power_law.emplace(m, law, extent, target_digits);
        }
        return *known_power_law;
    }
    const ContactLaw<Real>& mirrored(const Profile& profile, const Exact& modulus) {
        if (!mirror) {
            mirror = std::make_unique<ContactLaw<Real>>(profile.reflected(), modulus.to<Real>(),
                                                        target_digits);
        }
        return *mirror;
    }
    /// The smallest positive distance of an edge from a knot, which determines the cancellation in
    /// a - knot and b + knot.
    [[nodiscard]] Real smallest_gap() const {
        Real gap = extent.length();
        for (const Real& knot : law.slope().knots()) {
            for (const Real& d : {Real(abs(extent.a - knot)), Real(abs(extent.b + knot))}) {
                if (d > 0 && d < gap) {
                    gap = d;
                }
            }
        }
        return gap;
    }

    unsigned target_digits;
    Real roundoff; ///< the relative roundoff of all values computed with it
    ContactLaw<Real> law;
    Extent<Real> extent;
    std::unique_ptr<ContactLaw<Real>> mirror;
    std::optional<Marks<Real, Real>> known_marks;
    std::optional<PowerLawPressure> known_power_law;
};

std::string route_name(Route route) {
    switch (route) {
    case Route::barber_mossakovskii:
        return "barber-mossakovskii";
    case Route::singular_integral:
        return "singular-integral";
    case Route::closed_form:
        return "closed-form";
    case Route::automatic:
        break;
    }
    return "automatic";
}

NormalContact::~NormalContact() = default;
NormalContact::NormalContact(NormalContact&&) noexcept = default;
NormalContact& NormalContact::operator=(NormalContact&&) noexcept = default;

Real NormalContact::a() const { return at(base_working_).extent.a; }
Real NormalContact::b() const { return at(base_working_).extent.b; }
Real NormalContact::force() const {
    const PrecisionScope scope(base_working_);
    const Solved& s = at(base_working_);
    return s.law.force(s.extent);
}
Real NormalContact::moment() const {
    const PrecisionScope scope(base_working_);
    const Solved& s = at(base_working_);
    return s.law.moment(s.extent);
}

/// P^(k)(a), a multiple of a coefficient of the law's series.
Real NormalContact::force_derivative(unsigned k) const {
    if (k == 0) {
        return force();
    }
    const PrecisionScope scope(base_working_);
    const Solved& s = at(base_working_);
    Real d = s.law.series(s.extent, k).force_rate[k - 1];
    for (unsigned j = 2; j < k; ++j) {
        d *= j;
    }
    return d;
}

Real NormalContact::left_edge_derivative(unsigned k) const {
    if (k == 0) {
        return b();
    }
    const PrecisionScope scope(base_working_);
    const Solved& s = at(base_working_);
    Real d = s.law.series(s.extent, k + 1).b[k];
    for (unsigned j = 2; j <= k; ++j) {
        d *= j;
    }
    return d;
}

Route NormalContact::chosen(Route route) const {
    if (route != Route::automatic) {
        return route;
    }
    return profile_.has_closed_form() ? Route::closed_form : Route::singular_integral;
}

Estimated NormalContact::pressure(Edge edge, const Exact& u, Route route) const {
    const auto read = [&](unsigned working) {
        const PrecisionScope scope(working);
        return u.to<Real>();
    };
    route = chosen(route);
    Look found = look(read(base_working_), edge, base_working_, route);
    if (found.on_knot) {
        const unsigned closer = base_working_ + knot_decades;
        found = look(read(closer), edge, closer, route);
    }
    return pressure_at(edge, read(found.working), route, found);
}

Estimated NormalContact::pressure(Edge edge, const Real& u, Route route) const {
    route = chosen(route);
    return pressure_at(edge, u, route, look(u, edge, base_working_, route));
}

Estimated NormalContact::pressure_at(Edge edge, const Real& u, Route route,
                                     const Look& found) const {
    const unsigned working = found.working;
    Solved& s = at(working);
    const PrecisionScope scope(working);
    Point<Real> point = point_at(s.extent, edge, u);
    if (found.on_knot) {
        if (profile_.has_corner(*found.on_knot)) {
            throw DomainError("the pressure is infinite at a corner of the profile");
        }
        const Real& knot = s.law.slope().knots()[*found.on_knot];
        point = {Real(s.extent.a - knot), Real(s.extent.b + knot), knot};
    }
    RoutedPressure p{};
    const unsigned target = digits_ + guard_digits / 2;
    switch (route) {
    case Route::barber_mossakovskii:
        if (point.x < 0) {
            // moore-hills EQ21, second branch: the first branch of the mirrored problem.
            const auto& mirror = s.mirrored(profile_, modulus_);
            const Extent<Real> e{s.extent.b, s.extent.a};
            p = barber_mossakovskii(mirror, e, Point<Real>{point.left, point.right, Real(-point.x)},
                                    target);
        } else {
            p = barber_mossakovskii(s.law, s.extent, point, target);
        }
        break;
    case Route::singular_integral:
        p = singular_integral(s.law, s.extent, point, target);
        break;
    default:
        if (!profile_.has_closed_form()) {
            throw DomainError("only a piecewise linear slope or a power law has a closed form");
        }
        p = profile_.piecewise_linear() ? logarithmic_closed_form(s.law, s.marks(), point)
                                        : s.power_law(profile_.parameters().at("m"))(point);
        break;
    }
    if (!p.converged) {
        throw BudgetError("the quadrature of " + route_name(route) +
                          " did not converge within its levels");
    }
    // The roundoff of the whole computation; the working precision has made up for the digits lost
    // in gaps.
    return {p.value, std::max(p.estimate, s.roundoff), route, p.evaluations, working};
}

std::vector<Real> NormalContact::expansion(Edge edge, std::size_t terms) const {
    // High coefficients are sums in which terms of the size of binomial coefficients cancel.
    const unsigned working = base_working_ + static_cast<unsigned>(terms);
    const Solved& s = at(working);
    const PrecisionScope scope(working);
    return edge_expansion(s.law, s.extent, edge, terms);
}

Real NormalContact::convergence_radius(Edge edge) const {
    const Solved& s = at(base_working_);
    const PrecisionScope scope(base_working_);
    Real radius = s.extent.length();
    for (const Real& knot : s.law.slope().knots()) {
        const Real d = edge == Edge::right ? Real(s.extent.a - knot) : Real(s.extent.b + knot);
        if (d > 0 && d < radius) {
            radius = d;
        }
    }
    return radius;
}

// The working precision is that of the digits requested, and of those that the formulas of
// docs/pressure.md lose if edges, knots and points lie close.
NormalContact::NormalContact(Profile profile, Exact contact_modulus, Load load, unsigned digits)
    : profile_(std::move(profile)), modulus_(std::move(contact_modulus)), load_(std::move(load)),
      digits_(digits) {
    if (modulus_.sign() <= 0) {
        throw InputError("the contact modulus " + modulus_.text() + " is not positive",
                         "give E* > 0");
    }
    if (load_.value.sign() <= 0) {
        const bool edge = load_.kind == Load::Kind::right_edge;
        throw InputError(
            std::string(edge ? "the contact half-width a = " : "the normal force P = ") +
                load_.value.text() + " is not positive",
            edge ? "give a > 0" : "give P > 0");
    }
    // The precision is raised until the smallest gap has enough digits.
    unsigned working = digits_ + guard_digits;
    for (;;) {
        const Solved& s = at(working);
        const PrecisionScope scope(working);
        // An edge equal to a knot lies nearer to it than these digits show.
        const bool on_knot = !edge_taken_on_knot() && solved_edge_on_knot(s);
        const unsigned lost =
            on_knot ? working : decades_below(s.smallest_gap(), s.extent.length());
        const unsigned needed = digits_ + guard_digits + 2 * lost;
        if (needed <= working) {
            break;
        }
        const unsigned enough = profile_.piecewise_linear() ? edge_decades : curved_edge_decades;
        if (lost >= enough && lost + guard_digits >= working && take_edges_on_knots(working)) {
            solved_.clear();
            working = digits_ + guard_digits;
            continue;
        }
        working = needed;
        if (lost > 100000) {
            throw BudgetError("an edge lies within 1e-100000 of a knot");
        }
    }
    base_working_ = working;
    if (profile_.kind() == Profile::Kind::piecewise && !profile_.piecewise_linear()) {
        const PrecisionScope scope(working);
        const Solved& s = at(working);
        const long bits = mpfr_get_prec(s.extent.a.backend().data());
        check_reach(profile_, Ball(s.extent.a, bits), Ball(s.extent.b, bits));
        sample_slope(profile_, s.law.slope(), s.extent.a, s.extent.b);
    }
}

bool NormalContact::solved_edge_on_knot(const Solved& s) const {
    const bool by_force = load_.kind == Load::Kind::force;
    return (by_force && s.law.right_edge_on_knot(s.extent)) ||
           ((by_force || !profile_.symmetric()) && s.law.left_edge_on_knot(s.extent));
}

bool NormalContact::take_edges_on_knots(unsigned working) {
    const Solved& s = at(working);
    const PrecisionScope scope(working);
    const auto& knots = s.law.slope().knots();
    const auto on = [&](const Real& offset) {
        return offset == 0 ||
               decades_below(Real(abs(offset)), s.extent.length()) + guard_digits >= working;
    };
    for (std::size_t i = 0; i < knots.size(); ++i) {
        if (load_.kind == Load::Kind::force && on(Real(s.extent.a - knots[i]))) {
            a_on_knot_ = i;
        }
        const bool solved = load_.kind == Load::Kind::force || !profile_.symmetric();
        if (solved && on(Real(s.extent.b + knots[i]))) {
            b_on_knot_ = i;
        }
    }
    return edge_taken_on_knot();
}

NormalContact::Solved& NormalContact::at(unsigned working) const {
    auto& slot = solved_[working];
    if (!slot) {
        const PrecisionScope scope(working);
        slot = std::make_unique<Solved>(profile_, modulus_, load_, digits_ + guard_digits / 2);
        Solved& s = *slot;
        if (a_on_knot_) {
            s.extent.a = s.law.slope().knots()[*a_on_knot_];
        }
        if (b_on_knot_) {
            s.extent.b = -s.law.slope().knots()[*b_on_knot_];
        }
    }
    return *slot;
}

NormalContact::Look NormalContact::look(const Real& u, Edge edge, unsigned working,
                                        Route route) const {
    const Solved& s = at(working);
    const PrecisionScope scope(working);
    // The cancellation is in x - knot; the distance from an edge has all its digits.
    const Real length = s.extent.length();
    Look found{base_working_, std::nullopt};
    Real gap = length;
    std::size_t nearest = 0;
    const auto& knots = s.law.slope().knots();
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const Real from_edge =
            edge == Edge::right ? Real(s.extent.a - knots[i]) : Real(s.extent.b + knots[i]);
        const Real d = abs(from_edge - u);
        if (d < gap) {
            gap = d;
            nearest = i;
            // Within the roundoff of this precision x may be equal to the knot.
            if (d == 0 || decades_below(d, length) + 7 >= working) {
                found.on_knot = i;
            }
        }
    }
    if (found.on_knot) {
        return found;
    }
    const unsigned lost = decades_below(gap, length);
    unsigned more = 2 * lost;
    if (route == Route::closed_form) {
        // In the closed form the gap d occurs in d ln d, so that a small d needs no further digits,
        // or at a corner in ln d, or in a power of d.
        more = profile_.piecewise_linear() && !profile_.has_corner(nearest) ? 0 : lost;
    }
    if (lost > 3) {
        // In steps of 16 digits, so that neighbouring points share a solved contact.
        found.working += (more + 15) / 16 * 16;
    }
    return found;
}

} // namespace edgeproof::contact
