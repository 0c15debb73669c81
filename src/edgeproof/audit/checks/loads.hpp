// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/audit/sample/evaluated_scene.hpp"

#include <string>
#include <vector>

namespace edgeproof::audit {

/// A scene under two loads (parameters such as Q and sig0) in which a quantity is linear: with only
/// one of them, and with the second chosen so that another quantity vanishes.
class LinearLoads {
public:
    /// Throws InputError if the scene does not have these parameters.
    LinearLoads(const SceneSpec& scene, unsigned digits, const std::string& first,
                const std::string& second);

    /// The contributions of each load to a quantity.
    struct Parts {
        Real first;
        Real second;
    };
    /// Throws DomainError if the quantity is not the sum of its parts, to all digits except a few.
    [[nodiscard]] Parts parts(const Expr& e) const;
    /// Returns the second load for which e vanishes, with the first load of the scene. Throws
    /// DomainError if the second load has no effect on e.
    [[nodiscard]] Real second_for_zero(const Expr& e) const;
    /// Evaluates a formula in the scene with that second load; the formula must not contain
    /// functions of the load.
    [[nodiscard]] Real evaluate(const Expr& e, const Real& second) const;
    /// The second load in the scene, as used by `parts`.
    [[nodiscard]] const Real& second() const noexcept { return second_value_; }
    [[nodiscard]] unsigned digits() const noexcept { return digits_; }

private:
    unsigned digits_;
    std::string second_;
    EvaluatedScene both_;
    EvaluatedScene only_first_;
    EvaluatedScene only_second_;
    Real second_value_;
};

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
        : sample_({scene, std::nullopt, Edge::right, {}}, bits), names_(names) {
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
    [[nodiscard]] Parts parts(const Expr& e) {
        const Ball zero(0, sample_.bits());
        return {with(loads_.first, zero, e), with(zero, loads_.second, e)};
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

private:
    [[nodiscard]] Ball with(const Ball& first, const Ball& second, const Expr& e) {
        sample_.set(names_[0], first);
        sample_.set(names_[1], second);
        return sample_.evaluate(e);
    }
    EnclosedSample sample_;
    std::vector<std::string> names_;
    Parts loads_;
};

} // namespace edgeproof::audit
