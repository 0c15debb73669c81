// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"

#include <string>
#include <vector>

namespace edgeproof::audit {

/// Returns the names of the two loads of a claim. Throws InputError if they are not two.
[[nodiscard]] inline const std::vector<std::string>& two_loads(const Claim& claim) {
    if (claim.list("loads").size() != 2) {
        claim.reject("loads", "loads are not two", "write loads = [\"Q\", \"sig0\"]");
    }
    return claim.list("loads");
}

/// A scene in balls under two loads (parameters such as Q and sig0) in which a quantity is linear:
/// with only one of them, and with the second load for which another quantity vanishes.
class EnclosedLoads {
public:
    /// `names`: of the two loads. A second load that is zero in the scene is replaced by 1.
    EnclosedLoads(const SceneSpec& scene, const std::vector<std::string>& names, long bits)
        : scene_(scene), sample_({scene, std::nullopt, Edge::right, {}}, bits), names_(names) {
        const Exact& second = scene.parameter(names_[1]);
        loads_ = {ball_of(scene.parameter(names_[0]), bits),
                  second.sign() == 0 ? Ball(1, bits) : ball_of(second, bits)};
    }

    /// The loads of the scene, or the contributions of each to a quantity.
    struct Parts {
        Ball first;
        Ball second;
    };
    [[nodiscard]] const Parts& loads() const { return loads_; }
    /// Throws DomainError if the quantity is proved not to be the sum of its parts.
    [[nodiscard]] Parts parts(const Expr& e) {
        const Ball zero(0, sample_.bits());
        Parts p{with(loads_.first, zero, e), with(zero, loads_.second, e)};
        if (disjoint(with(loads_.first, loads_.second, e), p.first + p.second)) {
            throw DomainError(to_text(e) + " is not the sum of its values under each load alone");
        }
        return p;
    }
    /// Returns the second load for which e vanishes, with the first load of the scene; not finite
    /// if the second load is not proved to have an effect on e.
    [[nodiscard]] Ball second_for_zero(const Expr& e) {
        const Parts p = parts(e);
        return -(loads_.second * p.first / p.second);
    }
    /// Returns a formula under the first load and another second load.
    [[nodiscard]] Ball with_second(const Expr& e, const Ball& second) {
        return with(loads_.first, second, e);
    }
    [[nodiscard]] EnclosedSample& sample() { return sample_; }
    [[nodiscard]] const SceneSpec& scene() const { return scene_; }

private:
    [[nodiscard]] Ball with(const Ball& first, const Ball& second, const Expr& e) {
        sample_.set(names_[0], first);
        sample_.set(names_[1], second);
        return sample_.evaluate(e);
    }
    SceneSpec scene_;
    EnclosedSample sample_;
    std::vector<std::string> names_;
    Parts loads_;
};

} // namespace edgeproof::audit
