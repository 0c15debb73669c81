// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosure/integrand_program.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

using Op = IntegrandStep::Op;

/// True if a value is certainly off the cuts of asin and acos, which extend outwards from -1 and 1;
/// with the axes exchanged, off those of atan.
bool off_cuts_from_one(const Ball& along, const Ball& across) {
    return !contains_zero(across) || certainly_less(abs(along), Ball(1, along.bits()));
}

void indeterminate(Box& z) { acb_indeterminate(z.get()); }

/// Computes log z with its cut along the negative imaginary axis, real for z > 0.
void log_above(Box& r, const Box& z, bool analytic, long bits) {
    acb_div_onei(r.get(), z.get());
    acb_log_analytic(r.get(), r.get(), analytic ? 1 : 0, bits);
    const Ball quarter = Ball::pi(bits) / 2;
    arb_add(acb_imagref(r.get()), acb_imagref(r.get()), quarter.data(), bits);
}

} // namespace

void Integrand::Program::take(std::size_t i) {
    const IntegrandStep& step = all()[i];
    ValuedBox& r = valued_[i];
    switch (step.op) {
    case Op::constant:
        return;
    case Op::variable:
        r = variable_now_;
        break;
    case Op::left_edge:
        r = edge_now_;
        break;
    case Op::force_rate:
        r.k = 0;
        r.w = force_rate_;
        indeterminate(r.slope);
        break;
    case Op::neg: {
        const ValuedBox& x = valued_[step.args[0]];
        r.k = x.k;
        r.w = -x.w;
        if (sloped_[i]) {
            r.end = -x.end;
            r.slope = -x.slope;
        }
        break;
    }
    case Op::add:
        take_sum(i, false);
        break;
    case Op::sub:
        take_sum(i, true);
        break;
    case Op::mul:
        take_product(i);
        break;
    case Op::div:
        take_quotient(i);
        break;
    case Op::power:
        take_power(i);
        break;
    case Op::sqrt:
        take_root(i);
        break;
    default:
        take_function(i);
    }
    if (zero_[i]) {
        r.k = power_;
        r.w = r.slope;
        acb_zero(r.end.get());
    }
}

void Integrand::Program::take_sum(std::size_t i, bool minus) {
    const ValuedBox& x = valued_[all()[i].args[0]];
    const ValuedBox& y = valued_[all()[i].args[1]];
    ValuedBox& r = valued_[i];
    const auto combine = minus ? acb_sub : acb_add;
    if (sloped_[i]) {
        combine(r.slope.get(), x.slope.get(), y.slope.get(), bits_);
        combine(r.end.get(), x.end.get(), y.end.get(), bits_);
    }
    if (zero_[i]) {
        return;
    }
    r.k = std::min(x.k, y.k);
    if (x.k == y.k) {
        combine(r.w.get(), x.w.get(), y.w.get(), bits_);
        return;
    }
    Box lower = x.w;
    Box upper = y.w;
    multiply_by_power(lower, x.k - r.k);
    multiply_by_power(upper, y.k - r.k);
    combine(r.w.get(), lower.get(), upper.get(), bits_);
}

void Integrand::Program::take_product(std::size_t i) {
    const ValuedBox& x = valued_[all()[i].args[0]];
    const ValuedBox& y = valued_[all()[i].args[1]];
    ValuedBox& r = valued_[i];
    r.k = x.k + y.k;
    acb_mul(r.w.get(), x.w.get(), y.w.get(), bits_);
    if (sloped_[i]) {
        r.slope = plain(x) * y.slope + y.end * x.slope;
        r.end = x.end * y.end;
    }
}

void Integrand::Program::take_quotient(std::size_t i) {
    const ValuedBox& x = valued_[all()[i].args[0]];
    const ValuedBox& y = valued_[all()[i].args[1]];
    ValuedBox& r = valued_[i];
    r.k = x.k - y.k;
    acb_div(r.w.get(), x.w.get(), y.w.get(), bits_);
    if (sloped_[i]) {
        r.end = x.end / y.end;
        r.slope = (x.slope - r.end * y.slope) / plain(y);
    }
}

void Integrand::Program::take_power(std::size_t i) {
    const IntegrandStep& step = all()[i];
    const ValuedBox& x = valued_[step.args[0]];
    ValuedBox& r = valued_[i];
    const bool whole =
        step.exponent && denominator(*step.exponent) == 1 && abs(*step.exponent) < 1000;
    if (whole) {
        const long n = step.exponent->convert_to<long>();
        r.k = x.k * n;
        acb_pow_si(r.w.get(), x.w.get(), n, bits_);
        if (sloped_[i]) {
            constexpr long most_written = 8;
            if (n < 1 || n > most_written) {
                indeterminate(r.slope);
                return;
            }
            const Box now = plain(x);
            r.end = x.end;
            r.slope = x.slope;
            for (long j = 1; j < n; ++j) {
                r.slope = now * r.slope + r.end * x.slope;
                r.end = r.end * x.end;
            }
        }
        return;
    }
    indeterminate(r.slope);
    const Rational order = step.exponent ? Rational(*step.exponent * x.k) : Rational(0);
    const bool split = x.k != 0 && step.exponent && denominator(order) == 1;
    const Box base = split ? x.w : plain(x);
    r.k = split ? order.convert_to<long>() : 0;
    acb_pow_analytic(r.w.get(), base.get(), valued_[step.args[1]].w.get(), analytic_ ? 1 : 0,
                     bits_);
    if (sloped_[i]) {
        r.end = r.w; // not used without a slope
    }
}

void Integrand::Program::take_root(std::size_t i) {
    const ValuedBox& x = valued_[all()[i].args[0]];
    ValuedBox& r = valued_[i];
    const bool split = x.k % 2 == 0;
    const Box base = split ? x.w : plain(x);
    r.k = split ? x.k / 2 : 0;
    acb_sqrt_analytic(r.w.get(), base.get(), analytic_ ? 1 : 0, bits_);
    if (!sloped_[i]) {
        return;
    }
    acb_sqrt(r.end.get(), x.end.get(), bits_);
    if (x.k == 0) {
        r.slope = x.slope / (r.w + r.end);
    } else {
        indeterminate(r.slope);
    }
}

void Integrand::Program::take_function(std::size_t i) {
    const IntegrandStep& step = all()[i];
    ValuedBox& r = valued_[i];
    const int whole = analytic_ ? 1 : 0;
    const Box x = plain(valued_[step.args.back()]);
    r.k = 0;
    acb_ptr y = r.w.get();
    switch (step.op) {
    case Op::log:
        acb_log_analytic(y, x.get(), whole, bits_);
        break;
    case Op::log_above:
        log_above(r.w, x, analytic_, bits_);
        break;
    case Op::exp:
        acb_exp(y, x.get(), bits_);
        break;
    case Op::sin:
        acb_sin(y, x.get(), bits_);
        break;
    case Op::cos:
        acb_cos(y, x.get(), bits_);
        break;
    case Op::asin:
    case Op::acos:
        if (analytic_ && !off_cuts_from_one(x.real(), x.imaginary())) {
            indeterminate(r.w);
        } else {
            (step.op == Op::asin ? acb_asin : acb_acos)(y, x.get(), bits_);
        }
        break;
    case Op::atan:
        if (analytic_ && !off_cuts_from_one(x.imaginary(), x.real())) {
            indeterminate(r.w);
        } else {
            acb_atan(y, x.get(), bits_);
        }
        break;
    case Op::gauss: {
        const auto part = [&](std::size_t k) { return valued_[step.args[k]].w.get(); };
        // A polynomial if a or b is 0 or a negative integer; else the cut runs from 1 to infinity.
        const auto ends_the_series = [](acb_ptr a) {
            return acb_is_int(a) != 0 && arb_is_nonpositive(acb_realref(a)) != 0;
        };
        const bool off = ends_the_series(part(0)) || ends_the_series(part(1)) || !x.may_be_real() ||
                         certainly_less(x.real(), Ball(1, bits_));
        if (analytic_ && !off) {
            indeterminate(r.w);
        } else {
            acb_hypgeom_2f1(y, part(0), part(1), part(2), x.get(), 0, bits_);
        }
        break;
    }
    default:
        indeterminate(r.w);
    }
    if (sloped_[i]) {
        r.end = r.w;
        indeterminate(r.slope);
    }
}

} // namespace edgeproof::audit
