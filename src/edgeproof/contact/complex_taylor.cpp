// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/complex_taylor.hpp"

#include "edgeproof/precision/ball.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof {
namespace {

class Poly {
public:
    Poly() { acb_poly_init(p_); }
    ~Poly() { acb_poly_clear(p_); }
    Poly(const Poly&) = delete;
    Poly& operator=(const Poly&) = delete;
    operator acb_poly_struct*() { return p_; } // NOLINT: what Arb's functions take

private:
    acb_poly_t p_;
};

class Walk {
public:
    Walk(const acb_t at, long terms, long bits) : at_(at), terms_(terms), bits_(bits) {}

    void operator()(acb_poly_struct* r, const Expr& e) const {
        if (const Rational* q = e.rational()) {
            constant(r, Ball(*q, bits_));
            return;
        }
        switch (e.kind()) {
        case Expr::Kind::pi:
            constant(r, Ball::pi(bits_));
            return;
        case Expr::Kind::symbol:
            acb_poly_set_coeff_acb(r, 0, at_);
            if (terms_ > 1) {
                acb_poly_set_coeff_si(r, 1, 1);
            }
            return;
        case Expr::Kind::neg:
            (*this)(r, e.arg(0));
            acb_poly_neg(r, r);
            return;
        case Expr::Kind::pow:
            power(r, e);
            return;
        case Expr::Kind::call:
            call(r, e);
            return;
        default:
            break;
        }
        Poly x;
        Poly y;
        (*this)(x, e.arg(0));
        (*this)(y, e.arg(1));
        switch (e.kind()) {
        case Expr::Kind::add:
            acb_poly_add(r, x, y, bits_);
            break;
        case Expr::Kind::sub:
            acb_poly_sub(r, x, y, bits_);
            break;
        case Expr::Kind::mul:
            acb_poly_mullow(r, x, y, terms_, bits_);
            break;
        case Expr::Kind::div:
            acb_poly_div_series(r, x, y, terms_, bits_);
            break;
        default:
            nowhere(r);
        }
    }

private:
    static void constant(acb_poly_struct* r, const Ball& c) {
        acb_t z;
        acb_init(z);
        acb_set_arb(z, c.data());
        acb_poly_set_acb(r, z);
        acb_clear(z);
    }
    void nowhere(acb_poly_struct* r) const {
        acb_t z;
        acb_init(z);
        acb_indeterminate(z);
        for (long k = 0; k < terms_; ++k) {
            acb_poly_set_coeff_acb(r, k, z);
        }
        acb_clear(z);
    }
    /// The constant term may lie on (-inf, 0].
    static bool meets_cut(acb_poly_struct* x) {
        acb_t z;
        acb_init(z);
        acb_poly_get_coeff_acb(z, x, 0);
        const bool meets =
            arb_contains_zero(acb_imagref(z)) != 0 && arb_contains_nonpositive(acb_realref(z)) != 0;
        acb_clear(z);
        return meets;
    }
    void power(acb_poly_struct* r, const Expr& e) const {
        Poly x;
        (*this)(x, e.arg(0));
        const Rational* exponent = e.arg(1).rational();
        if (exponent != nullptr && boost::multiprecision::denominator(*exponent) == 1 &&
            abs(*exponent) < 10000) {
            const long n = boost::multiprecision::numerator(*exponent).convert_to<long>();
            acb_poly_pow_ui_trunc_binexp(r, x, static_cast<ulong>(n < 0 ? -n : n), terms_, bits_);
            if (n < 0) {
                acb_poly_inv_series(r, r, terms_, bits_);
            }
            return;
        }
        if (meets_cut(x)) {
            nowhere(r);
            return;
        }
        Poly y;
        (*this)(y, e.arg(1));
        acb_poly_log_series(x, x, terms_, bits_);
        acb_poly_mullow(x, x, y, terms_, bits_);
        acb_poly_exp_series(r, x, terms_, bits_);
    }
    void call(acb_poly_struct* r, const Expr& e) const {
        Poly x;
        (*this)(x, e.arg(0));
        switch (e.builtin()) {
        case Builtin::exp:
            acb_poly_exp_series(r, x, terms_, bits_);
            return;
        case Builtin::sin:
            acb_poly_sin_series(r, x, terms_, bits_);
            return;
        case Builtin::cos:
            acb_poly_cos_series(r, x, terms_, bits_);
            return;
        case Builtin::sinh:
            acb_poly_sinh_series(r, x, terms_, bits_);
            return;
        case Builtin::cosh:
            acb_poly_cosh_series(r, x, terms_, bits_);
            return;
        case Builtin::tan:
            acb_poly_tan_series(r, x, terms_, bits_);
            return;
        case Builtin::tanh: {
            Poly y;
            acb_poly_cosh_series(y, x, terms_, bits_);
            acb_poly_sinh_series(x, x, terms_, bits_);
            acb_poly_div_series(r, x, y, terms_, bits_);
            return;
        }
        case Builtin::sqrt:
        case Builtin::log:
            if (meets_cut(x)) {
                nowhere(r);
            } else if (e.builtin() == Builtin::sqrt) {
                acb_poly_sqrt_series(r, x, terms_, bits_);
            } else {
                acb_poly_log_series(r, x, terms_, bits_);
            }
            return;
        default:
            nowhere(r);
        }
    }

    const acb_struct* at_;
    long terms_;
    long bits_;
};

} // namespace

bool has_complex_taylor(const Expr& e) {
    switch (e.kind()) {
    case Expr::Kind::number:
    case Expr::Kind::pi:
        return true;
    case Expr::Kind::symbol:
        return e.name() == "x";
    case Expr::Kind::integral:
    case Expr::Kind::pv:
    case Expr::Kind::sum:
        return false;
    case Expr::Kind::call:
        switch (e.builtin()) {
        case Builtin::exp:
        case Builtin::sin:
        case Builtin::cos:
        case Builtin::sinh:
        case Builtin::cosh:
        case Builtin::tan:
        case Builtin::tanh:
        case Builtin::sqrt:
        case Builtin::log:
            break;
        default:
            return false;
        }
        break;
    default:
        break;
    }
    return std::all_of(e.args().begin(), e.args().end(), has_complex_taylor);
}

void complex_taylor(acb_poly_t series, const Expr& e, const acb_t at, long terms, long bits) {
    acb_poly_zero(series);
    Walk(at, terms, bits)(series, e);
}

} // namespace edgeproof
