// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"

#include <string>

namespace edgeproof::audit {

/// A scene in balls under two loads (parameters such as Q and sig0) in which a quantity is linear:
/// with only one of them, and with the second load for which another quantity vanishes.
class EnclosedLoads {
public:
    /// A second load that is zero in the scene is replaced by 1.
    EnclosedLoads(const SceneSpec& scene, std::string first, std::string second, long bits);

    /// A formula under the first load alone, and under the second alone.
    [[nodiscard]] Ball of_first(const formula::Expr& e);
    [[nodiscard]] Ball of_second(const formula::Expr& e);
    /// Returns the second load for which e vanishes, with the first load of the scene; not finite
    /// if the second load is not proved to have an effect on e.
    [[nodiscard]] Ball second_for_zero(const formula::Expr& e);
    /// Returns a formula under the first load and another second load.
    [[nodiscard]] Ball with_second(const formula::Expr& e, const Ball& second);
    /// The loads of the scene.
    [[nodiscard]] const Ball& first() const { return first_value_; }
    [[nodiscard]] const Ball& second() const { return second_value_; }
    [[nodiscard]] EnclosedSample& sample() { return sample_; }

private:
    [[nodiscard]] Ball with(const Ball& first, const Ball& second, const formula::Expr& e);
    EnclosedSample sample_;
    std::string first_;
    std::string second_;
    Ball first_value_;
    Ball second_value_;
};

} // namespace edgeproof::audit
