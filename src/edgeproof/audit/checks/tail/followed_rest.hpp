// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <optional>
#include <string>
#include <vector>

namespace edgeproof::audit {

/// An expansion in a small variable, and where another variable goes to.
struct ExpansionToFollow {
    formula::Expr of;
    formula::Expr approximation;
    std::string small;
    unsigned order = 0; ///< the power of the small variable that comes next
    std::string variable;
    formula::Exact towards;
    /// (of - approximation)/small^order.
    [[nodiscard]] formula::Expr rest() const;
};

/// The sample with the variable at the distance 10^-decades, about, from where it goes to; at
/// exactly that distance if `exactly`.
[[nodiscard]] Sample at_distance(const Sample& sample, const ExpansionToFollow& expansion,
                                 unsigned decades, bool exactly = false);

/// What an expansion leaves, over the power that comes next, as the variable comes to its limit: in
/// balls, for three sizes of the small variable, down to distances beyond all powers of it up to
/// the second and what the formula may hide (hidden_terms.hpp).
class FollowedRest {
public:
    FollowedRest(const Sample& sample, const ExpansionToFollow& expansion, unsigned digits);

    enum class Course {
        unknown,
        nothing,     ///< no rest that the balls distinguish from zero
        bounded,     ///< it tends to a limit for each size, and its maximum does for small sizes
        grows,       ///< without bound as the variable comes to its limit, or as the size falls
        wrong_order, ///< it grows as the size falls, far from the limit as well
    };
    [[nodiscard]] Course course() const { return course_; }
    /// Why the course is not known.
    [[nodiscard]] const std::string& problem() const { return problem_; }
    /// |rest| at the last distance but one and at the last, for the first size; of the course
    /// `wrong_order` far from the limit, for the first size and the smallest.
    [[nodiscard]] const Ball& before_last() const;
    [[nodiscard]] const Ball& last() const;
    /// The largest, for the first size.
    [[nodiscard]] Ball largest() const;
    /// For a table: "10^-64".
    [[nodiscard]] std::string last_distance() const;

private:
    struct Station {
        unsigned decades;
        Ball rest; ///< |rest|
        bool nothing;
    };
    /// At one size of the small variable.
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
    formula::Expr simplified_; ///< the same, in which the terms that cancel are seen no more
    unsigned digits_;
    std::vector<Run> runs_;
    Course course_ = Course::unknown;
    std::string problem_;
};

/// Whether a formula certainly grows, as the variable comes to its limit, by half at least each
/// time that the decades of the distance double.
[[nodiscard]] bool certainly_grows(const formula::Expr& e, const Sample& sample,
                                   const ExpansionToFollow& expansion, unsigned digits);

} // namespace edgeproof::audit
