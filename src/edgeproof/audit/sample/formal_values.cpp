// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/sample/formal_values.hpp"

#include "edgeproof/precision/error.hpp"

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
    for (const std::string& name : wanted) {
        const Expr meaning = derive(Expr::symbol(name), under);
        if (meaning == Expr::symbol(name)) {
            drawn_.emplace(name, drawn(name, draw));
        } else {
            meanings_.emplace(name, meaning);
            for (const std::string& other : free_symbols(meaning)) {
                drawn_.emplace(other, drawn(other, draw));
            }
        }
    }
    for (const auto& [name, q] : drawn_) {
        values_.set(name, from_rational<Real>(q));
    }
    const formula::Values<Real> drawn_values = values_;
    for (const auto& [name, meaning] : meanings_) {
        values_.set(name, formula::evaluate<Real>(meaning, drawn_values));
    }
}

Real FormalValues::evaluate(const Expr& e) const {
    const PrecisionScope scope(working_digits_);
    return formula::evaluate<Real>(e, values_);
}

Ball FormalValues::enclose(const Expr& e, long bits) const {
    struct Balls {
        const FormalValues& values;
        long bits;
        [[nodiscard]] Ball number(const Rational& q) const { return Ball(q, bits); }
        [[nodiscard]] Ball pi() const { return Ball::pi(bits); }
        [[nodiscard]] Ball symbol(std::string_view name) const {
            if (const auto it = values.meanings_.find(name); it != values.meanings_.end()) {
                return formula::evaluate<Ball>(it->second, *this);
            }
            const auto it = values.drawn_.find(name);
            if (it == values.drawn_.end()) {
                throw Error("'" + std::string(name) + "' has no value here");
            }
            return Ball(it->second, bits);
        }
    };
    return formula::evaluate<Ball>(e, Balls{*this, bits});
}

} // namespace edgeproof::audit
