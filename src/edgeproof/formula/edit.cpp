// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/error.hpp"

#include <functional>

namespace edgeproof::formula {
namespace {

constexpr std::size_t bound_variable = 1;

/// A binder binds its variable in its first argument only.
bool binds_in(const Expr& e, std::size_t child) { return e.is_binder() && child == 0; }

void walk(const Expr& e, const std::function<void(const Expr&)>& visit) {
    visit(e);
    for (std::size_t i = 0; i < e.args().size(); ++i) {
        if (!(e.is_binder() && i == bound_variable)) {
            walk(e.args()[i], visit);
        }
    }
}

void collect_free(const Expr& e, std::multiset<std::string>& bound, std::set<std::string>& out) {
    if (e.kind() == Expr::Kind::symbol) {
        if (!bound.contains(e.name())) {
            out.insert(e.name());
        }
        return;
    }
    for (std::size_t i = 0; i < e.args().size(); ++i) {
        if (e.is_binder() && i == bound_variable) {
            continue;
        }
        if (binds_in(e, i)) {
            const auto it = bound.insert(e.args()[bound_variable].name());
            collect_free(e.args()[i], bound, out);
            bound.erase(it);
        } else {
            collect_free(e.args()[i], bound, out);
        }
    }
}

std::string fresh(const std::string& name, const std::set<std::string>& taken,
                  const std::set<std::string>& also_taken) {
    for (std::size_t i = 1;; ++i) {
        std::string candidate = name + "_" + std::to_string(i);
        if (!taken.contains(candidate) && !also_taken.contains(candidate)) {
            return candidate;
        }
    }
}

class Substitution {
public:
    Substitution(std::string_view name, const Expr& value)
        : name_(name), value_(value), names_of_value_(free_symbols(value)) {}

    [[nodiscard]] Expr operator()(const Expr& e) const {
        if (e.kind() == Expr::Kind::symbol) {
            return e.name() == name_ ? value_ : e;
        }
        if (e.args().empty()) {
            return e;
        }
        std::vector<Expr> args(e.args().begin(), e.args().end());
        if (e.is_binder()) {
            for (std::size_t i = bound_variable + 1; i < args.size(); ++i) {
                args[i] = (*this)(args[i]);
            }
            substitute_under(args);
        } else {
            for (Expr& x : args) {
                x = (*this)(x);
            }
        }
        return args == std::vector<Expr>(e.args().begin(), e.args().end())
                   ? e
                   : Expr::with_args(e, std::move(args));
    }

private:
    /// Substitutes in args[0], which is in the scope of the variable args[1].
    void substitute_under(std::vector<Expr>& args) const {
        const std::string variable = args[bound_variable].name();
        if (variable == name_) {
            return;
        }
        const std::set<std::string> names = free_symbols(args[0]);
        if (!names.contains(name_)) {
            return;
        }
        if (names_of_value_.contains(variable)) {
            const Expr renamed = Expr::symbol(fresh(variable, names, names_of_value_));
            args[0] = substitute(args[0], variable, renamed);
            args[bound_variable] = renamed;
        }
        args[0] = (*this)(args[0]);
    }

    std::string name_;
    Expr value_;
    std::set<std::string> names_of_value_;
};

void collect_paths(const Expr& e, Path& here, std::vector<Path>& out) {
    out.push_back(here);
    for (std::size_t i = 0; i < e.args().size(); ++i) {
        if (e.is_binder() && i == bound_variable) {
            continue;
        }
        here.push_back(i);
        collect_paths(e.args()[i], here, out);
        here.pop_back();
    }
}

} // namespace

std::set<std::string> free_symbols(const Expr& e) {
    std::set<std::string> out;
    std::multiset<std::string> bound;
    collect_free(e, bound, out);
    return out;
}

std::set<std::string> called_functions(const Expr& e) {
    std::set<std::string> out;
    walk(e, [&out](const Expr& x) {
        if (x.kind() == Expr::Kind::call && x.builtin() == Builtin::none) {
            out.insert(x.name());
        }
    });
    return out;
}

bool has_binder(const Expr& e) {
    bool found = false;
    walk(e, [&found](const Expr& x) { found = found || x.is_binder(); });
    return found;
}

Expr substitute(const Expr& e, std::string_view name, const Expr& value) {
    return Substitution(name, value)(e);
}

std::vector<Path> paths(const Expr& e) {
    std::vector<Path> out;
    Path here;
    collect_paths(e, here, out);
    return out;
}

Expr at(const Expr& e, std::span<const std::size_t> path) {
    return path.empty() ? e : at(e.arg(path.front()), path.subspan(1));
}

Expr replace(const Expr& e, std::span<const std::size_t> path, const Expr& value) {
    if (path.empty()) {
        return value;
    }
    const std::size_t i = path.front();
    Expr child = replace(e.arg(i), path.subspan(1), value);
    std::vector<Expr> args(e.args().begin(), e.args().end());
    args[i] = std::move(child);
    return Expr::with_args(e, std::move(args));
}

} // namespace edgeproof::formula
