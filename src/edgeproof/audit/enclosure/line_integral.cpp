// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosure/line_integral.hpp"

#include <exception>

namespace edgeproof::audit {
namespace {

constexpr long most_evaluations = 20000;

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
    options->eval_limit = most_evaluations;
    options->depth_limit = 4 * bits;
    // The tolerance is relative to the length times the value in the middle.
    MagValue tolerance;
    Box sample(bits);
    f.at(sample.get(), (from + to) * Box(Ball(Rational(1, 2), bits)), false);
    const Box size = sample * (to - from);
    if (size.is_finite()) {
        acb_get_mag(tolerance, size.get());
        mag_mul_2exp_si(tolerance, tolerance, -goal);
    }
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
