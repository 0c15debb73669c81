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

/// Decides if a quantity is a function of others near some point, for free names: it is one if its
/// gradient lies in the span of their gradients. Derivatives are taken by symbols. At a point, the
/// rank is bounded from below by minors in balls; near it, the rank is bounded from above by minors
/// that vanish by symbols.
class GradientRank {
public:
    /// The formulas must be derived (symbolic.hpp).
    GradientRank(const formula::Expr& of, const std::vector<formula::Expr>& others,
                 const SymbolicCase& under);

    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    /// If the quantity is not a function of the others: a component of its gradient at a point
    /// after elimination of the others, certainly positive.
    [[nodiscard]] const std::optional<Ball>& outside() const { return outside_; }
    /// If it is a function of the others near the point: the rank, with it and without it.
    [[nodiscard]] const std::optional<std::size_t>& rank() const { return rank_; }
    /// The point, as text.
    [[nodiscard]] const std::string& at() const { return at_; }
    /// The reason why neither is proved.
    [[nodiscard]] const std::string& problem() const { return problem_; }

private:
    using Row = std::vector<formula::Expr>;
    /// The gradients at a drawn point after elimination as far as pivots are certainly not zero.
    struct Eliminated {
        std::vector<std::size_t> rows;    ///< of the pivots
        std::vector<std::size_t> columns; ///< of the pivots
        std::vector<Ball> left;           ///< the rest of the quantity's gradient
        std::string at;
    };
    [[nodiscard]] Row gradient(const formula::Expr& e) const;
    void drop_equal_columns();
    [[nodiscard]] std::optional<Eliminated> eliminate(std::size_t draw) const;
    /// True if the row does not increase the rank of the pivots' rows where their minor is not 0.
    [[nodiscard]] bool adds_nothing(const Row& row, const Eliminated& pivots) const;
    [[nodiscard]] bool others_add_nothing(const Eliminated& pivots) const;
    [[nodiscard]] bool by_own_name(const Eliminated& pivots);
    void decide(const Eliminated& pivots);

    const SymbolicCase& under_;
    std::vector<std::string> names_;
    std::vector<std::string> columns_; ///< the names by which derivatives are taken
    std::vector<Row> others_;
    Row of_;
    std::optional<Ball> outside_;
    std::optional<std::size_t> rank_;
    std::string at_;
    std::string problem_;
};

} // namespace edgeproof::audit
