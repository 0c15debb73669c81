// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/naive_integral.hpp"
#include "edgeproof/audit/setting.hpp"
#include "edgeproof/contact/contact_law.hpp"
#include "edgeproof/contact/shear.hpp"

#include <array>

namespace edgeproof {

/// The family of contacts that the one of a Setting belongs to, and the parameters, at one
/// precision.
struct SettingLevel {
    SettingLevel(const SceneSpec& spec, const Profile& profile);

    ContactLaw<Real> law;
    std::map<std::string, Real, std::less<>> parameters;
    Extent<Real> extent;
    std::optional<Extent<Real>> last_extent;              ///< of the contact with right edge at .a
    std::optional<std::pair<Real, Real>> last_right_edge; ///< y and b^{-1}(y)
    std::optional<std::pair<Real, Real>> last_force_rate; ///< s and P'(s)

    /// The contact of the family whose right edge is at s.
    const Extent<Real>& extent_at(const Real& s);
    /// P'(s).
    Real force_rate_at(const Real& s);
    /// b^{-1}(y).
    Real right_edge_of(const Real& y);
};

/// What a Setting holds: the exact contact, and the family of contacts that it belongs to.
struct SettingState {
    SettingState(SceneSpec scene, unsigned digits_wanted, Effort effort);

    SceneSpec spec;
    unsigned digits;
    /// Enough for naive integrals; plain formulas get the same.
    NaivePrecision precision;
    Profile profile;
    NormalContact contact;
    std::map<std::string, Real, std::less<>> derived; ///< P, P1, ... as they are asked for
    std::array<std::vector<Real>, 2> expansions;      ///< right, left
    std::map<unsigned, SettingLevel> levels;          ///< by digits

    /// At the working precision: far from their ends integrands need few digits, and everything
    /// that they are made of has to have as few, for that to be cheap.
    SettingLevel& here();
    /// At the precision at which plain formulas are worked.
    [[nodiscard]] const SettingLevel& top() const { return levels.at(precision.integrand()); }
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
