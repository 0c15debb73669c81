// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/checks/parts/parameter_sweep.hpp"
#include "edgeproof/audit/checks/tail/sweep_target.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::audit {

/// A claimed limit of a quantity along a sweep; without `limit`, the claim is growth without bound.
struct LimitClaimed {
    formula::Expr of;
    std::optional<formula::Expr> limit;
    [[nodiscard]] bool is_infinite() const { return !limit.has_value(); }
    /// Returns the distance from the limit; the quantity itself if the limit is infinity.
    [[nodiscard]] formula::Expr difference() const { return limit ? of - *limit : of; }
};

/// One sample of a claim about a limit, in balls, followed from the last listed value to values
/// 10^1024 times as near to the end of the sweep, or as far as there are enclosures.
class FollowedTail {
public:
    FollowedTail(const ParameterSweep& sweep, std::size_t sample, SweepTarget target,
                 LimitClaimed claimed, unsigned digits);

    [[nodiscard]] const SweepTarget& target() const { return target_; }
    /// The decision from the values that were computed. It does not prove anything beyond them;
    /// hidden_terms.hpp gives the conditions under which it stays undecided.
    [[nodiscard]] const Decision& decision() const { return decision_; }
    /// The reason why nothing is decided.
    [[nodiscard]] const std::string& problem() const { return problem_; }
    /// The number of decades from the last listed value.
    [[nodiscard]] unsigned decades() const;
    /// Two numbers that certainly differ, and show the trend.
    struct Compared {
        std::string first_name;
        Ball first;
        std::string second_name;
        Ball second;
    };
    [[nodiscard]] const std::optional<Compared>& compared() const { return compared_; }
    /// Returns texts such as "10^512 times as near", each with the quantity at that value.
    [[nodiscard]] std::vector<std::string> texts() const;

private:
    struct Point {
        unsigned decades = 0;
        Ball value;
        Ball difference; ///< value - limit, or value if the limit is infinity
        Ball gap;        ///< |difference|
    };
    void find_scales();
    void follow();
    [[nodiscard]] Sample sample_at(unsigned decades, std::size_t which) const;
    [[nodiscard]] bool add(unsigned decades, std::size_t which);
    void judge();
    void judge_finite();
    void judge_infinite();
    void compare(const std::string& first_name, const std::optional<Ball>& first,
                 const std::string& second_name, const std::vector<Ball>& sequence);
    [[nodiscard]] bool sums_settle() const;
    [[nodiscard]] std::vector<Ball> gaps() const;
    [[nodiscard]] std::vector<Ball> steps() const;
    [[nodiscard]] bool dies_away(const std::vector<Ball>& d, const Ball& reference) const;
    [[nodiscard]] bool grows(const std::vector<Ball>& d, const Ball& reference) const;
    [[nodiscard]] bool is_short() const { return !ended_by_.empty(); }
    [[nodiscard]] Ball tolerance() const;
    [[nodiscard]] bool is_costly() const;
    [[nodiscard]] unsigned digits_at(unsigned decades) const;

    const ParameterSweep& sweep_;
    std::size_t sample_;
    SweepTarget target_;
    LimitClaimed claimed_;
    unsigned digits_;
    double hidden_ = 0;         ///< decades that the formulas may hide
    double scene_decades_ = 0;  ///< from the scene's parameters
    std::optional<Ball> scale_; ///< of the gap
    std::vector<Point> points_; ///< from the last listed value on
    std::string ended_by_;      ///< why there is no further enclosure
    Decision decision_;
    std::string problem_;
    std::optional<Compared> compared_;
};

/// False for numbers beyond 10^100000, or as near to zero; they have no decimals here.
[[nodiscard]] bool can_be_printed(const Ball& x);

} // namespace edgeproof::audit
