// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/vouched.hpp"

#include <utility>

namespace edgeproof {
namespace {

constexpr unsigned bits_beyond = 16;

/// The largest |x - q| over the ball.
Real farthest(const Ball& x, const Rational& q) {
    return abs(Ball(x - Ball(q, x.bits() + bits_beyond))).upper();
}

} // namespace

PrintedValue printed(const Vouched& x, unsigned digits) {
    const std::string mark = x.proved ? "" : "~";
    if (contains_zero(x.value)) {
        return {"0", mark + bound_text(farthest(x.value, Rational(0))), x.value.is_exact()};
    }
    const Rounded r = round_ball(x.value, digits);
    const std::string text = r.text.empty() ? to_decimal(x.value.midpoint(), 1) : r.text;
    return {text, mark + bound_text(farthest(x.value, parse_decimal(text))), r.complete};
}

Vouched estimated(const Real& value, const Real& error, std::string route) {
    const long bits = mpfr_get_prec(value.backend().data());
    return {Ball::around(value, error, bits), false, std::move(route)};
}

} // namespace edgeproof
