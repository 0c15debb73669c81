// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosure/integrand_program.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

using Kind = formula::Expr::Kind;

using Step = IntegrandStep;

[[noreturn]] void refuse(const formula::Expr& e) {
    throw Error("'" + e.name() + "' has no enclosure inside an integral");
}

std::optional<Step::Op> operation_of(formula::Builtin f) {
    switch (f) {
    case formula::Builtin::sqrt:
        return Step::Op::sqrt;
    case formula::Builtin::log:
        return Step::Op::log;
    case formula::Builtin::exp:
        return Step::Op::exp;
    case formula::Builtin::sin:
        return Step::Op::sin;
    case formula::Builtin::cos:
        return Step::Op::cos;
    case formula::Builtin::asin:
        return Step::Op::asin;
    case formula::Builtin::acos:
        return Step::Op::acos;
    case formula::Builtin::atan:
        return Step::Op::atan;
    default:
        return std::nullopt;
    }
}

} // namespace

IntegrandSteps::IntegrandSteps(const formula::Expr& f, const std::string& variable,
                               const IntegrandMeaning& meaning)
    : variable_(variable), meaning_(meaning), last_(add(f)) {}

bool IntegrandSteps::holds_variable(const formula::Expr& e) const {
    if (e.kind() == formula::Expr::Kind::symbol) {
        return e.name() == variable_;
    }
    if (e.is_binder()) {
        return free_symbols(e).contains(variable_);
    }
    return std::any_of(e.args().begin(), e.args().end(),
                       [&](const formula::Expr& part) { return holds_variable(part); });
}

std::size_t IntegrandSteps::step(Step::Op op, const formula::Expr& e, std::vector<std::size_t> args,
                                 std::optional<Rational> exponent) {
    steps_.push_back({op, e, std::move(args), std::move(exponent)});
    return steps_.size() - 1;
}

bool IntegrandSteps::is_zero(std::size_t i) const {
    const Rational* q = steps_[i].written.rational();
    return steps_[i].op == Step::Op::constant && q != nullptr && *q == 0;
}

std::size_t IntegrandSteps::add(const formula::Expr& e) {
    if (const auto it = known_.find(e); it != known_.end()) {
        return it->second;
    }
    std::size_t index = 0;
    const auto binary = [&](Step::Op op) {
        const std::size_t x = add(e.arg(0));
        const std::size_t y = add(e.arg(1));
        // The zero slope of a flat removes the other factor, including its singularities.
        const bool times = op == Step::Op::mul;
        if (is_zero(x) && (times || (op == Step::Op::div && !is_zero(y)))) {
            return x;
        }
        return times && is_zero(y) ? y : step(op, e, {x, y});
    };
    if (!holds_variable(e)) {
        index = step(Step::Op::constant, e, {});
    } else {
        switch (e.kind()) {
        case Kind::symbol:
            index = step(Step::Op::variable, e, {});
            break;
        case Kind::neg:
            index = add(e.arg(0));
            index = is_zero(index) ? index : step(Step::Op::neg, e, {index});
            break;
        case Kind::add:
            index = binary(Step::Op::add);
            break;
        case Kind::sub:
            index = binary(Step::Op::sub);
            break;
        case Kind::mul:
            index = binary(Step::Op::mul);
            break;
        case Kind::div:
            index = binary(Step::Op::div);
            break;
        case Kind::pow: {
            if (holds_variable(e.arg(1))) {
                throw Error("a power to the variable has no enclosure inside an integral");
            }
            const std::size_t base = add(e.arg(0));
            const std::size_t exponent = add(e.arg(1));
            index = step(Step::Op::power, e, {base, exponent}, meaning_.rational(e.arg(1)));
            break;
        }
        case Kind::call:
            index = add_call(e);
            break;
        default:
            refuse(e);
        }
    }
    known_.emplace(e, index);
    return index;
}

std::size_t IntegrandSteps::add_call(const formula::Expr& e) {
    if (const auto op = operation_of(e.builtin())) {
        return step(*op, e, {add(e.arg(0))});
    }
    if (e.name() == "log_above") {
        return step(Step::Op::log_above, e, {add(e.arg(0))});
    }
    if (e.name() == "gauss") {
        std::vector<std::size_t> args;
        for (const formula::Expr& part : e.args()) {
            args.push_back(add(part));
        }
        return step(Step::Op::gauss, e, std::move(args));
    }
    const bool edge = e.name() == "bof";
    if (meaning_.path != nullptr && (edge || e.name() == "P1of")) {
        if (!(e.arg(0) == *meaning_.path_argument)) {
            refuse(e); // two contacts of the family in one integrand
        }
        add(formula::Expr::symbol(variable_));
        return step(edge ? Step::Op::left_edge : Step::Op::force_rate, e, {});
    }
    return add(meaning_.written_out(e));
}

} // namespace edgeproof::audit
