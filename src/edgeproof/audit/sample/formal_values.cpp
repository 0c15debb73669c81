// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/sample/formal_values.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

/// Returns a number between 0 and 1 that depends on the name and the draw.
Rational random_fraction(const std::string& name, std::size_t draw) {
    constexpr std::size_t steps = 9973;
    return {static_cast<long>(stratified_index("formal/" + name, steps, draw) + 1),
            static_cast<long>(steps + 1)};
}

/// Lengths have the order that printed formulas assume: a is largest, then b; others are small.
Rational drawn(const std::string& name, std::size_t draw) {
    const Rational r = random_fraction(name, draw);
    if (name == "a") {
        return 2 + r;
    }
    if (name == "b") {
        return 1 + r / 2;
    }
    if (name == "X") {
        return Rational(1, 2) + r / 3;
    }
    return Rational(1, 10) + r * Rational(2, 5);
}

} // namespace

FormalValues::FormalValues(const std::set<std::string>& names, const SymbolicCase& under,
                           std::size_t draw, unsigned working_digits)
    : working_digits_(working_digits) {
    const PrecisionScope scope(working_digits_);
    std::set<std::string> wanted = names;
    wanted.insert({"a", "b"});
    const auto set_drawn = [&](const std::string& name) {
        values_.set(name, from_rational<Real>(drawn(name, draw)));
    };
    std::map<std::string, Expr> meanings;
    for (const std::string& name : wanted) {
        const Expr meaning = derive(Expr::symbol(name), under);
        if (meaning == Expr::symbol(name)) {
            set_drawn(name);
        } else {
            meanings.emplace(name, meaning);
            std::ranges::for_each(free_symbols(meaning), set_drawn);
        }
    }
    const formula::Values<Real> free = values_;
    for (const auto& [name, meaning] : meanings) {
        values_.set(name, formula::evaluate<Real>(meaning, free));
    }
}

Real FormalValues::evaluate(const Expr& e) const {
    const PrecisionScope scope(working_digits_);
    return formula::evaluate<Real>(e, values_);
}

} // namespace edgeproof::audit
