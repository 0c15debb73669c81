// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/rounding/text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace edgeproof {
namespace {

/// If a number is as close to a power of ten as this, relatively, its first digit is not decided
/// here.
constexpr double too_near = 1e-9;
constexpr long most_exponent =
    1L << 20; // binary exponent for which the logarithm is accurate in binary64
constexpr long least_accuracy = 40; // bits, so that no ball contains numbers on both sides
constexpr double least_off = 1e-3;  // units: smaller distances have lost digits in binary64

/// Finds k with 10^k <= |x| < 10^(k+1) for every x in a ball narrower than 2^-least_accuracy; false
/// where that is not certain.
bool leading_place(const Ball& x, long& k) {
    if (x.relative_accuracy_bits() < least_accuracy) {
        return false;
    }
    arf_srcptr middle = arb_midref(x.data());
    if (arf_cmpabs_2exp_si(middle, most_exponent) >= 0 ||
        arf_cmpabs_2exp_si(middle, -most_exponent) <= 0) {
        return false;
    }
    ArfValue mantissa;
    FmpzValue exponent;
    arf_frexp(mantissa, exponent, middle);
    const double m = std::abs(arf_get_d(mantissa, ARF_RND_NEAR));
    const double decades =
        (std::log2(m) + static_cast<double>(fmpz_get_si(exponent))) * std::log10(2.0);
    k = static_cast<long>(std::floor(decades));
    return std::abs(decades - std::round(decades)) > too_near;
}

/// Returns 10^k with that many bits. The last power is kept, because the next number often has the
/// same size.
const ArbValue& power_of_ten(ulong k, long bits) {
    struct Kept {
        ulong k = 0;
        long bits = 0; ///< 0: nothing is kept
        ArbValue power;
    };
    static thread_local Kept kept;
    if (kept.bits != bits || kept.k != k) {
        arb_ui_pow_ui(kept.power, 10, k, bits);
        kept.k = k;
        kept.bits = bits;
    }
    return kept.power;
}

/// The number to which all numbers of a ball round, in units of 10^place.
struct WholeUnits {
    FmpzValue whole;
    long place = 0;
    double off = 0;           ///< approximate distance of the middle of the ball from it
    bool is_accurate = false; ///< `off` is accurate to a part in 10^12 for every number in the ball
};

/// Rounds x to `digits` digits; false if that is not decided here.
bool find_whole_units(const Ball& x, unsigned digits, Rounding mode, WholeUnits& to) {
    long first = 0;
    if (digits == 0 || !leading_place(x, first)) {
        return false;
    }
    // All numbers in the ball round alike if none of them is a whole number (or, for rounding to
    // nearest, half of an odd one). A ball that is too wide contains one.
    to.place = first - static_cast<long>(digits) + 1;
    const ArbValue& ten = power_of_ten(static_cast<ulong>(std::abs(to.place)), x.bits());
    ArbValue units;
    if (to.place > 0) {
        arb_div(units, x.data(), ten, x.bits());
    } else {
        arb_mul(units, x.data(), ten, x.bits());
    }
    if (mode == Rounding::nearest) {
        static const ArbValue half = [] {
            ArbValue h;
            arb_set_d(h, 0.5);
            return h;
        }();
        arb_add(units, units, half, x.bits());
    }
    // The middle is farther from the whole numbers on both sides than the radius.
    ArfValue above;
    arf_floor(above, arb_midref(units));
    (void)arf_get_fmpz(to.whole, above, ARF_RND_DOWN);
    arf_sub(above, arb_midref(units), above, ARF_PREC_EXACT, ARF_RND_DOWN);
    const double part = arf_get_d(above, ARF_RND_NEAR);
    const bool alike = arf_cmpabs_mag(above, arb_radref(units)) > 0;
    arf_sub_ui(above, above, 1, ARF_PREC_EXACT, ARF_RND_DOWN);
    if (mode == Rounding::up) {
        fmpz_add_ui(to.whole, to.whole, 1);
    }
    to.off = mode == Rounding::nearest ? std::abs(part - 0.5)
             : mode == Rounding::down  ? part
                                       : arf_get_d(above, ARF_RND_NEAR);
    to.off = std::abs(to.off);
    to.is_accurate = mag_get_d(arb_radref(units)) < 1e-14 * to.off && to.off > least_off;
    return alike && arf_cmpabs_mag(above, arb_radref(units)) > 0;
}

/// The same. The last result is kept, because a value is examined when it is found and when it is
/// printed.
const WholeUnits* whole_units(const Ball& x, unsigned digits, Rounding mode) {
    struct Kept {
        ArbValue x;
        long bits = 0; ///< 0: nothing is kept
        unsigned digits = 0;
        Rounding mode = Rounding::nearest;
        WholeUnits units;
        bool seen = false;
    };
    static thread_local Kept kept;
    if (kept.bits != x.bits() || kept.digits != digits || kept.mode != mode ||
        arb_equal(kept.x, x.data()) == 0) {
        kept.bits = 0; // in case an exception follows
        kept.seen = find_whole_units(x, digits, mode, kept.units);
        arb_set(kept.x, x.data());
        kept.bits = x.bits();
        kept.digits = digits;
        kept.mode = mode;
    }
    return kept.seen ? &kept.units : nullptr;
}

/// Beyond these limits a binary64 is subnormal or infinite, or close to it.
constexpr double least_binary64 = 1e-300;
constexpr double most_binary64 = 1e300;
constexpr long more_than_binary64 = 80; // bits

} // namespace

bool rounds_alike(const Ball& x, unsigned digits, Rounding mode) {
    return whole_units(x, digits, mode) != nullptr;
}

std::optional<SeenAtAGlance> rounded_at_a_glance(const Ball& x, unsigned digits, Rounding mode) {
    const WholeUnits* units = whole_units(x, digits, mode);
    if (units == nullptr || fmpz_is_zero(units->whole) != 0) {
        return {};
    }
    SeenAtAGlance seen;
    Decimal& d = seen.value;
    d.negative = fmpz_sgn(units->whole) < 0;
    FmpzValue size;
    fmpz_abs(size, units->whole);
    d.digits.resize(fmpz_sizeinbase(size, 10) + 1); // with the terminating zero that C writes
    fmpz_get_str(d.digits.data(), 10, size);
    d.digits.resize(std::strlen(d.digits.c_str()));
    d.exponent = static_cast<long>(d.digits.size()) + units->place;
    d.digits.resize(digits, '0'); // 999 -> 1000
    if (units->is_accurate) {
        seen.bound = bound_at_a_glance(units->off, units->place);
    }
    return seen;
}

std::optional<double> binary64_at_a_glance(const Ball& x) {
    ArfValue radius;
    ArfValue end;
    arf_set_mag(radius, arb_radref(x.data()));
    arf_sub(end, arb_midref(x.data()), radius, more_than_binary64, ARF_RND_FLOOR);
    const double lower = arf_get_d(end, ARF_RND_NEAR);
    arf_add(end, arb_midref(x.data()), radius, more_than_binary64, ARF_RND_CEIL);
    const double size = std::abs(lower);
    return lower == arf_get_d(end, ARF_RND_NEAR) && size > least_binary64 && size < most_binary64
               ? std::optional(lower)
               : std::nullopt;
}

std::string layout(const Decimal& d, unsigned digits) {
    if (d.digits.empty()) {
        return "0";
    }
    const std::string sign = d.negative ? "-" : "";
    const long point = d.exponent; // digits before the decimal point
    if (point > -5 && point <= static_cast<long>(digits)) {
        if (point <= 0) {
            return sign + "0." + std::string(static_cast<std::size_t>(-point), '0') + d.digits;
        }
        const auto before = static_cast<std::size_t>(point);
        std::string text = sign + d.digits.substr(0, before);
        if (before < d.digits.size()) {
            text += "." + d.digits.substr(before);
        }
        return text;
    }
    std::string text = sign + d.digits.substr(0, 1);
    if (d.digits.size() > 1) {
        text += "." + d.digits.substr(1);
    }
    const long e = point - 1;
    const std::string size = std::to_string(e < 0 ? -e : e);
    return text + "e" + (e < 0 ? "-" : "+") + (size.size() < 2 ? "0" : "") + size;
}

std::string bound_at_a_glance(double near, long place) {
    constexpr int more = 15;                           // digits after the first
    constexpr std::int64_t unsure = 100'000;           // units of the last of them
    constexpr std::int64_t unit = 100'000'000'000'000; // of the second digit
    constexpr unsigned bound_digits = 2;
    if (!(near > least_binary64 && near < most_binary64)) {
        return {};
    }
    // d.ddddddddddddddde-NN
    std::array<char, 32> text{};
    const char* const end = std::to_chars(text.data(), text.data() + text.size(), near,
                                          std::chars_format::scientific, more)
                                .ptr;
    const char* const e = text.data() + 2 + more;
    std::int64_t behind = 0;
    (void)std::from_chars(text.data() + 3, e, behind);
    if (behind < unsure || behind > unit - unsure) {
        return {};
    }
    long exponent = 0;
    (void)std::from_chars(e + (e[1] == '-' ? 1 : 2), end, exponent);
    int first_two = 10 * (text[0] - '0') + (text[2] - '0') + 1;
    if (first_two == 100) {
        first_two = 10;
        ++exponent;
    }
    return layout({false, std::to_string(first_two), exponent + place + 1}, bound_digits);
}

} // namespace edgeproof
