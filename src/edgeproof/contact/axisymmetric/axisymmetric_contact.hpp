// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/proved_contact.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/slip/stick_zone.hpp"
#include "edgeproof/precision/ball/complex_box.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace edgeproof::contact {

/// An axisymmetric contact that is integrated, in ball arithmetic.
class RoundContact : public ProvedContact {
public:
    using ProvedContact::ProvedContact;
    /// The total force P (force).
    [[nodiscard]] Ball force() const override { return force_at(a_); }
    [[nodiscard]] Ball moment() const override { return {0, bits_}; }
    /// The approach delta of the bodies (length).
    [[nodiscard]] Ball approach() const { return approach_at(a_); }
    /// dP/da (force/length).
    [[nodiscard]] Ball force_rate() const { return modulus_ * a_ * approach_rate_at(a_) * 2; }
    /// Returns the coefficients of dP/da (force/length) at the radius a - d in powers of d.
    [[nodiscard]] virtual std::vector<Ball> force_rates(std::size_t terms) const = 0;
    /// The radius (length) of the contact of the same profile under the total force P.
    [[nodiscard]] Ball radius_for(const Ball& P) const;
    /// The contact of the same profile with the radius `a` (length).
    [[nodiscard]] virtual std::unique_ptr<RoundContact> resized(const Ball& a) const = 0;
    /// The radius (length) at which g' begins to rise.
    [[nodiscard]] virtual Ball minimum_end() const = 0;
    /// The gap (length) between the bodies at the distance `beyond` >= 0 (length) outside the edge.
    [[nodiscard]] virtual Ball gap_beyond(const Ball& beyond) const = 0;
    /// Returns the integral of (1 - tau/2) P - L over the approach (force x length), where the
    /// force L grows from (1 - tau) P, at the radius `from` (length), to P.
    [[nodiscard]] virtual Ball loop_integral(const Ball& from, const Ball& tau) const = 0;
    [[nodiscard]] std::vector<Ball> expansion(Edge edge, std::size_t terms) const override;

protected:
    /// Finds the radius: a (length), or that of the total force P (force) or of the approach delta
    /// (length).
    void carry(const Load& load);
    /// A radius from which the search for that of a force, or of an approach, starts.
    struct Start {
        Ball radius;
        bool near; ///< ZeroSearch::near
    };
    [[nodiscard]] virtual Start start_for(Load::Kind kind, const Ball& given) const = 0;
    /// The force, the approach h and its rate h' for the radius s (length).
    [[nodiscard]] virtual Ball force_at(const Ball& s) const = 0;
    [[nodiscard]] virtual Ball approach_at(const Ball& s) const = 0;
    [[nodiscard]] virtual Ball approach_rate_at(const Ball& s) const = 0;
    /// The coefficients of h'(a + z) in powers of z; not finite if g' may jump or bend at the edge.
    [[nodiscard]] virtual std::vector<Ball> approach_rates(std::size_t terms) const = 0;
    [[nodiscard]] bool inside(std::size_t knot) const override;
};

/// An axisymmetric contact whose slope g'(r) is piecewise linear, in ball arithmetic
/// (docs/axisymmetric.md). x is the radius r, a the radius of the contact, u = a - r; the left edge
/// is the mirror image of the right one. The radius, the force and the approach are elementary
/// functions (`sneddon1965`); the pressure is found by Arb's rigorous integration
/// (`johansson2018`).
class AxisymmetricContact : public RoundContact {
public:
    /// Throws BudgetError where `bits` do not suffice to enclose the radius.
    /// @param profile g'(r), symmetric and piecewise linear
    /// @param contact_modulus E* (stress)
    /// @param load the radius a (length), the total force P (force) or the approach delta (length)
    /// @param bits working precision
    AxisymmetricContact(const Profile& profile, const Exact& contact_modulus, const Load& load,
                        long bits);

    [[nodiscard]] Ball pressure(Edge edge, const Exact& u) const override;
    [[nodiscard]] Ball pressure(Edge edge, const Ball& u) const override;
    [[nodiscard]] Ball least_pressure(Edge edge, const Ball& u) const override;
    [[nodiscard]] BallSeries pressure_series(Edge edge, const Ball& u,
                                             std::size_t order) const override;
    [[nodiscard]] Ball reach(Edge edge) const override;
    [[nodiscard]] Ball majorant(Edge edge, const Ball& rho) const override;
    [[nodiscard]] std::size_t cost() const override { return 10; }

    /// The pressure (stress) at the radius r >= 0 (length). Not finite at a corner.
    [[nodiscard]] Ball pressure_at(const Exact& r) const;
    /// The integral of h'(s) sqrt(s^2 - r^2) over r < s < a (length^2), for r > 0.
    [[nodiscard]] Ball outer_moment(const Exact& r) const;
    /// The integral of h'(s) s/(s^2 + w)^n over 0 < s < a, for w > 0 (length^2) and n > 0.
    [[nodiscard]] Ball approach_moment(const Ball& w, long n) const;

    /// The real part of the integral of h'(s) f(s) over 0 < s < a, for f as in `integral_of`
    /// (abel_integral.hpp).
    [[nodiscard]] Ball over_approach(const std::function<Box(const Box& s)>& f) const;

    [[nodiscard]] Ball gap_beyond(const Ball& beyond) const override;
    /// Returns the contact of the same body with another radius of contact (length).
    [[nodiscard]] AxisymmetricContact with_radius(const Ball& a) const;
    [[nodiscard]] std::unique_ptr<RoundContact> resized(const Ball& a) const override {
        return std::make_unique<AxisymmetricContact>(with_radius(a));
    }
    [[nodiscard]] std::vector<Ball> force_rates(std::size_t terms) const override;
    [[nodiscard]] Ball loop_integral(const Ball& from, const Ball& tau) const override;
    /// True if g' jumps on the axis, where the pressure is then infinite.
    [[nodiscard]] bool has_apex() const {
        return bends_.front().at_origin && !contains_zero(bends_.front().jump);
    }
    [[nodiscard]] Ball minimum_end() const override;

private:
    /// g' rises by `jump` at the radius v, and its rate by `rate` (1/length).
    struct Bend {
        Ball v;
        Ball jump;
        Ball rate;
        bool at_origin;
        std::size_t knot;
    };
    struct Place;
    [[nodiscard]] Start start_for(Load::Kind kind, const Ball& given) const override;
    [[nodiscard]] Ball force_at(const Ball& a) const override;
    [[nodiscard]] Ball approach_at(const Ball& s) const override;
    /// docs/axisymmetric.md, "Piecewise linear slopes".
    [[nodiscard]] Ball approach_rate_at(const Ball& s) const override;
    [[nodiscard]] BallSeries approach_rate_series(std::size_t terms) const;
    [[nodiscard]] std::vector<Ball> approach_rates(std::size_t terms) const override {
        return approach_rate_series(terms).coefficients();
    }
    [[nodiscard]] Place place_at(const Exact& r) const;
    template <class F> [[nodiscard]] Ball over_bends(const Ball& s, const F& f) const;
    [[nodiscard]] Ball pressure(const Place& at, bool least) const;

    std::vector<Bend> bends_; ///< ascending
};

/// The zones of an axisymmetric contact under smaller forces, which bound its stick zone in partial
/// slip (docs/axisymmetric.md, "Partial slip"). The solver keeps a copy of `contact`.
[[nodiscard]] std::unique_ptr<ZoneSolver> axisymmetric_zones(const RoundContact& contact);
/// The same for an axisymmetric power law: `plane` is the plane contact that has the same pressure,
/// `force` the total force.
[[nodiscard]] std::unique_ptr<ZoneSolver> axisymmetric_zones(const BallContact& plane,
                                                             const Ball& force);

/// The real part of the integral of h'(s) f(s) over 0 < s < a (AxisymmetricContact::over_approach)
/// of an axisymmetric power law; `plane` is the plane contact that has the same pressure.
[[nodiscard]] Ball over_approach(const BallContact& plane,
                                 const std::function<Box(const Box& s)>& f);

/// The gap (length) at the distance `beyond` >= 0 (length) outside the edge of an axisymmetric
/// power law; `plane` is the plane contact that has the same pressure.
[[nodiscard]] Ball axisymmetric_gap(const BallContact& plane, const Ball& beyond);

} // namespace edgeproof::contact
