// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/route/ball_level.hpp"
#include "edgeproof/scene/route/exact_values.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace edgeproof::scene {

/// Computes a scene's values in balls of more and more bits until they can be printed. Keeps
/// references to all three arguments; `work` counts how often the bits were raised.
class BallRefinement {
public:
    using InBalls = std::function<Ball(BallLevel&)>;
    using Exactly = std::function<formula::ExactNumber(ExactValues&)>;

    BallRefinement(const Scene& scene, const Plan& plan, contact::Work& work);

    /// A value, and its exact value if that is a rational number and was searched for.
    struct Found {
        Ball value;
        std::optional<Rational> exactly = {};
    };
    /// Evaluates f at more and more bits (starting from `first`, or from those of the plan) until
    /// the value has its digits, or is zero to 1e-400 and `lost` more bits (at least those of
    /// expect_lost()), or the bits are used up. Returns nothing if the value is not finite. If the
    /// ball is narrow enough but does not round to one number, more bits cannot help when the value
    /// lies exactly on the limit, so the exact form is tried first.
    [[nodiscard]] std::optional<Found> refine(const InBalls& f, const Exactly& exactly,
                                              const Digits& digits, long first = 0, long lost = 0);
    /// States that values of the scene lose this number of bits by cancellation.
    void expect_lost(long bits) { lost_bits_ = bits; }
    /// The rational number given by the exact form of the value, if it is known to be rational.
    [[nodiscard]] std::optional<Rational> exact_value(const Exactly& exactly,
                                                      const BallLevel& level, const Ball& near);
    /// Null if these bits do not isolate the edges.
    [[nodiscard]] BallLevel* at_level(long bits);
    [[nodiscard]] long last_bits() const { return closed() ? last_bits_ : last_curved_bits_; }
    [[nodiscard]] bool closed() const { return plan_.route == contact::Route::closed_form; }

private:
    /// Made on first use. Null under a tilt that was solved for and is not zero.
    [[nodiscard]] ExactValues* exact_values(const BallLevel& level);
    [[nodiscard]] long after(long bits) const { return bits < plan_.bits ? plan_.bits : 2 * bits; }

    const Scene& scene_;
    const Plan& plan_;
    contact::Work& work_;
    long last_bits_;
    long last_curved_bits_; ///< integrals cost more
    long lost_bits_ = 0;
    std::map<long, std::unique_ptr<BallLevel>> levels_;
    std::optional<contact::ExactEdges> edges_; ///< if a level proved them
    std::optional<ExactValues> exact_;
};

} // namespace edgeproof::scene
