// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/contact/stress/plane_stress.hpp"
#include "edgeproof/precision/double_word/binary64_ball.hpp"
#include "edgeproof/precision/double_word/double_word.hpp"

#include <optional>
#include <vector>

namespace edgeproof::contact {

/// The stress at a point of a body in binary64, each component with a proved bound of its error
/// (stress); signs as in StressState.
struct Binary64StressState {
    Binary64Ball sxx;
    Binary64Ball szz;
    Binary64Ball sxz;
    Binary64Ball half_difference; ///< (sxx - szz)/2
};

/// Stresses at many points of a body, in binary64 with bounds: the formulas of plane_stress.hpp
/// and cauchy_integral.hpp. The object is immutable: many threads may use it.
class Binary64Stress {
public:
    /// The precision that the field should have, so that places near edges and knots are accurate.
    static constexpr long field_bits = 192;

    /// For piecewise linear slopes only.
    /// @param field the load on the body
    /// @param stuck the shear load on the body under full stick, if there is one
    Binary64Stress(const StressField& field, const std::optional<ShearLoad<Ball>>& stuck);

    /// Returns the stress at the place x and the depth z >= 0 (length), exactly these binary64. The
    /// bounds are not finite where the formulas do not hold in binary64, such as on knots.
    [[nodiscard]] Binary64StressState at(double x, double z) const;

private:
    struct Knot {
        DoubleWord place;
        Binary64Ball w;
        Binary64Ball cosine; ///< of the angle h of the knot
        Binary64Ball sine;
        Binary64Ball jump; ///< of g'
        Binary64Ball drop; ///< of g''
        bool corner;
    };
    struct Part {
        DoubleWord right; ///< a
        DoubleWord left;  ///< -b
        Binary64Ball half;
        Binary64Ball arc;      ///< (D/2) times the integral of g'' dh
        Binary64Ball pressure; ///< factors of the Cauchy integral in P and T, with E*/2
        Binary64Ball shear;
        std::vector<Knot> knots;
    };

    std::vector<Part> parts_;
    Binary64Ball bulk_;
    bool stuck_ = false;
    Binary64Ball Q_;
    Binary64Ball tension_; ///< pi sigma_0/4
};

} // namespace edgeproof::contact
