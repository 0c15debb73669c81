// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <map>
#include <string>
#include <vector>

namespace edgeproof::formula {

/// Names with the formulas that they stand for, which may have further ones of these names.
using Definitions = std::map<std::string, Expr, std::less<>>;

/// Puts the definitions into each other: none of the results has a name that is defined. Throws
/// InputError where a name needs itself, with the circle: "P2 -> P3 -> P2".
[[nodiscard]] Definitions put_into_each_other(const Definitions& definitions);

/// e with the results of put_into_each_other in place of their names.
[[nodiscard]] Expr put_in(const Definitions& resolved, Expr e);

/// Adds a name to those that are being replaced, for as long as it lives. Throws InputError where
/// it is among them already.
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
