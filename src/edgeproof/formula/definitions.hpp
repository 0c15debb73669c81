// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <map>
#include <string>
#include <vector>

namespace edgeproof::formula {

/// Names with their formulas, which may contain other names of the map.
using Definitions = std::map<std::string, Expr, std::less<>>;

/// Substitutes the definitions into each other, so that no result contains a defined name. Throws
/// InputError if a name depends on itself, with the cycle: "P2 -> P3 -> P2".
[[nodiscard]] Definitions put_into_each_other(const Definitions& definitions);

/// Returns e with the names replaced by the results of put_into_each_other.
[[nodiscard]] Expr put_in(const Definitions& resolved, Expr e);

/// Adds a name to those that are being replaced, and removes it in the destructor. Throws
/// InputError if the name is already among them.
class Replacing {
public:
    Replacing(std::vector<std::string>& names, const std::string& name);
    ~Replacing() { names_.pop_back(); }
    Replacing(const Replacing&) = delete;
    Replacing& operator=(const Replacing&) = delete;

private:
    std::vector<std::string>& names_;
};

} // namespace edgeproof::formula
