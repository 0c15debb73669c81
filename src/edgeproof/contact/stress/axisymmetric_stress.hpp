// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"
#include "edgeproof/contact/stress/plane_stress.hpp"

#include <cstddef>
#include <optional>

namespace edgeproof::contact {

/// The stresses in a body of an axisymmetric contact without shear (docs/axisymmetric.md,
/// "Stresses"): sxx is the radial stress, `across` the hoop stress. The object keeps a reference to
/// the contact.
class AxisymmetricStress {
public:
    /// @param contact an AxisymmetricContact, or the plane contact that has the pressure of an
    ///   axisymmetric power law
    /// @param force the total force P (force)
    /// @param poisson Poisson's ratio of the body
    AxisymmetricStress(const ProvedContact& contact, const Ball& force, const Ball& poisson);

    /// At the depth z >= 0 (length) on the axis. Throws DomainError at a corner of the profile.
    [[nodiscard]] StressState on_axis(const Ball& z) const;
    /// At the radius r > 0 (length) on the surface; `known` is r, if it is an exact number. Throws
    /// DomainError at a corner, and InputError where an integral needs `known`.
    [[nodiscard]] StressState on_surface(const Ball& r, const std::optional<Exact>& known) const;

    /// At the radius r > 0 and the depth z > 0 (lengths).
    [[nodiscard]] StressState inside(const Ball& r, const Ball& z) const;

    /// The greatest tau_max on the axis and its depth, by branch and bound: both are proved.
    struct Greatest {
        Ball z;
        Ball value;
        std::size_t intervals = 0; ///< examined
    };
    /// Throws BudgetError if the intervals do not decide which place it is, or if the bits do not
    /// suffice to enclose it.
    [[nodiscard]] Greatest greatest_on_axis() const;

private:
    class ShearOnAxis;
    /// The integral of h'(s) s/(s^2 + w)^n over the approach (1/length^(2n - 2)); decreases with w.
    [[nodiscard]] Ball moment(const Ball& w, long n) const;
    /// The integral of h'(s)/s over 0 < s < S <= a: pi p/E* on the axis if the radius is S.
    [[nodiscard]] Ball on_axis_below(const Ball& S) const;
    const ProvedContact& contact_;
    const AxisymmetricContact* of_revolution_; ///< null for a power law
    bool apex_ = false;                        ///< g' jumps on the axis
    Ball force_;
    Ball poisson_;
    Ball exponent_{}; ///< m of a power law
    Ball rate_{};     ///< its h'(a)
};

} // namespace edgeproof::contact
