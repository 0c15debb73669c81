// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/algebra/identity.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/contact/profile/slope.hpp"

#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace edgeproof::contact {

Expr slope_from_knot(const Expr& slope, const Expr& knot) {
    if (!free_symbols(slope).contains("x")) {
        return slope;
    }
    if (const auto linear = as_linear(slope, "x")) {
        const Expr there = linear->at_origin + linear->rate * knot;
        const Expr moved = linear->rate * Expr::symbol("x");
        const Rational* q = there.rational();
        return algebra::proved_zero(there) ? moved
                                           : (q != nullptr ? Expr::number(*q) : there) + moved;
    }
    std::vector<Expr> args;
    for (const Expr& x : slope.args()) {
        args.push_back(slope_from_knot(x, knot));
    }
    return Expr::with_args(slope, std::move(args));
}

namespace {

constexpr long largest_root = 24;

/// (factor x)^exponent.
struct PowerOfX {
    Expr factor;
    Rational exponent;
};

std::optional<PowerOfX> power_of_x(const Expr& e) {
    const bool root = e.kind() == Expr::Kind::call && e.builtin() == formula::Builtin::sqrt;
    if (!root && e.kind() != Expr::Kind::pow) {
        return {};
    }
    const Rational* exponent = root ? nullptr : e.arg(1).rational();
    const auto linear = as_linear(e.arg(0), "x");
    const Rational* constant = linear ? linear->at_origin.rational() : nullptr;
    if ((!root && exponent == nullptr) || constant == nullptr || *constant != 0) {
        return {};
    }
    return PowerOfX{linear->rate, root ? Rational(1, 2) : *exponent};
}

void collect(const Expr& e, long& root) {
    if (const auto power = power_of_x(e)) {
        const Integer least = denominator(power->exponent);
        root = least > largest_root ? largest_root + 1 : std::lcm(root, least.convert_to<long>());
        return;
    }
    for (const Expr& part : e.args()) {
        if (root <= largest_root) {
            collect(part, root);
        }
    }
}

/// e with +w^root or -w^root in place of x (docs/curved-slopes.md, "What is integrated").
Expr with_root(const Expr& e, long root, bool positive) {
    const Expr w = Expr::symbol("x");
    const auto signed_by_side = [&](const Expr& x) { return positive ? x : -x; };
    if (const auto power = power_of_x(e)) {
        const Expr n = Expr::number(Rational(power->exponent * root));
        return pow(signed_by_side(power->factor), Expr::number(power->exponent)) * pow(w, n);
    }
    if (e.kind() == Expr::Kind::symbol) {
        return signed_by_side(pow(w, Expr::number(Rational(root))));
    }
    if (e.args().empty()) {
        return e;
    }
    std::vector<Expr> args;
    for (const Expr& part : e.args()) {
        args.push_back(with_root(part, root, positive));
    }
    return Expr::with_args(e, std::move(args));
}

} // namespace

std::optional<SlopeAtRoot> slope_at_root(const Expr& slope, const Expr& knot, bool to_the_right) {
    const Expr moved = slope_from_knot(slope, knot);
    long root = 1;
    collect(moved, root);
    if (root == 1 || root > largest_root) {
        return {};
    }
    return SlopeAtRoot{with_root(moved, root, to_the_right), root};
}

} // namespace edgeproof::contact
