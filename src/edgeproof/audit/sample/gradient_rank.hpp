// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/symbolic/symbolic.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::audit {

/// Whether a quantity is a function of others near some point, all names being free: whether its
/// gradient lies in the span of theirs. Derivatives are by symbols. The rank at a point is bounded
/// from below by minors in balls, and around it from above by minors that vanish by symbols.
class GradientRank {
public:
    /// Of formulas that are derived (symbolic.hpp).
    GradientRank(const formula::Expr& of, const std::vector<formula::Expr>& others,
                 const SymbolicCase& under);

    /// All free names.
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    /// The quantity is no function of the others: what is certainly left of its gradient at a point
    /// when the others are eliminated, certainly positive.
    [[nodiscard]] const std::optional<Ball>& outside() const { return outside_; }
    /// The quantity is a function of the others near the point: the rank with it and without it.
    [[nodiscard]] const std::optional<std::size_t>& rank() const { return rank_; }
    /// The point, for a reader.
    [[nodiscard]] const std::string& at() const { return at_; }
    /// Why neither is proved.
    [[nodiscard]] const std::string& problem() const { return problem_; }

private:
    using Row = std::vector<formula::Expr>;
    /// The gradients at a drawn point, eliminated from each other as far as certain pivots go.
    struct Eliminated {
        std::vector<std::size_t> rows;    ///< of the pivots
        std::vector<std::size_t> columns; ///< of the pivots
        std::vector<Ball> left;           ///< of the quantity's gradient
        std::string at;
    };
    [[nodiscard]] Row gradient(const formula::Expr& e) const;
    void drop_equal_columns();
    [[nodiscard]] std::optional<Eliminated> eliminate(std::size_t draw) const;
    /// Whether the row adds nothing to the rank of the pivots' rows, wherever their minor is not 0.
    [[nodiscard]] bool adds_nothing(const Row& row, const Eliminated& pivots) const;
    [[nodiscard]] bool others_add_nothing(const Eliminated& pivots) const;
    [[nodiscard]] bool by_own_name(const Eliminated& pivots);
    void decide(const Eliminated& pivots);

    const SymbolicCase& under_;
    std::vector<std::string> names_;
    std::vector<std::string> columns_; ///< by which derivatives are taken
    std::vector<Row> others_;
    Row of_;
    std::optional<Ball> outside_;
    std::optional<std::size_t> rank_;
    std::string at_;
    std::string problem_;
};

} // namespace edgeproof::audit
