// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosure/piece_integrals.hpp"
#include "edgeproof/precision/error.hpp"

#include <exception>

namespace edgeproof::audit {

using formula::Expr;

namespace {

using Centre = Integrand::Centre;

const Ball& position(const PieceEnd& end, bool by_angle) { return by_angle ? end.angle : end.at; }

} // namespace

/// Integrates from the centre to v; half the piece, or all of it.
Box PieceIntegrals::from_centre(Integrand& f, const Ball& near, const Ball& far) const {
    const auto root_of_distance = [&](const Ball& x) {
        Ball v(0, bits_);
        if (arb_is_zero(x.data()) != 0) {
            return Box(v); // Arb does not take the root of zero
        }
        arb_root_ui(v.data(), x.data(), static_cast<ulong>(f.power()), bits_);
        return Box(v);
    };
    return line_integral(f, root_of_distance(near), root_of_distance(far), digits_);
}

/// Returns the end at which to centre: that of the piece, or that of the whole integral if it is
/// near enough for its singularity to matter.
std::optional<PieceEnd> PieceIntegrals::singular_end(Integrand& f, const PieceEnd& end,
                                                     const PieceEnd& outermost, int direction,
                                                     const Ball& length, bool by_angle) const {
    f.centre(end.written, end.at, direction, end.angle, Centre::rooted);
    if (f.power() > 1) {
        return end;
    }
    if (by_angle || !certainly_less(abs(end.at - outermost.at) * 10, length)) {
        return std::nullopt;
    }
    f.centre(outermost.written, outermost.at, direction, outermost.angle, Centre::rooted);
    return f.power() > 1 ? std::optional(outermost) : std::nullopt;
}

Box PieceIntegrals::by_ends(Integrand& f, const PieceEnd& from, const PieceEnd& to,
                            bool by_angle) const {
    const Ball start = position(from, by_angle);
    const Ball stop = position(to, by_angle);
    const Ball length = abs(stop - start);
    const auto right = singular_end(f, to, highest_, -1, length, by_angle);
    const auto left = singular_end(f, from, lowest_, 1, length, by_angle);
    const Ball middle = left && right ? (start + stop) / 2 : left ? stop : start;
    Box sum(bits_);
    const auto add = [&](const PieceEnd& end, const Ball& near) {
        const Ball& at = position(end, by_angle);
        sum = sum + from_centre(f, distance(at, near), distance(at, middle));
    };
    if (left) {
        add(*left, start);
    }
    if (right) {
        f.centre(right->written, right->at, -1, right->angle, Centre::rooted);
        add(*right, stop);
    }
    if (!left && !right) {
        f.centre(from.written, from.at, 1, from.angle, Centre::regular);
        sum = from_centre(f, Ball(0, bits_), length);
    }
    return sum;
}

/// Returns zero for the distance of a place from itself, even if the ball is wide.
Ball PieceIntegrals::distance(const Ball& x, const Ball& y) const {
    return arb_equal(x.data(), y.data()) != 0 ? Ball(0, bits_) : abs(y - x);
}

Box PieceIntegrals::over_pole(Integrand& f, const PieceEnd& pole, const PieceEnd& from,
                              const PieceEnd& to) const {
    f.centre(pole.written, pole.at, 1, {}, Centre::pole);
    Ball r(min(pole.at - from.at, to.at - pole.at).midpoint(), bits_);
    for (int k = 0; k < 16; ++k) {
        r /= 2;
        const Ball across = r * Ball::from_interval(Real(-1), Real(1), bits_);
        const Integrand::Leading without = f.leading(Box(across, across));
        if (without.power != -1 || !without.factor.is_finite()) {
            continue;
        }
        const Ball zero(0, bits_);
        const Box top(zero, r);
        Box sum = line_integral(f, Box(-r), top, digits_) + line_integral(f, top, Box(r), digits_) +
                  f.leading(Box(bits_)).factor * Box(zero, Ball::pi(bits_));
        const Expr unnamed = Expr::symbol("a place inside"); // not a name in any text
        const PieceEnd before{unnamed, pole.at - r};
        const PieceEnd behind{unnamed, pole.at + r};
        sum = sum + by_ends(f, from, before, false);
        return sum + by_ends(f, behind, to, false);
    }
    throw Error("the pole of a principal value is not shown to be a simple one");
}

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
