// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::formula {
namespace {

constexpr std::size_t bound_variable = 1;

/// Calls visit(i) for each child of e except a bound variable.
template <class Visit> void for_parts(const Expr& e, const Visit& visit) {
    for (std::size_t i = 0; i < e.args().size(); ++i) {
        if (!(e.is_binder() && i == bound_variable)) {
            visit(i);
        }
    }
}

/// A binder binds its variable in its first argument only.
void collect_free(const Expr& e, std::vector<std::string_view>& bound, std::set<std::string>& out) {
    if (e.kind() == Expr::Kind::symbol && std::ranges::find(bound, e.name()) == bound.end()) {
        out.insert(e.name());
    }
    for_parts(e, [&](std::size_t i) {
        const bool binds = e.is_binder() && i == 0;
        if (binds) {
            bound.emplace_back(e.args()[bound_variable].name());
        }
        collect_free(e.args()[i], bound, out);
        if (binds) {
            bound.pop_back();
        }
    });
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
        for_parts(e, [&](std::size_t i) {
            if (e.is_binder() && i == 0) {
                substitute_under(args);
            } else {
                args[i] = (*this)(args[i]);
            }
        });
        return std::ranges::equal(args, e.args()) ? e : Expr::with_args(e, std::move(args));
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
    for_parts(e, [&](std::size_t i) {
        here.push_back(i);
        collect_paths(e.args()[i], here, out);
        here.pop_back();
    });
}

} // namespace

std::set<std::string> free_symbols(const Expr& e) {
    std::set<std::string> out;
    std::vector<std::string_view> bound;
    collect_free(e, bound, out);
    return out;
}

bool holds_symbol(const Expr& e, std::string_view name) {
    if (e.kind() == Expr::Kind::symbol) {
        return e.name() == name;
    }
    bool found = false;
    for_parts(e, [&](std::size_t i) {
        const bool hidden = e.is_binder() && i == 0 && e.args()[bound_variable].name() == name;
        found = found || (!hidden && holds_symbol(e.args()[i], name));
    });
    return found;
}

bool holds_call(const Expr& e, std::string_view name) {
    return any_part(e, [&](const Expr& part) {
        return part.kind() == Expr::Kind::call && part.name() == name;
    });
}

bool has_binder(const Expr& e) { return any_part(e, &Expr::is_binder); }

Expr substitute(const Expr& e, std::string_view name, const Expr& value) {
    return Substitution(name, value)(e);
}

std::optional<std::size_t> order_behind(std::string_view name, std::string_view stem) {
    const bool fits = name.starts_with(stem) && name.size() == stem.size() + 1 &&
                      name.back() >= '0' && name.back() <= '9';
    return fits ? std::optional(static_cast<std::size_t>(name.back() - '0')) : std::nullopt;
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
