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
    std::optional<BoundedValue> u; ///< where it was not given as a number
    std::optional<BoundedValue> p;
    std::vector<Approximation> p_local;
    std::optional<BoundedValue> q;
    std::vector<Approximation> q_local;
    std::optional<contact::SlipState> state; ///< of q, where there is friction
};

struct EdgeValues {
    contact::Edge edge = contact::Edge::right;
    std::vector<BoundedValue> c; ///< of u^(1/2), u^(3/2), ... in p
    std::vector<BoundedValue> s; ///< of q, from u^(s_half_powers/2) on
    int s_half_powers = -1;
};

struct ExtentValues {
    contact::Edge edge = contact::Edge::right;
    std::size_t n = 0;
    BoundedValue
        first_exit; ///< the end of the part looked at where it does not leave the tolerance
    BoundedValue measure;
    BoundedValue first_exit_fraction; ///< of a + b
    BoundedValue measure_fraction;
    std::vector<BoundedValue> crossings;
    bool leaves = true; ///< there is a first exit in the part looked at
    /// The first exit lies beyond the process zone, where there is one.
    std::optional<bool> covers_zone;
};

/// What the first n terms give for a slip zone.
struct SlipTerms {
    std::size_t n = 0;
    BoundedValue size;           ///< d_n
    BoundedValue relative_error; ///< |1 - d_n/d|
    /// The load ratio up to which that error stays within the tolerance; none without a tolerance,
    /// where nothing decides it, or where the edge would first slip the other way.
    std::optional<BoundedValue> reach;
    bool leaves = true; ///< false: up to full sliding
};

struct SlipValues {
    contact::Edge edge = contact::Edge::right;
    BoundedValue size; ///< d
    std::vector<SlipTerms> terms;
};

/// The zone -b < x < a that sticks.
struct StickValues {
    BoundedValue load_ratio; ///< |Q|/(f P)
    BoundedValue a;
    BoundedValue b;
    /// The bulk tensions with which the stick zone reaches an edge of the contact, Q and P as they
    /// are: the least and the greatest that are allowed.
    std::optional<BoundedValue> least_tension;
    std::optional<BoundedValue> most_tension;
    /// cycle_energy_beside(): what friction takes in a cycle from -Q to Q and back, P held; energy
    /// per unit length.
    std::optional<BoundedValue> cycle_energy;
    /// |sigma_0 (a + b)/Q| < 8/pi: the slip at both edges is in the direction of Q from the first
    /// load on, Q and sigma_0 growing in proportion.
    bool in_proportion = true;
};

struct ContactValues {
    BoundedValue a;
    BoundedValue b;
    std::optional<BoundedValue> alpha; ///< the tilt, where it was solved for
    std::optional<BoundedValue> force;
    std::optional<BoundedValue> moment;
    /// What else the groups `contact` and `peak` have (quantity.hpp), where it is asked for.
    std::vector<std::pair<Quantity, BoundedValue>> others;
};

/// Where a scene's values come from: each with how far it is to be trusted, and by which name the
/// way goes. One object belongs to one thread.
class ValueRoute {
public:
    virtual ~ValueRoute() = default;

    /// One number, by the evaluators of its row (quantity.hpp); the plan must have it. Throws
    /// DomainError where there is no value (outside the contact, on a corner).
    [[nodiscard]] virtual BoundedValue value(const AskedValue& asked) = 0;
    /// x of the point at the distance u from an edge. Throws DomainError outside the contact.
    [[nodiscard]] virtual BoundedValue place(contact::Edge edge, const Distance& u) = 0;

    // The same together, as scenes ask for them, and counted.
    [[nodiscard]] virtual ContactValues contact() = 0;
    /// `p`, `q`: which of them to compute, with their approximations where terms are asked for.
    /// Throws DomainError as value() does.
    [[nodiscard]] virtual PointValues at(contact::Edge edge, const Distance& u, bool p, bool q) = 0;
    [[nodiscard]] virtual EdgeValues expansion(contact::Edge edge, bool p, bool q) = 0;
    [[nodiscard]] virtual ExtentValues extent(contact::Edge edge, std::size_t n) = 0;
    /// Of a scene with friction. Throws InputError, told with the line of the friction, where the
    /// contact slides, or where the stick zone would reach beyond it.
    [[nodiscard]] virtual StickValues stick() = 0;
    [[nodiscard]] virtual SlipValues slip(contact::Edge edge) = 0;
};

/// Whether a stick zone is told with its cycle_energy: without a bulk tension; not where g' is
/// curved, as a quadrature over contacts that are quadratures takes minutes.
[[nodiscard]] bool tells_cycle_energy(const Scene& scene);

/// That energy where it is told and found. The stick zone is an answer without it: a quadrature
/// that finds none leaves it out.
[[nodiscard]] std::optional<BoundedValue> cycle_energy_beside(ValueRoute& route, const Scene& scene,
                                                              const Plan& plan);

/// What a plan has of the contact itself, one by one.
[[nodiscard]] ContactValues contact_values(ValueRoute& route, const Scene& scene, const Plan& plan);

/// Values in Real with estimated errors (NormalContact, ShearTraction). Keeps references to all
/// three. Throws InputError, told with the line of the load, where no contact carries it.
[[nodiscard]] std::unique_ptr<ValueRoute> make_real_route(const Scene& scene, const Plan& plan,
                                                          contact::Work& work);

/// Values in balls, proved (BallContact, shear.hpp), for a plan that says `proved`: more and
/// more bits until each rounds correctly. What has no enclosure within the bits (an edge on a knot
/// that no exact number tells from it, an error that touches the tolerance) comes from the route in
/// Real, and is called an estimate; so does everything where a curved g' is not proved to rise in
/// the contact. Throws InputError, told with the line of the profile, where it is proved to fall.
[[nodiscard]] std::unique_ptr<ValueRoute> make_ball_route(const Scene& scene, const Plan& plan,
                                                          contact::Work& work);

} // namespace edgeproof::scene
