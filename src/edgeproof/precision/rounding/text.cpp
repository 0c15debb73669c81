// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/rounding/text.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ostream>
#include <utility>

namespace edgeproof {

namespace {

constexpr long max_exponent = 100000;
/// For a result: relative errors of many terms contain powers of the input.
constexpr long most_result_exponent = 100 * max_exponent;
constexpr std::array<std::string_view, 3> rounding_names{"nearest", "down", "up"};
static_assert(rounding_names.size() == static_cast<std::size_t>(Rounding::up) + 1);

[[noreturn]] void not_a_number(std::string_view text) {
    throw InputError("'" + std::string(text.substr(0, 60)) + "' is not a number",
                     "write a decimal such as 0.4 or 1e-30, or a quotient such as 3/2");
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Returns a finite number in decimal.
Decimal decimal_of(const Real& x, unsigned count, mpfr_rnd_t rounding) {
    if (count == 0) {
        throw DomainError("a number cannot be written to no digits at all");
    }
    Decimal d;
    if (mpfr_zero_p(x.backend().data()) != 0) {
        return d;
    }
    mpfr_exp_t exponent = 0;
    char* raw = mpfr_get_str(nullptr, &exponent, 10, count, x.backend().data(), rounding);
    d.digits = raw;
    mpfr_free_str(raw);
    d.exponent = exponent;
    if (d.digits[0] == '-') {
        d.negative = true;
        d.digits.erase(0, 1);
    }
    return d;
}

/// Writes a decimal that has digits without an exponent.
std::string plain(const Decimal& d) {
    const auto zeros = [](long n) { return std::string(static_cast<std::size_t>(n), '0'); };
    const auto size = static_cast<long>(d.digits.size());
    std::string text = d.digits;
    if (d.exponent <= 0) {
        text.insert(0, "0." + zeros(-d.exponent));
    } else if (d.exponent < size) {
        text.insert(static_cast<std::size_t>(d.exponent), ".");
    } else {
        text += zeros(d.exponent - size);
    }
    return (d.negative ? "-" : "") + text;
}

/// Lays out a decimal as to_decimal() does.
std::string layout(const Decimal& d, unsigned digits) {
    if (d.digits.empty()) {
        return "0";
    }
    const long point = d.exponent; // digits before the decimal point
    if (point > -5 && point <= static_cast<long>(digits)) {
        return plain(d);
    }
    const std::string sign = d.negative ? "-" : "";
    std::string text = sign + d.digits.substr(0, 1);
    if (d.digits.size() > 1) {
        text += "." + d.digits.substr(1);
    }
    const long e = point - 1;
    const std::string size = std::to_string(e < 0 ? -e : e);
    return text + "e" + (e < 0 ? "-" : "+") + (size.size() < 2 ? "0" : "") + size;
}

std::string decimal(const Real& x, unsigned digits, mpfr_rnd_t rounding) {
    if (mpfr_number_p(x.backend().data()) == 0) {
        return mpfr_nan_p(x.backend().data()) != 0 ? "nan" : x > 0 ? "inf" : "-inf";
    }
    return layout(decimal_of(x, digits, rounding), digits);
}

Rounded single(const Decimal& d, unsigned digits, bool complete) {
    return {layout(d, digits), digits, complete, d};
}

/// About floor(log10(x/y)): near a power of ten it may be wrong by one.
long decades(const Integer& x, const Integer& y) {
    long of_x = 0;
    long of_y = 0;
    const double ratio =
        mpz_get_d_2exp(&of_x, x.backend().data()) / mpz_get_d_2exp(&of_y, y.backend().data());
    return static_cast<long>(
        std::floor((std::log2(ratio) + static_cast<double>(of_x - of_y)) * std::log10(2.0)));
}

Integer ten_to(long k) {
    Integer power;
    mpz_ui_pow_ui(power.backend().data(), 10, static_cast<unsigned long>(k));
    return power;
}

/// d = whole * 10^scale; d has digits.
struct Scaled {
    Integer whole;
    long scale = 0;
};
Scaled scaled(const Decimal& d) {
    if (std::abs(d.exponent) > most_result_exponent) {
        throw InputError("a value has an exponent beyond 10000000",
                         "ask for fewer terms, or for numbers nearer to 1");
    }
    Scaled s{Integer(d.digits), d.exponent - static_cast<long>(d.digits.size())};
    if (d.negative) {
        s.whole.backend().negate();
    }
    return s;
}

/// The ends of a ball, midpoint -+ radius, exactly, in as many bits as that takes.
struct Ends {
    Real lo;
    Real hi;
};
Ends exact_ends(const Ball& x) {
    ArfValue lo;
    ArfValue hi;
    arb_get_interval_arf(lo, hi, x.data(), ARF_PREC_EXACT);
    const auto exactly = [](const ArfValue& end) {
        Real r;
        mpfr_set_prec(r.backend().data(), std::max<mpfr_prec_t>(2, arf_bits(end)));
        arf_get_mpfr(r.backend().data(), end, MPFR_RNDN);
        return r;
    };
    return {exactly(lo), exactly(hi)};
}

} // namespace

std::string_view rounding_name(Rounding mode) {
    return rounding_names.at(static_cast<std::size_t>(mode));
}

std::optional<Rounding> rounding_named(std::string_view name) {
    const auto* const at = std::find(rounding_names.begin(), rounding_names.end(), name);
    return at == rounding_names.end()
               ? std::nullopt
               : std::optional(static_cast<Rounding>(at - rounding_names.begin()));
}

Rational Decimal::value() const {
    if (digits.empty()) {
        return 0;
    }
    const auto [whole, scale] = scaled(*this);
    return scale < 0 ? Rational(whole, ten_to(-scale)) : Rational(whole * ten_to(scale));
}

Ball Decimal::enclosure(long bits) const {
    Ball x(0, bits);
    if (digits.empty()) {
        return x;
    }
    const auto [whole, scale] = scaled(*this);
    FmpzValue above;
    fmpz_set_mpz(above, Integer(scale > 0 ? whole * ten_to(scale) : whole).backend().data());
    FmpzValue below;
    fmpz_set_mpz(below, ten_to(scale < 0 ? -scale : 0).backend().data());
    arb_fmpz_div_fmpz(x.data(), above, below, bits);
    return x;
}

Rational parse_decimal(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash != std::string_view::npos) {
        const Rational numerator = parse_decimal(text.substr(0, slash));
        const std::string_view below = text.substr(slash + 1);
        if (below.empty() || !is_digit(below[0]) || below.find('/') != std::string_view::npos) {
            not_a_number(text);
        }
        const Rational denominator = parse_decimal(below);
        if (denominator == 0) {
            throw InputError("'" + std::string(text.substr(0, 60)) + "' divides by zero",
                             "write a quotient with a denominator that is not 0");
        }
        return numerator / denominator;
    }
    std::size_t i = 0;
    bool negative = false;
    if (i < text.size() && (text[i] == '-' || text[i] == '+')) {
        negative = text[i] == '-';
        ++i;
    }
    std::string digits;
    long scale = 0;
    bool point = false;
    for (; i < text.size() && (is_digit(text[i]) || (text[i] == '.' && !point)); ++i) {
        if (text[i] == '.') {
            point = true;
        } else {
            digits += text[i];
            scale -= point ? 1 : 0;
        }
    }
    if (digits.empty() || digits.size() > static_cast<std::size_t>(max_exponent)) {
        not_a_number(text);
    }
    if (i < text.size()) {
        if (text[i] != 'e' && text[i] != 'E') {
            not_a_number(text);
        }
        const char* const end = text.data() + text.size();
        const char* begin = text.data() + i + 1;
        begin += begin != end && *begin == '+' ? 1 : 0;
        long exponent = 0;
        const auto [behind, error] = std::from_chars(begin, end, exponent);
        if (behind == begin || behind != end || (*begin == '-' && text[i + 1] == '+')) {
            not_a_number(text);
        }
        if (error != std::errc() || std::abs(exponent) > max_exponent) {
            throw InputError("the exponent of '" + std::string(text.substr(0, 60)) +
                                 "' is beyond 100000",
                             "write a number between 1e-100000 and 1e100000");
        }
        scale += exponent;
    }
    digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
    const auto exponent = static_cast<long>(digits.size()) + scale;
    return Decimal{negative, std::move(digits), exponent}.value();
}

std::string to_decimal(const Real& x, unsigned digits) { return decimal(x, digits, MPFR_RNDN); }

std::string to_decimal(const Rational& q, unsigned digits, Rounding mode) {
    return round_rational(q, digits, mode).text;
}

Rounded round_rational(const Rational& q, unsigned digits, Rounding mode) {
    if (digits == 0) {
        throw DomainError("a number cannot be written to no digits at all");
    }
    if (q == 0) {
        return single({}, digits, true);
    }
    const bool negative = q.sign() < 0;
    const Integer size = abs(boost::multiprecision::numerator(q));
    const Integer denominator = boost::multiprecision::denominator(q);
    // |q| 10^shift has `digits` digits before its point: `whole` is between these two.
    const Integer least = ten_to(static_cast<long>(digits) - 1);
    const Integer most = 10 * least;
    long shift = static_cast<long>(digits) - 1 - decades(size, denominator);
    Integer whole;
    Integer rest; // in units of 1/below
    Integer below;
    for (;;) {
        const Integer above = shift > 0 ? Integer(size * ten_to(shift)) : size;
        below = shift < 0 ? Integer(denominator * ten_to(-shift)) : denominator;
        divide_qr(above, below, whole, rest);
        if (whole >= most) {
            --shift;
        } else if (whole < least) {
            ++shift;
        } else {
            break;
        }
    }
    const int half = Integer(2 * rest).compare(below);
    const bool away = mode == Rounding::nearest ? half > 0 || (half == 0 && whole % 2 != 0)
                                                : rest != 0 && (mode == Rounding::up) != negative;
    if (away) {
        ++whole;
    }
    Decimal d{negative, whole.str(), 0};
    d.exponent = static_cast<long>(d.digits.size()) - shift;
    d.digits.resize(digits, '0'); // 999 -> 1000
    return single(d, digits, true);
}

std::string bound_text(const Real& x) { return decimal(x, 2, MPFR_RNDU); }

std::optional<Decimal> terminating_decimal(const Rational& q) {
    const Integer below(boost::multiprecision::denominator(q));
    const Integer five(5);
    Integer rest;
    const auto twos = mpz_scan1(below.backend().data(), 0);
    mpz_tdiv_q_2exp(rest.backend().data(), below.backend().data(), twos);
    const auto fives =
        mpz_remove(rest.backend().data(), rest.backend().data(), five.backend().data());
    if (rest != 1) {
        return {};
    }
    const auto places = static_cast<long>(std::max(twos, fives));
    Decimal d{q < 0, Integer(abs(numerator(q)) * (ten_to(places) / below)).str(), 0};
    d.exponent = static_cast<long>(d.digits.size()) - places;
    d.digits.resize(d.digits.find_last_not_of('0') + 1);
    return q == 0 ? Decimal() : d;
}

std::string exact_text(const Rational& q) {
    const auto d = terminating_decimal(q);
    if (!d) {
        return q.str();
    }
    return d->digits.empty() ? "0" : plain(*d);
}

Rounded round_ball(const Ball& x, unsigned digits, Rounding mode) {
    if (!x.is_finite()) {
        return {};
    }
    const Ends ends = exact_ends(x);
    const mpfr_rnd_t rounding = mode == Rounding::nearest ? MPFR_RNDN
                                : mode == Rounding::down  ? MPFR_RNDD
                                                          : MPFR_RNDU;
    for (unsigned k = digits; k > 0; --k) {
        const Decimal lo = decimal_of(ends.lo, k, rounding);
        if (lo == decimal_of(ends.hi, k, rounding)) {
            return single(lo, k, k == digits);
        }
    }
    return {};
}

std::optional<double> nearest_binary64(const Ball& x) {
    if (!x.is_finite()) {
        return {};
    }
    const Ends ends = exact_ends(x);
    // mpfr_get_d rounds once, including subnormals.
    const double lo = mpfr_get_d(ends.lo.backend().data(), MPFR_RNDN);
    const double hi = mpfr_get_d(ends.hi.backend().data(), MPFR_RNDN);
    if (lo == hi) {
        return lo;
    }
    return {};
}

Real rounded_to_odd(const Rational& q, long bits) {
    Real x;
    mpfr_set_prec(x.backend().data(), bits);
    if (mpfr_set_q(x.backend().data(), q.backend().data(), MPFR_RNDZ) != 0 &&
        mpfr_min_prec(x.backend().data()) < bits) {
        if (q > 0) {
            mpfr_nextabove(x.backend().data());
        } else {
            mpfr_nextbelow(x.backend().data());
        }
    }
    return x;
}

double nearest_binary64(const Rational& q) {
    constexpr long bits = 80; // far behind the last bit of every binary64
    return mpfr_get_d(rounded_to_odd(q, bits).backend().data(), MPFR_RNDN);
}

double digits_reached(const Real& x, const Ball& exact) {
    constexpr unsigned working = 40; // digits of the result
    constexpr double digits_a_bit = 0.30103;
    if (!isfinite(x) || !exact.is_finite()) {
        return 0;
    }
    const PrecisionScope scope(working);
    const long bits = std::max<long>(exact.bits(), mpfr_get_prec(x.backend().data())) + 64;
    const Ball at = exact.with_bits(bits);
    const Ball relative = abs(Ball((Ball(x, bits) - at) / at));
    if (!relative.is_finite()) {
        return 0;
    }
    const double most = static_cast<double>(bits) * digits_a_bit;
    const Real error = relative.upper();
    return error > 0 ? std::clamp(Real(-log10(error)).convert_to<double>(), 0.0, most) : most;
}

std::ostream& operator<<(std::ostream& out, const Ball& x) {
    constexpr unsigned digits_of_ends = 2;
    constexpr long bits_beyond = 16;
    if (!x.is_finite()) {
        return out << "nan";
    }
    const auto digits = static_cast<unsigned>(std::max<std::streamsize>(out.precision(), 1));
    const Rounded r = round_ball(x, digits);
    if (r.text.empty() || r.digits == 0) {
        if (contains_zero(x) && x.is_exact()) {
            return out << "0 +/- 0";
        }
        const Ends ends = exact_ends(x);
        return out << '[' << decimal(ends.lo, digits_of_ends, MPFR_RNDD) << ", "
                   << decimal(ends.hi, digits_of_ends, MPFR_RNDU) << ']';
    }
    const Ball error = abs(Ball(x - r.value.enclosure(x.bits() + bits_beyond)));
    return out << r.text << " +/- " << bound_text(error.upper());
}

} // namespace edgeproof
