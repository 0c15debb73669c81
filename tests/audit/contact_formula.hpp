// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/setting.hpp"
#include "edgeproof/formula/parse.hpp"

#include <string>

namespace edgeproof {

/// A formula with the names and functions of a setting, as a ledger has them.
inline Expr contact_formula(const std::string& text) {
    Symbols symbols;
    for (const std::string& name : setting_symbols()) {
        symbols.add(name);
    }
    for (const char* name : {"Q", "sig0", "s"}) {
        symbols.add(name);
    }
    for (const auto& [name, arity] : setting_functions()) {
        symbols.add_function(name, arity);
    }
    return parse(text, symbols);
}

} // namespace edgeproof
