// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/sample/evaluated_scene.hpp"
#include "edgeproof/audit/symbolic/symbolic.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <map>
#include <set>
#include <string>

namespace edgeproof::audit {

/// Numbers for the symbols of an identity, drawn at random (but the same ones every time): what
/// holds identically holds for them, and what holds for them to many digits at several draws hardly
/// fails to. Used to pick candidates; a proof is by symbols.
class FormalValues {
public:
    /// Draw number `draw` for these names and all that they depend on under the case.
    FormalValues(const std::set<std::string>& names, const SymbolicCase& under, std::size_t draw,
                 unsigned working_digits = digits);

    [[nodiscard]] const Variables& values() const noexcept { return values_; }
    /// One more name, or another value.
    void set(const std::string& name, const Real& value) { values_.insert_or_assign(name, value); }
    /// Throws Error for names without a value and for functions along the family of contacts.
    [[nodiscard]] Real evaluate(const formula::Expr& e) const;
    /// The same in ball arithmetic: the numbers drawn are exact, what depends on them is enclosed.
    [[nodiscard]] Ball enclose(const formula::Expr& e, long bits) const;

    static constexpr unsigned digits = 40;

private:
    Variables values_;
    std::map<std::string, Rational, std::less<>> drawn_;
    std::map<std::string, formula::Expr, std::less<>>
        meanings_; ///< of names that depend on those drawn
    unsigned working_digits_;
};

} // namespace edgeproof::audit
