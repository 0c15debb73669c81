// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/fold.hpp"
#include "edgeproof/formula/names.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
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

DecimalToken decimal_token(std::string_view text, std::size_t start, std::size_t& bits) {
    constexpr std::size_t max_number_bits = 4'000'000; // of all numbers of one expression together
    std::size_t end = start;
    const auto is_digit = [&](std::size_t i) {
        return i < text.size() && text[i] >= '0' && text[i] <= '9';
    };
    const auto digits = [&] {
        const std::size_t from = end;
        while (is_digit(end)) {
            ++end;
        }
        return end - from;
    };
    const auto fail = [&](const std::string& problem, const std::string& instead) {
        throw FormulaError(problem + at_column(text, start), instead);
    };
    const auto point = [&] { return end < text.size() && text[end] == '.'; };
    std::size_t count = digits();
    if (point()) {
        ++end;
        count += digits();
    }
    if (count == 0) {
        fail("a '.' without digits", "write a number such as 0.5");
    }
    const bool zero = text.substr(start, end - start).find_first_not_of("0.") == text.npos;
    if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
        const bool sign = end + 1 < text.size() && (text[end + 1] == '-' || text[end + 1] == '+');
        if (const std::size_t first = end + (sign ? 2 : 1); is_digit(first)) {
            end = first;
            static_cast<void>(digits());
        }
    }
    if (point()) {
        fail("a second '.' in the number", "write a number such as 0.5");
    }
    Rational q;
    try {
        q = zero ? Rational(0) : parse_decimal(text.substr(start, end - start));
    } catch (const InputError& error) {
        throw FormulaError(error.problem() + at_column(text, start), error.instead());
    }
    static const Rational most = parse_decimal("1e100000") * 10;
    static const Rational least = parse_decimal("1e-100000");
    if (q != 0 && (q >= most || q < least)) {
        fail("a number beyond 1e100000 or 1e-100000,",
             "write a number between 1e-100000 and 1e100000");
    }
    bits += q == 0 ? 0 : bits_of(q);
    if (bits > max_number_bits) {
        fail("the numbers are too long in total,", "write fewer digits or smaller exponents");
    }
    return {std::move(q), end};
}

} // namespace edgeproof::formula
