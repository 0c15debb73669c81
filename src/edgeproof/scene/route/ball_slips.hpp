// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/route/ball_refinement.hpp"
#include "edgeproof/scene/route/row.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::scene {

/// The partial slip of a scene with friction, proved. Keeps references to all three arguments.
class BallSlips {
public:
    BallSlips(BallRefinement& balls, const Scene& scene, const Plan& plan)
        : balls_(balls), scene_(scene), plan_(plan) {}

    /// Throws InputError, with the line of its cause, if the contact slides or the stick zone would
    /// extend beyond it.
    void check();
    /// Returns nothing if no number of bits encloses the slip.
    [[nodiscard]] std::optional<contact::SlipState> state(contact::Edge edge, const Distance& u);
    /// True if both edges slip in the direction of Q from the beginning of loading.
    [[nodiscard]] bool in_proportion();
    /// The rows of d_n (ValueRoute::slip_terms). None if no number of bits encloses the slip.
    [[nodiscard]] std::vector<Row> terms(contact::Edge edge, std::size_t n);

private:
    [[nodiscard]] std::optional<BoundedValue> bounded(const BallRefinement::InBalls& f,
                                                      const Digits& digits, const char* route,
                                                      long lost = 0);
    /// The bits lost by cancellation when n + 1 powers of the load ratio are compared with 1.
    [[nodiscard]] long lost_by(std::size_t n) const;
    void refuse_exactly_sliding(const BallLevel& level);
    /// Sets the value of the row of a slip load, if it is found.
    void find_reach(Row& row);

    BallRefinement& balls_;
    const Scene& scene_;
    const Plan& plan_;
    bool checked_ = false;
    BallLevel* level_ = nullptr; ///< a level that encloses the slip
};

} // namespace edgeproof::scene
