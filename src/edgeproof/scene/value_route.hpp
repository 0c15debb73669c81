// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/work.hpp"
#include "edgeproof/scene/bounded_value.hpp"
#include "edgeproof/scene/plan.hpp"

#include <cstddef>
#include <memory>
#include <optional>
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
    std::optional<BoundedValue> p;
    std::vector<Approximation> p_local;
    std::optional<BoundedValue> q;
    std::vector<Approximation> q_local;
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

struct ContactValues {
    BoundedValue a;
    BoundedValue b;
    std::optional<BoundedValue> alpha; ///< the tilt, where it was solved for
    std::optional<BoundedValue> force;
    std::optional<BoundedValue> moment;
};

/// Where a scene's values come from: each with how far it is to be trusted, and by which name the
/// way goes. What is done is counted. One object belongs to one thread.
class ValueRoute {
public:
    virtual ~ValueRoute() = default;

    [[nodiscard]] virtual ContactValues contact() = 0;
    /// `p`, `q`: which of them to compute, with their approximations where terms are asked for.
    /// Throws DomainError where there is no value (outside the contact, on a corner).
    [[nodiscard]] virtual PointValues at(contact::Edge edge, const formula::Exact& u, bool p,
                                         bool q) = 0;
    [[nodiscard]] virtual EdgeValues expansion(contact::Edge edge, bool p, bool q) = 0;
    [[nodiscard]] virtual ExtentValues extent(contact::Edge edge, std::size_t n) = 0;
};

/// Values in Real with estimated errors (NormalContact, ShearTraction). Keeps references to all
/// three. Throws InputError, told with the line of the load, where no contact carries it.
[[nodiscard]] std::unique_ptr<ValueRoute> make_real_route(const Scene& scene, const Plan& plan,
                                                          contact::Work& work);

/// Values in balls, proved (BallContact, ball_shear.hpp), for a plan that says `proved`: more and
/// more bits until each rounds correctly. What has no enclosure within the bits (an edge on a knot
/// that no exact number tells from it, an error that touches the tolerance) comes from the route in
/// Real, and is called an estimate; so does everything where a curved g' is not proved to rise in
/// the contact. Throws InputError, told with the line of the profile, where it is proved to fall.
[[nodiscard]] std::unique_ptr<ValueRoute> make_ball_route(const Scene& scene, const Plan& plan,
                                                          contact::Work& work);

} // namespace edgeproof::scene
