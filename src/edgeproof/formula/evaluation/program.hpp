// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/expr.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace edgeproof::formula {

/// An expression compiled once for a fixed order of its symbols, for evaluation at many points.
/// Equal parts are computed once; parts without symbols are constants, computed once for each
/// precision; sums with constant bounds are expanded. Immutable and thread-safe.
class Program {
public:
    enum class Op { neg, add, sub, mul, div, pow, call, extern_call, binder };

    /// One step. It writes the slot `symbols + constants + own index`, and reads the slots listed
    /// at `first ... first + count - 1` of the operand list. A power with a rational exponent also
    /// reads the number 1.
    struct Step {
        Op op;
        std::size_t first;
        std::size_t count;
        Expr source;
    };

    Program() = default;
    /// Throws Error if e has a free symbol that is not among `symbols`.
    Program(const Expr& e, std::vector<std::string> symbols);

    [[nodiscard]] const std::vector<std::string>& symbols() const { return symbols_; }
    /// The expressions without symbols, whose values `run` needs.
    [[nodiscard]] const std::vector<Expr>& constants() const { return constants_; }
    [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
    [[nodiscard]] const std::vector<std::size_t>& operands() const { return operands_; }
    /// The slot of the result.
    [[nodiscard]] std::size_t result() const { return result_; }

private:
    friend class ProgramBuilder;
    std::vector<std::string> symbols_;
    std::vector<Expr> constants_;
    std::vector<Step> steps_;
    std::vector<std::size_t> operands_;
    std::size_t result_ = 0;
};

/// The constants of a program in T, at the precision of `env`.
template <class T, class Env>
[[nodiscard]] std::vector<T> constants_of(const Program& program, const Env& env) {
    std::vector<T> values;
    values.reserve(program.constants().size());
    for (const Expr& e : program.constants()) {
        values.push_back(evaluate<T>(e, env));
    }
    return values;
}
template <Arithmetic T> [[nodiscard]] std::vector<T> constants_of(const Program& program) {
    return constants_of<T>(program, Values<T>{});
}

/// The requirements of `run` for functions that are not built in and for integrals, if there are
/// any:
///   T call(const Expr& node, std::span<const T> args) const
///   T binder(const Expr& node, std::span<const T> symbols) const    symbols in the program's order
struct NoExternals {};

/// Returns the value of a program; throws like `evaluate`.
/// @param program the program
/// @param symbols values in the order of program.symbols()
/// @param constants result of `constants_of`
/// @param externals functions that are not built in, and integrals
template <class T, class Externals = NoExternals>
[[nodiscard]] T run(const Program& program, std::span<const T> symbols,
                    const std::vector<T>& constants, const Externals& externals = {}) {
    const std::size_t symbol_count = program.symbols().size();
    const std::size_t input_count = symbol_count + program.constants().size();
    if (symbols.size() != symbol_count || constants.size() != program.constants().size()) {
        throw Error("a program is run with a wrong number of symbols or constants");
    }
    std::vector<T> results;
    results.reserve(program.steps().size());
    const auto slot = [&](std::size_t i) -> const T& {
        return i < symbol_count  ? symbols[i]
               : i < input_count ? constants[i - symbol_count]
                                 : results[i - input_count];
    };
    // The requirements of a power with a rational exponent: the exponent, and the number 1.
    struct PowerConstants {
        const T& exponent;
        const T& one;
        [[nodiscard]] T number(const Rational& q) const { return q == 1 ? one : exponent; }
    };
    std::vector<T> args;
    for (const Program::Step& step : program.steps()) {
        const std::size_t* in = program.operands().data() + step.first;
        switch (step.op) {
        case Program::Op::neg:
            results.push_back(T(-slot(in[0])));
            continue;
        case Program::Op::add:
            results.push_back(T(slot(in[0]) + slot(in[1])));
            continue;
        case Program::Op::sub:
            results.push_back(T(slot(in[0]) - slot(in[1])));
            continue;
        case Program::Op::mul:
            results.push_back(T(slot(in[0]) * slot(in[1])));
            continue;
        case Program::Op::div:
            results.push_back(detail::in_part(
                step.source, [&] { return detail::quotient<T>(slot(in[0]), slot(in[1])); }));
            continue;
        case Program::Op::pow:
            results.push_back(detail::in_part(step.source, [&] {
                const Rational* q = step.source.arg(1).rational();
                return q != nullptr ? detail::power<T>(slot(in[0]), *q,
                                                       PowerConstants{slot(in[1]), slot(in[2])})
                                    : detail::power<T>(slot(in[0]), slot(in[1]));
            }));
            continue;
        case Program::Op::binder:
            if constexpr (requires { T(externals.binder(step.source, symbols)); }) {
                results.push_back(T(externals.binder(step.source, symbols)));
                continue;
            } else {
                throw Error("'" + step.source.name() + "' has no meaning here");
            }
        case Program::Op::call:
        case Program::Op::extern_call:
            break;
        }
        args.clear();
        for (std::size_t i = 0; i < step.count; ++i) {
            args.push_back(slot(in[i]));
        }
        const std::span<const T> view(args);
        if (step.op == Program::Op::call) {
            results.push_back(detail::in_part(
                step.source, [&] { return detail::call_builtin<T>(step.source.builtin(), view); }));
        } else if constexpr (requires { T(externals.call(step.source, view)); }) {
            results.push_back(T(externals.call(step.source, view)));
        } else {
            throw Error("the function '" + step.source.name() + "' has no meaning here");
        }
    }
    return slot(program.result());
}

} // namespace edgeproof::formula
