// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/relations/weights.hpp"

#include <string>

namespace edgeproof::audit {
namespace {

ScalingWeights weights_of_name(const std::string& name) {
    if (name == "a" || name == "b" || name == "L") {
        return {0, 1, 0};
    }
    if (name == "P" || name == "M") {
        return {1, name == "M" ? 1 : 0, 0};
    }
    if (name == "Q" || name == "sig0") {
        return {0, name == "Q" ? 0 : -1, 1};
    }
    if (name.size() == 2 && name[1] >= '1' && name[1] <= '9') {
        const int k = name[1] - '0';
        if (name[0] == 'P') {
            return {1, -k, 0};
        }
        if (name[0] == 'b') {
            return {0, 1 - k, 0};
        }
    }
    return {0, 0, 0};
}

ScalingWeights times(ScalingWeights w, const Rational& q) {
    for (Rational& x : w) {
        x *= q;
    }
    return w;
}

ScalingWeights plus(ScalingWeights w, const ScalingWeights& o, int sign) {
    for (std::size_t i = 0; i < w.size(); ++i) {
        w[i] += sign * o[i];
    }
    return w;
}

} // namespace

std::optional<ScalingWeights> scaling_weights(const formula::Expr& e) {
    using Kind = formula::Expr::Kind;
    if (e.rational() != nullptr || e.kind() == Kind::pi) {
        return ScalingWeights{0, 0, 0};
    }
    if (e.kind() == Kind::symbol) {
        return weights_of_name(e.name());
    }
    const auto first = e.args().empty() ? std::nullopt : scaling_weights(e.arg(0));
    if (!first) {
        return {};
    }
    if (e.kind() == Kind::neg) {
        return first;
    }
    if (e.kind() == Kind::call) {
        return e.builtin() == formula::Builtin::sqrt ? std::optional(times(*first, Rational(1, 2)))
                                                     : std::nullopt;
    }
    if (e.kind() == Kind::pow) {
        const Rational* q = e.arg(1).rational();
        return q != nullptr ? std::optional(times(*first, *q)) : std::nullopt;
    }
    if (e.is_binder()) {
        return {};
    }
    const auto second = scaling_weights(e.arg(1));
    if (!second) {
        return {};
    }
    switch (e.kind()) {
    case Kind::mul:
        return plus(*first, *second, 1);
    case Kind::div:
        return plus(*first, *second, -1);
    default: // a sum; it is not necessary to know if a part is zero
        return *first == *second ? first : std::nullopt;
    }
}

} // namespace edgeproof::audit
