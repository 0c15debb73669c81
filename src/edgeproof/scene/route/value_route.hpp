// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/work.hpp"
#include "edgeproof/contact/slip/ball_slip.hpp"
#include "edgeproof/scene/input/bounded_value.hpp"
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/route/plan.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace edgeproof::scene {

/// The sum of the first n terms at a point, and |1 - sum/value|.
struct Approximation {
    std::size_t n = 0;
    BoundedValue local;
    BoundedValue relative_error;
};

struct PointValues {
    BoundedValue x;
    std::optional<BoundedValue> u; ///< if it was not given as a number
    std::optional<BoundedValue> p;
    std::vector<Approximation> p_local;
    std::optional<BoundedValue> q;
    std::vector<Approximation> q_local;
    std::optional<contact::SlipState> state; ///< of q, if there is friction
};

struct EdgeValues {
    contact::Edge edge = contact::Edge::right;
    std::vector<BoundedValue> c; ///< coefficients of u^(1/2), u^(3/2), ... in p
    std::vector<BoundedValue> s; ///< coefficients of q, from u^(s_half_powers/2) on
    int s_half_powers = -1;
};

struct ExtentValues {
    contact::Edge edge = contact::Edge::right;
    std::size_t n = 0;
    BoundedValue first_exit; ///< if none, the end of the part considered
    BoundedValue measure;
    BoundedValue first_exit_fraction; ///< as a fraction of a + b
    BoundedValue measure_fraction;
    std::vector<BoundedValue> crossings;
    bool leaves = true; ///< there is a first exit in the part considered
    /// The first exit lies beyond the process zone, if one is given.
    std::optional<bool> covers_zone;
};

/// The slip zone given by the first n terms.
struct SlipTerms {
    std::size_t n = 0;
    BoundedValue size;           ///< d_n
    BoundedValue relative_error; ///< |1 - d_n/d|
    /// The load ratio up to which that error stays within the tolerance. Empty without a tolerance,
    /// if it cannot be decided, or if the edge would first slip in the other direction.
    std::optional<BoundedValue> reach;
    bool leaves = true; ///< false: within the tolerance up to full sliding
};

struct SlipValues {
    contact::Edge edge = contact::Edge::right;
    BoundedValue size; ///< d
    std::vector<SlipTerms> terms;
};

/// The stick zone -b < x < a.
struct StickValues {
    BoundedValue load_ratio; ///< |Q|/(f P)
    BoundedValue a;
    BoundedValue b;
    /// The bulk tensions, for the given Q and P, with which the stick zone reaches an edge of the
    /// contact: the least and the greatest that are allowed.
    std::optional<BoundedValue> least_tension;
    std::optional<BoundedValue> most_tension;
    /// cycle_energy_of(): the energy per unit length dissipated by friction in a cycle from -Q
    /// to Q and back at constant P.
    std::optional<BoundedValue> cycle_energy;
    /// True if |sigma_0 (a + b)/Q| < 8/pi: both edges slip in the direction of Q from the beginning
    /// of loading if Q and sigma_0 grow in proportion.
    bool in_proportion = true;
};

struct ContactValues {
    BoundedValue a;
    BoundedValue b;
    std::optional<BoundedValue> alpha; ///< the tilt, if it was solved for
    std::optional<BoundedValue> force;
    std::optional<BoundedValue> moment;
    /// Other requested values of the groups `contact` and `peak` (quantity.hpp).
    std::vector<std::pair<Quantity, BoundedValue>> others;
};

/// Computes the values of a scene, each with its error and the name of the route. One object
/// belongs to one thread.
class ValueRoute {
public:
    virtual ~ValueRoute() = default;

    /// One number, by the evaluators of its row (quantity.hpp); the plan must contain it. Throws
    /// DomainError if there is no value (outside the contact, on a corner).
    [[nodiscard]] virtual BoundedValue value(const AskedValue& asked) = 0;
    /// The coordinate x of the point at the distance u from an edge. Throws DomainError outside the
    /// contact.
    [[nodiscard]] virtual BoundedValue place(contact::Edge edge, const Distance& u) = 0;

    // Groups of values, as scenes ask for them; the work is counted.
    [[nodiscard]] virtual ContactValues contact() = 0;
    /// `p`, `q`: which of the two to compute, with their approximations if terms are requested.
    /// Throws DomainError as value() does.
    [[nodiscard]] virtual PointValues at(contact::Edge edge, const Distance& u, bool p, bool q) = 0;
    [[nodiscard]] virtual EdgeValues expansion(contact::Edge edge, bool p, bool q) = 0;
    [[nodiscard]] virtual ExtentValues extent(contact::Edge edge, std::size_t n) = 0;
    /// For a scene with friction. Throws InputError, with the line of the friction, if the contact
    /// slides, or if the stick zone would extend beyond it.
    [[nodiscard]] virtual StickValues stick() = 0;
    [[nodiscard]] virtual SlipValues slip(contact::Edge edge) = 0;
};

/// True if the cycle_energy is given together with the stick zone: without a bulk tension, and not
/// for a curved g', where a quadrature over contacts that are quadratures takes minutes.
[[nodiscard]] bool has_cycle_energy(const Scene& scene);

/// Returns that energy, if has_cycle_energy() and it is found. The stick zone is valid without
/// it, so a quadrature that fails only leaves the energy out.
[[nodiscard]] std::optional<BoundedValue> cycle_energy_of(ValueRoute& route, const Scene& scene,
                                                          const Plan& plan);

/// The values of the contact itself that a plan contains.
[[nodiscard]] ContactValues contact_values(ValueRoute& route, const Scene& scene, const Plan& plan);

/// Makes a route in Real with estimated errors (NormalContact, ShearTraction). Keeps references to
/// all three arguments. Throws InputError, with the line of the load, if no contact carries it.
[[nodiscard]] std::unique_ptr<ValueRoute> make_real_route(const Scene& scene, const Plan& plan,
                                                          contact::Work& work);

/// Makes a route in balls, with proved values (BallContact, shear.hpp), for a plan with `proved`:
/// more and more bits until each value rounds correctly. A value that the bits do not enclose (an
/// edge that may lie on a knot, an error that touches the tolerance) is an estimate by the route in
/// Real; so are all values if a curved g' is not proved to rise in the contact. Throws InputError,
/// with the line of the profile, if g' is proved to fall.
[[nodiscard]] std::unique_ptr<ValueRoute> make_ball_route(const Scene& scene, const Plan& plan,
                                                          contact::Work& work);

} // namespace edgeproof::scene
