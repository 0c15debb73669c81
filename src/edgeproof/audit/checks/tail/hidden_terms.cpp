// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/tail/hidden_terms.hpp"

#include "edgeproof/audit/checks/tail/sweep_target.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace edgeproof::audit {
namespace {

using formula::Builtin;
using formula::Expr;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double prevails = 3;     ///< decades by which a term dominates
constexpr double no_change = 1e-6; ///< of the ratio of two terms, in decades

std::optional<Ball> value_in(const EnclosedSample& sample, const Expr& e) {
    try {
        Ball value = sample.evaluate(e);
        return value.is_finite() ? std::optional(std::move(value)) : std::nullopt;
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// Returns log10 |e|.
std::optional<double> decades_in(const EnclosedSample& sample, const Expr& e) {
    const auto value = value_in(sample, e);
    return value ? decades_of(*value) : std::nullopt;
}

bool is_zero_ball(const Ball& x) { return x.is_exact() && contains_zero(x); }

/// True if no name in an expression changes from one sample to the other.
bool is_constant(const Expr& e, const SweptPair& at) {
    if (e.is_binder()) {
        return false;
    }
    if (e.args().empty() || (e.kind() == Expr::Kind::call && e.builtin() == Builtin::none)) {
        const auto before = value_in(at.before, e);
        const auto after = before ? value_in(at.after, e) : std::nullopt;
        if (!after || !overlaps(*before, *after)) {
            return false;
        }
    }
    return std::all_of(e.args().begin(), e.args().end(),
                       [&](const Expr& part) { return is_constant(part, at); });
}

/// Returns the number of written digits, without zeros at the ends.
double digits_of_number(const Rational& q) {
    const auto digits = [](Integer n) {
        n = abs(n);
        while (n != 0 && n % 10 == 0) {
            n /= 10;
        }
        return n == 0 ? 0 : static_cast<double>(msb(n)) * 0.30103;
    };
    return digits(numerator(q)) + digits(denominator(q));
}

bool combines(const Expr& e) {
    return e.kind() == Expr::Kind::add || e.kind() == Expr::Kind::sub ||
           e.builtin() == Builtin::max || e.builtin() == Builtin::min ||
           e.builtin() == Builtin::hypot;
}

/// Everything that may hide a term in a formula, each part once, with its number of decades.
class HiddenScales {
public:
    explicit HiddenScales(const SweptPair& at) : at_(at) {}
    void collect(const Expr& e, double times = 1);
    [[nodiscard]] double sum() const {
        double all = 0;
        for (const auto& [text, decades] : decades_) {
            all += decades;
        }
        return all;
    }

private:
    void add(const Expr& e, double decades) {
        double& known = decades_[to_text(e)];
        known = std::max(known, decades);
    }
    void collect_terms(const Expr& e, double times);
    void collect_binder(const Expr& e, double times);
    [[nodiscard]] double power_of(const Expr& e) const;
    const SweptPair& at_;
    std::map<std::string, double> decades_;
};

/// Adds the ratios of the terms at the first sample in decades; for a constant, also the
/// cancellation.
void HiddenScales::collect_terms(const Expr& e, double times) {
    double apart = 0;
    for (std::size_t i = 0; i + 1 < e.args().size(); ++i) {
        const auto first = decades_in(at_.before, e.arg(i));
        const auto second = decades_in(at_.before, e.arg(i + 1));
        if (first && second) {
            apart += std::abs(*first - *second);
            const auto all = is_constant(e, at_) ? decades_in(at_.before, e) : std::nullopt;
            apart += all ? std::abs(std::max(*first, *second) - *all) : 0;
        }
    }
    add(e, times * apart);
}

void HiddenScales::collect_binder(const Expr& e, double times) {
    const Expr middle = (e.arg(2) + e.arg(3)) / Expr::number(2);
    collect(substitute(e.arg(0), e.arg(1).name(), middle), times);
    collect(e.arg(2), times);
    collect(e.arg(3), times);
}

/// Returns the factor by which a power multiplies what its base hides.
double HiddenScales::power_of(const Expr& e) const {
    const auto exponent = e.kind() == Expr::Kind::pow && is_constant(e.arg(1), at_)
                              ? value_in(at_.after, e.arg(1))
                              : std::nullopt;
    return exponent ? std::max(1.0, std::abs(exponent->midpoint().convert_to<double>())) : 1;
}

void HiddenScales::collect(const Expr& e, double times) {
    if (e.kind() == Expr::Kind::number) {
        add(e, times * digits_of_number(e.number()));
    } else if (e.kind() == Expr::Kind::symbol && (e.name() == "x" || e.name() == "u")) {
        // A place near an edge hides as many decades as its distance from the edge.
        const Expr fraction = Expr::symbol("u") / Expr::symbol("L");
        add(fraction, std::abs(decades_in(at_.after, fraction).value_or(infinite)));
    } else if (e.args().empty()) {
        if (!value_in(at_.after, e)) {
            add(e, infinite);
        }
    } else if (e.is_binder()) {
        collect_binder(e, times);
    } else {
        if (combines(e)) {
            collect_terms(e, times);
        }
        for (const Expr& part : e.args()) {
            collect(part, times * power_of(e));
        }
    }
}

bool pair_is_steady(const Expr& first, const Expr& second, const SweptPair& at) {
    const auto ratio = [&](const EnclosedSample& sample) -> std::optional<double> {
        const auto p = decades_in(sample, first);
        const auto q = decades_in(sample, second);
        return p && q ? std::optional(*p - *q) : std::nullopt;
    };
    const auto zero = [&](const Expr& e) {
        const auto before = value_in(at.before, e);
        const auto after = value_in(at.after, e);
        return before && after && is_zero_ball(*before) && is_zero_ball(*after);
    };
    if (zero(first) || zero(second)) {
        return true;
    }
    const auto before = ratio(at.before);
    const auto after = ratio(at.after);
    if (!before || !after) {
        return false;
    }
    return std::abs(*after - *before) < no_change ||
           (*before * *after > 0 && std::abs(*after) > std::abs(*before) &&
            std::abs(*after) >= prevails);
}

} // namespace

double hidden_decades(const Expr& e, const SweptPair& at) {
    HiddenScales scales(at);
    scales.collect(e);
    return scales.sum();
}

bool sums_are_steady(const Expr& e, const SweptPair& at) {
    if (e.is_binder() || e.args().empty() || is_constant(e, at)) {
        return true;
    }
    if (combines(e)) {
        for (std::size_t i = 0; i + 1 < e.args().size(); ++i) {
            if (!pair_is_steady(e.arg(i), e.arg(i + 1), at)) {
                return false;
            }
        }
    }
    return std::all_of(e.args().begin(), e.args().end(),
                       [&](const Expr& part) { return sums_are_steady(part, at); });
}

} // namespace edgeproof::audit
