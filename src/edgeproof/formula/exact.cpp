// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/exact.hpp"

#include "edgeproof/formula/environment.hpp"
#include "edgeproof/formula/evaluate.hpp"
#include "edgeproof/formula/parse.hpp"

#include <utility>

namespace edgeproof {
namespace {

Real value_at(const Expr& e, unsigned digits) {
    const PrecisionScope scope(digits);
    return evaluate<Real>(e, Values<Real>{});
}

} // namespace

Exact::Exact() : text_("0") {}

Exact Exact::parse(std::string_view text) {
    Expr e = edgeproof::parse(text);
    if (e.rational() == nullptr) {
        try {
            (void)value_at(e, 30);
        } catch (const DomainError& error) {
            throw FormulaError(error.what(), "write a constant with a real value", 0);
        }
    }
    return {std::string(text), std::move(e)};
}

Exact::Exact(Expr e) : text_(to_text(e)), expr_(std::move(e)) {
    if (expr_.rational() == nullptr) {
        (void)value_at(expr_, 30);
    }
}

Exact Exact::of(const Rational& q) {
    Expr e = Expr::number(q);
    return {to_text(e), std::move(e)};
}

const Rational& Exact::rational() const {
    if (!is_rational()) {
        throw Error("'" + text_ + "' is not a rational number");
    }
    return *expr_.rational();
}

template <Arithmetic T> T Exact::to() const {
    if (is_rational()) {
        return number_of<T>(rational());
    }
    const Real wide = value_at(expr_, digits_of<T>() + 40);
    if constexpr (std::same_as<T, Real>) {
        return at_working_precision(wide);
    } else {
        return wide.convert_to<T>();
    }
}

template double Exact::to() const;
template long double Exact::to() const;
template Float128 Exact::to() const;
template Real Exact::to() const;

int Exact::sign() const {
    if (is_rational()) {
        return rational().sign();
    }
    const Real wide = value_at(expr_, 100);
    return wide.sign();
}

} // namespace edgeproof
