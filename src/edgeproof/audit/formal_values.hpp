// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/setting.hpp"
#include "edgeproof/audit/symbolic.hpp"

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace edgeproof {

/// Numbers for the symbols of an identity, drawn at random (but the same ones every time): what
/// holds identically holds for them, and what holds for them to many digits at several draws hardly
/// fails to. Used to pick candidates; a proof is by symbols.
class FormalValues {
public:
    /// Draw number `draw` for these names and all that they depend on under the case.
    FormalValues(const std::set<std::string>& names, const SymbolicCase& under, std::size_t draw);

    [[nodiscard]] const Variables& values() const noexcept { return values_; }
    /// Throws Error for names without a value and for functions along the family of contacts.
    [[nodiscard]] Real evaluate(const Expr& e) const;
    /// The coefficients of an expansion by powers of variable^(1/2), from `first` to `last`; those
    /// of e times variable^(first/2) where e begins there. Throws what its evaluation throws.
    [[nodiscard]] std::vector<Real> coefficients(const Expr& e, const ExpansionIn& in, long first,
                                                 long last) const;

    static constexpr unsigned digits = 40;

private:
    Variables values_;
};

} // namespace edgeproof
