// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/profile/slope_at_root.hpp"

#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/contact/profile/slope_from_knot.hpp"

#include <numeric>
#include <utility>
#include <vector>

namespace edgeproof::contact {
namespace {

constexpr long largest_root = 24;

/// (factor x)^exponent.
struct PowerOfX {
    formula::Expr factor;
    Rational exponent;
};

std::optional<PowerOfX> power_of_x(const formula::Expr& e) {
    const bool root =
        e.kind() == formula::Expr::Kind::call && e.builtin() == formula::Builtin::sqrt;
    if (!root && e.kind() != formula::Expr::Kind::pow) {
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

void collect(const formula::Expr& e, long& root) {
    if (const auto power = power_of_x(e)) {
        const Integer least = denominator(power->exponent);
        root = least > largest_root ? largest_root + 1 : std::lcm(root, least.convert_to<long>());
        return;
    }
    for (const formula::Expr& part : e.args()) {
        if (root <= largest_root) {
            collect(part, root);
        }
    }
}

/// e with +w^root or -w^root in place of x (docs/curved-slopes.md, "What is integrated").
formula::Expr with_root(const formula::Expr& e, long root, bool positive) {
    const formula::Expr w = formula::Expr::symbol("x");
    const auto signed_by_side = [&](const formula::Expr& x) { return positive ? x : -x; };
    if (const auto power = power_of_x(e)) {
        const formula::Expr n = formula::Expr::number(Rational(power->exponent * root));
        return pow(signed_by_side(power->factor), formula::Expr::number(power->exponent)) *
               pow(w, n);
    }
    if (e.kind() == formula::Expr::Kind::symbol) {
        return signed_by_side(pow(w, formula::Expr::number(Rational(root))));
    }
    if (e.args().empty()) {
        return e;
    }
    std::vector<formula::Expr> args;
    for (const formula::Expr& part : e.args()) {
        args.push_back(with_root(part, root, positive));
    }
    return formula::Expr::with_args(e, std::move(args));
}

} // namespace

std::optional<SlopeAtRoot> slope_at_root(const formula::Expr& slope, const formula::Expr& knot,
                                         bool to_the_right) {
    const formula::Expr moved = slope_from_knot(slope, knot);
    long root = 1;
    collect(moved, root);
    if (root == 1 || root > largest_root) {
        return {};
    }
    return SlopeAtRoot{with_root(moved, root, to_the_right), root};
}

} // namespace edgeproof::contact
