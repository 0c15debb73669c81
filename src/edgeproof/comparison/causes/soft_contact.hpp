// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/measures/exact_contact.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace edgeproof::comparison {

/// g at the middles of elements of equal width, the first of which is `first`, up to a constant.
[[nodiscard]] std::vector<double> gap_of(const scene::Scene& scene, const ExactContact& exact,
                                         double first, double width, std::size_t elements);

/// The contact as a program with a penalty solves it: p = k times the penetration, so that a layer
/// of springs with the compliance 1/k lies between the bodies. Where p > 0,
///     u(x) + g(x) + p(x)/k = delta + phi x,
/// with the displacement u of the half-plane, or of the half-space, under p. The contact is longer,
/// p is lower, and p vanishes like u, not like u^(1/2), at its edges. P is that of the scene; so is
/// M where the scene gives it, and phi = 0 otherwise.
///
/// Boundary elements (rings, if axisymmetric) of constant p, of equal width, with the active
/// elements found by iteration (johnson1985, section 4.3, has the springs alone). All values are
/// estimates.
class SoftContact {
public:
    /// `scene`: that of `exact`. Keeps no reference to them.
    SoftContact(const scene::Scene& scene, const ExactContact& exact);

    struct Solution {
        double softness = 0; ///< E*/(k (a + b)) with the exact a and b; 0 for rigid springs
        double a = 0;        ///< p > 0 for -b < x < a
        double b = 0;
        std::vector<double> p; ///< of the elements
    };
    /// Returns nothing if the contact extends beyond the elements, by a third of a + b on each
    /// side.
    [[nodiscard]] std::optional<Solution> solve(double softness) const;
    /// Returns the solution for which `left`, a sum of squares, is least; nothing if none halves
    /// that of rigid springs.
    [[nodiscard]] std::optional<Solution>
    fitted(const std::function<double(const Solution&)>& left) const;
    /// The change of p at x by the springs, between elements by interpolation: the error of the
    /// elements themselves nearly cancels in it. NaN near an exact edge or a corner, where it does
    /// not.
    [[nodiscard]] double change(const Solution& soft, double x) const;
    /// k in units of E*/(a + b), times this number, is k in pressure per length.
    [[nodiscard]] double stiffness_unit() const { return modulus_ / length_; }

private:
    void find_influences();

    bool round_ = false;
    double modulus_ = 0; ///< E*
    double length_ = 0;  ///< a + b
    double width_ = 0;   ///< of an element
    double force_ = 0;
    std::optional<double> moment_;
    std::vector<double> special_;        ///< the exact edges, and the corners
    std::vector<double> x_;              ///< the middles of the elements
    std::vector<double> gap_;            ///< g there, up to a constant
    std::vector<std::vector<double>> u_; ///< at an element, under a unit pressure on another
    Solution rigid_;
    std::vector<Solution> soft_; ///< by softness, from springs that are nearly rigid
};

} // namespace edgeproof::comparison
