// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/precision/ball/arb_values.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <string>
#include <vector>

namespace edgeproof::formula {
namespace {

class Encloser {
public:
    explicit Encloser(long bits) : bits_(bits) {}

    [[nodiscard]] ArbValue operator()(const Expr& e) const {
        check_interruption();
        ArbValue y;
        if (const Rational* q = e.rational()) {
            arb_set_fmpq(y, to_fmpq(*q), bits_);
            return y;
        }
        switch (e.kind()) {
        case Expr::Kind::pi:
            arb_const_pi(y, bits_);
            return y;
        case Expr::Kind::neg:
            arb_neg(y, (*this)(e.arg(0)));
            return y;
        case Expr::Kind::add:
            arb_add(y, (*this)(e.arg(0)), (*this)(e.arg(1)), bits_);
            return y;
        case Expr::Kind::sub:
            arb_sub(y, (*this)(e.arg(0)), (*this)(e.arg(1)), bits_);
            return y;
        case Expr::Kind::mul:
            arb_mul(y, (*this)(e.arg(0)), (*this)(e.arg(1)), bits_);
            return y;
        case Expr::Kind::div:
            arb_div(y, (*this)(e.arg(0)), (*this)(e.arg(1)), bits_);
            return y;
        case Expr::Kind::pow:
            return power(e);
        case Expr::Kind::sum:
            return sum(e);
        case Expr::Kind::call:
            return call(e);
        default:
            throw Error("'" + e.name() + "' has no meaning in a constant");
        }
    }

private:
    [[nodiscard]] ArbValue power(const Expr& e) const {
        ArbValue y;
        const ArbValue base = (*this)(e.arg(0));
        if (const Rational* q = e.arg(1).rational()) {
            arb_pow_fmpq(y, base, to_fmpq(*q), bits_);
        } else {
            arb_pow(y, base, (*this)(e.arg(1)), bits_);
        }
        return y;
    }

    [[nodiscard]] ArbValue sum(const Expr& e) const {
        ArbValue total;
        const auto [lo, hi] = sum_bounds(e);
        for (long k = lo; k <= hi; ++k) {
            const Expr term = substitute(e.arg(0), e.arg(1).name(), Expr::number(Rational(k)));
            arb_add(total, total, (*this)(term), bits_);
        }
        return total;
    }

    [[nodiscard]] ArbValue call(const Expr& e) const {
        std::vector<ArbValue> x;
        for (const Expr& arg : e.args()) {
            x.push_back((*this)(arg));
        }
        ArbValue y;
        switch (e.builtin()) {
        case Builtin::atan2:
            arb_atan2(y, x[0], x[1], bits_);
            return y;
        case Builtin::hypot:
            arb_hypot(y, x[0], x[1], bits_);
            return y;
        case Builtin::max:
        case Builtin::min:
            arb_set(y, x[0]);
            for (const ArbValue& z : x) {
                (e.builtin() == Builtin::max ? arb_max : arb_min)(y, y, z, bits_);
            }
            return y;
        case Builtin::abs:
            arb_abs(y, x[0]);
            return y;
        case Builtin::sgn:
            arb_sgn(y, x[0]);
            return y;
        case Builtin::step:
            arb_sgn(y, x[0]);
            arb_add_ui(y, y, 1, bits_);
            arb_mul_2exp_si(y, y, -1);
            return y;
        case Builtin::none:
            throw Error("the function '" + e.name() + "' has no meaning in a constant");
        default:
            elementary(e.builtin())(y, x[0], bits_);
            return y;
        }
    }

    using Elementary = void (*)(arb_ptr, arb_srcptr, slong);
    static Elementary elementary(Builtin f) {
        switch (f) {
        case Builtin::sqrt:
            return arb_sqrt;
        case Builtin::exp:
            return arb_exp;
        case Builtin::log:
            return arb_log;
        case Builtin::sin:
            return arb_sin;
        case Builtin::cos:
            return arb_cos;
        case Builtin::tan:
            return arb_tan;
        case Builtin::asin:
            return arb_asin;
        case Builtin::acos:
            return arb_acos;
        case Builtin::atan:
            return arb_atan;
        case Builtin::sinh:
            return arb_sinh;
        case Builtin::cosh:
            return arb_cosh;
        case Builtin::tanh:
            return arb_tanh;
        case Builtin::asinh:
            return arb_asinh;
        case Builtin::acosh:
            return arb_acosh;
        case Builtin::atanh:
            return arb_atanh;
        case Builtin::gamma:
            return arb_gamma;
        default:
            throw Error("'" + std::string(name_of(f)) + "' has no enclosure");
        }
    }

    long bits_;
};

} // namespace

std::optional<Enclosure> enclose(const Expr& constant, long bits) {
    const ArbValue ball = Encloser(bits)(constant);
    if (arb_is_finite(ball) == 0) {
        return std::nullopt;
    }
    Enclosure result;
    mpfr_set_prec(result.lower.backend().data(), bits + 2);
    mpfr_set_prec(result.upper.backend().data(), bits + 2);
    arb_get_interval_mpfr(result.lower.backend().data(), result.upper.backend().data(), ball);
    return result;
}

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

Ball ball_of(const Exact& x, long bits) {
    if (x.is_rational()) {
        return Ball(x.rational(), bits);
    }
    const auto e = enclose(x.expr(), bits);
    if (!e) {
        throw BudgetError("'" + x.text() + "' cannot be enclosed");
    }
    return Ball::from_interval(e->lower, e->upper, bits);
}

long bits_for(unsigned digits) { return static_cast<long>(digits) * 10 / 3 + 16; }

std::optional<Rational> rational_of(const Exact& x) {
    if (x.is_rational()) {
        return x.rational();
    }
    return {};
}

} // namespace edgeproof::formula
