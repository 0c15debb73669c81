// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/naive_integral.hpp"
#include "edgeproof/audit/setting.hpp"
#include "edgeproof/contact/contact_law.hpp"
#include "edgeproof/contact/shear.hpp"

#include <array>

namespace edgeproof {

/// What a Setting holds: the exact contact, and the family of contacts that it belongs to at the
/// precision at which formulas are worked.
struct SettingState {
    SettingState(SceneSpec scene, unsigned digits_wanted);

    SceneSpec spec;
    unsigned digits;
    /// Enough for naive integrals; plain formulas get the same.
    NaivePrecision precision;
    Profile profile;
    NormalContact contact;
    ContactLaw<Real> law;
    Extent<Real> extent;
    std::map<std::string, Real, std::less<>> parameters;
    std::map<std::string, Real, std::less<>> derived;     ///< P, P1, ... as they are asked for
    std::array<std::vector<Real>, 2> expansions;          ///< right, left
    std::optional<Extent<Real>> last_extent;              ///< of the contact with right edge at .a
    std::optional<std::pair<Real, Real>> last_right_edge; ///< y and b^{-1}(y)

    /// The contact of the family whose right edge is at s.
    const Extent<Real>& extent_at(const Real& s);
    /// b^{-1}(y).
    Real right_edge_of(const Real& y);
    const std::vector<Real>& expansion(Edge edge, std::size_t terms);
    /// A name that is no parameter, place or variable; nullopt if unknown.
    std::optional<Real> derived_symbol(std::string_view name);
    Real call(const std::string& name, std::span<const Real> args, const Place* place);
    /// Values of the argument of a function at which it is not analytic.
    std::vector<Real> critical_arguments(const std::string& function);
    [[nodiscard]] ShearLoad<Real> shear_load() const;
    [[nodiscard]] std::vector<Real> shear_coefficients(Edge edge, std::size_t terms) const;
    [[nodiscard]] Place place_of_x(const Real& x) const;
};

} // namespace edgeproof
