// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/route/ball_level.hpp"
#include "edgeproof/scene/route/exact_values.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace edgeproof::scene {

/// A scene's values in balls of more and more bits, until they can be printed. Keeps references to
/// all three; `work` counts how often the bits were raised.
class BallRefinement {
public:
    using InBalls = std::function<Ball(BallLevel&)>;
    using Exactly = std::function<formula::ExactNumber(ExactValues&)>;

    BallRefinement(const Scene& scene, const Plan& plan, contact::Work& work);

    /// A value, and what it is exactly where that is a rational number and was looked at.
    struct Found {
        Ball value;
        std::optional<Rational> exactly = {};
    };
    /// f at more and more bits (from `first`, or those of the plan), until it has its digits,
    /// or it is zero to 1e-400 and `lost` bits more (at least those of expect_lost()), or the bits
    /// are used up. Nothing where it has no finite
    /// value. Where the ball has the digits and yet does not round alike, more bits cannot help if
    /// the value lies exactly on the limit: so the exact form is looked at first.
    [[nodiscard]] std::optional<Found> refine(const InBalls& f, const Exactly& exactly,
                                              const Digits& digits, long first = 0, long lost = 0);
    /// That values of the scene lose so many bits by cancellation.
    void expect_lost(long bits) { lost_bits_ = bits; }
    /// The rational number that the value is by its exact form, if it is known to be one.
    [[nodiscard]] std::optional<Rational> exact_value(const Exactly& exactly,
                                                      const BallLevel& level, const Ball& near);
    /// Null where so few bits do not isolate the edges.
    [[nodiscard]] BallLevel* at_level(long bits);
    /// That it is worth while to try.
    [[nodiscard]] long last_bits() const { return closed() ? last_bits_ : last_curved_bits_; }
    [[nodiscard]] bool closed() const { return plan_.route == contact::Route::closed_form; }

private:
    /// Made when it is first asked for. Null under a tilt that was solved for and is not zero.
    [[nodiscard]] ExactValues* exact_values(const BallLevel& level);
    /// The bits of the next attempt.
    [[nodiscard]] long after(long bits) const { return bits < plan_.bits ? plan_.bits : 2 * bits; }

    const Scene& scene_;
    const Plan& plan_;
    contact::Work& work_;
    long last_bits_;
    long last_curved_bits_; ///< integrals cost more
    long lost_bits_ = 0;
    std::map<long, std::unique_ptr<BallLevel>> levels_;
    std::optional<contact::ExactEdges> edges_; ///< where a level proved them
    std::optional<ExactValues> exact_;
};

} // namespace edgeproof::scene
