// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/tilted_path.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/formula/expr.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::audit {

/// The functions of a contact inside an integral, as formulas that Integrand knows, in names of
/// their own, such as no text has (`constants`), beside a, b, Q and sig0. For the paper's profiles;
/// Error for others.
class ContactFormulas {
public:
    /// Refers to both.
    ContactFormulas(const contact::Profile& profile, const contact::BallContact& contact,
                    const Ball& modulus);

    [[nodiscard]] const std::map<std::string, Ball, std::less<>>& constants() const {
        return constants_;
    }
    [[nodiscard]] bool symmetric() const { return profile_.symmetric(); }

    /// g1(x) in the piece that `near` lies in, or |g1(x)|.
    [[nodiscard]] formula::Expr slope(const formula::Expr& x, const Ball& near,
                                      bool absolute) const;
    /// P1of(s) and bof(s) for contacts like the one whose right edge is `near`; nothing where only
    /// a path of angles has them.
    [[nodiscard]] std::optional<formula::Expr> force_rate(const formula::Expr& s,
                                                          const Ball& near) const;
    [[nodiscard]] std::optional<formula::Expr> left_edge(const formula::Expr& s,
                                                         const Ball& near) const;
    /// The path of angles for contacts like that one, if they need one.
    [[nodiscard]] std::optional<TiltedPath> path(const Ball& near) const;
    /// q(x) under full stick.
    [[nodiscard]] static formula::Expr traction(const formula::Expr& x);
    /// p(x) is the real part of this, which is analytic above the contact: the logarithm of the
    /// distance from a corner is that of log_above. Nothing for a power law that is not whole.
    [[nodiscard]] std::optional<formula::Expr> pressure_above(const formula::Expr& x) const;
    /// p(x) of a power law, near the origin or near an edge, for x of the sign of `near`.
    [[nodiscard]] formula::Expr power_law_pressure(const formula::Expr& x, const Ball& near) const;

    /// Arguments at which these change their formulas: constants, and b^{-1} of constants.
    [[nodiscard]] std::vector<formula::Expr> slope_knots(bool absolute) const;
    [[nodiscard]] std::vector<formula::Expr> contact_knots() const;
    [[nodiscard]] std::vector<formula::Expr> pressure_knots() const;

private:
    [[nodiscard]] bool whole_exponent() const;
    /// p of a power law with a whole exponent, for w = sqrt(1 - z^2), z = |x|/a and log(z).
    [[nodiscard]] formula::Expr whole_power_pressure(const formula::Expr& w, const formula::Expr& z,
                                                     const formula::Expr& log_z) const;
    [[nodiscard]] formula::Expr parameter(const char* name) const;
    /// A name for a number.
    formula::Expr named(const std::string& name, const Ball& value);
    void read_pressure();
    /// At which the formula of g1, or of |g1|, changes.
    [[nodiscard]] std::vector<std::size_t> changing_knots(bool absolute) const;
    [[nodiscard]] bool beyond(const Ball& near, const formula::Expr& knot) const;
    [[nodiscard]] formula::Expr root_of_y(const formula::Expr& x) const;

    const contact::Profile& profile_;
    const contact::BallContact& contact_;
    Ball modulus_;
    std::map<std::string, Ball, std::less<>> constants_;
    std::optional<Rational> exponent_; ///< of a power law
};

} // namespace edgeproof::audit
