// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace edgeproof::contact {

/// A second route to p (docs/pressure.md, "The witness").
enum class Route {
    singular_integral,  ///< regularised principal value (moore-hills EQ01)
    barber_mossakovskii ///< a sequence of flat punches (moore-hills EQ21)
};
[[nodiscard]] std::string route_name(Route route);

/// A plane normal contact whose edges and pressures are computed by multiprecision tanh-sinh
/// quadrature alone. It is a witness of the proved routes: it shares with them only the slope
/// (docs/independence.md), and proves nothing. Lengths in one unit, pressures in the unit of
/// contact_modulus, forces per unit length.
/// The working precision is the required digits, plus guard digits, plus twice the decades between
/// the contact's length and the smallest gap between edges, knots and the point. One object belongs
/// to one thread.
class Witness {
public:
    /// Throws InputError if the load is not positive, DomainError if no contact carries it.
    Witness(Profile profile, Exact contact_modulus, Load load, unsigned digits);
    ~Witness();
    Witness(Witness&&) noexcept;
    Witness& operator=(Witness&&) noexcept;

    [[nodiscard]] const Profile& profile() const noexcept { return profile_; }
    [[nodiscard]] unsigned digits() const noexcept { return digits_; }
    [[nodiscard]] Real a() const;      ///< right edge
    [[nodiscard]] Real b() const;      ///< distance of the left edge from the origin
    [[nodiscard]] Real force() const;  ///< P
    [[nodiscard]] Real moment() const; ///< M about the origin

    struct Pressure {
        Real value;
        Real estimate; ///< of the relative error by quadrature and roundoff; not a bound
        std::size_t evaluations = 0; ///< of the integrand
        unsigned working_digits = 0;
    };
    /// p at the distance u inwards from `edge`. Throws DomainError for u outside (0, a + b) and on
    /// a corner of the profile, where p is infinite. A point within 1e-400 of a knot (curved
    /// slopes: 1e-60) that exact numbers do not distinguish from it counts as on it.
    [[nodiscard]] Pressure pressure(Edge edge, const Exact& u, Route route) const;

private:
    struct Solved;
    [[nodiscard]] Solved& at(unsigned working) const;
    [[nodiscard]] bool solved_for(Edge edge) const;
    /// True if exact numbers prove that the point is the knot.
    [[nodiscard]] bool exactly_on(std::size_t knot, Edge edge, const Exact& u) const;

    Profile profile_;
    Exact modulus_;
    Load load_;
    unsigned digits_;
    unsigned base_working_ = 0;
    /// The knots that edges are taken to be on, without a proof: those that are solved for, lie
    /// within 1e-60 of a knot, and are not separated from it by the digits.
    std::optional<std::size_t> a_on_knot_;
    std::optional<std::size_t> b_on_knot_;
    mutable std::map<unsigned, std::unique_ptr<Solved>> solved_;
};

} // namespace edgeproof::contact
