// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace edgeproof::contact {

/// Returns a place near the zero of f, which is monotone on the positive axis, to `accuracy` bits
/// or to the roundoff of f; it proves nothing. f(x) > 0 must mean that the zero lies beyond x, as
/// it must lie before an x where f is not finite; `rate` is f' (of one sign), called after f at the
/// same place. `near`: the start is near the zero. Throws a DomainError that names `what` if f > 0
/// however far out.
template <class F, class Rate>
Ball approximate_zero(const F& f, const Rate& rate, const Ball& start, const char* what,
                      long accuracy, bool near = false) {
    constexpr int most_doublings = 64;
    constexpr int most_steps = 400;
    Ball x = middle(start);
    std::optional<Ball> lo;
    std::optional<Ball> hi;
    // Returns f with certain signs at the ends of the range; 0 within its roundoff.
    const auto value_at = [&](const Ball& at) {
        Ball value = f(at);
        value = !value.is_finite()     ? Ball(-1, at.bits())
                : contains_zero(value) ? Ball(0, at.bits())
                                       : middle(value);
        if (certainly_positive(value)) {
            lo = at;
        } else if (certainly_negative(value)) {
            hi = at;
        }
        return value;
    };
    // First a search for a change of sign, then Newton's method on midpoints.
    long factor = 2;
    for (int k = 0; !near && !(lo && hi); ++k) {
        if (k == most_doublings && lo) {
            throw DomainError(std::string("no value of ") + what +
                              " satisfies the equations of this contact: the profile does not "
                              "rise on that side");
        }
        const Ball value = value_at(x);
        if (contains_zero(value) || k == most_doublings) {
            return x;
        }
        x = middle(certainly_positive(value) ? x * factor : x / factor);
        factor = factor < (1L << 30) ? factor * factor : factor;
    }
    const auto between = [&] { return middle(sqrt(*lo * *hi)); };
    x = near ? x : between();
    const Ball tiny = power_of_two(-accuracy, x.bits());
    std::optional<Ball> previous;
    for (int k = 0; k < most_steps; ++k) {
        const Ball value = value_at(x);
        if (contains_zero(value)) {
            return x;
        }
        const Ball step = middle(value / rate(x));
        Ball next = step.is_finite() ? middle(x - step) : x;
        const bool inside = step.is_finite() && (!lo || certainly_less(*lo, next)) &&
                            (!hi || certainly_less(next, *hi)) && certainly_positive(next);
        if (inside && !certainly_less(tiny * abs(x), abs(step))) {
            return next;
        }
        // Halve instead of a step where the rate may be zero (an edge on the end of a flat), and
        // where steps do not shrink: near a corner f behaves like a root, and Newton's method
        // oscillates.
        const bool slow = inside && previous && !certainly_less(abs(step) * 2, *previous);
        if ((!inside || slow) && lo && hi) {
            next = between();
            if (!certainly_less(tiny * *hi, *hi - *lo)) {
                return next;
            }
            previous = std::nullopt;
        } else if (!inside) {
            return x;
        } else {
            previous = abs(step);
        }
        x = next;
    }
    return x;
}

/// Encloses the only zero of f near x, by the interval form of Newton's method
/// (`moore-kearfott-cloud2009`): if x - f(x)/f'(X) lies inside X, there is exactly one zero in X,
/// and it lies in this image. `rate` encloses f' over a ball. Throws a BudgetError that names
/// `what` if the bits do not isolate the zero.
template <class F, class Rate>
Ball prove_zero(const F& f, const Rate& rate, const Ball& x, const char* what) {
    const long bits = x.bits();
    const Ball value = f(x);
    const Ball off = upper_end(abs(value / rate(x))) * 2;
    Ball radius = abs(x) * power_of_two(12 - bits, bits);
    radius = off.is_finite() ? radius + off : radius;
    for (long k = 0; 5 * k < bits; ++k) {
        const Ball candidate = Ball::around(x.midpoint(), radius.upper(), bits);
        const Ball image = x - value / rate(candidate);
        if (image.is_finite() && certainly_positive(image) && contains(candidate, image)) {
            return image;
        }
        radius = middle(radius * 32);
    }
    throw BudgetError(std::string("ball arithmetic at ") + std::to_string(bits) +
                      " bits does not isolate " + what);
}

/// The zero of f, found and proved.
template <class F, class Rate>
Ball isolate_zero(const F& f, const Rate& rate, const Ball& start, const char* what,
                  bool near = false) {
    constexpr long bits_lost = 12;
    return prove_zero(f, rate,
                      approximate_zero(f, rate, start, what, start.bits() - bits_lost, near), what);
}

} // namespace edgeproof::contact
