// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/sample/evaluated_scene.hpp"

#include <memory>
#include <string>
#include <vector>

namespace edgeproof::audit {

/// A scene under two loads (parameters of it, such as Q and sig0) that a quantity is linear in:
/// with one of them alone, and with the second chosen so that another quantity vanishes.
class LinearLoads {
public:
    /// Throws InputError if the scene has no such parameters.
    LinearLoads(const SceneSpec& scene, unsigned digits, const std::string& first,
                const std::string& second);
    ~LinearLoads();
    LinearLoads(LinearLoads&&) noexcept;

    /// What each load alone makes of it.
    struct Parts {
        Real first;
        Real second;
    };
    /// Throws DomainError if it is not the sum of its parts, to all digits but a few.
    [[nodiscard]] Parts parts(const formula::Expr& e) const;
    /// The second load at which e vanishes, the first being as it is in the scene. Throws
    /// DomainError if the second has no effect on it.
    [[nodiscard]] Real second_for_zero(const formula::Expr& e) const;
    /// A formula in the scene with that second load, where no function of the load stands in it.
    [[nodiscard]] Real evaluate(const formula::Expr& e, const Real& second) const;
    /// The second load in the scene: what `parts` are of.
    [[nodiscard]] const Real& second() const noexcept { return second_value_; }
    [[nodiscard]] unsigned digits() const noexcept { return digits_; }

private:
    unsigned digits_;
    std::string second_;
    Real second_value_;
    std::unique_ptr<EvaluatedScene> both_;
    std::unique_ptr<EvaluatedScene> only_first_;
    std::unique_ptr<EvaluatedScene> only_second_;
};

} // namespace edgeproof::audit
