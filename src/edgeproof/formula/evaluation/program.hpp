// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/expr.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgeproof::formula {

/// An expression compiled once for evaluation at many points. Its inputs are symbols, and possibly
/// other parts that contain one of these symbols. Equal parts are computed once; parts without
/// these symbols are constants, computed once for each precision; sums with constant bounds are
/// expanded. Immutable and thread-safe.
class Program {
public:
    /// One step. It writes the slot `inputs + constants + own index`, and reads the slots listed
    /// at `first ... first + count - 1` of the operand list. A power with a rational exponent also
    /// reads the number 1.
    struct Step {
        Expr::Kind kind;
        std::size_t first;
        std::size_t count;
        Expr source;
    };
    /// Returns another expression with the same value for a part that contains a symbol of the
    /// inputs; nothing for a part that is computed as it is.
    using WrittenOut = std::function<std::optional<Expr>(const Expr& part)>;

    Program() = default;
    Program(const Expr& e, const std::vector<std::string>& symbols);
    /// With `written_out`, the product of a number 0 and any other factor is this number 0, and so
    /// is a quotient of 0 and a part that is not this number.
    Program(const Expr& e, std::vector<Expr> inputs, const WrittenOut& written_out);

    [[nodiscard]] const std::vector<Expr>& inputs() const { return inputs_; }
    /// The parts without a symbol of the inputs, whose values `run` needs.
    [[nodiscard]] const std::vector<Expr>& constants() const { return constants_; }
    [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
    [[nodiscard]] const std::vector<std::size_t>& operands() const { return operands_; }
    /// The slot of the result.
    [[nodiscard]] std::size_t result() const { return result_; }

private:
    friend class ProgramBuilder;
    std::vector<Expr> inputs_;
    std::vector<Expr> constants_;
    std::vector<Step> steps_;
    std::vector<std::size_t> operands_;
    std::size_t result_ = 0;
};

/// The constants of a program in T, at the precision of `env`. Throws Error for a symbol that
/// neither the inputs nor `env` have.
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

/// Returns the value of a program; throws like `evaluate`. Functions must be built in.
/// @param program the program
/// @param inputs values in the order of program.inputs()
/// @param constants result of `constants_of`
template <class T>
[[nodiscard]] T run(const Program& program, std::span<const T> inputs,
                    const std::vector<T>& constants) {
    const std::size_t input_count = program.inputs().size();
    const std::size_t given_count = input_count + program.constants().size();
    if (inputs.size() != input_count || constants.size() != program.constants().size()) {
        throw Error("a program is run with a wrong number of symbols or constants");
    }
    std::vector<T> results;
    results.reserve(program.steps().size());
    const auto slot = [&](std::size_t i) -> const T& {
        return i < input_count   ? inputs[i]
               : i < given_count ? constants[i - input_count]
                                 : results[i - given_count];
    };
    for (const Program::Step& step : program.steps()) {
        const auto operand = [&, in = program.operands().data() + step.first](
                                 std::size_t i) -> const T& { return slot(in[i]); };
        // The requirements of a power with a rational exponent: the exponent, and the number 1.
        struct PowerConstants {
            const decltype(operand)& read;
            [[nodiscard]] T number(const Rational& q) const { return q == 1 ? read(2) : read(1); }
        };
        results.push_back(
            detail::value_of<T>(step.kind, step.source, operand, PowerConstants{operand}));
    }
    return slot(program.result());
}

} // namespace edgeproof::formula
