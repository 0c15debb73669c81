// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/integrand.hpp"

namespace edgeproof::audit {

/// One operation of an integrand that is evaluated on many boxes; its operands come before it.
struct IntegrandStep {
    enum class Op {
        constant,
        variable,
        neg,
        add,
        sub,
        mul,
        div,
        power, ///< to a rational number, or to a ball
        sqrt,
        log,
        log_above,
        exp,
        sin,
        cos,
        asin,
        acos,
        atan,
        gauss,
        left_edge,  ///< b(s) of the path
        force_rate, ///< P'(s)
    };
    Op op;
    formula::Expr written;
    std::vector<std::size_t> args;
    std::optional<Rational> exponent; ///< of a power, if it is rational
};

/// The steps of a formula, whose value is that of last(). Equal parts are one step.
class IntegrandSteps {
public:
    IntegrandSteps(const formula::Expr& f, const std::string& variable,
                   const IntegrandMeaning& meaning);
    [[nodiscard]] const std::vector<IntegrandStep>& all() const { return steps_; }
    [[nodiscard]] std::size_t last() const { return last_; }
    [[nodiscard]] bool vanish() const { return is_zero(last_); }

private:
    std::size_t add(const formula::Expr& e);
    std::size_t add_call(const formula::Expr& e);
    std::size_t step(IntegrandStep::Op op, const formula::Expr& e, std::vector<std::size_t> args,
                     std::optional<Rational> exponent = std::nullopt);
    [[nodiscard]] bool is_zero(std::size_t i) const;
    [[nodiscard]] bool holds_variable(const formula::Expr& e) const;
    const std::string& variable_;
    const IntegrandMeaning& meaning_;
    std::vector<IntegrandStep> steps_;
    std::unordered_map<formula::Expr, std::size_t, formula::ExprHash> known_;
    std::size_t last_;
};

} // namespace edgeproof::audit
