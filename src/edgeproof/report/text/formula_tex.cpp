// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/text/formula_tex.hpp"

#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <vector>

namespace edgeproof::report {
namespace {

using formula::Expr;
using Kind = Expr::Kind;

/// The factors above and below the bar of a product, in the order of the text.
struct Factors {
    std::vector<Expr> above;
    std::vector<Expr> below;
    bool negative = false;

    void take(const Expr& e, bool up) {
        if (e.kind() == Kind::mul) {
            take(e.arg(0), up);
            take(e.arg(1), up);
        } else if (e.kind() == Kind::div) {
            take(e.arg(0), up);
            take(e.arg(1), !up);
        } else if (e.kind() == Kind::neg) {
            negative = !negative;
            take(e.arg(0), up);
        } else if (!(e.kind() == Kind::number && e.number() == 1)) {
            (up ? above : below).push_back(e);
        }
    }
};

/// The order of factors: numbers, roots of numbers, letters, other roots, sums, integrals.
int place_of(const Expr& e) {
    const Kind kind = e.kind();
    const bool root = kind == Kind::call && e.builtin() == formula::Builtin::sqrt;
    if (kind == Kind::number) {
        return 0;
    }
    if (root && e.rational() == nullptr && free_symbols(e).empty()) {
        return 1;
    }
    if (kind == Kind::add || kind == Kind::sub) {
        return 4;
    }
    if (e.is_binder()) {
        return 5;
    }
    return root ? 3 : 2;
}

Expr product_in_order(std::vector<Expr> factors) {
    std::ranges::stable_sort(factors, {}, place_of);
    Expr all = factors.front();
    for (std::size_t i = 1; i < factors.size(); ++i) {
        all = all * factors[i];
    }
    return all;
}

bool in_fraction(const Expr& sum) { // a sum is placed next to the fraction: (P'/4a)(X + S)
    return place_of(sum) < 4;
}

Expr arranged_product(const Expr& e) {
    Factors factors;
    factors.take(e, true);
    std::vector<Expr> next_to_fraction;
    if (!factors.below.empty()) {
        std::ranges::copy_if(factors.above, std::back_inserter(next_to_fraction),
                             [](const Expr& f) { return !in_fraction(f); });
        std::erase_if(factors.above, [](const Expr& f) { return !in_fraction(f); });
    }
    // A fraction with only 1 above takes the sums back: (2 + 3g)/(3 pi), not 1/(3 pi) (2 + 3g).
    constexpr std::size_t most = 80; // a longer one breaks into lines only outside a fraction
    const auto text_size = [](const Expr& f) { return to_text(f).size(); };
    if (factors.above.empty() && std::ranges::all_of(next_to_fraction, [&](const Expr& f) {
            return text_size(f) <= most;
        })) {
        factors.above.swap(next_to_fraction);
    }
    Expr all = factors.above.empty() ? Expr::number(1) : product_in_order(factors.above);
    if (!factors.below.empty()) {
        all = all / product_in_order(factors.below);
    }
    if (!next_to_fraction.empty()) {
        all = all * product_in_order(next_to_fraction);
    }
    return factors.negative ? -all : all;
}

Expr with_fraction_exponent(const Expr& e) {
    const Rational* power = e.arg(1).rational();
    if (power == nullptr || denominator(*power) == 1) {
        return e;
    }
    const Rational size = abs(*power);
    const Expr fraction =
        Expr::number(Rational(numerator(size))) / Expr::number(Rational(denominator(size)));
    return pow(e.arg(0), *power < 0 ? -fraction : fraction);
}

/// Moves a factor that an edit placed next to a fraction into it; the rest keeps its order.
Expr tidied_edit(const Expr& e) {
    const bool product = e.kind() == Kind::mul;
    if (product && e.arg(1).kind() == Kind::div && in_fraction(e.arg(0)) &&
        e.arg(0).kind() != Kind::div && e.arg(0).kind() != Kind::number) {
        const Expr& fraction = e.arg(1);
        const bool one = fraction.arg(0).kind() == Kind::number && fraction.arg(0).number() == 1;
        return (one ? e.arg(0) : fraction.arg(0) * e.arg(0)) / fraction.arg(1);
    }
    if (e.kind() == Kind::div && e.arg(0).kind() == Kind::mul &&
        e.arg(0).arg(0).kind() == Kind::div) { // A/B*S/n
        const Expr& fraction = e.arg(0).arg(0);
        return fraction.arg(0) / product_in_order({e.arg(1), fraction.arg(1)}) * e.arg(0).arg(1);
    }
    if (e.kind() == Kind::div && e.arg(0).kind() == Kind::div) {
        return e.arg(0).arg(0) / product_in_order({e.arg(0).arg(1), e.arg(1)});
    }
    return e;
}

Expr rebuilt(const Expr& e, Expr (*product)(const Expr&)) {
    std::vector<Expr> parts;
    for (const Expr& part : e.args()) {
        parts.push_back(rebuilt(part, product));
    }
    const Expr same = parts.empty() ? e : Expr::with_args(e, std::move(parts));
    return same.kind() == Kind::pow                               ? with_fraction_exponent(same)
           : same.kind() == Kind::mul || same.kind() == Kind::div ? product(same)
                                                                  : same;
}

} // namespace

Expr arranged(const Expr& e) { return rebuilt(e, tidied_edit); }

Expr gathered(const Expr& e) { return rebuilt(e, arranged_product); }

std::string formula_tex(const Expr& e, const audit::PrintedSource& source,
                        std::string_view family) {
    return to_tex(e, [&](std::string_view name) { return source.notation_of(name, family); });
}

std::optional<Expr> formula_of(std::string_view text, const audit::Claim& claim) {
    try {
        return parse_formula(text, claim.vocabulary);
    } catch (const Error&) {
        return std::nullopt;
    }
}

} // namespace edgeproof::report
