// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/definitions.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::formula {
namespace {

class Resolver {
public:
    explicit Resolver(const Definitions& definitions) : definitions_(definitions) {}

    Definitions all() {
        for (const auto& [name, formula] : definitions_) {
            (void)resolved(name, formula);
        }
        return std::move(done_);
    }

private:
    const Expr& resolved(const std::string& name, const Expr& formula) {
        if (const auto it = done_.find(name); it != done_.end()) {
            return it->second;
        }
        const Replacing now(names_, name);
        Expr e = formula;
        for (const std::string& part : free_symbols(formula)) {
            if (const auto it = definitions_.find(part); it != definitions_.end()) {
                e = substitute(e, part, resolved(part, it->second));
            }
        }
        return done_.emplace(name, std::move(e)).first->second;
    }

    const Definitions& definitions_;
    Definitions done_;
    std::vector<std::string> names_;
};

} // namespace

Replacing::Replacing(std::vector<std::string>& names, const std::string& name) : names_(names) {
    const auto first = std::find(names.begin(), names.end(), name);
    if (first != names.end()) {
        std::string circle;
        for (auto it = first; it != names.end(); ++it) {
            circle += *it + " -> ";
        }
        throw InputError("the definitions are circular: " + circle + name,
                         "define each name by names that do not depend on it");
    }
    names_.push_back(name);
}

Definitions put_into_each_other(const Definitions& definitions) {
    return Resolver(definitions).all();
}

Expr put_in(const Definitions& resolved, Expr e) {
    for (const std::string& name : free_symbols(e)) {
        if (const auto it = resolved.find(name); it != resolved.end()) {
            e = substitute(e, name, it->second);
        }
    }
    return e;
}

} // namespace edgeproof::formula
