// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace edgeproof::contact::witness {

/// The contact -b < x < a (lengths).
struct Ends {
    Real a;
    Real b;
    [[nodiscard]] Real length() const { return a + b; }
};

/// A place in the contact (lengths).
struct Place {
    Real right; ///< a - x
    Real left;  ///< x + b
    Real x;
};

using Integral = quadrature::QuadratureResult;

/// The number of decimal digits by which `part` is smaller than `whole`; 0 if it is not.
[[nodiscard]] unsigned digits_lost(const Real& whole, const Real& part);

/// The conditions for the edges as integrals of g'/w, w = sqrt((a - s)(s + b)) (docs/pressure.md,
/// "The witness"). Of the proved routes it uses only the slope. The integrals are quadratures;
/// where Barber-Mossakovskii needs one at every node, a linear piece of g' is integrated by hand.
/// Values have the working precision of the thread that constructed the object; none is a bound.
/// One object belongs to one thread.
class EdgeEquations {
public:
    /// `contact_modulus`: E*, a stress.
    EdgeEquations(Profile profile, Exact contact_modulus);

    [[nodiscard]] const RealSlope& slope() const { return slope_; }
    [[nodiscard]] const Real& modulus() const { return modulus_; }
    /// The edges for a load. Throws DomainError if no contact carries it.
    [[nodiscard]] Ends ends(const Load& load) const;
    /// The edges for the right edge a (length).
    [[nodiscard]] Ends ends_at(const Real& a) const;
    [[nodiscard]] Real force(const Ends& e) const;  ///< P (force per unit length)
    [[nodiscard]] Real moment(const Ends& e) const; ///< M about the origin (force)
    /// dP/da or dP/db along the contacts of the profile (stress).
    [[nodiscard]] Real rate(const Ends& e, Edge edge) const;
    /// The integral of (g'(s) - g'(x))/((s - x) w) ds (1/length) by quadrature to `target_digits`.
    [[nodiscard]] Integral difference_integral(const Ends& e, const Place& at,
                                               unsigned target_digits) const;

private:
    struct Cut {
        Place at;
        std::size_t piece; ///< the piece of g' that begins here
    };
    /// The contact, cut at the knots and at one more place.
    struct Stretches {
        std::vector<Cut> cuts;
        std::vector<Real> lengths;
        std::size_t own; ///< the index of that place
    };
    [[nodiscard]] Stretches stretches(const Ends& e, const Place& at) const;
    [[nodiscard]] static Place end(const Ends& e, Edge edge);
    /// The integral of f(s, lo, hi)/w over a stretch; lo, hi: the distances of s from both cuts.
    template <class F>
    [[nodiscard]] static Integral over(const Stretches& list, std::size_t i, unsigned digits,
                                       const F& f);
    /// The integral of g' (s - c)^k/w, c = (a - b)/2. For k = 0 it is 0 (moore-hills EQ20).
    [[nodiscard]] Real slope_integral(const Ends& e, int k) const;
    /// (g'(x + delta) - g'(x))/delta by one piece.
    [[nodiscard]] Real quotient(std::size_t piece, const Real& x, const Real& delta,
                                const Real& length) const;
    /// The part of difference_integral over one stretch.
    [[nodiscard]] Integral difference_over(const Stretches& list, std::size_t i, const Ends& e,
                                           unsigned digits) const;
    /// Newton's steps from `e`; nothing if they do not converge. `P` is null for a given a.
    [[nodiscard]] std::optional<Ends> refined(Ends e, const Real* P) const;
    /// The same between brackets, to the accuracy `relative`. `value`: P or a.
    [[nodiscard]] Ends searched(const Real& value, bool by_force, const Real& relative) const;

    Profile profile_;
    Exact exact_modulus_;
    RealSlope slope_;
    Real modulus_;
    unsigned target_digits_;           ///< of the quadratures for edges, forces and rates
    mutable std::optional<Ends> last_; ///< the edges found before
    /// For a power law: a half-width, and P' there.
    mutable std::optional<std::pair<Real, Real>> rate_of_power_;
};

} // namespace edgeproof::contact::witness
