// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/tail/sweep_target.hpp"

#include "edgeproof/contact/enclosure/exact_contact.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgeproof::audit {
namespace {

using formula::Exact;
using formula::Expr;

constexpr long target_bits = 4000;
constexpr double most_height = 1000; ///< of the simplest multiple of a unit
/// A multiple is not a coincidence if its height, times the relative width of the interval in which
/// it must lie, is below this.
constexpr double most_coincidence = 0.1;

/// True if each value is at most half of the previous one (`twice`: at least twice it), all with
/// one sign. Values pass if balls do not prove the contrary: the balls of a ratio of exactly 2
/// overlap.
bool each_halves(const std::vector<Ball>& d, bool twice) {
    for (std::size_t i = 0; i + 1 < d.size(); ++i) {
        const Ball& larger = twice ? d[i + 1] : d[i];
        const Ball& smaller = twice ? d[i] : d[i + 1];
        if (!certainly_positive(larger * smaller) ||
            certainly_less(abs(larger), abs(smaller) * 2)) {
            return false;
        }
    }
    return true;
}

bool halves_towards(const Expr& at, std::vector<Ball> values) {
    const Ball target = formula::ball_of(Exact(at), target_bits);
    for (Ball& value : values) {
        value -= target;
    }
    return each_halves(values, false);
}

struct Candidate {
    Expr at;
    Ball value;
    double height = 0;
};

/// Returns the simplest multiple of the unit to which the values can tend. It lies beyond the last
/// value by at most the last step.
std::optional<Candidate> multiple_of(const Expr& unit, const std::vector<Ball>& values) {
    const Ball u = formula::ball_of(Exact(unit), target_bits);
    if (contains_zero(u)) {
        return std::nullopt;
    }
    const Ball last = values.back() / u;
    const Ball step = last - values[values.size() - 2] / u;
    const Ball end = last + step;
    const bool negative = certainly_negative(last);
    if (!certainly_positive(last * end)) {
        return std::nullopt;
    }
    const Ball between = Ball::hull(abs(last), abs(end));
    const auto q = contact::simplest_rational(between);
    const double height = q ? Rational(numerator(*q) * denominator(*q)).convert_to<double>() : 0;
    const Real width = (between.upper() - between.lower()) / between.lower();
    if (!q || height > most_height || height * width.convert_to<double>() > most_coincidence) {
        return std::nullopt;
    }
    const Rational factor = negative ? Rational(-*q) : *q;
    const Rational* known = unit.rational();
    const Expr at = known != nullptr ? Expr::number(factor * *known)
                    : factor == 1    ? unit
                                     : Expr::number(factor) * unit;
    if (!halves_towards(at, values)) {
        return std::nullopt;
    }
    return Candidate{at, u * Ball(factor, target_bits), height};
}

std::optional<Expr> finite_target(const std::vector<Ball>& values,
                                  const std::vector<Exact>& units) {
    std::vector<Expr> all{Expr::number(1), Expr::pi()};
    for (const Exact& unit : units) {
        all.push_back(unit.expr());
    }
    std::vector<Candidate> found;
    for (const Expr& unit : all) {
        if (auto candidate = multiple_of(unit, values)) {
            found.push_back(std::move(*candidate));
        }
    }
    if (found.empty()) {
        return std::nullopt;
    }
    const auto best = std::ranges::min_element(found, {}, &Candidate::height);
    // Two numbers fit, and there is no reason to prefer one of them.
    constexpr double as_simple = 4;
    const bool doubtful = std::any_of(found.begin(), found.end(), [&](const Candidate& other) {
        return disjoint(other.value, best->value) && other.height <= as_simple * best->height;
    });
    return doubtful ? std::nullopt : std::optional(best->at);
}

/// Returns a factor between 1/2 and 1 that has no meaning in any formula.
Rational irregular(std::size_t which) {
    static constexpr std::array<std::array<long, 2>, 7> factors{{{7001, 7919},
                                                                 {6007, 7013},
                                                                 {6101, 8059},
                                                                 {5003, 6863},
                                                                 {8111, 9973},
                                                                 {6271, 8243},
                                                                 {5309, 7477}}};
    const auto& [over, under] = factors.at(which % factors.size());
    return {over, under};
}

} // namespace

std::optional<double> decades_of(const Ball& x) {
    if (!x.is_finite() || contains_zero(x)) {
        return std::nullopt;
    }
    const Ball ten(10, x.bits());
    const Ball decades = log(abs(x)) / log(ten);
    return decades.is_finite() ? std::optional(decades.midpoint().convert_to<double>())
                               : std::nullopt;
}

SweepTarget::SweepTarget(Kind kind, Expr at, const Exact& last)
    : kind_(kind), at_(std::move(at)), last_(last) {
    const Ball end = formula::ball_of(last, target_bits);
    const Ball off = kind == Kind::finite ? end - formula::ball_of(Exact(at_), target_bits) : end;
    decades_ = std::abs(decades_of(off).value_or(0));
}

std::optional<SweepTarget> SweepTarget::of(const std::vector<Exact>& listed,
                                           const std::vector<Exact>& units) {
    const PrecisionScope scope(target_bits * 3 / 10);
    std::vector<Ball> values;
    for (const Exact& value : listed) {
        values.push_back(formula::ball_of(value, target_bits));
    }
    if (each_halves(values, false)) {
        return SweepTarget(Kind::zero, Expr::number(0), listed.back());
    }
    if (each_halves(values, true)) {
        return SweepTarget(Kind::infinity, Expr::number(0), listed.back());
    }
    const auto at = finite_target(values, units);
    return at ? std::optional(SweepTarget(Kind::finite, *at, listed.back())) : std::nullopt;
}

std::string SweepTarget::text() const {
    return kind_ == Kind::infinity ? "infinity" : to_text(at_);
}

Exact SweepTarget::beyond(unsigned decades, std::size_t which) const {
    Rational power(boost::multiprecision::pow(Integer(10), decades));
    if (kind_ != Kind::infinity) {
        power = 1 / power;
    }
    const Rational factor = irregular(which) * power;
    const Rational* last = last_.expr().rational();
    if (kind_ != Kind::finite) {
        return last != nullptr ? Exact::of(factor * *last)
                               : Exact(Expr::number(factor) * last_.expr());
    }
    const Rational* at = at_.rational();
    if (last != nullptr && at != nullptr) {
        return Exact::of(*at + factor * (*last - *at));
    }
    return Exact(at_ + Expr::number(factor) * (last_.expr() - at_));
}

} // namespace edgeproof::audit
