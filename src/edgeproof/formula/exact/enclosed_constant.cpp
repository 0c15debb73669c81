// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/exact/enclosed_constant.hpp"

#include "edgeproof/formula/evaluate.hpp"
#include "edgeproof/precision/error.hpp"

#include <string>
#include <string_view>

namespace edgeproof::formula {
namespace {

struct ConstantEnvironment {
    long bits;
    [[nodiscard]] Ball number(const Rational& q) const { return {q, bits}; }
    [[nodiscard]] Ball pi() const { return Ball::pi(bits); }
    [[nodiscard]] static Ball symbol(std::string_view name) {
        throw Error("the constant has a variable " + std::string(name));
    }
};

} // namespace

Ball enclosed_constant(const Expr& e, long bits) {
    if (const Rational* q = e.rational()) {
        return {*q, bits};
    }
    return evaluate<Ball>(e, ConstantEnvironment{bits});
}

Ball enclosed_constant(const Exact& x, long bits) { return enclosed_constant(x.expr(), bits); }

} // namespace edgeproof::formula
