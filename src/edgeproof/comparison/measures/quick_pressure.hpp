// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/slope.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::comparison {

/// Estimates of the pressure of a plane contact of a curved slope in binary64, for searches and
/// suspects: g' at the nodes of the rule is computed once. At least about 9 digits.
class QuickPressure {
public:
    /// @param profile g'(x)
    /// @param contact_modulus E* (stress)
    /// @param a distance of the right edge from the origin (length), b of the left one
    QuickPressure(const contact::Profile& profile, double contact_modulus, double a, double b);

    /// Returns p at a place inside the contact. Nothing if the rule and one of half as many nodes
    /// disagree, for example close to a knot.
    [[nodiscard]] std::optional<double> at(double x) const;

private:
    struct Node {
        double s;
        double slope; ///< g'(s)
        double weight;
    };
    /// g'(x).
    [[nodiscard]] double slope(std::size_t piece, double x) const;

    contact::RealSlope slope_;
    double factor_; ///< E*/(2 pi)
    double a_;
    double b_;
    std::array<std::vector<Node>, 2> rules_;
};

} // namespace edgeproof::comparison
