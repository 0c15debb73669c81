// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/route/ball_refinement.hpp"
#include "edgeproof/scene/route/value_route.hpp"

#include <cstddef>
#include <optional>

namespace edgeproof::scene {

/// The partial slip of a scene with friction, proved. Keeps references to all three.
class BallSlips {
public:
    BallSlips(BallRefinement& balls, const Scene& scene, const Plan& plan)
        : balls_(balls), scene_(scene), plan_(plan) {}

    /// Throws InputError, told with its line, where the contact slides, and where the stick zone
    /// would reach beyond it.
    void check();
    /// Nothing where no number of bits encloses the slip; so of all that follow.
    [[nodiscard]] std::optional<contact::SlipState> state(contact::Edge edge, const Distance& u);
    [[nodiscard]] std::optional<BoundedValue> load_ratio();
    /// The bulk tension with which the stick zone reaches that edge.
    [[nodiscard]] std::optional<BoundedValue> tension_limit(contact::Edge edge);
    /// Both edges slip in the direction of Q from the first load on.
    [[nodiscard]] bool in_proportion();
    /// d_n, and how far it is good.
    [[nodiscard]] std::optional<SlipTerms> terms(contact::Edge edge, std::size_t n);

private:
    [[nodiscard]] std::optional<BoundedValue> bounded(const BallRefinement::InBalls& f,
                                                      const Digits& digits, const char* route,
                                                      long lost = 0);
    /// The bits that n + 1 powers of the load ratio lose beside 1.
    [[nodiscard]] long lost_by(std::size_t n) const;
    void refuse_exactly_sliding(const BallLevel& level);
    void find_reach(contact::Edge edge, SlipTerms& t);

    BallRefinement& balls_;
    const Scene& scene_;
    const Plan& plan_;
    bool checked_ = false;
    BallLevel* level_ = nullptr; ///< one that encloses the slip
};

} // namespace edgeproof::scene
