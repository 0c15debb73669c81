// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/interface/enclosed_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <sstream>

namespace edgeproof {
namespace {

constexpr long fewest_digits = 2;
constexpr long most_digits = 100'000;
/// Longer exact numbers are kept as enclosures only: repeated products would fill the memory.
constexpr std::size_t most_bits_of_exact = 100'000;
/// Results are refused if their size is not between 2^-limit and 2^limit: their texts and exact
/// ends would be as long as this exponent.
constexpr long limit_of_exponent = 400'000;

Rational rational_of_real(const Real& x) {
    Rational q;
    mpfr_get_q(q.backend().data(), x.backend().data());
    return q;
}

std::pair<Rational, Rational> ends(const Value& v) {
    const scene::BoundedValue& x = v.enclosure->value;
    if (x.exactly) {
        return {*x.exactly, *x.exactly};
    }
    const Rational middle = rational_of_real(x.value.midpoint());
    const Rational radius = rational_of_real(x.value.radius());
    return {middle - radius, middle + radius};
}

std::string hexadecimal(const Rational& q) {
    const std::unique_ptr<char, void (*)(void*)> text(mpq_get_str(nullptr, 16, q.backend().data()),
                                                      [](void* memory) { std::free(memory); });
    return text.get();
}

bool is_short(const Rational& q) {
    return mpz_sizeinbase(numerator(q).backend().data(), 2) +
               mpz_sizeinbase(denominator(q).backend().data(), 2) <
           most_bits_of_exact;
}

void require_size(const Ball& x) {
    const Ball most = abs(x);
    static const Ball scale = pow_int(Ball(2, 64), limit_of_exponent);
    if (most.is_exact() && contains_zero(most)) {
        return;
    }
    require(certainly_less(most, scale) && !certainly_less(most, 1 / scale),
            "the result is beyond the range of numbers",
            fmt::format("compute with numbers within 2^(+-{})", limit_of_exponent));
}

/// Returns the digits of a result: those requested, or fewer if only these are certain, for example
/// after a difference of nearly equal values.
unsigned certain_digits(const Ball& x, unsigned digits) {
    if (contains_zero(x)) {
        return digits;
    }
    const Rounded r = round_ball(x, digits);
    return r.complete ? digits
                      : std::max(static_cast<unsigned>(fewest_digits), std::min(r.digits, digits));
}

Ball ball_of(const Value& v, long bits) {
    const scene::BoundedValue& x = v.enclosure->value;
    return x.exactly ? Ball(*x.exactly, bits) : x.value;
}

/// Returns x op y in ball arithmetic, exactly where both are exact.
template <class Operation> Value computed(const Value& x, const Value& y, const Operation& op) {
    const scene::BoundedValue& u = x.enclosure->value;
    const scene::BoundedValue& v = y.enclosure->value;
    const long bits = std::max(u.value.bits(), v.value.bits());
    scene::BoundedValue result{Ball(op(ball_of(x, bits), ball_of(y, bits))), u.proved && v.proved,
                               "arithmetic"};
    require_size(result.value);
    if (u.exactly && v.exactly) {
        if (const Rational q(op(*u.exactly, *v.exactly)); is_short(q)) {
            result.value = Ball(q, bits);
            result.exactly = q;
        }
    }
    const unsigned digits = x.exact && !y.exact   ? y.digits
                            : y.exact && !x.exact ? x.digits
                                                  : std::min(x.digits, y.digits);
    const bool exactly = result.exactly.has_value();
    return value_of(result, exactly ? digits : certain_digits(result.value, digits));
}

/// Returns op(x), which needs no rounding.
template <class Operation> Value changed(const Value& x, const Operation& op) {
    scene::BoundedValue value = x.enclosure->value;
    value.value = op(value.value);
    if (value.exactly) {
        value.exactly = Rational(op(*value.exactly));
    }
    return value_of(std::move(value), x.digits);
}

} // namespace

void require_digits(long digits, long least, long most) {
    require(digits >= least && digits <= most, fmt::format("digits = {} is out of range", digits),
            fmt::format("give a number from {} to {}", least, most));
}

Value value_of(scene::BoundedValue value, unsigned digits) {
    if (!value.exactly && !value.value.is_finite()) {
        throw BudgetError("no number of bits tried gives a value");
    }
    const scene::PrintedValue p = scene::printed(value, {digits});
    Value v{p.text,
            p.bound,
            value.proved,
            scene::how(value, p),
            digits,
            p.complete,
            value.exactly.has_value()};
    v.enclosure = std::make_shared<const Value::Enclosure>(Value::Enclosure{std::move(value)});
    return v;
}

Value Value::given(const std::string& number, unsigned digits) {
    const formula::Exact x = formula::Exact::parse(number);
    return value_of(
        {formula::ball_of(x, formula::bits_for(digits) + 64), true, "given", rational_of(x)},
        digits);
}

std::string Value::rounded(long to_digits) const {
    require_digits(to_digits, fewest_digits, most_digits);
    return scene::printed(enclosure->value, {static_cast<unsigned>(to_digits)}).text;
}

double Value::nearest() const {
    const scene::BoundedValue& x = enclosure->value;
    const std::optional<double> found =
        x.exactly ? nearest_binary64(*x.exactly) : nearest_binary64(x.value);
    if (!found) {
        throw UndecidedError("two binary64 may be the nearest one", "ask for more digits");
    }
    return *found + 0.0; // no negative zero
}

std::pair<std::string, std::string> Value::interval() const {
    const auto [low, high] = ends(*this);
    return {hexadecimal(low), hexadecimal(high)};
}

std::string Value::state() const {
    const scene::BoundedValue& x = enclosure->value;
    const std::unique_ptr<char, void (*)(void*)> ball(arb_dump_str(x.value.data()), flint_free);
    return fmt::format("{} {:d} {} {}\n{}\n{}", x.value.bits(), x.proved, digits,
                       x.exactly ? x.exactly->str() : "-", x.route, ball.get());
}

Value Value::from_state(const std::string& state) {
    std::istringstream in(state);
    long bits = 2;
    unsigned digits = 0;
    std::string exactly;
    std::string ball;
    scene::BoundedValue x;
    in >> bits >> x.proved >> digits >> exactly >> std::ws;
    std::getline(in, x.route);
    std::getline(in, ball);
    x.value = Ball(0, std::max(bits, 2L));
    require(in && arb_load_str(x.value.data(), ball.c_str()) == 0, "this is not a pickled Value",
            "");
    if (exactly != "-") {
        x.exactly = parse_decimal(exactly);
    }
    return value_of(std::move(x), digits);
}

Value operator+(const Value& x, const Value& y) {
    return computed(x, y, [](const auto& u, const auto& v) { return u + v; });
}
Value operator-(const Value& x, const Value& y) {
    return computed(x, y, [](const auto& u, const auto& v) { return u - v; });
}
Value operator*(const Value& x, const Value& y) {
    return computed(x, y, [](const auto& u, const auto& v) { return u * v; });
}
Value operator/(const Value& x, const Value& y) {
    if (contains_zero(ball_of(y, y.enclosure->value.value.bits()))) {
        if (y.enclosure->value.value.is_exact()) {
            throw DomainError("division by zero");
        }
        throw UndecidedError("the divisor may be zero", "ask for it with more digits");
    }
    return computed(x, y, [](const auto& u, const auto& v) { return u / v; });
}
Value operator-(const Value& x) {
    return changed(x, [](const auto& u) { return -u; });
}
Value abs(const Value& x) {
    return changed(x, [](const auto& u) { return abs(u); });
}

int compared(const Value& x, const Value& y) {
    const auto u = ends(x);
    const auto v = ends(y);
    if (u.second < v.first || v.second < u.first) {
        return u.second < v.first ? -1 : 1;
    }
    if (u.first != u.second || v.first != v.second) {
        throw UndecidedError("the bounds of the two values overlap",
                             "ask for both with more digits");
    }
    return 0;
}

} // namespace edgeproof
