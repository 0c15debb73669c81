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
/// these symbols are constants; sums with constant bounds are expanded. Immutable and thread-safe.
class Program {
public:
    struct Part {
        enum class Role { input, constant, operation } role;
        Expr::Kind kind; ///< of the operation
        Expr source;
        std::vector<std::size_t> operands; ///< of an operation: places of previous parts
        [[nodiscard]] bool is_operation() const { return role == Role::operation; }
    };
    /// Returns another expression with the same value for a part that contains a symbol of the
    /// inputs; nothing for a part that is computed as it is.
    using WrittenOut = std::function<std::optional<Expr>(const Expr& part)>;

    /// The product of a number 0 and any other factor is this number 0, and so is a quotient of 0
    /// and a part that is not this number.
    Program(const Expr& e, const std::vector<Expr>& inputs, const WrittenOut& written_out);

    /// The inputs, and then each part after its operands.
    [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }
    /// The place of the result.
    [[nodiscard]] std::size_t result() const { return result_; }

private:
    std::vector<Part> parts_;
    std::size_t result_ = 0;
};

} // namespace edgeproof::formula
