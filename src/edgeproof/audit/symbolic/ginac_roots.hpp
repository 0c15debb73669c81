// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>

namespace GiNaC {
class ex;
} // namespace GiNaC

namespace edgeproof::audit::ginac {

/// GiNaC's `normal` knows nothing of roots: to it a^(1/2) and (2 a)^(1/2) have nothing in common.
/// Here every root is taken of irreducible factors only, each with a symbol w of its own and the
/// rule w^n = factor; what is left is a rational function, and `normal` decides.
class Roots {
public:
    Roots();
    ~Roots();
    Roots(const Roots&) = delete;
    Roots& operator=(const Roots&) = delete;

    /// e as a rational function of symbols, roots and other transcendental parts being symbols.
    GiNaC::ex rational(const GiNaC::ex& e);
    /// `rational`, as one fraction in lowest terms with every power of a root put down.
    GiNaC::ex fraction(const GiNaC::ex& e);
    /// A polynomial with every w^k, k >= n, put down by w^n = factor.
    [[nodiscard]] GiNaC::ex reduced(const GiNaC::ex& polynomial) const;
    /// With the roots and other parts back in their places.
    [[nodiscard]] GiNaC::ex restored(const GiNaC::ex& e) const;
    /// Whether a root or another transcendental part that is left in `whole` holds s.
    [[nodiscard]] bool involves(const GiNaC::ex& whole, const GiNaC::ex& s) const;
    /// What the symbol s of a root stands for; 0 if it is none.
    [[nodiscard]] GiNaC::ex root_meaning(const GiNaC::ex& s) const;

private:
    class Found;
    std::unique_ptr<Found> found_;
};

} // namespace edgeproof::audit::ginac
