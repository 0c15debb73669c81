// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/exact/enclosed_constant.hpp"

#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/precision/error.hpp"

#include <string>

namespace edgeproof::formula {

Ball BallConstants::symbol(std::string_view name) {
    throw Error("the constant has a variable " + std::string(name));
}

Ball enclosed_constant(const Expr& e, long bits) {
    if (const Rational* q = e.rational()) {
        return {*q, bits};
    }
    return evaluate<Ball>(e, BallConstants{bits});
}

Ball enclosed_constant(const Exact& x, long bits) { return enclosed_constant(x.expr(), bits); }

} // namespace edgeproof::formula
