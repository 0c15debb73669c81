// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
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
    [[nodiscard]] Parts parts(const formula::Expr& e) const;
    /// Returns the second load for which e vanishes, with the first load of the scene. Throws
    /// DomainError if the second load has no effect on e.
    [[nodiscard]] Real second_for_zero(const formula::Expr& e) const;
    /// Evaluates a formula in the scene with that second load; the formula must not contain
    /// functions of the load.
    [[nodiscard]] Real evaluate(const formula::Expr& e, const Real& second) const;
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

} // namespace edgeproof::audit
