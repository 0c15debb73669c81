// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/enclosure/integrand.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <array>
#include <exception>

namespace edgeproof::audit {

namespace {

using formula::Builtin;
using StepKind = Expr::Kind;

enum class Cuts { none, real, imaginary }; ///< from -1 and 1, or -i and i, outwards

/// A function of one argument on boxes, and the axis of its cuts.
struct BoxFunction {
    Builtin id;
    void (*of)(acb_ptr, acb_srcptr, slong);
    Cuts cuts;
};
constexpr std::array box_functions{BoxFunction{Builtin::exp, acb_exp, Cuts::none},
                                   BoxFunction{Builtin::sin, acb_sin, Cuts::none},
                                   BoxFunction{Builtin::cos, acb_cos, Cuts::none},
                                   BoxFunction{Builtin::asin, acb_asin, Cuts::real},
                                   BoxFunction{Builtin::acos, acb_acos, Cuts::real},
                                   BoxFunction{Builtin::atan, acb_atan, Cuts::imaginary}};

/// Returns null for other functions.
const BoxFunction* box_function(Builtin f) {
    const auto* const row = std::ranges::find(box_functions, f, &BoxFunction::id);
    return row == box_functions.end() ? nullptr : row;
}

bool certainly_off(Cuts cuts, const Box& z) {
    if (cuts == Cuts::none) {
        return true;
    }
    const Ball along = cuts == Cuts::real ? z.real() : z.imaginary();
    const Ball across = cuts == Cuts::real ? z.imaginary() : z.real();
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

std::optional<Expr> Integrand::written_out(const Expr& e) const {
    const bool contacts = e.name() == "bof" || e.name() == "P1of";
    // Two contacts of the family in one integrand have no common path.
    if (e.is_binder() || (meaning_.path != nullptr && contacts)) {
        throw Error("'" + e.name() + "' has no enclosure inside an integral");
    }
    if (e.kind() == StepKind::pow && holds_symbol(e.arg(1), variable_)) {
        throw Error("a power to the variable has no enclosure inside an integral");
    }
    if (e.kind() != StepKind::call || e.name() == "log_above" || e.name() == "gauss" ||
        e.builtin() == Builtin::sqrt || e.builtin() == Builtin::log ||
        box_function(e.builtin()) != nullptr) {
        return std::nullopt;
    }
    const Builtin f = e.builtin();
    if (f == Builtin::acosh || f == Builtin::asinh || f == Builtin::atanh) {
        const Expr& z = e.arg(0);
        const Expr one = Expr::number(1);
        const auto of = [](const char* name, const Expr& x) { return Expr::call(name, {x}); };
        return f == Builtin::acosh   ? of("log", z + of("sqrt", z - one) * of("sqrt", z + one))
               : f == Builtin::asinh ? of("log", z + of("sqrt", z * z + one))
                                     : (of("log", one + z) - of("log", one - z)) / Expr::number(2);
    }
    return meaning_.written_out(e);
}

std::size_t Integrand::compiled(const Expr& f) {
    std::vector<Expr> inputs{Expr::symbol(variable_)};
    if (meaning_.path != nullptr) {
        inputs.push_back(Expr::call("bof", {*meaning_.path_argument}));
        inputs.push_back(Expr::call("P1of", {*meaning_.path_argument}));
    }
    for (const Expr& input : inputs) {
        places_.emplace(input, add(Role::input, input.kind(), input));
    }
    return place_of(f);
}

std::size_t Integrand::place_of(const Expr& part) {
    if (const auto it = places_.find(part); it != places_.end()) {
        return it->second;
    }
    const std::size_t place = new_place_of(part);
    places_.emplace(part, place);
    return place;
}

std::size_t Integrand::new_place_of(const Expr& e) {
    if (!holds_symbol(e, variable_)) {
        return add(Role::constant, e.kind(), e);
    }
    if (const auto other = written_out(e)) {
        return place_of(*other);
    }
    std::vector<std::size_t> in;
    for (const Expr& x : e.args()) {
        in.push_back(place_of(x));
    }
    const bool times = e.kind() == StepKind::mul;
    const bool over = e.kind() == StepKind::div && !is_zero(in[1]);
    if (is_zero(in[0]) && (times || over || e.kind() == StepKind::neg)) {
        return in[0];
    }
    return times && is_zero(in[1]) ? in[1] : add(Role::operation, e.kind(), e, std::move(in));
}

void Integrand::take(std::size_t slot) {
    const Step& step = steps_[slot];
    switch (step.kind) {
    case StepKind::neg: {
        const ValuedBox& x = part(step, 0);
        ValuedBox& r = valued_[slot];
        r.k = x.k;
        r.w = -x.w;
        if (sloped_[slot]) {
            r.end = -x.end;
            r.slope = -x.slope;
        }
        break;
    }
    case StepKind::add:
    case StepKind::sub:
        take_sum(step, slot);
        break;
    case StepKind::mul:
        take_product(step, slot);
        break;
    case StepKind::div:
        take_quotient(step, slot);
        break;
    case StepKind::pow:
        take_power(step, slot);
        break;
    default:
        if (step.source.builtin() == Builtin::sqrt) {
            take_root(step, slot);
        } else {
            take_function(step, slot);
        }
    }
    apply_zero(slot);
}

void Integrand::apply_zero(std::size_t slot) {
    if (zero_[slot]) {
        ValuedBox& r = valued_[slot];
        r.k = power_;
        r.w = r.slope;
        acb_zero(r.end.get());
    }
}

void Integrand::take_sum(const Step& step, std::size_t i) {
    const ValuedBox& x = part(step, 0);
    const ValuedBox& y = part(step, 1);
    ValuedBox& r = valued_[i];
    const auto combine = step.kind == StepKind::sub ? acb_sub : acb_add;
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

void Integrand::take_product(const Step& step, std::size_t i) {
    const ValuedBox& x = part(step, 0);
    const ValuedBox& y = part(step, 1);
    ValuedBox& r = valued_[i];
    r.k = x.k + y.k;
    acb_mul(r.w.get(), x.w.get(), y.w.get(), bits_);
    if (sloped_[i]) {
        r.slope = plain(x) * y.slope + y.end * x.slope;
        r.end = x.end * y.end;
    }
}

void Integrand::take_quotient(const Step& step, std::size_t i) {
    const ValuedBox& x = part(step, 0);
    const ValuedBox& y = part(step, 1);
    ValuedBox& r = valued_[i];
    r.k = x.k - y.k;
    acb_div(r.w.get(), x.w.get(), y.w.get(), bits_);
    if (sloped_[i]) {
        r.end = x.end / y.end;
        r.slope = (x.slope - r.end * y.slope) / plain(y);
    }
}

void Integrand::take_power(const Step& step, std::size_t slot) {
    const std::optional<Rational>& exponent = exponents_[slot];
    const ValuedBox& x = part(step, 0);
    ValuedBox& r = valued_[slot];
    const bool whole = exponent && denominator(*exponent) == 1 && abs(*exponent) < 1000;
    if (whole) {
        const long n = exponent->convert_to<long>();
        r.k = x.k * n;
        acb_pow_si(r.w.get(), x.w.get(), n, bits_);
        if (sloped_[slot]) {
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
    const Rational order = exponent ? Rational(*exponent * x.k) : Rational(0);
    const bool split = x.k != 0 && exponent && denominator(order) == 1;
    const Box base = split ? x.w : plain(x);
    r.k = split ? order.convert_to<long>() : 0;
    acb_pow_analytic(r.w.get(), base.get(), part(step, 1).w.get(), analytic_ ? 1 : 0, bits_);
    if (sloped_[slot]) {
        r.end = r.w; // not used without a slope
    }
}

void Integrand::take_root(const Step& step, std::size_t i) {
    const ValuedBox& x = part(step, 0);
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

void Integrand::take_log(const ValuedBox& x, ValuedBox& r) const {
    Box of_factor(bits_);
    acb_log_analytic(of_factor.get(), x.w.get(), analytic_ ? 1 : 0, bits_);
    const Box k(Ball(x.k, bits_));
    if (leading_) {
        r.k = 0;
        r.w = k + of_factor;
        return;
    }
    Box log_v(bits_); // times v
    if (!v_.contains_zero()) {
        acb_log_analytic(log_v.get(), v_.get(), analytic_ ? 1 : 0, bits_);
        log_v = log_v * v_;
    } else {
        // |v log v| <= |v| (pi - log |v|), which grows up to |v| = 1.
        const Ball most(abs(v_).upper(), bits_);
        const bool small = !analytic_ && certainly_less(most, Ball(1, bits_));
        const Ball bound =
            arb_is_zero(most.data()) != 0 ? most : most * (Ball::pi(bits_) - log(most));
        if (small) {
            const Ball around = bound * Ball::from_interval(Real(-1), Real(1), bits_);
            log_v = Box(around, around);
        } else {
            indeterminate(log_v);
        }
    }
    r.k = -1;
    r.w = k * log_v + of_factor * v_;
}

void Integrand::take_function(const Step& step, std::size_t i) {
    ValuedBox& r = valued_[i];
    const ValuedBox& argument = part(step, step.operands.size() - 1);
    if (argument.k != 0 && step.source.builtin() == Builtin::log) {
        take_log(argument, r);
        indeterminate(r.slope);
        r.end = r.w; // not used without a slope
        return;
    }
    const Box x = plain(argument);
    r.k = 0;
    acb_ptr y = r.w.get();
    if (const BoxFunction* f = box_function(step.source.builtin())) {
        if (analytic_ && !certainly_off(f->cuts, x)) {
            indeterminate(r.w);
        } else {
            f->of(y, x.get(), bits_);
        }
    } else if (step.source.builtin() == Builtin::log) {
        acb_log_analytic(y, x.get(), analytic_ ? 1 : 0, bits_);
    } else if (step.source.name() == "log_above") {
        log_above(r.w, x, analytic_, bits_);
    } else { // Gauss's function
        const auto parameter = [&](std::size_t k) { return part(step, k).w.get(); };
        // A polynomial if a or b is 0 or a negative integer; else the cut runs from 1 to infinity.
        const auto ends_the_series = [](acb_srcptr a) {
            return acb_is_int(a) != 0 && arb_is_nonpositive(acb_realref(a)) != 0;
        };
        const bool off = ends_the_series(parameter(0)) || ends_the_series(parameter(1)) ||
                         !x.may_be_real() || certainly_less(x.real(), Ball(1, bits_));
        if (analytic_ && !off) {
            indeterminate(r.w);
        } else {
            acb_hypgeom_2f1(y, parameter(0), parameter(1), parameter(2), x.get(), 0, bits_);
        }
    }
    if (sloped_[i]) {
        r.end = r.w;
        indeterminate(r.slope);
    }
}

namespace {

/// A few digits, as for the many variants of a formula in a diagnosis, need few evaluations.
long most_evaluations(unsigned digits) { return std::min(20'000L, 20L * digits * digits); }

struct IntegrandCall {
    Integrand& f;
    std::exception_ptr thrown;
};

int integrand_on(acb_ptr out, const acb_t at, void* parameter, slong order, slong bits) {
    auto& work = *static_cast<IntegrandCall*>(parameter);
    // Exceptions must not pass through Arb, which calls the function again after the first one.
    if (work.thrown) {
        acb_indeterminate(out);
        return 0;
    }
    try {
        work.f.at(out, Box(at, bits), order != 0);
    } catch (...) {
        work.thrown = std::current_exception();
        acb_indeterminate(out);
    }
    return 0;
}

} // namespace

Box line_integral(Integrand& f, const Box& v, const Box& w, unsigned digits) {
    const long bits = w.bits();
    const auto goal = static_cast<slong>(digits) * 10 / 3 + 3;
    const Box from = v.middle();
    const Box to = w.middle();
    acb_calc_integrate_opt_t options;
    acb_calc_integrate_opt_init(options);
    options->eval_limit = most_evaluations(digits);
    options->depth_limit = 4 * bits;
    // The tolerance is relative to the length times the value in the middle.
    MagValue tolerance;
    Box sample(bits);
    for (const Rational& part : {Rational(1, 64), Rational(63, 64), Rational(1, 2)}) {
        f.at(sample.get(), from + (to - from) * Box(Ball(part, bits)), false);
        if (!sample.is_finite()) {
            return sample; // no subdivision makes the sum finite
        }
    }
    const Box size = sample * (to - from);
    acb_get_mag(tolerance, size.get());
    mag_mul_2exp_si(tolerance, tolerance, -goal);
    IntegrandCall work{f, nullptr};
    Box sum(bits);
    acb_calc_integrate(sum.get(), integrand_on, &work, from.get(), to.get(), goal, tolerance,
                       options, bits);
    if (work.thrown) {
        std::rethrow_exception(work.thrown);
    }
    // The integral from the middle of a box to another of its points is at most the largest value
    // times the distance.
    for (const Box* end : {&v, &w}) {
        if (acb_is_exact(end->get()) == 0) {
            Box value(bits);
            f.at(value.get(), *end, false);
            const Box rest = value * (*end - end->middle());
            sum = end == &w ? sum + rest : sum - rest;
        }
    }
    return sum;
}

} // namespace edgeproof::audit
