// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/measures/exact_contact.hpp"

#include <vector>

namespace edgeproof::comparison {

/// The pressure of a simulated program with a penalty, to test the diagnosis
/// (causes/causes.hpp describes the problem). It shares with the diagnosis the gap alone: p
/// is linear between nodes (constant on rings, whose influence is integrated from that of a point
/// on the surface, if the contact is axisymmetric), and the contact is found by conjugate gradients
/// (polonsky-keer1999).
class SpringBed {
public:
    SpringBed(const scene::Scene& scene, const ExactContact& exact, double softness);
    [[nodiscard]] double pressure(double x) const;

private:
    using Values = std::vector<double>;
    [[nodiscard]] double influence(std::size_t at, std::size_t of) const;
    [[nodiscard]] Values displacement(const Values& p) const;
    [[nodiscard]] double total(const Values& one, const Values& other) const;
    void solve(double force, double tilt);

    bool round_;
    double softness_; ///< 1/k
    double modulus_;
    double width_;
    Values x_;
    Values gap_;
    Values weight_; ///< the force of a unit pressure
    std::vector<Values> u_;
    Values p_;
};

} // namespace edgeproof::comparison
