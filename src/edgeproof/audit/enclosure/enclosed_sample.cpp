// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"

#include "edgeproof/audit/enclosure/sample_state.hpp"
#include "edgeproof/precision/rounding/escalate.hpp"
#include "edgeproof/precision/rounding/text.hpp"

namespace edgeproof::audit {

EnclosedSample::EnclosedSample(const Sample& sample, long bits, unsigned integral_digits)
    : state_(std::make_unique<State>(sample, bits, integral_digits)) {}
EnclosedSample::~EnclosedSample() = default;
EnclosedSample::EnclosedSample(EnclosedSample&&) noexcept = default;

Ball EnclosedSample::evaluate(const Expr& e) const { return formula::evaluate<Ball>(e, *state_); }

Ball EnclosedSample::finite(const Expr& e) const {
    Ball value = evaluate(e);
    if (!value.is_finite()) {
        throw BudgetError("the balls do not exclude a point where it is undefined");
    }
    return value;
}

bool EnclosedSample::diverges(const Expr& integral) const {
    bool found = false;
    try {
        state_->integral(
            integral, [&](std::string_view name) { return state_->symbol(name); },
            [&](const Expr& e, const IntegralSurroundings& around) {
                found = certainly_divergent(e, around);
            });
    } catch (const Error&) {
        return false; // no enclosure of the integrand
    }
    return found;
}

void EnclosedSample::set(const std::string& name, const Ball& value) {
    state_->names.insert_or_assign(name, value);
    state_->overridden.insert(name);
    state_->fields_.reset();
    state_->integrals_.clear();
}

void EnclosedSample::set_place(Edge edge, const Ball& u) {
    state_->sample.edge = edge;
    state_->u = u;
    state_->integrals_.clear();
}

Ball EnclosedSample::length() const { return state_->length(); }
long EnclosedSample::bits() const { return state_->bits; }

std::optional<Exact> exact_value(Expr e, const Sample& sample) {
    for (const auto& [name, value] : sample.variables) {
        e = substitute(e, name, value.expr());
    }
    for (const auto& [name, value] : sample.scene.parameters) {
        e = substitute(e, name, value.expr());
    }
    if (!free_symbols(e).empty() || holds_function(e)) {
        return std::nullopt;
    }
    return Exact(e);
}

Enclosed enclosed(const Expr& e, const Sample& sample, unsigned digits) {
    Enclosed best;
    const long needed = formula::bits_for(digits);
    best.problem = look_closer(
        [&](long bits) {
            best.ball = EnclosedSample(sample, bits).finite(e);
            return best.ball->relative_accuracy_bits() >= needed;
        },
        {2 * needed, 16 * needed});
    return best;
}

std::string ball_text(const Ball& ball, unsigned digits) {
    // These exponents are not allowed for numbers in a text.
    constexpr long most_exponent = 330'000; // of two: about 1e100000
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
    const Ball off = abs(ball - Ball(middle.value.value(), ball.bits()));
    return middle.text + " +- " + bound_text(off.upper());
}

} // namespace edgeproof::audit
