// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/checks/tail/parameter_sweep.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::audit {

/// A claimed limit of a quantity along a sweep; without `limit`, the claim is growth without bound.
struct LimitClaimed {
    Expr of;
    std::optional<Expr> limit;
    /// Returns the distance from the limit; the quantity itself if the limit is infinity.
    [[nodiscard]] Expr difference() const { return limit ? of - *limit : of; }
};

/// One sample of a claim about a limit, in balls, followed from the last listed value to values
/// 10^1024 times as near to the end of the sweep, or as far as there are enclosures.
struct FollowedTail {
    /// The decision from the values that were computed. It does not prove anything beyond them;
    /// parameter_sweep.hpp gives the conditions under which it stays undecided.
    Decision decision;
    std::string problem;               ///< the reason why nothing is decided
    std::optional<std::string> target; ///< of the sweep: "0", "infinity", "3/7", ...
    unsigned decades = 0;              ///< from the last listed value
    std::vector<std::string> texts;    ///< "about 10^512 times as near ...", each with the quantity
    std::optional<Evidence> compared;  ///< two numbers that certainly differ, and show the trend
};
[[nodiscard]] FollowedTail follow_tail(const ParameterSweep& sweep, std::size_t sample,
                                       const LimitClaimed& claimed, unsigned digits);

/// An expansion in a small variable, and the limit of another variable.
struct ExpansionToFollow {
    Expr of;
    Expr approximation;
    std::string small;
    unsigned order = 0; ///< the next power of the small variable
    std::string variable;
    Exact towards;
    /// Returns (of - approximation)/small^order.
    [[nodiscard]] Expr rest() const;
};

/// Returns the sample with the variable at about (or `exactly`) 10^-decades from its limit.
[[nodiscard]] Sample at_distance(const Sample& sample, const ExpansionToFollow& expansion,
                                 unsigned decades, bool exactly = false);

/// The remainder of an expansion divided by the next power, as the variable tends to its limit.
struct FollowedRest {
    enum class Course {
        unknown,
        nothing,     ///< the balls do not distinguish the remainder from zero
        bounded,     ///< it has a limit for each size, and its maximum has one for small sizes
        grows,       ///< without bound as the variable tends to its limit, or as the size decreases
        wrong_order, ///< it grows as the size decreases, also far from the limit
    };
    Sample sample;
    Course course = Course::unknown;
    std::string problem; ///< the reason why the course is not known; no numbers follow then
    /// |rest| at the last two distances, for the first size; for the course `wrong_order`, far from
    /// the limit for the first size and the smallest.
    Ball before_last;
    Ball last;
    Ball largest;              ///< |rest| for the first size
    std::string last_distance; ///< "10^-64"
};
/// Follows the remainder in balls, for three sizes of the small variable, down to distances below
/// the square of the small variable and beyond what the formula may hide (parameter_sweep.hpp).
[[nodiscard]] FollowedRest follow_rest(const Sample& sample, const ExpansionToFollow& expansion,
                                       unsigned digits);

/// True if a formula certainly grows by at least one half each time the number of decades of the
/// distance doubles, as the variable tends to its limit.
[[nodiscard]] bool certainly_grows(const Expr& e, const Sample& sample,
                                   const ExpansionToFollow& expansion, unsigned digits);

} // namespace edgeproof::audit
