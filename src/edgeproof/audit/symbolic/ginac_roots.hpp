// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>

namespace GiNaC {
class ex;
} // namespace GiNaC

namespace edgeproof::audit::ginac {

/// Replaces roots by symbols, because GiNaC's `normal` treats a^(1/2) and (2 a)^(1/2) as
/// independent. Here roots are taken of irreducible factors only; each is a symbol w with the rule
/// w^n = factor. The result is a rational function, for which `normal` decides.
class Roots {
public:
    Roots();
    ~Roots();
    Roots(const Roots&) = delete;
    Roots& operator=(const Roots&) = delete;

    /// Returns e as a rational function, with symbols for roots and other transcendental parts.
    GiNaC::ex rational(const GiNaC::ex& e);
    /// Returns `rational` as one fraction in lowest terms, with powers of roots reduced.
    GiNaC::ex fraction(const GiNaC::ex& e);
    /// Returns a polynomial with every w^k, k >= n, reduced by w^n = factor.
    [[nodiscard]] GiNaC::ex reduced(const GiNaC::ex& polynomial) const;
    /// Returns e with the roots and other parts put back.
    [[nodiscard]] GiNaC::ex restored(const GiNaC::ex& e) const;
    /// True if a root or another transcendental part in `whole` contains s.
    [[nodiscard]] bool involves(const GiNaC::ex& whole, const GiNaC::ex& s) const;
    /// Returns the root for which the symbol s was introduced; 0 if there is none.
    [[nodiscard]] GiNaC::ex root_meaning(const GiNaC::ex& s) const;

private:
    class Found;
    std::unique_ptr<Found> found_;
};

} // namespace edgeproof::audit::ginac
