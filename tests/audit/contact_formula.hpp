// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/ledger/ledger_parts.hpp"
#include "edgeproof/formula/parse.hpp"
#include "tests/support/namespaces.hpp"

#include <string>

namespace edgeproof {

/// A formula with the names and functions of a sample in balls, as in a ledger.
inline Expr contact_formula(const std::string& text) {
    Symbols symbols;
    for (const std::string& name : scene_symbols()) {
        symbols.add(name);
    }
    for (const char* name : {"Q", "sig0", "s"}) {
        symbols.add(name);
    }
    for (const auto& [name, arity] : scene_functions()) {
        symbols.add_function(name, arity);
    }
    return parse(text, symbols);
}

} // namespace edgeproof
