// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <cmath>

namespace edgeproof::contact {
namespace {

/// The most evaluations of an integrand: a bend at the distance 1e-300 takes fewer than 300 a bit.
/// Beyond it the result is wide, and the caller takes more bits, or smaller balls.
constexpr slong evaluations_a_bit = 400;
constexpr slong evaluations_if_wide = 800;
constexpr long narrow_parameter_bits = 48; ///< a parameter with fewer bits is a range
constexpr long parts_of_range = 8;         ///< into which a coarse enclosure is divided

bool meets_cut_of_root(const Box& c) { return !certainly_positive(c.real()) && c.may_be_real(); }
bool may_meet_cut_of_arctangent(const Box& c) {
    return !certainly_positive(c.real()) && !certainly_less(abs(c), Ball(1, c.bits()));
}

/// No exception may pass through Arb: after an interruption all remaining values are zero.
struct Evaluation {
    const std::function<Box(const Box&)>& f;
    bool interrupted = false;
};

int evaluate(acb_ptr out, const acb_t t, void* parameter, slong /*order*/, slong bits) {
    auto& evaluation = *static_cast<Evaluation*>(parameter);
    evaluation.interrupted = evaluation.interrupted || interruption_requested() != 0;
    if (evaluation.interrupted) {
        acb_zero(out);
    } else {
        acb_set(out, evaluation.f(Box(t, static_cast<long>(bits))).get());
    }
    return 0;
}

} // namespace

Box unknown_box(long bits) {
    Box c(bits);
    acb_indeterminate(c.get());
    return c;
}

long useful_accuracy(long known, long bits) {
    constexpr long spare_bits = 24;
    return std::min(bits, std::clamp(known, 0L, bits) + spare_bits);
}

// Arb's root of a wide box around a positive number has an imaginary part that grows as the root of
// the width of the box, and not as the width: no ellipse of the integration would be accepted.
Box principal_root(const Box& x) {
    if (certainly_positive(x.real())) {
        const Ball twice = sqrt((abs(x) + x.real()) * 2);
        return {twice / 2, x.imaginary() / twice};
    }
    return meets_cut_of_root(x) ? unknown_box(x.bits()) : sqrt(x);
}

Box principal_arctangent(const Box& x) {
    Box r(x.bits());
    if (may_meet_cut_of_arctangent(x)) {
        return unknown_box(x.bits());
    }
    acb_atan(r.get(), x.get(), x.bits());
    return r;
}

/// Integrates by Arb (johansson2018).
Box inner_integral_of(const std::function<Box(const Box& t)>& f, const IntegralGoal& goal) {
    AcbValue from;
    AcbValue to;
    acb_one(to);
    // Where the parameters are wide balls, the integrand may be unbounded everywhere.
    const Box in_the_middle = f(Box(Ball(Rational(1, 2), goal.bits)));
    if (!in_the_middle.is_finite()) {
        return unknown_box(goal.bits);
    }
    // An integrand that is 0 (on a flat) would be evaluated until the limit: no tolerance is met.
    if (acb_is_zero(in_the_middle.get()) != 0 &&
        acb_is_zero(f(Box(Ball::hull(Ball(0, goal.bits), Ball(1, goal.bits)))).get()) != 0) {
        return Box(goal.bits);
    }
    MagValue tolerance;
    arb_get_mag(tolerance,
                contains_zero(goal.scale) ? abs(in_the_middle).data() : goal.scale.data());
    mag_mul_2exp_si(tolerance, tolerance, -goal.accuracy - 64);
    acb_calc_integrate_opt_t options;
    acb_calc_integrate_opt_init(options);
    options->eval_limit = goal.accuracy < narrow_integral_bits ? evaluations_if_wide
                                                               : evaluations_a_bit * goal.accuracy;
    Evaluation evaluation{f};
    Box sum(goal.bits);
    acb_calc_integrate(sum.get(), evaluate, &evaluation, from, to, goal.accuracy, tolerance,
                       options, goal.bits);
    return evaluation.interrupted ? unknown_box(goal.bits) : sum;
}

Box integral_between(const std::function<Box(const Box& t)>& f, const Ball& from, const Ball& to,
                     long accuracy, long bits) {
    const Box begin = Box(from).middle();
    const Box end = Box(to).middle();
    MagValue tolerance;
    mag_set_ui_2exp_si(tolerance, 1, -bits - 64);
    Evaluation evaluation{f};
    Box sum(bits);
    acb_calc_integrate(sum.get(), evaluate, &evaluation, begin.get(), end.get(), accuracy,
                       tolerance, nullptr, bits);
    for (const Ball* limit : {&from, &to}) {
        sum = sum + f(Box(limit->with_bits(bits))) * up_to(Ball(limit->radius(), bits));
    }
    check_interruption();
    return sum;
}

Ball integral_of(const std::function<Box(const Box& t)>& f, const IntegralGoal& goal) {
    const Ball result = inner_integral_of(f, goal).real();
    check_interruption();
    return result;
}

bool is_narrow(const Box& x) { return acb_rel_accuracy_bits(x.get()) >= narrow_parameter_bits; }

Box integral_or_range(const std::function<Box(const Box& t)>& f, bool narrow, long bits) {
    if (narrow) {
        return inner_integral_of(f, {bits, bits, Ball(0, bits), Ball(1, bits)});
    }
    Box sum(bits);
    for (long i = 0; i < parts_of_range; ++i) {
        const Ball lo(Rational(i, parts_of_range), bits);
        const Ball hi(Rational(i + 1, parts_of_range), bits);
        sum = sum + f(Box(Ball::hull(lo, hi)));
    }
    return sum / Ball(parts_of_range, bits);
}

std::vector<Ball> taylor_on_circle(const std::function<Box(const Box& z)>& f, const Ball& most,
                                   const Ball& rho, const Rational& q, std::size_t terms) {
    const long bits = rho.bits();
    const double fall = -std::log2(q.convert_to<double>());
    const std::size_t half = std::max(
        (terms + 1) / 2, static_cast<std::size_t>(static_cast<double>(bits) / (2 * fall)) + 1);
    const auto n = static_cast<long>(2 * half); // at least `terms`, and q^n < 2^-bits
    const Ball r = rho * Ball(q, bits);
    std::vector<Box> unit;
    std::vector<Box> values;
    for (std::size_t j = 0; j <= half; ++j) {
        Ball c(0, bits);
        Ball s(0, bits);
        const Ball part(Rational(static_cast<long>(j), static_cast<long>(half)), bits);
        arb_sin_cos_pi(s.data(), c.data(), part.data(), bits);
        const bool real = j == 0 || j == half;
        unit.push_back(real ? Box(Ball(j == 0 ? 1 : -1, bits)) : Box(c, s));
        // The lower half of the circle has the conjugate values.
        values.push_back(f(unit[j] * r) * Ball(real ? 1 : 2, bits));
    }
    const Ball alias = pow_int(Ball(q, bits), n);
    const Ball error = up_to(most * alias / (1 - alias));
    std::vector<Ball> a;
    for (std::size_t k = 0; k < terms; ++k) {
        Ball sum(0, bits);
        for (std::size_t j = 0; j <= half; ++j) {
            const std::size_t turned = j * k % (2 * half);
            sum += (values[j] * (turned <= half ? conj(unit[turned]) : unit[2 * half - turned]))
                       .real();
        }
        const auto power = static_cast<long>(k);
        a.push_back(sum / n / pow_int(r, power) + error / pow_int(rho, power));
    }
    return a;
}

std::vector<Box> taylor_at(std::vector<Box> c, const Ball& radius, const Magnitude& bound,
                           const Box& z, std::size_t order) {
    constexpr long bits_of_rest = 64;
    const std::size_t terms = c.size();
    const long bits = c[0].bits();
    bool real = arb_is_zero(acb_imagref(z.get())) != 0;
    for (const Box& x : c) {
        real = real && acb_is_real(x.get()) != 0;
    }
    for (std::size_t k = 0; k < std::min(order, terms); ++k) {
        for (std::size_t j = terms - 1; j-- > k;) {
            acb_addmul(c[j].get(), z.get(), c[j + 1].get(), bits);
        }
    }
    c.resize(order, Box(bits));
    // The remainder: the sum over j >= n of binomial(j, k) bound q^(j - k)/radius^k, in which each
    // term is at most a multiple of the one before it.
    const auto n = static_cast<long>(terms);
    const Ball q = upper_end(abs(z) / radius).with_bits(bits_of_rest);
    for (long k = 0; k < static_cast<long>(order); ++k) {
        const Ball less = 1 - q * (n + 1) / std::max(1L, n + 1 - k);
        Ball rest = unknown_ball(bits_of_rest);
        if (k < n && certainly_positive(less)) {
            arb_bin_uiui(rest.data(), terms, static_cast<ulong>(k), bits_of_rest);
            rest *= bound.ball(bits_of_rest) * pow_int(q, n - k) / pow_int(radius, k) / less;
            rest = up_to(rest);
        }
        Box& sum = c[static_cast<std::size_t>(k)];
        sum = sum + Box(rest, real ? Ball(0, bits_of_rest) : rest);
    }
    return c;
}

} // namespace edgeproof::contact
