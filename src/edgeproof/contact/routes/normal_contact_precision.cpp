// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/profile/profile_checks.hpp"
#include "edgeproof/contact/routes/solved_contact.hpp"
#include "edgeproof/precision/error.hpp"

#include <cmath>
#include <utility>

/// The working precision at which a contact is solved, and that of a point: the digits requested,
/// and those that the formulas of docs/pressure.md lose if edges, knots and points lie close.
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

NormalContact::NormalContact(Profile profile, formula::Exact contact_modulus, Load load,
                             unsigned digits, Work* work)
    : profile_(std::move(profile)), modulus_(std::move(contact_modulus)), load_(std::move(load)),
      digits_(digits), work_(work) {
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
        if (work_ != nullptr) {
            if (std::exchange(counted_, true)) {
                ++work_->raised;
            } else {
                work_->counts.consistency += profile_.symmetric() ? 0 : 1;
                work_->counts.load_inversions += load_.kind == Load::Kind::force ? 1 : 0;
            }
        }
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
