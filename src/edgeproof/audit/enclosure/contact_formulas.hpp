// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/tilted_path.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/formula/expr.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::audit {

using formula::Expr;

/// The functions of a contact inside an integral, as formulas for Integrand. They contain a, b, Q,
/// sig0 and special names that no text can contain (`constants`). Available for the paper's
/// profiles; throws Error for others.
class ContactFormulas {
public:
    /// Keeps references to the profile and the contact.
    ContactFormulas(const contact::Profile& profile, const contact::BallContact& contact,
                    const Ball& modulus);

    [[nodiscard]] const std::map<std::string, Ball, std::less<>>& constants() const {
        return constants_;
    }
    [[nodiscard]] bool symmetric() const { return profile_.symmetric(); }

    /// Returns g1(x), or |g1(x)|, in the piece that contains `near`.
    [[nodiscard]] Expr slope(const Expr& x, const Ball& near, bool absolute) const;
    /// Return P1of(s) and bof(s) for contacts like the one whose right edge is `near`; nothing if
    /// they are available only on a path of angles.
    [[nodiscard]] std::optional<Expr> force_rate(const Expr& s, const Ball& near) const;
    [[nodiscard]] std::optional<Expr> left_edge(const Expr& s, const Ball& near) const;
    /// Returns the path of angles for contacts like that one, if they need one.
    [[nodiscard]] std::optional<TiltedPath> path(const Ball& near) const;
    /// Returns q(x) under full stick.
    [[nodiscard]] static Expr traction(const Expr& x);
    /// Returns a function whose real part is p(x) and which is analytic above the contact: the
    /// logarithm of the distance from a corner is taken as log_above. Returns nothing for a power
    /// law with a non-integer exponent.
    [[nodiscard]] std::optional<Expr> pressure_above(const Expr& x) const;
    /// Returns p(x) of a power law, near the origin or near an edge, for x with the sign of `near`.
    [[nodiscard]] Expr power_law_pressure(const Expr& x, const Ball& near) const;

    /// Returns the arguments at which g1 (or |g1|), p, P1of or bof changes its formula: constants,
    /// and b^{-1} of constants; none for other functions.
    [[nodiscard]] std::vector<Expr> knots(std::string_view function, bool absolute) const;

private:
    [[nodiscard]] bool whole_exponent() const;
    /// p of a power law with a whole exponent, for w = sqrt(1 - z^2), z = |x|/a and log(z).
    [[nodiscard]] Expr whole_power_pressure(const Expr& w, const Expr& z, const Expr& log_z) const;
    [[nodiscard]] Expr parameter(const char* name) const;
    /// Introduces a name for a number.
    Expr named(const std::string& name, const Ball& value);
    void read_pressure();
    /// Returns the knots at which the formula of g1, or of |g1|, changes.
    [[nodiscard]] std::vector<std::size_t> changing_knots(bool absolute) const;
    [[nodiscard]] bool beyond(const Ball& near, const Expr& knot) const;
    [[nodiscard]] Expr root_of_y(const Expr& x) const;

    const contact::Profile& profile_;
    const contact::BallContact& contact_;
    Ball modulus_;
    std::map<std::string, Ball, std::less<>> constants_;
    std::optional<Rational> exponent_; ///< of a power law
};

} // namespace edgeproof::audit
