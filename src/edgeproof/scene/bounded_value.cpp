// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/bounded_value.hpp"

#include "edgeproof/formula/exact/exact_ball.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::scene {
namespace {

constexpr long bits_beyond = 16;
constexpr long binary64_limit_bits = 64;
constexpr unsigned bound_bits = 64;

/// The largest |x - q| over the ball.
Real farthest(const Ball& x, const Rational& q) {
    return abs(Ball(x - Ball(q, x.bits() + bits_beyond))).upper();
}

std::string bound_of(const Rational& error) {
    return bound_text(abs(Ball(error, bound_bits)).upper());
}

/// hi - lo of "[lo, hi]".
Rational width(const std::string& text) {
    const std::size_t comma = text.find(',');
    return parse_decimal(text.substr(comma + 2, text.size() - comma - 3)) -
           parse_decimal(text.substr(1, comma - 1));
}

PrintedValue printed_exactly(const Rational& q, const Digits& digits) {
    PrintedValue p;
    p.text = to_decimal(q, digits.count, digits.rounding);
    p.bound =
        bound_of(digits.rounding == Rounding::enclosure ? width(p.text)
                                                        : Rational(parse_decimal(p.text) - q));
    p.complete = true;
    return p;
}

} // namespace

bool settles(const Ball& x, const Digits& digits) {
    return (rounds_alike(x, digits.count, digits.rounding) ||
            round_ball(x, digits.count, digits.rounding).complete) &&
           (!digits.binary64 || nearest_binary64(x));
}

bool may_be_a_limit(const Ball& x, const Digits& digits) {
    if (contains_zero(x)) {
        return true;
    }
    const long needed =
        std::max(formula::bits_for(digits.count), digits.binary64 ? binary64_limit_bits : 0);
    if (x.relative_accuracy_bits() < needed) {
        return false;
    }
    // An enclosure of what is exactly a short decimal is that decimal, twice.
    const bool told = digits.rounding == Rounding::enclosure
                          ? round_ball(x, digits.count, Rounding::down).complete
                          : settles(x, digits);
    return !told || (digits.binary64 && !nearest_binary64(x));
}

std::string how(const BoundedValue& x, const PrintedValue& p) {
    return x.how() + (p.undecided ? " (rounding undecided)" : "");
}

PrintedValue printed(const BoundedValue& x, const Digits& digits) {
    PrintedValue p;
    if (x.exactly) {
        p = printed_exactly(*x.exactly, digits);
    } else if (!x.value.is_finite()) {
        return {"nan", "inf", false, false, {}, {}};
    } else if (digits.rounding == Rounding::enclosure) {
        const Rounded r = round_ball(x.value, digits.count, Rounding::enclosure);
        p = {r.text, bound_of(width(r.text)), r.complete, false, {}, {}};
    } else if (contains_zero(x.value) && digits.rounding == Rounding::nearest) {
        p = {"0", bound_text(farthest(x.value, Rational(0))), x.value.is_exact(), false, {}, {}};
    } else {
        Rounded r = round_ball(x.value, digits.count, digits.rounding);
        if (!r.complete && x.proved) {
            r = round_ball(x.value, digits.count, Rounding::enclosure);
            p = {r.text, bound_of(width(r.text)), false, true, {}, {}};
        } else {
            if (!r.complete && digits.rounding != Rounding::nearest) {
                const std::string both =
                    round_ball(x.value, digits.count, Rounding::enclosure).text;
                const std::size_t comma = both.find(',');
                r.text = digits.rounding == Rounding::down
                             ? both.substr(1, comma - 1)
                             : both.substr(comma + 2, both.size() - comma - 3);
            } else if (r.text.empty()) {
                r.text = to_decimal(x.value.midpoint(), 1);
            }
            p = {r.text,     bound_text(farthest(x.value, parse_decimal(r.text))),
                 r.complete, false,
                 {},         {}};
        }
    }
    if (digits.binary64 && x.exactly) {
        p.binary64 = nearest_binary64(*x.exactly);
    } else if (digits.binary64) {
        p.binary64 = nearest_binary64(x.value);
        if (!p.binary64) {
            p.undecided = p.undecided || x.proved;
            p.binary64_between = {x.value.lower().convert_to<double>(),
                                  x.value.upper().convert_to<double>()};
        }
    }
    return p;
}

BoundedValue estimated(const Real& value, const Real& error, std::string route) {
    const long bits = mpfr_get_prec(value.backend().data());
    return {Ball::around(value, error, bits), false, std::move(route)};
}

} // namespace edgeproof::scene
