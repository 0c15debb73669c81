// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/exact/exact_number.hpp"

#include "edgeproof/formula/fold.hpp"

#include <cstddef>
#include <map>
#include <numeric>
#include <utility>

namespace edgeproof::formula {
namespace {

using boost::multiprecision::denominator;
using boost::multiprecision::numerator;

constexpr unsigned highest_degree = 64;
/// The limit of the bits of a numerator or denominator; a larger number becomes unknown.
constexpr std::size_t most_rational_bits = std::size_t{1} << 22U;
constexpr std::size_t most_exact_terms = 64;
constexpr long most_exponent_of_power = 4096;
constexpr long most_sign_bits = 1L << 14;

bool is_of_moderate_size(const Rational& q) {
    return mpz_sizeinbase(mpq_numref(q.backend().data()), 2) <= most_rational_bits &&
           mpz_sizeinbase(mpq_denref(q.backend().data()), 2) <= most_rational_bits;
}

/// Returns q^n; nothing beyond the limit of size.
std::optional<Rational> moderate_power(const Rational& q, unsigned n) {
    if (n > 1 && bits_of(q) * n > most_rational_bits) {
        return {};
    }
    return whole_power(q, n);
}

/// Returns the product of a term without a radical and a radical.
template <class Term, class Radical> Term times_root(Term t, Radical root) {
    if (root.degree == 1) {
        t.factor *= root.radicand;
    } else {
        t.root = std::move(root);
    }
    return t;
}

} // namespace

ExactNumber::ExactNumber(const Rational& q) {
    if (q != 0) {
        terms_.push_back({q, {}, 0});
    }
}

ExactNumber ExactNumber::pi() {
    ExactNumber x;
    x.terms_.push_back({1, {}, 1});
    return x;
}

ExactNumber ExactNumber::unknown() {
    ExactNumber x;
    x.known_ = false;
    return x;
}

ExactNumber ExactNumber::of(const Expr& e) {
    if (const Rational* q = e.rational()) {
        return ExactNumber(*q);
    }
    const auto arg = [&](std::size_t i) { return of(e.arg(i)); };
    switch (e.kind()) {
    case Expr::Kind::number:
        return ExactNumber(e.number());
    case Expr::Kind::pi:
        return pi();
    case Expr::Kind::neg:
        return -arg(0);
    case Expr::Kind::add:
        return arg(0) + arg(1);
    case Expr::Kind::sub:
        return arg(0) - arg(1);
    case Expr::Kind::mul:
        return arg(0) * arg(1);
    case Expr::Kind::div:
        return arg(0) / arg(1);
    case Expr::Kind::pow: {
        const auto exponent = arg(1).rational();
        return exponent ? pow(arg(0), *exponent) : unknown();
    }
    case Expr::Kind::call:
        return e.builtin() == Builtin::sqrt  ? sqrt(arg(0))
               : e.builtin() == Builtin::abs ? abs(arg(0))
                                             : unknown();
    default:
        return unknown();
    }
}

std::optional<Rational> ExactNumber::rational() const {
    if (!known_ || terms_.size() > 1) {
        return {};
    }
    if (terms_.empty()) {
        return Rational(0);
    }
    const Term& t = terms_.front();
    if (t.root.degree != 1 || t.pi_power != 0) {
        return {};
    }
    return t.factor;
}

Ball ExactNumber::enclosure(long bits) const {
    Ball sum(0, bits);
    if (!known_) {
        arb_indeterminate(sum.data());
        return sum;
    }
    for (const Term& t : terms_) {
        Ball product(t.factor, bits);
        if (t.root.degree > 1) {
            product *= edgeproof::pow(Ball(t.root.radicand, bits), Rational(1, t.root.degree));
        }
        if (t.pi_power != 0) {
            product *= edgeproof::pow(Ball::pi(bits), t.pi_power);
        }
        sum += product;
    }
    return sum;
}

std::optional<int> ExactNumber::sign() const {
    if (!known_) {
        return {};
    }
    if (terms_.empty()) {
        return 0;
    }
    if (terms_.size() == 1) {
        return terms_.front().factor.sign();
    }
    for (long bits = 64; bits <= most_sign_bits; bits *= 2) {
        const Ball x = enclosure(bits);
        if (certainly_positive(x) || certainly_negative(x)) {
            return certainly_positive(x) ? 1 : -1;
        }
    }
    return {};
}

std::optional<ExactNumber::Radical> ExactNumber::times(const Radical& x, const Radical& y) {
    const unsigned degree = std::lcm(x.degree, y.degree);
    if (degree > highest_degree) {
        return {};
    }
    const auto of_x = moderate_power(x.radicand, degree / x.degree);
    const auto of_y = moderate_power(y.radicand, degree / y.degree);
    if (!of_x || !of_y) {
        return {};
    }
    Radical r{*of_x * *of_y, degree};
    // Reduces to the lowest degree: R^(1/k) = S^(1/(k/d)) with R = S^d.
    for (unsigned d = degree; d > 1; --d) {
        if (r.degree % d == 0) {
            if (auto root = exact_root(r.radicand, d)) {
                r = {std::move(*root), r.degree / d};
            }
        }
    }
    return r;
}

std::optional<ExactNumber::Term> ExactNumber::product(const Term& x, const Term& y) {
    Term t{x.factor * y.factor, {}, x.pi_power + y.pi_power};
    auto root = x.root.degree == 1   ? std::optional(y.root)
                : y.root.degree == 1 ? std::optional(x.root)
                                     : times(x.root, y.root);
    if (!root || !is_of_moderate_size(t.factor)) {
        return {};
    }
    return times_root(std::move(t), std::move(*root));
}

std::optional<ExactNumber::Term> ExactNumber::power(const Term& x, const Rational& e) {
    const Integer above = numerator(e);
    const Integer below = denominator(e);
    if (abs(above) > most_exponent_of_power || below > highest_degree) {
        return {};
    }
    const auto n = static_cast<unsigned>(Integer(abs(above)).convert_to<unsigned long>());
    const auto k = static_cast<unsigned>(below.convert_to<unsigned long>());
    if (x.factor < 0 && k != 1) {
        return {};
    }
    // (q R^(1/d))^(n/k) is the k-th root of q^n times the (d k)-th root of R^n.
    auto of_factor = moderate_power(abs(x.factor), n);
    auto of_root = moderate_power(x.root.radicand, n);
    if (!of_factor || !of_root || x.root.degree * k > highest_degree) {
        return {};
    }
    if (above < 0) {
        of_factor = 1 / *of_factor;
        of_root = 1 / *of_root;
    }
    auto root = times({*of_factor, k}, {*of_root, x.root.degree * k});
    if (!root) {
        return {};
    }
    Term t{x.factor < 0 && n % 2 == 1 ? -1 : 1, {}, x.pi_power * e};
    return times_root(std::move(t), std::move(*root));
}

void ExactNumber::add(const Term& t) {
    if (!known_ || t.factor == 0) {
        return;
    }
    for (std::size_t i = 0; i < terms_.size(); ++i) {
        Term& old = terms_[i];
        if (old.pi_power != t.pi_power || old.root.degree != t.root.degree) {
            continue;
        }
        // Terms are combined if the quotient of their radicals is rational. (Radicals with
        // different lowest degrees have no rational quotient, because a rational multiple of a
        // radical has its degree.)
        const auto ratio = exact_root(Rational(t.root.radicand / old.root.radicand), t.root.degree);
        if (!ratio) {
            continue;
        }
        old.factor += t.factor * *ratio;
        if (old.factor == 0) {
            terms_.erase(terms_.begin() + static_cast<std::ptrdiff_t>(i));
        } else if (!is_of_moderate_size(old.factor)) {
            *this = unknown();
        }
        return;
    }
    terms_.push_back(t);
    if (terms_.size() > most_exact_terms) {
        *this = unknown();
    }
}

ExactNumber& ExactNumber::operator+=(const ExactNumber& o) {
    if (!known_ || !o.known_) {
        return *this = unknown();
    }
    const std::vector<Term> added = o.terms_; // o may be *this
    for (const Term& t : added) {
        add(t);
    }
    return *this;
}

ExactNumber operator-(ExactNumber x) {
    for (ExactNumber::Term& t : x.terms_) {
        t.factor = -t.factor;
    }
    return x;
}

ExactNumber& ExactNumber::operator-=(const ExactNumber& o) { return *this += -o; }

ExactNumber& ExactNumber::operator*=(const ExactNumber& o) {
    // Zero times an unknown number is unknown, because that number may be infinite.
    ExactNumber result = known_ && o.known_ ? ExactNumber() : unknown();
    if (result.known_) {
        for (const Term& x : terms_) {
            for (const Term& y : o.terms_) {
                const auto t = product(x, y);
                if (!t) {
                    return *this = unknown();
                }
                result.add(*t);
            }
        }
    }
    return *this = std::move(result);
}

ExactNumber& ExactNumber::operator/=(const ExactNumber& o) { return *this *= pow(o, Rational(-1)); }

ExactNumber abs(const ExactNumber& x) {
    const auto sign = x.sign();
    return !sign ? ExactNumber::unknown() : *sign < 0 ? -x : x;
}

ExactNumber pow(const ExactNumber& x, const Rational& e) {
    if (!x.known_) {
        return x;
    }
    if (e == 0) {
        return {1};
    }
    if (x.terms_.empty()) {
        return e > 0 ? x : ExactNumber::unknown();
    }
    if (x.terms_.size() == 1) {
        const auto t = ExactNumber::power(x.terms_.front(), e);
        if (!t) {
            return ExactNumber::unknown();
        }
        ExactNumber y;
        y.add(*t);
        return y;
    }
    if (e < 0 || denominator(e) != 1 || e > most_exponent_of_power) {
        return ExactNumber::unknown();
    }
    ExactNumber y(1);
    ExactNumber square = x;
    for (auto n = numerator(e).convert_to<unsigned long>(); n != 0 && y.known(); n >>= 1U) {
        if ((n & 1U) != 0) {
            y *= square;
        }
        if (n > 1) {
            square *= square;
        }
    }
    return y;
}

ExactNumber sqrt(const ExactNumber& x) { return pow(x, Rational(1, 2)); }

std::optional<Rational> part_of_pi(const Rational& square_of_cosine) {
    static const std::map<Rational, Rational> table{{0, Rational(1, 2)},
                                                    {Rational(1, 4), Rational(1, 3)},
                                                    {Rational(1, 2), Rational(1, 4)},
                                                    {Rational(3, 4), Rational(1, 6)},
                                                    {1, 0}};
    const auto known = table.find(square_of_cosine);
    return known == table.end() ? std::nullopt : std::optional(known->second);
}

ExactNumber angle_of_cosine(const ExactNumber& c) {
    const auto sign = c.sign();
    if (!sign) {
        return ExactNumber::unknown();
    }
    const auto in_its_quadrant = [&](const ExactNumber& first) {
        return *sign < 0 ? ExactNumber::pi() - first : first;
    };
    const auto known_part = [&](const ExactNumber& cosine) -> std::optional<Rational> {
        const auto square = ExactNumber(cosine * cosine).rational();
        return square ? part_of_pi(*square) : std::nullopt;
    };
    if (const auto part = known_part(c)) {
        return in_its_quadrant(ExactNumber(*part) * ExactNumber::pi());
    }
    const ExactNumber twice = c * c * 2 - 1;
    const auto part = known_part(twice);
    const auto side = twice.sign();
    if (!part || !side) {
        return ExactNumber::unknown();
    }
    const Rational whole = *side < 0 ? Rational(1 - *part) : *part;
    return in_its_quadrant(ExactNumber(Rational(whole / 2)) * ExactNumber::pi());
}

} // namespace edgeproof::formula
