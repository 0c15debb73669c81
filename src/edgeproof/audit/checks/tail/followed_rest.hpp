// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <optional>
#include <string>
#include <vector>

namespace edgeproof::audit {

/// An expansion in a small variable, and the limit of another variable.
struct ExpansionToFollow {
    formula::Expr of;
    formula::Expr approximation;
    std::string small;
    unsigned order = 0; ///< the next power of the small variable
    std::string variable;
    formula::Exact towards;
    /// Returns (of - approximation)/small^order.
    [[nodiscard]] formula::Expr rest() const;
};

/// Returns the sample with the variable at about (or `exactly`) 10^-decades from its limit.
[[nodiscard]] Sample at_distance(const Sample& sample, const ExpansionToFollow& expansion,
                                 unsigned decades, bool exactly = false);

/// The remainder of an expansion divided by the next power, as the variable tends to its limit: in
/// balls, for three sizes of the small variable, down to distances below the square of the small
/// variable and beyond what the formula may hide (hidden_terms.hpp).
class FollowedRest {
public:
    FollowedRest(const Sample& sample, const ExpansionToFollow& expansion, unsigned digits);

    enum class Course {
        unknown,
        nothing,     ///< the balls do not distinguish the remainder from zero
        bounded,     ///< it has a limit for each size, and its maximum has one for small sizes
        grows,       ///< without bound as the variable tends to its limit, or as the size decreases
        wrong_order, ///< it grows as the size decreases, also far from the limit
    };
    [[nodiscard]] Course course() const { return course_; }
    /// The reason why the course is not known.
    [[nodiscard]] const std::string& problem() const { return problem_; }
    /// |rest| at the last two distances, for the first size; for the course `wrong_order`, far from
    /// the limit for the first size and the smallest.
    [[nodiscard]] const Ball& before_last() const;
    [[nodiscard]] const Ball& last() const;
    /// The largest |rest| for the first size.
    [[nodiscard]] Ball largest() const;
    /// Returns the last distance as text: "10^-64".
    [[nodiscard]] std::string last_distance() const;

private:
    struct Station {
        unsigned decades;
        Ball rest; ///< |rest|
        bool nothing;
    };
    /// The remainder for one size of the small variable.
    struct Run {
        Sample sample;
        std::optional<Ball> far; ///< |rest| at the variable's own value
        std::vector<Station> stations;
        double hidden = 0; ///< decades that the formula may hide
    };
    [[nodiscard]] static Ball largest_of(const Run& run);
    [[nodiscard]] bool add_run(const Sample& sample);
    [[nodiscard]] std::optional<Station> station(const Sample& at, unsigned decades, double small);
    [[nodiscard]] Course judge();
    [[nodiscard]] bool sums_settle(const Run& run) const;
    [[nodiscard]] static bool is_bounded(const Run& run);
    [[nodiscard]] static bool is_growing(const Run& run);

    const ExpansionToFollow& expansion_;
    formula::Expr rest_;
    formula::Expr simplified_; ///< the same expression with cancelling terms removed
    unsigned digits_;
    std::vector<Run> runs_;
    Course course_ = Course::unknown;
    std::string problem_;
};

/// True if a formula certainly grows by at least one half each time the number of decades of the
/// distance doubles, as the variable tends to its limit.
[[nodiscard]] bool certainly_grows(const formula::Expr& e, const Sample& sample,
                                   const ExpansionToFollow& expansion, unsigned digits);

} // namespace edgeproof::audit
