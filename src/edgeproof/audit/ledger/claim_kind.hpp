// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <string_view>
#include <vector>

namespace edgeproof::audit {

class AuditContext;
struct Claim;
struct Outcome;

/// A key of the claims of one kind, in addition to the common keys.
struct KeySpec {
    enum class Type {
        text,      ///< any text
        formula,   ///< parsed, with its names checked, when the ledger is read; or one of `choices`
        condition, ///< "x > 0 and x < a", parsed in the same way
        number,    ///< an exact constant: "1/100", not "1 %"
        integer,
        list,          ///< of texts
        formulas,      ///< a list of formulas
        table,         ///< name = text or list of texts
        formula_table, ///< name = formula
        choice,        ///< one of `choices`
    };
    std::string_view name;
    Type type = Type::text;
    bool required = false;
    std::vector<std::string_view> choices = {};
};

/// A kind of claim, defined in one file of checks/.
struct CheckKind {
    std::string_view name;
    std::vector<KeySpec> keys;
    std::function<Outcome(const Claim&, const AuditContext&)> check;
};

/// Returns all kinds, in the order of checks/kinds.cpp.
[[nodiscard]] const std::vector<CheckKind>& check_kinds();
/// Returns nullptr if there is no kind of that name.
[[nodiscard]] const CheckKind* find_check_kind(std::string_view name);
/// The keys that claims of every kind may have: says, of, over, edge, where, quoted, with, vary,
/// points, remark, decimals.
[[nodiscard]] const std::vector<KeySpec>& common_keys();

} // namespace edgeproof::audit
