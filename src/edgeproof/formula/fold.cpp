// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/fold.hpp"

#include <algorithm>

namespace edgeproof::formula {
namespace {

Integer whole_power(const Integer& x, unsigned long n) {
    Integer y;
    mpz_pow_ui(y.backend().data(), x.backend().data(), n);
    return y;
}

/// Returns the exact root of x >= 0, if there is one.
std::optional<Integer> exact_root(const Integer& x, unsigned long degree) {
    Integer y;
    if (mpz_root(y.backend().data(), x.backend().data(), degree) == 0) {
        return std::nullopt;
    }
    return y;
}

std::optional<Rational> exact_root(const Rational& q, unsigned long degree) {
    if (q < 0) {
        return std::nullopt;
    }
    const auto n = exact_root(Integer(numerator(q)), degree);
    const auto d = exact_root(Integer(denominator(q)), degree);
    return n && d ? std::optional(Rational(*n, *d)) : std::nullopt;
}

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
    const Rational y(whole_power(Integer(numerator(x)), k),
                     whole_power(Integer(denominator(x)), k));
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

} // namespace edgeproof::formula
