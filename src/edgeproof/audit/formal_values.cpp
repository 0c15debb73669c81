// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/formal_values.hpp"

#include "edgeproof/formula/environment.hpp"
#include "edgeproof/precision/error.hpp"

namespace edgeproof {
namespace {

/// Between 0 and 1, from the name and the draw.
Rational random_fraction(const std::string& name, std::size_t draw) {
    constexpr std::size_t steps = 9973;
    return {static_cast<long>(stratified_index("formal/" + name, steps, draw) + 1),
            static_cast<long>(steps + 1)};
}

/// Lengths in an order that printed formulas take for granted: a largest, b next, the rest small.
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

Values<Real> as_environment(const Variables& values) {
    Values<Real> environment;
    for (const auto& [name, value] : values) {
        environment.set(name, value);
    }
    return environment;
}

} // namespace

FormalValues::FormalValues(const std::set<std::string>& names, const SymbolicCase& under,
                           std::size_t draw, unsigned working_digits)
    : working_digits_(working_digits) {
    const PrecisionScope scope(working_digits_);
    std::set<std::string> dependent;
    std::set<std::string> wanted = names;
    wanted.insert({"a", "b"});
    for (const std::string& name : wanted) {
        const Expr meaning = derive(Expr::symbol(name), under);
        if (meaning == Expr::symbol(name)) {
            values_.emplace(name, from_rational<Real>(drawn(name, draw)));
        } else {
            dependent.insert(name);
            for (const std::string& other : free_symbols(meaning)) {
                values_.emplace(other, from_rational<Real>(drawn(other, draw)));
            }
        }
    }
    const Values<Real> environment = as_environment(values_);
    for (const std::string& name : dependent) {
        values_.insert_or_assign(
            name, edgeproof::evaluate<Real>(derive(Expr::symbol(name), under), environment));
    }
}

Real FormalValues::evaluate(const Expr& e) const {
    const PrecisionScope scope(working_digits_);
    return edgeproof::evaluate<Real>(e, as_environment(values_));
}

} // namespace edgeproof
