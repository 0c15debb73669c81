// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/precision/real.hpp"
#include "edgeproof/scene/binary64_values.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::comparison {

inline constexpr std::array both_edges{contact::Edge::right, contact::Edge::left};

/// What the shear traction of a scene is compared with.
struct ExactShear {
    /// |Q|/(a + b) + |sigma_0|/4, the mean of |q| under full stick of Q and of sigma_0 alone: the
    /// reference of relative errors of q, since q itself may be infinite at the edges.
    /// Of an axisymmetric contact |Q|/(pi a^2). After steps, at whose end Q may be 0, f times the
    /// mean pressure.
    double scale = 0;
    std::string scale_text;
    double force = 0; ///< Q
    /// Where the stick zone ends in partial slip: the slope of q is infinite on its inner side.
    /// Empty without friction, and after steps.
    std::vector<double> stick_edges;
    bool singular = false; ///< q grows without bound towards the edges: no partial slip
};

/// The question about a quantity at the place x.
[[nodiscard]] scene::AskedValue asked_at(scene::Quantity quantity, const Real& x);

/// A place where g' changes, inside the contact.
struct ContactKnot {
    double x = 0;
    bool corner = false; ///< g' jumps: p is infinite there
};

/// A value of the contact in double precision, with the name of its route.
struct ExactValue {
    double value = 0;
    std::string route; ///< "closed-form", or "... (estimate)" if no bound is proved
};

/// Estimates of the pressure of a plane contact of a curved slope in binary64, for searches and
/// suspects: g' at the nodes of the rule is computed once. At least about 9 digits.
class QuickPressure {
public:
    /// @param profile g'(x)
    /// @param contact_modulus E* (stress)
    /// @param a distance of the right edge from the origin (length)
    /// @param b of the left edge
    QuickPressure(const contact::Profile& profile, double contact_modulus, double a, double b);

    /// Returns p at a place inside the contact. Nothing if the rule and one of half as many nodes
    /// disagree, for example close to a knot.
    [[nodiscard]] std::optional<double> at(double x) const;

private:
    struct Node {
        double s;
        double slope; ///< g'(s)
        double weight;
    };
    /// g'(x).
    [[nodiscard]] double slope(std::size_t piece, double x) const;

    contact::RealSlope slope_;
    double factor_; ///< E*/(2 pi)
    double a_;
    double b_;
    std::array<std::vector<Node>, 2> rules_;
};

/// The exact solution of a scene for comparison, by the scene's own routes: sizes, loads,
/// coefficients, pressures and tractions in binary64. The scene is solved once. One object belongs
/// to one thread.
class ExactContact {
public:
    /// Keeps no reference to the scene. Throws InputError, with the line, for a load that no
    /// contact carries, and if the contact slides or the stick zone reaches an edge.
    explicit ExactContact(const scene::Scene& scene);

    [[nodiscard]] const ExactValue& a() const { return a_; }
    [[nodiscard]] const ExactValue& b() const { return b_; }
    /// The distance of an edge from the origin: a or b.
    [[nodiscard]] double edge(contact::Edge edge) const {
        return edge == contact::Edge::right ? a_.value : b_.value;
    }
    [[nodiscard]] const ExactValue& force() const { return force_; }
    /// c_0, c_1 and c_2 at an edge.
    [[nodiscard]] ExactValue c(contact::Edge edge, std::size_t k) const;
    [[nodiscard]] double length() const { return a_.value + b_.value; }
    /// The profile, with its tilt if P and M determine that. Of an axisymmetric power law, the
    /// profile of the plane contact with the same pressure.
    [[nodiscard]] const contact::Profile& profile() const { return *profile_; }
    [[nodiscard]] bool symmetric() const { return symmetric_; }
    [[nodiscard]] bool axisymmetric() const { return axisymmetric_; }
    /// a + b; of an axisymmetric contact pi a^2.
    [[nodiscard]] double area() const;
    /// The factor of p in the integral over x from -b to a that is P: 1; of an axisymmetric
    /// contact pi |x|.
    [[nodiscard]] double force_width(double x) const;
    /// The radius in u within which the expansion at an edge converges.
    [[nodiscard]] double convergence_radius(contact::Edge edge) const {
        return radius_.at(index_of(edge));
    }
    [[nodiscard]] const std::vector<ContactKnot>& knots() const { return knots_; }
    /// Returns the method for pressures: "in closed form" (nearly all), "by the Abel
    /// integral" or "by rigorous integration".
    [[nodiscard]] std::string pressure_route() const;

    /// The reference of relative errors: the largest pressure, or, if that is infinite (a corner of
    /// g' inside the contact), the mean one, P/area().
    struct Scale {
        double value = 0;
        bool mean = false;
    };
    [[nodiscard]] const Scale& scale() const;

    /// A place x. `from_right` and `from_left` are a - x and x + b, without cancellation.
    struct Place {
        double from_right = 0;
        double from_left = 0;
        bool on_corner = false;
        std::optional<Real> near_corner; ///< x, if the place is near a corner
        [[nodiscard]] bool inside() const { return from_right > 0 && from_left > 0; }
        [[nodiscard]] contact::Edge nearer() const {
            return from_right <= from_left ? contact::Edge::right : contact::Edge::left;
        }
        [[nodiscard]] double from(contact::Edge edge) const {
            return edge == contact::Edge::right ? from_right : from_left;
        }
        [[nodiscard]] double u() const { return from(nearer()); }
    };
    [[nodiscard]] Place at(const Real& x) const;
    /// p at x in binary64, for searches and suspects: of a curved slope an estimate of at least
    /// about 9 digits. Empty on a corner.
    [[nodiscard]] std::optional<double> quick_pressure(double x) const;
    [[nodiscard]] double pressure(double x) const; ///< the same; the scale's value on a corner

    /// The shear, if the scene has it; otherwise null.
    [[nodiscard]] const ExactShear* shear() const { return shear_ ? &*shear_ : nullptr; }
    /// The exact p and q at a place of this contact, in binary64 to about the last digit: 0
    /// outside; empty where they are infinite (p on a corner, q on an edge under full stick and on
    /// a corner where it is proportional to p), and without shear.
    [[nodiscard]] std::optional<double> p(const Place& place) const;
    [[nodiscard]] std::optional<double> q(const Place& place) const;

    /// The digits with which places are to be given.
    static constexpr unsigned place_digits = 60;

private:
    [[nodiscard]] ExactValue value(const scene::AskedValue& asked) const;
    /// p or q inside the contact, not on a corner. `values` are made when needed.
    [[nodiscard]] std::optional<double>
    traction(scene::Quantity quantity, const Place& place,
             std::optional<scene::Binary64Values>& values) const;
    void solve();
    void find_shear();

    scene::Scene scene_;
    std::unique_ptr<scene::SceneValues> values_;
    std::optional<contact::Profile> profile_;
    mutable std::optional<scene::Binary64Values> pressures_; ///< made when needed
    mutable std::optional<scene::Binary64Values> tractions_; ///< the same
    std::optional<QuickPressure> quick_; ///< set for a curved slope in the plane
    Real right_;                         ///< a
    Real left_;                          ///< b
    std::optional<ExactShear> shear_;
    ExactValue a_;
    ExactValue b_;
    ExactValue force_;
    mutable std::array<std::vector<ExactValue>, 2> c_; ///< made when needed
    std::array<double, 2> radius_{};
    std::vector<ContactKnot> knots_;
    bool symmetric_ = false;
    bool axisymmetric_ = false;
    mutable std::optional<Scale> scale_; ///< found when it is first needed
};

} // namespace edgeproof::comparison
