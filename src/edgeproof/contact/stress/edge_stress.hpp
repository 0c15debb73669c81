// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/stress/plane_stress.hpp"
#include "edgeproof/formula/exact/exact.hpp"

#include <cstddef>
#include <optional>
#include <vector>

/// The stresses near an edge of a contact as series in the distance from it (docs/stress.md, "Near
/// an edge").
namespace edgeproof::contact {

enum class StressComponent { sxx, szz, sxz };

/// With zeta = e + s^2 at the edge e the Cauchy integrals of p and q are sums of A_j s^j and B_j
/// s^j: odd j from the expansions of p and q, even j from the slope g' and from the tractions that
/// are analytic at the edge. Each stress is then the sum of K_j r^(j/2) at the distance r from the
/// edge, along a ray into the body.
class EdgeStress {
public:
    /// The first `terms` powers. Throws BudgetError if these bits do not separate the edge from the
    /// places where the series end.
    /// @param field the loads on the body
    /// @param stick the load on this body under full stick, which `field` does not contain
    /// @param edge of the contact
    /// @param terms the number of powers
    EdgeStress(const StressField& field, const std::optional<ShearLoad<Ball>>& stick, Edge edge,
               std::size_t terms);

    /// j of the first power: -1 under full stick, else 0.
    [[nodiscard]] int first() const { return first_; }
    /// K_first, K_first+1, ... (stress/length^(j/2)), each enclosed; exactly zero where that is
    /// known.
    /// @param component of the stress
    /// @param angle in degrees, between the ray and the surface of the contact: 0 along the
    /// contact, 90 downwards, 180 along the free surface
    [[nodiscard]] std::vector<Ball> along(StressComponent component, const Exact& angle) const;

private:
    void add_contact(const PlaneContact& contact, const Ball& pressure, const Ball& shear);
    void add_zone(const PlaneContact& zone, const Ball& at, const Ball& shear);
    void add_stick(const ShearLoad<Ball>& load, const Ball& length);
    /// The entry of the power j of s.
    [[nodiscard]] std::size_t entry(int j) const { return static_cast<std::size_t>(j - first_); }

    long bits_;
    int first_;
    Edge edge_;
    Ball bulk_;
    Ball radius_;                ///< the series converges for smaller r (length)
    std::vector<Ball> pressure_; ///< A_j (stress/length^(j/2))
    std::vector<Ball> shear_;    ///< B_j
};

} // namespace edgeproof::contact
