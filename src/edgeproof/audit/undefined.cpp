// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/undefined.hpp"

#include "edgeproof/audit/magnitude.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof {
namespace {

using Kind = Expr::Kind;

constexpr int halvings = 16; // places in an integral: 2^-16 of its length from an end, at the least

/// A formula at a spot, under values for the variables of the integrals that it stands in.
class At {
public:
    At(const Spot& spot, Variables variables) : spot_(spot), variables_(std::move(variables)) {}

    /// By more than roundoff.
    [[nodiscard]] bool undefined(const Expr& e) {
        switch (e.kind()) {
        case Kind::call:
            if (negative_inside(e) || (e.name() == "q" && beyond_the_contact(e.arg(0)))) {
                return true;
            }
            break;
        case Kind::pow:
            if (const Rational* k = e.arg(1).rational();
                k != nullptr && denominator(*k) != 1 && negative(e.arg(0))) {
                return true;
            }
            break;
        case Kind::integral:
        case Kind::pv:
            return undefined_within(e);
        case Kind::neg:
        case Kind::add:
        case Kind::sub:
        case Kind::mul:
        case Kind::div:
            break;
        default:
            return false;
        }
        return std::any_of(e.args().begin(), e.args().end(),
                           [&](const Expr& part) { return undefined(part); });
    }

    [[nodiscard]] bool by_roundoff() const { return by_roundoff_; }

private:
    [[nodiscard]] Real value(const Expr& e) const {
        return spot_.setting->evaluate(e, spot_.place ? &*spot_.place : nullptr, variables_).value;
    }
    [[nodiscard]] bool negative(const Expr& e) {
        try {
            const Real x = value(e);
            const Real terms = magnitude(e, [this](const Expr& part) { return value(part); });
            const bool beyond = -x > terms * pow(Real(10), -20);
            by_roundoff_ = by_roundoff_ || (x < 0 && !beyond);
            return x < 0 && beyond;
        } catch (const Error&) {
            return false; // it has a part that is undefined, which is looked at by itself
        }
    }
    [[nodiscard]] bool negative_inside(const Expr& e) {
        return (e.builtin() == Builtin::sqrt || e.builtin() == Builtin::log) && negative(e.arg(0));
    }
    [[nodiscard]] bool beyond_the_contact(const Expr& x) {
        return negative(Expr::symbol("a") - x) || negative(x + Expr::symbol("b"));
    }
    [[nodiscard]] bool undefined_within(const Expr& integral) {
        const Expr& from = integral.arg(2);
        const Expr& to = integral.arg(3);
        if (undefined(from) || undefined(to)) {
            return true;
        }
        try {
            const Real lo = value(from);
            const Real length = value(to) - lo;
            for (int k = 1; k <= halvings; ++k) {
                const Real part = ldexp(length, -k);
                for (const Real& s : {Real(lo + part), Real(lo + length - part)}) {
                    Variables inside = variables_;
                    inside.insert_or_assign(integral.arg(1).name(), s);
                    At there(spot_, std::move(inside));
                    if (there.undefined(integral.arg(0))) {
                        return true;
                    }
                    by_roundoff_ = by_roundoff_ || there.by_roundoff();
                }
            }
        } catch (const Error&) {
            return false; // limits without a value, for reasons that are none here
        }
        return false;
    }

    const Spot& spot_;
    Variables variables_;
    bool by_roundoff_ = false;
};

} // namespace

Undefined why_undefined(const Expr& e, const Spot& spot) {
    At at(spot, spot.variables);
    return at.undefined(e)    ? Undefined::beyond_roundoff
           : at.by_roundoff() ? Undefined::by_roundoff
                              : Undefined::unknown;
}

} // namespace edgeproof
