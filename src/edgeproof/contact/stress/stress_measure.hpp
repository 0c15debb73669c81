// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/stress/plane_stress.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::contact {

[[nodiscard]] Ball square(const Ball& x);

/// A function of x and z with its first and second derivatives.
struct PlaneJet {
    Ball value;
    std::array<Ball, 2> first;  ///< by x, by z
    std::array<Ball, 3> second; ///< by xx, xz, zz
    [[nodiscard]] bool is_finite() const {
        const auto finite = [](const Ball& x) { return x.is_finite(); };
        return value.is_finite() && std::ranges::all_of(first, finite) &&
               std::ranges::all_of(second, finite);
    }
    /// True if the function is proved to be strictly concave.
    [[nodiscard]] bool concave() const {
        return certainly_negative(second[0]) &&
               certainly_positive(second[0] * second[2] - square(second[1]));
    }
};

[[nodiscard]] inline PlaneJet square(const PlaneJet& f) {
    const auto& [x, z] = f.first;
    const auto& [xx, xz, zz] = f.second;
    const Ball& v = f.value;
    return {square(v),
            {v * x * 2, v * z * 2},
            {(square(x) + v * xx) * 2, (x * z + v * xz) * 2, (square(z) + v * zz) * 2}};
}

/// by f + with g.
[[nodiscard]] inline PlaneJet sum(const Ball& by, const PlaneJet& f, const Ball& with,
                                  const PlaneJet& g) {
    PlaneJet r{by * f.value + with * g.value, {}, {}};
    for (std::size_t i = 0; i < r.first.size(); ++i) {
        r.first[i] = by * f.first[i] + with * g.first[i];
    }
    for (std::size_t i = 0; i < r.second.size(); ++i) {
        r.second[i] = by * f.second[i] + with * g.second[i];
    }
    return r;
}

/// The quantity whose greatest value is searched for: the greatest shear stress in the plane, the
/// equivalent stress of von Mises in plane strain, or sxx on the surface.
struct StressNorm {
    enum class Kind { tau_max, mises, surface_sxx };
    Kind kind = Kind::tau_max;
    /// Poisson's ratio <= 1/2, for mises.
    std::optional<Ball> poisson;
};

/// F of a field, as a function of the place, which grows with the quantity of a StressNorm. With
/// D = z (P' - i T') - T + pi bulk/2 and S = Im P - Re T + pi bulk/2 it is
///   tau_max  |D|^2 = pi^2 tau_max^2 (stress^2)
///   mises    3 |D|^2 + (1 - 2 nu)^2 S^2 = pi^2 mises^2 (stress^2)
///   surface_sxx  Re D + S = pi sxx (stress), for z = 0 only
/// (docs/stress.md, "The greatest values").
class StressMeasure {
public:
    StressMeasure(StressField field, const StressNorm& norm);

    [[nodiscard]] const StressField& field() const { return field_; }
    /// True if F is compared on the surface only.
    [[nodiscard]] bool on_surface_only() const { return kind_ == Kind::surface_sxx; }
    /// The stress of a value of F.
    [[nodiscard]] Ball stress(const Ball& F) const;
    /// F for every place of a box with z >= 0; not finite if the box is too wide.
    [[nodiscard]] Ball bound(const Box& zeta) const;
    /// The same with derivatives, which are not finite if F is not smooth in the box.
    [[nodiscard]] PlaneJet jet(const Box& zeta) const;
    /// An upper bound of F everywhere at the distance (length) from the contact or further.
    [[nodiscard]] Ball far(const Ball& distance) const;
    /// F at an edge of a part (0: the contact).
    [[nodiscard]] Ball at_edge(std::size_t part, Edge edge) const;
    /// True if F is proved to be less than at the right edge of a part at all other places within
    /// `radius`, a power of two (length), of it.
    [[nodiscard]] bool greatest_at_right_edge(std::size_t part, const Ball& radius) const;
    /// The measure of the mirror image.
    [[nodiscard]] StressMeasure reflected() const;

    /// True if F is known to be the same at the mirror image of a place (x, 0) on the surface of a
    /// field with `surface_mirrored`.
    [[nodiscard]] bool mirrored_on_surface(const Ball& x) const;

private:
    using Kind = StressNorm::Kind;
    struct Sums; ///< D and S
    [[nodiscard]] Sums sums(const Box& zeta) const;
    [[nodiscard]] Ball measure(const Box& D, const Ball& S) const;
    [[nodiscard]] Sums at_right_edge(std::size_t part) const;

    StressField field_;
    Kind kind_;
    Ball deviator_; ///< the factor of |D|^2 for tau_max and mises
    Ball mean_;     ///< that of S^2
    Ball bulk_;     ///< pi bulk/2
    /// For each part its factor P' - i T' in G, and the force (force/length).
    std::vector<Box> weights_;
    std::vector<Ball> forces_;
};

} // namespace edgeproof::contact
