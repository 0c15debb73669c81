// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/input/bounded_value.hpp"

#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <ostream>
#include <utility>

namespace edgeproof::scene {

namespace {

constexpr long bits_beyond = 16;
constexpr long binary64_limit_bits = 64;
constexpr unsigned bound_bits = 64;

/// Returns the largest |x - d| over the ball.
Real farthest(const Ball& x, const Decimal& d) {
    return abs(Ball(x - d.enclosure(x.bits() + bits_beyond))).upper();
}

std::string bound_of(const Rational& error) {
    return bound_text(abs(Ball(error, bound_bits)).upper());
}

PrintedValue printed_exactly(const Rational& q, const Digits& digits) {
    const Rounded r = round_rational(q, digits.count, digits.rounding);
    PrintedValue p;
    p.text = r.text;
    p.bound = bound_of(Rational(r.value.value() - q));
    p.complete = true;
    return p;
}

} // namespace

bool has_digits(const Ball& x, const Digits& digits) {
    return round_ball(x, digits.count, digits.rounding).complete &&
           (!digits.binary64 || nearest_binary64(x));
}

bool may_be_a_limit(const Ball& x, const Digits& digits, bool has_them) {
    if (contains_zero(x)) {
        return true;
    }
    const long needed =
        std::max(formula::bits_for(digits.count), digits.binary64 ? binary64_limit_bits : 0);
    if (x.relative_accuracy_bits() < needed) {
        return false;
    }
    return !has_them;
}

std::string how(const BoundedValue& x, const PrintedValue& p) {
    return x.how() + (p.undecided ? " (rounding undecided)" : "");
}

PrintedValue printed(const BoundedValue& x, const Digits& digits) {
    PrintedValue p;
    if (x.exactly) {
        p = printed_exactly(*x.exactly, digits);
    } else if (!x.value.is_finite()) {
        return {"nan", "inf", false, false, {}};
    } else if (contains_zero(x.value) && digits.rounding == Rounding::nearest) {
        const bool zero = x.value.is_exact();
        p = {"0", bound_text(abs(x.value).upper()), zero, !zero && x.proved, {}};
    } else {
        Rounded r = round_ball(x.value, digits.count, digits.rounding);
        const bool complete = r.complete;
        const bool narrow =
            x.proved && x.value.relative_accuracy_bits() >= formula::bits_for(digits.count);
        if (!complete && digits.rounding != Rounding::nearest) {
            const Real end = digits.rounding == Rounding::down ? x.value.lower() : x.value.upper();
            r = round_ball(Ball(end, x.value.bits() + bits_beyond), digits.count, digits.rounding);
        } else if (!complete && (narrow || r.text.empty())) {
            r = round_ball(Ball(x.value.midpoint(), x.value.bits()), narrow ? digits.count : 1);
        }
        p = {r.text, bound_text(farthest(x.value, r.value)), complete, !complete && x.proved, {}};
    }
    if (digits.binary64 && x.exactly) {
        p.binary64 = nearest_binary64(*x.exactly);
    } else if (digits.binary64) {
        p.binary64 = nearest_binary64(x.value);
        if (!p.binary64) {
            p.undecided = p.undecided || x.proved;
        }
    }
    return p;
}

std::string decimal_text(const Exact& x, const Digits& digits) {
    if (digits.exact) {
        return x.text();
    }
    if (x.is_rational()) {
        const Rational& q = x.rational();
        const PrintedValue rounded = printed_exactly(q, digits);
        const bool is_short =
            Rounded(round_rational(q, digits.count, Rounding::nearest)).value.value() == q;
        return !is_short                                 ? rounded.text
               : x.text().find('/') == std::string::npos ? x.text()
                                                         : exact_text(q);
    }
    constexpr long most_bits = 1L << 20;
    PrintedValue rounded;
    for (long bits = formula::bits_for(digits.count) + 64; !rounded.complete && bits < most_bits;
         bits *= 2) {
        rounded = printed({formula::ball_of(x, bits), true, "", {}}, digits);
    }
    return rounded.text;
}

BoundedValue estimated(const Real& value, const Real& error, std::string route) {
    const long bits = mpfr_get_prec(value.backend().data());
    return {Ball::around(value, error, bits), false, std::move(route)};
}

std::ostream& operator<<(std::ostream& out, const BoundedValue& x) {
    if (x.exactly) { // the ball of a rational number is wider than the number
        const auto digits = static_cast<unsigned>(std::max<std::streamsize>(out.precision(), 1));
        const PrintedValue p = printed(x, {digits});
        out << p.text << " +/- " << p.bound;
    } else {
        out << x.value;
    }
    return out << " (" << x.how() << ')';
}

} // namespace edgeproof::scene
