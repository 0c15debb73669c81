// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace edgeproof::formula {

/// An expression compiled once for evaluation at many points. Its inputs are symbols, and possibly
/// other parts that contain one of these symbols. Equal parts are computed once; parts without
/// these symbols are constants; sums with constant bounds are
/// expanded. Immutable and thread-safe.
class Program {
public:
    /// One step. It writes the slot `inputs + constants + own index`, and reads the slots listed
    /// at `first ... first + count - 1` of the operand list.
    struct Step {
        Expr::Kind kind;
        std::size_t first;
        std::size_t count;
        Expr source;
    };
    /// Returns another expression with the same value for a part that contains a symbol of the
    /// inputs; nothing for a part that is computed as it is.
    using WrittenOut = std::function<std::optional<Expr>(const Expr& part)>;

    /// The product of a number 0 and any other factor is this number 0, and so is a quotient of 0
    /// and a part that is not this number.
    Program(const Expr& e, std::vector<Expr> inputs, const WrittenOut& written_out);

    [[nodiscard]] const std::vector<Expr>& inputs() const { return inputs_; }
    /// The parts without a symbol of the inputs.
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

} // namespace edgeproof::formula
