// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/enclosure/integrand_parts.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

constexpr long most_exponent = 330'000; // of two: about 1e100000

} // namespace

std::optional<formula::Exact> exact_value(formula::Expr e, const Sample& sample) {
    for (const auto& [name, value] : sample.variables) {
        e = substitute(e, name, value.expr());
    }
    for (const auto& [name, value] : sample.scene.parameters) {
        e = substitute(e, name, value.expr());
    }
    if (!free_symbols(e).empty() || holds_function(e)) {
        return std::nullopt;
    }
    return formula::Exact(e);
}

Enclosed enclosed(const formula::Expr& e, const Sample& sample, unsigned digits) {
    Enclosed best;
    const long needed = formula::bits_for(digits);
    for (long bits = 2 * needed; bits <= 16 * needed; bits *= 2) {
        try {
            const Ball ball = EnclosedSample(sample, bits).evaluate(e);
            if (!ball.is_finite()) {
                best.problem = "the balls do not exclude a point where it is undefined";
                continue;
            }
            best.ball = ball;
            if (ball.relative_accuracy_bits() >= needed) {
                break;
            }
        } catch (const BudgetError& error) {
            best.problem = error.what();
        } catch (const Error& error) {
            best.problem = error.what();
            break;
        }
    }
    return best;
}

std::string ball_text(const Ball& ball, unsigned digits) {
    // These exponents are not allowed for numbers in a text.
    const long exponent = arf_abs_bound_lt_2exp_si(arb_midref(ball.data()));
    if (exponent > most_exponent || (exponent < -most_exponent && !contains_zero(ball))) {
        return exponent > 0 ? "beyond 1e100000" : "within 1e-100000 of 0";
    }
    if (!ball.is_exact() && contains_zero(ball)) {
        return "0 +- " + bound_text(abs(ball).upper());
    }
    // Only two digits that the radius makes uncertain are shown.
    const long known =
        std::min(ball.relative_accuracy_bits(), formula::bits_for(digits)) * 301 / 1000 + 2;
    const Rounded middle =
        round_ball(Ball(ball.midpoint(), ball.bits()),
                   static_cast<unsigned>(std::clamp(known, 1L, static_cast<long>(digits))));
    // The rounding of the middle for the text is part of the error.
    const Ball off = abs(ball - Ball(middle.lower.value(), ball.bits()));
    return middle.text + " +- " + bound_text(off.upper());
}

} // namespace edgeproof::audit
