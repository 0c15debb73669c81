// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/symbolic/symbolic.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"

#include <cstddef>
#include <map>
#include <set>
#include <string>

namespace edgeproof::audit {

/// Values of names.
using Variables = std::map<std::string, Real, std::less<>>;

/// Pseudo-random numbers for the symbols of an identity (always the same ones). An identity holds
/// for them; a formula that holds for many digits at several draws is very probably an identity.
/// They are used to select candidates; a proof uses symbols.
class FormalValues {
public:
    /// Makes draw number `draw` for these names and all names on which they depend in the case.
    FormalValues(const std::set<std::string>& names, const SymbolicCase& under, std::size_t draw,
                 unsigned working_digits = digits);

    void set(const std::string& name, const Real& value) { values_.set(name, value); }
    /// Throws Error for names without a value and for functions along the family of contacts.
    [[nodiscard]] Real evaluate(const Expr& e) const;

    static constexpr unsigned digits = 40;

private:
    formula::Values<Real> values_;
    unsigned working_digits_;
};

} // namespace edgeproof::audit
