// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/exact/enclosure.hpp"

#include "edgeproof/formula/evaluate.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#ifdef EDGEPROOF_ARB_IN_FLINT
#include <flint/arb.h>
#else
#include <arb.h>
#endif
#include <flint/fmpq.h>

#include <vector>

namespace edgeproof::formula {
namespace {

class ArbBall {
public:
    ArbBall() { arb_init(x_); }
    ArbBall(const ArbBall&) = delete;
    ArbBall& operator=(const ArbBall&) = delete;
    ArbBall(ArbBall&& other) noexcept : ArbBall() { arb_swap(x_, other.x_); }
    ArbBall& operator=(ArbBall&&) = delete;
    ~ArbBall() { arb_clear(x_); }
    [[nodiscard]] arb_ptr get() { return x_; }
    [[nodiscard]] arb_srcptr get() const { return x_; }

private:
    arb_t x_;
};

class Fraction {
public:
    explicit Fraction(const Rational& q) {
        fmpq_init(q_);
        fmpq_set_mpq(q_, q.backend().data());
    }
    ~Fraction() { fmpq_clear(q_); }
    Fraction(const Fraction&) = delete;
    Fraction& operator=(const Fraction&) = delete;
    [[nodiscard]] const fmpq* get() const { return q_; }

private:
    fmpq_t q_;
};

class Encloser {
public:
    explicit Encloser(long bits) : bits_(bits) {}

    [[nodiscard]] ArbBall operator()(const Expr& e) const {
        check_interruption();
        ArbBall y;
        if (const Rational* q = e.rational()) {
            arb_set_fmpq(y.get(), Fraction(*q).get(), bits_);
            return y;
        }
        switch (e.kind()) {
        case Expr::Kind::pi:
            arb_const_pi(y.get(), bits_);
            return y;
        case Expr::Kind::neg:
            arb_neg(y.get(), (*this)(e.arg(0)).get());
            return y;
        case Expr::Kind::add:
            arb_add(y.get(), (*this)(e.arg(0)).get(), (*this)(e.arg(1)).get(), bits_);
            return y;
        case Expr::Kind::sub:
            arb_sub(y.get(), (*this)(e.arg(0)).get(), (*this)(e.arg(1)).get(), bits_);
            return y;
        case Expr::Kind::mul:
            arb_mul(y.get(), (*this)(e.arg(0)).get(), (*this)(e.arg(1)).get(), bits_);
            return y;
        case Expr::Kind::div:
            arb_div(y.get(), (*this)(e.arg(0)).get(), (*this)(e.arg(1)).get(), bits_);
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
    [[nodiscard]] ArbBall power(const Expr& e) const {
        ArbBall y;
        const ArbBall base = (*this)(e.arg(0));
        if (const Rational* q = e.arg(1).rational()) {
            arb_pow_fmpq(y.get(), base.get(), Fraction(*q).get(), bits_);
        } else {
            arb_pow(y.get(), base.get(), (*this)(e.arg(1)).get(), bits_);
        }
        return y;
    }

    [[nodiscard]] ArbBall sum(const Expr& e) const {
        ArbBall total;
        const auto [lo, hi] = sum_bounds(e);
        for (long k = lo; k <= hi; ++k) {
            const Expr term = substitute(e.arg(0), e.arg(1).name(), Expr::number(Rational(k)));
            arb_add(total.get(), total.get(), (*this)(term).get(), bits_);
        }
        return total;
    }

    [[nodiscard]] ArbBall call(const Expr& e) const {
        std::vector<ArbBall> x;
        for (const Expr& arg : e.args()) {
            x.push_back((*this)(arg));
        }
        ArbBall y;
        switch (e.builtin()) {
        case Builtin::atan2:
            arb_atan2(y.get(), x[0].get(), x[1].get(), bits_);
            return y;
        case Builtin::hypot:
            arb_hypot(y.get(), x[0].get(), x[1].get(), bits_);
            return y;
        case Builtin::max:
        case Builtin::min:
            arb_set(y.get(), x[0].get());
            for (const ArbBall& z : x) {
                (e.builtin() == Builtin::max ? arb_max : arb_min)(y.get(), y.get(), z.get(), bits_);
            }
            return y;
        case Builtin::abs:
            arb_abs(y.get(), x[0].get());
            return y;
        case Builtin::sgn:
            arb_sgn(y.get(), x[0].get());
            return y;
        case Builtin::step:
            arb_sgn(y.get(), x[0].get());
            arb_add_ui(y.get(), y.get(), 1, bits_);
            arb_mul_2exp_si(y.get(), y.get(), -1);
            return y;
        case Builtin::none:
            throw Error("the function '" + e.name() + "' has no meaning in a constant");
        default:
            elementary(e.builtin())(y.get(), x[0].get(), bits_);
            return y;
        }
    }

    using Elementary = void (*)(arb_ptr, arb_srcptr, slong);
    static Elementary elementary(Builtin f) {
        switch (f) {
        case Builtin::sqrt:
            return [](arb_ptr y, arb_srcptr x, slong bits) { arb_sqrt(y, x, bits); };
        case Builtin::exp:
            return [](arb_ptr y, arb_srcptr x, slong bits) { arb_exp(y, x, bits); };
        case Builtin::log:
            return [](arb_ptr y, arb_srcptr x, slong bits) { arb_log(y, x, bits); };
        case Builtin::sin:
            return [](arb_ptr y, arb_srcptr x, slong bits) { arb_sin(y, x, bits); };
        case Builtin::cos:
            return [](arb_ptr y, arb_srcptr x, slong bits) { arb_cos(y, x, bits); };
        case Builtin::tan:
            return [](arb_ptr y, arb_srcptr x, slong bits) { arb_tan(y, x, bits); };
        case Builtin::asin:
            return [](arb_ptr y, arb_srcptr x, slong bits) { arb_asin(y, x, bits); };
        case Builtin::acos:
            return [](arb_ptr y, arb_srcptr x, slong bits) { arb_acos(y, x, bits); };
        case Builtin::atan:
            return [](arb_ptr y, arb_srcptr x, slong bits) { arb_atan(y, x, bits); };
        case Builtin::sinh:
            return [](arb_ptr y, arb_srcptr x, slong bits) { arb_sinh(y, x, bits); };
        case Builtin::cosh:
            return [](arb_ptr y, arb_srcptr x, slong bits) { arb_cosh(y, x, bits); };
        case Builtin::tanh:
            return [](arb_ptr y, arb_srcptr x, slong bits) { arb_tanh(y, x, bits); };
        case Builtin::asinh:
            return [](arb_ptr y, arb_srcptr x, slong bits) { arb_asinh(y, x, bits); };
        case Builtin::acosh:
            return [](arb_ptr y, arb_srcptr x, slong bits) { arb_acosh(y, x, bits); };
        case Builtin::atanh:
            return [](arb_ptr y, arb_srcptr x, slong bits) { arb_atanh(y, x, bits); };
        case Builtin::gamma:
            return [](arb_ptr y, arb_srcptr x, slong bits) { arb_gamma(y, x, bits); };
        default:
            throw Error("'" + std::string(name_of(f)) + "' has no enclosure");
        }
    }

    long bits_;
};

} // namespace

std::optional<Enclosure> enclose(const Expr& constant, long bits) {
    const ArbBall ball = Encloser(bits)(constant);
    if (arb_is_finite(ball.get()) == 0) {
        return std::nullopt;
    }
    Enclosure result;
    mpfr_set_prec(result.lower.backend().data(), bits + 2);
    mpfr_set_prec(result.upper.backend().data(), bits + 2);
    arb_get_interval_mpfr(result.lower.backend().data(), result.upper.backend().data(), ball.get());
    return result;
}

} // namespace edgeproof::formula
