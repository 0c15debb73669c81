// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/relations/residue.hpp"
#include "edgeproof/audit/symbolic/symbolic.hpp"

#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <string_view>

namespace edgeproof::audit {

/// Numbers modulo a prime for the free symbols of a contact (a, b, P1, P2, ..., b1, ..., Q, sig0
/// and any others), drawn on first use, and the values computed from them: the multipliers of both
/// edges by the templates of contact/law, and the names for which the case gives formulas. Pi is
/// drawn like a symbol (it is transcendental); the only root, that of a + b, is a root modulo the
/// prime. An environment of formula::evaluate<Residue>; formulas have no other root.
class ResidueSample {
public:
    /// Throws DomainError if a + b is not a square modulo the prime, or for a division by zero;
    /// then use another seed.
    ResidueSample(const SymbolicCase& under, std::uint64_t seed);

    [[nodiscard]] Residue number(const Rational& q) const { return Residue::of(q); }
    [[nodiscard]] Residue pi() const { return pi_; }
    [[nodiscard]] Residue symbol(std::string_view name) const;

private:
    [[nodiscard]] Residue meaning(std::string_view name) const;
    [[nodiscard]] Residue pressure_multiplier(bool right, std::size_t k) const;
    [[nodiscard]] Residue shear_multiplier(bool right, std::size_t k) const;
    [[nodiscard]] Residue draw() const;

    const SymbolicCase& under_;
    mutable std::mt19937_64 random_;
    Residue pi_;
    Residue root_;
    mutable std::map<std::string, Residue, std::less<>> known_;
};

} // namespace edgeproof::audit
