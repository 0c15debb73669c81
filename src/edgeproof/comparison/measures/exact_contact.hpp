// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/measures/exact_shear.hpp"
#include "edgeproof/precision/real.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::comparison {

/// A place where g' changes, inside the contact.
struct ContactKnot {
    double x = 0;
    bool corner = false; ///< g' jumps: p is infinite there
};

/// A value of the contact: to double precision and how it was computed.
struct ExactValue {
    double value = 0;
    std::string route; ///< "closed-form", "... (estimate)" where no bound is proved
};

/// The exact solution of a scene, to be held against: sizes, loads and coefficients to 20 digits by
/// the scene's own routes, and pressures at any place to 20 digits, in closed form (double words)
/// where there is one, else by the batch rule, whose error is bounded by Bernstein's ellipse but
/// for roundoff. One object belongs to one thread.
class ExactContact {
public:
    /// Keeps no reference to the scene. Throws what run_scene and NormalContact throw for a load
    /// that no contact carries, or an outer slope that ends inside it, and what ExactShear throws.
    explicit ExactContact(const scene::Scene& scene);
    ~ExactContact();
    ExactContact(ExactContact&&) noexcept;
    ExactContact& operator=(ExactContact&&) noexcept;

    [[nodiscard]] const ExactValue& a() const;
    [[nodiscard]] const ExactValue& b() const;
    [[nodiscard]] const ExactValue& force() const;
    /// c_0, c_1 and c_2 at an edge.
    [[nodiscard]] const ExactValue& c(contact::Edge edge, std::size_t k) const;
    [[nodiscard]] double length() const { return a().value + b().value; }
    [[nodiscard]] bool symmetric() const;
    /// The radius in u within which the expansion at an edge converges.
    [[nodiscard]] double convergence_radius(contact::Edge edge) const;
    [[nodiscard]] const std::vector<ContactKnot>& knots() const;
    /// How pressures are computed: "in closed form" (nearly all), or "by the batch rule".
    [[nodiscard]] std::string pressure_route() const;

    /// What relative errors are of: the largest pressure, or, where that is infinite (a corner of
    /// g' inside the contact), the mean one, P/(a + b).
    struct Scale {
        double value = 0;
        double x = 0; ///< where the largest pressure is
        bool mean = false;
    };
    [[nodiscard]] const Scale& scale() const;

    /// The pressure at x: 0 outside the contact, nothing on a corner. `from_right`, `from_left`
    /// are a - x and x + b, without cancellation.
    struct Place {
        double from_right = 0;
        double from_left = 0;
        std::optional<double> p;
        /// Of the same p, unrounded: what a difference is taken from.
        Real exact_p;
        [[nodiscard]] bool inside() const { return from_right > 0 && from_left > 0; }
        [[nodiscard]] contact::Edge nearer() const {
            return from_right <= from_left ? contact::Edge::right : contact::Edge::left;
        }
        [[nodiscard]] double u() const { return from_right <= from_left ? from_right : from_left; }
    };
    [[nodiscard]] Place at(const Real& x) const;
    [[nodiscard]] double pressure(double x) const; ///< the scale's value on a corner

    /// The shear of a scene that has one.
    [[nodiscard]] const ExactShear* shear() const;
    /// The exact q at the place of x: 0 outside; nothing where it is infinite (an edge under full
    /// stick, a corner where q goes with p), and without shear.
    [[nodiscard]] std::optional<double> traction(const Real& x, const Place& place) const;

    /// Digits that places are to be given with.
    static constexpr unsigned place_digits = 60;

private:
    struct Solved;
    std::unique_ptr<Solved> solved_;
};

} // namespace edgeproof::comparison
