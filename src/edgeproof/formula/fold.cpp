// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/fold.hpp"
#include "edgeproof/formula/names.hpp"
#include "edgeproof/formula/parse.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

namespace edgeproof::formula {
namespace {

std::optional<Rational> fold_power(const Rational& base, const Rational& exponent) {
    constexpr unsigned long max_root = 64;
    const Integer n(numerator(exponent));
    const Integer d(denominator(exponent));
    if (n == 0) {
        return Rational(1);
    }
    if (base == 0) {
        return n > 0 ? std::optional(Rational(0)) : std::nullopt;
    }
    Rational x = base;
    if (d != 1) {
        if (d > max_root) {
            return std::nullopt;
        }
        const auto root = exact_root(base, d.convert_to<unsigned long>());
        if (!root) {
            return std::nullopt;
        }
        x = *root;
    }
    if (x == 1) {
        return x;
    }
    if (x == -1) {
        return Rational(n % 2 == 0 ? 1 : -1);
    }
    const Integer size = abs(n);
    if (size * bits_of(x) > 2 * max_folded_bits) {
        return std::nullopt;
    }
    const auto k = size.convert_to<unsigned long>();
    const Rational y = whole_power(x, k);
    return n > 0 ? y : Rational(1) / y;
}

std::optional<Rational> fold_call(Builtin f, std::span<const Expr> args) {
    const auto less = [](const Expr& x, const Expr& y) { return *x.rational() < *y.rational(); };
    const Rational& x = *args[0].rational();
    switch (f) {
    case Builtin::sqrt:
        return exact_root(x, 2);
    case Builtin::abs:
        return x < 0 ? -x : x;
    case Builtin::sgn:
        return Rational(x.sign());
    case Builtin::step:
        return Rational(1 + x.sign(), 2);
    case Builtin::max:
        return *std::ranges::max_element(args, less)->rational();
    case Builtin::min:
        return *std::ranges::min_element(args, less)->rational();
    default:
        return std::nullopt;
    }
}

std::optional<Rational> fold_unbounded(Expr::Kind kind, Builtin f, std::span<const Expr> args) {
    const Rational& x = *args[0].rational();
    switch (kind) {
    case Expr::Kind::neg:
        return -x;
    case Expr::Kind::add:
        return x + *args[1].rational();
    case Expr::Kind::sub:
        return x - *args[1].rational();
    case Expr::Kind::mul:
        return x * *args[1].rational();
    case Expr::Kind::div:
        return *args[1].rational() == 0 ? std::nullopt : std::optional(x / *args[1].rational());
    case Expr::Kind::pow:
        return fold_power(x, *args[1].rational());
    case Expr::Kind::call:
        return fold_call(f, args);
    default:
        return std::nullopt;
    }
}

} // namespace

std::optional<Rational> exact_root(const Rational& q, unsigned long degree) {
    if (q < 0) {
        return std::nullopt;
    }
    Integer n;
    Integer d;
    const auto* raw = q.backend().data();
    if (mpz_root(n.backend().data(), mpq_numref(raw), degree) == 0 ||
        mpz_root(d.backend().data(), mpq_denref(raw), degree) == 0) {
        return std::nullopt;
    }
    return Rational(n, d);
}

Rational whole_power(const Rational& q, unsigned long n) {
    Rational y;
    auto* raw = y.backend().data();
    mpz_pow_ui(mpq_numref(raw), mpq_numref(q.backend().data()), n);
    mpz_pow_ui(mpq_denref(raw), mpq_denref(q.backend().data()), n);
    return y;
}

std::size_t bits_of(const Rational& q) {
    const auto* raw = q.backend().data();
    return mpz_sizeinbase(mpq_numref(raw), 2) + mpz_sizeinbase(mpq_denref(raw), 2);
}

std::optional<Rational> fold(Expr::Kind kind, Builtin f, std::span<const Expr> args) {
    if (args.empty() ||
        !std::ranges::all_of(args, [](const Expr& e) { return e.rational() != nullptr; })) {
        return std::nullopt;
    }
    auto q = fold_unbounded(kind, f, args);
    // A sign before a long literal does not increase its size.
    if (q && kind != Expr::Kind::neg && bits_of(*q) > max_folded_bits) {
        return std::nullopt;
    }
    return q;
}

namespace {

constexpr long max_exponent = 100'000;
/// For all numbers of one expression together.
constexpr std::size_t max_number_bits = 4'000'000;

class DecimalReader {
public:
    DecimalReader(std::string_view text, std::size_t start)
        : text_(text), start_(start), pos_(start) {}

    DecimalToken operator()(std::size_t& bits) {
        long scale = 0;
        read_digits();
        if (peek() == '.') {
            ++pos_;
            scale = -static_cast<long>(read_digits());
        }
        if (digits_.empty()) {
            fail("a '.' without digits" + at_column(text_, start_), "write a number such as 0.5",
                 start_);
        }
        scale += exponent();
        if (peek() == '.') {
            fail("a second '.' in the number" + at_column(text_, start_),
                 "write a number such as 0.5", start_);
        }
        Rational q = value(scale);
        bits += q == 0 ? 0 : bits_of(q);
        if (bits > max_number_bits) {
            fail("the numbers are too long in total," + at_column(text_, pos_),
                 "write fewer digits or smaller exponents", pos_);
        }
        return {std::move(q), pos_};
    }

private:
    [[noreturn]] static void fail(std::string problem, std::string instead, std::size_t offset) {
        throw FormulaError(std::move(problem), std::move(instead), offset);
    }
    static bool is_digit(char c) { return c >= '0' && c <= '9'; }
    [[nodiscard]] char peek() const { return pos_ < text_.size() ? text_[pos_] : '\0'; }

    std::size_t read_digits() {
        const std::size_t from = pos_;
        while (is_digit(peek())) {
            digits_ += text_[pos_++];
        }
        return pos_ - from;
    }

    /// The decimal exponent, if one follows.
    long exponent() {
        std::size_t p = pos_;
        const auto here = [&] { return p < text_.size() ? text_[p] : '\0'; };
        if (here() != 'e' && here() != 'E') {
            return 0;
        }
        ++p;
        const bool negative = here() == '-';
        if (here() == '-' || here() == '+') {
            ++p;
        }
        if (!is_digit(here())) {
            return 0;
        }
        long size = 0;
        for (; is_digit(here()); ++p) {
            size = std::min(10 * size + (here() - '0'), 10 * max_exponent);
        }
        pos_ = p;
        return negative ? -size : size;
    }

    /// The digits * 10^scale, exactly.
    [[nodiscard]] Rational value(long scale) const {
        const std::string digits =
            digits_.substr(std::min(digits_.find_first_not_of('0'), digits_.size()));
        if (digits.empty()) {
            return {};
        }
        if (std::abs(scale + static_cast<long>(digits.size()) - 1) > max_exponent) {
            fail("the number" + at_column(text_, start_) + " has an exponent beyond " +
                     std::to_string(max_exponent),
                 "write an exponent between -" + std::to_string(max_exponent) + " and " +
                     std::to_string(max_exponent),
                 start_);
        }
        const Integer mantissa(digits);
        Integer ten_power;
        mpz_ui_pow_ui(ten_power.backend().data(), 10, static_cast<unsigned long>(std::abs(scale)));
        return scale < 0 ? Rational(mantissa, ten_power) : Rational(mantissa * ten_power);
    }

    std::string_view text_;
    std::size_t start_;
    std::size_t pos_;
    std::string digits_;
};

} // namespace

DecimalToken decimal_token(std::string_view text, std::size_t start, std::size_t& bits) {
    return DecimalReader(text, start)(bits);
}

} // namespace edgeproof::formula
