// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/evaluation/complex_taylor.hpp"

#include "edgeproof/precision/ball/arb_values.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace edgeproof::formula {
namespace {

using OfSeries = void (*)(acb_poly_struct*, const acb_poly_struct*, slong, slong);
using OfNumber = void (*)(acb_struct*, const acb_struct*, slong);

/// Arb's functions of a series whose values are correct at every complex number.
constexpr std::array<std::pair<Builtin, OfSeries>, 7> entire_functions{
    {{Builtin::exp, acb_poly_exp_series},
     {Builtin::sin, acb_poly_sin_series},
     {Builtin::cos, acb_poly_cos_series},
     {Builtin::sinh, acb_poly_sinh_series},
     {Builtin::cosh, acb_poly_cosh_series},
     {Builtin::gamma, acb_poly_gamma_series},
     {Builtin::tan, acb_poly_tan_series}}};

/// Arb's functions for the values of the functions that Walk::inverse expands.
constexpr std::array<std::pair<Builtin, OfNumber>, 6> inverse_functions{
    {{Builtin::asin, acb_asin},
     {Builtin::acos, acb_acos},
     {Builtin::atan, acb_atan},
     {Builtin::asinh, acb_asinh},
     {Builtin::acosh, acb_acosh},
     {Builtin::atanh, acb_atanh}}};

/// Returns the function of f, or null.
template <class Table> auto function_in(const Table& table, Builtin f) {
    const auto row = std::ranges::find(table, f, [](const auto& r) { return r.first; });
    return row == table.end() ? nullptr : row->second;
}

class Walk {
public:
    Walk(const acb_t at, long terms, long bits, bool real)
        : at_(at), terms_(terms), bits_(bits), real_(real) {}

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
        AcbPolyValue x;
        AcbPolyValue y;
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
        AcbValue z;
        acb_set_arb(z, c.data());
        acb_poly_set_acb(r, z);
    }
    void nowhere(acb_poly_struct* r) const {
        AcbValue z;
        acb_indeterminate(z);
        for (long k = 0; k < terms_; ++k) {
            acb_poly_set_coeff_acb(r, k, z);
        }
    }
    /// True if the constant term may lie on (-inf, 0].
    static bool meets_cut(acb_poly_struct* x) {
        AcbValue z;
        acb_poly_get_coeff_acb(z, x, 0);
        return arb_contains_zero(acb_imagref(z)) != 0 &&
               arb_contains_nonpositive(acb_realref(z)) != 0;
    }
    void power(acb_poly_struct* r, const Expr& e) const {
        AcbPolyValue x;
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
            if (real_ && exponent != nullptr) {
                power_near_zero(r, x, *exponent);
            } else {
                nowhere(r);
            }
            return;
        }
        AcbPolyValue y;
        (*this)(y, e.arg(1));
        acb_poly_log_series(x, x, terms_, bits_);
        acb_poly_mullow(x, x, y, terms_, bits_);
        acb_poly_exp_series(r, x, terms_, bits_);
    }
    /// x^q for a real ball that contains 0: bounds binomial(q, k) x^(q - k) (DLMF 4.6.7) for q > k
    /// by an upper bound of |x|.
    void power_near_zero(acb_poly_struct* r, acb_poly_struct* x, const Rational& q) const {
        AcbValue z;
        acb_poly_get_coeff_acb(z, x, 0);
        Ball most(0, bits_);
        arb_get_abs_ubound_arf(arb_midref(most.data()), acb_realref(z), bits_);
        AcbPolyValue outer;
        Ball binomial(1, bits_);
        for (long k = 0; k < terms_; ++k) {
            acb_zero(z);
            const Rational rest = q - k;
            if (rest > 0) {
                const Ball size = abs(binomial) * pow(most, rest);
                arb_add_error(acb_realref(z), size.data());
            } else {
                acb_indeterminate(z);
            }
            acb_poly_set_coeff_acb(outer, k, z);
            binomial *= Ball(Rational(rest / (k + 1)), bits_);
        }
        acb_zero(z);
        acb_poly_set_coeff_acb(x, 0, z);
        acb_poly_compose_series(r, outer, x, terms_, bits_);
    }
    void call(acb_poly_struct* r, const Expr& e) const {
        AcbPolyValue x;
        (*this)(x, e.arg(0));
        if (const OfSeries f = function_in(entire_functions, e.builtin())) {
            f(r, x, terms_, bits_);
            return;
        }
        const bool root = e.builtin() == Builtin::sqrt;
        if (e.builtin() == Builtin::tanh) {
            AcbPolyValue y;
            acb_poly_cosh_series(y, x, terms_, bits_);
            acb_poly_sinh_series(x, x, terms_, bits_);
            acb_poly_div_series(r, x, y, terms_, bits_);
        } else if (root && real_ && meets_cut(x)) {
            power_near_zero(r, x, Rational(1, 2));
        } else if ((root || e.builtin() == Builtin::log) && !meets_cut(x)) {
            (root ? acb_poly_sqrt_series : acb_poly_log_series)(r, x, terms_, bits_);
        } else if (function_in(inverse_functions, e.builtin()) != nullptr) {
            inverse(r, x, e.builtin());
        } else {
            nowhere(r);
        }
    }
    /// The functions whose derivative is +-1/(1 +- x^2) or +-1/sqrt(1 +- x^2) (DLMF 4.24(ii),
    /// 4.38(ii)), away from their branch cuts, which lie where 1 +- x^2 is in (-inf, 0].
    void inverse(acb_poly_struct* r, acb_poly_struct* x, Builtin f) const {
        const bool hyperbola = f == Builtin::asinh || f == Builtin::atan;
        const bool rational = f == Builtin::atan || f == Builtin::atanh;
        AcbPolyValue square;
        acb_poly_mullow(square, x, x, terms_, bits_);
        if (!hyperbola) {
            acb_poly_neg(square, square);
        }
        AcbPolyValue one;
        acb_poly_one(one);
        acb_poly_add(square, square, one, bits_);
        AcbValue z;
        acb_poly_get_coeff_acb(z, x, 0);
        const bool outside = f == Builtin::acosh ? arb_contains_zero(acb_imagref(z)) != 0 &&
                                                       !certainly_beyond_one(acb_realref(z))
                                                 : meets_cut(square);
        if (outside) {
            nowhere(r);
            return;
        }
        AcbPolyValue rate;
        acb_poly_derivative(rate, x, bits_);
        if (f == Builtin::acosh) {
            // 1/(sqrt(x - 1) sqrt(x + 1)): the single root of the product has a different branch
            // cut.
            AcbPolyValue less;
            AcbPolyValue more;
            acb_poly_sub(less, x, one, bits_);
            acb_poly_add(more, x, one, bits_);
            acb_poly_sqrt_series(less, less, terms_, bits_);
            acb_poly_sqrt_series(more, more, terms_, bits_);
            acb_poly_mullow(square, less, more, terms_, bits_);
        } else if (!rational) {
            acb_poly_sqrt_series(square, square, terms_, bits_);
        }
        if (f == Builtin::acos) {
            acb_poly_neg(square, square);
        }
        mean_value(z, square, f);
        acb_poly_div_series(r, rate, square, terms_, bits_);
        acb_poly_integral(r, r, bits_);
        acb_poly_set_coeff_acb(r, 0, z);
        acb_poly_truncate(r, terms_);
    }
    /// Encloses f over the box z by the mean value theorem; f is holomorphic on z with the
    /// derivative 1/slowness. Arb's functions of a wide box may subtract nearly equal numbers, as
    /// in sqrt(1 + z^2) - z.
    void mean_value(acb_t z, const acb_poly_struct* slowness, Builtin f) const {
        AcbValue middle;
        AcbValue rate;
        acb_get_mid(middle, z);
        acb_sub(z, z, middle, bits_);
        acb_poly_get_coeff_acb(rate, slowness, 0);
        acb_div(z, z, rate, bits_);
        function_in(inverse_functions, f)(middle, middle, bits_);
        acb_add(z, z, middle, bits_);
    }
    static bool certainly_beyond_one(const arb_t x) {
        ArbValue y;
        arb_sub_ui(y, x, 1, 64);
        return arb_is_positive(y) != 0;
    }

    const acb_struct* at_;
    long terms_;
    long bits_;
    bool real_;
};

} // namespace

bool has_complex_taylor(const Expr& e) {
    return !any_part(e, [](const Expr& part) {
        const Builtin f = part.builtin();
        const bool known = f == Builtin::tanh || f == Builtin::sqrt || f == Builtin::log ||
                           function_in(entire_functions, f) != nullptr ||
                           function_in(inverse_functions, f) != nullptr;
        return part.is_binder() || (part.kind() == Expr::Kind::call && !known) ||
               (part.kind() == Expr::Kind::symbol && part.name() != "x");
    });
}

void complex_taylor(acb_poly_t series, const Expr& e, const acb_t at, long terms, long bits) {
    acb_poly_zero(series);
    Walk(at, terms, bits, false)(series, e);
}

void real_taylor(acb_poly_t series, const Expr& e, const acb_t at, long terms, long bits) {
    acb_poly_zero(series);
    Walk(at, terms, bits, true)(series, e);
}

} // namespace edgeproof::formula
