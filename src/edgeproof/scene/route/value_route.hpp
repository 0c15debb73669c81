// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/work.hpp"
#include "edgeproof/scene/route/plan.hpp"
#include "edgeproof/scene/route/row.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace edgeproof::scene {

/// Computes the values of a scene, each with its error and the name of the route, and counts the
/// work. One object belongs to one thread.
class ValueRoute {
public:
    virtual ~ValueRoute() = default;

    /// One number, by the evaluators of its row (quantity.hpp); the plan must contain it. Throws
    /// DomainError if there is no value (outside the contact, on a corner); InputError, with the
    /// line of the friction, for a value of the slip if the contact slides or if the stick zone
    /// would extend beyond it.
    [[nodiscard]] virtual BoundedValue value(const AskedValue& asked) = 0;
    /// For a scene with friction.
    [[nodiscard]] virtual contact::SlipState state(contact::Edge edge, const Distance& u) = 0;
    /// The rows of the extent of n terms: the first exit, the measure, both as fractions of a + b,
    /// and all crossings.
    [[nodiscard]] virtual std::vector<Row> extent(contact::Edge edge, std::size_t n) = 0;
    /// The rows of the slip zone by n terms: its size, the error, and with a tolerance the load
    /// ratio up to which the error stays within it.
    [[nodiscard]] virtual std::vector<Row> slip_terms(contact::Edge edge, std::size_t n) = 0;
    /// True if |sigma_0 (a + b)/Q| < 8/pi: both edges slip in the direction of Q from the beginning
    /// of loading if Q and sigma_0 grow in proportion.
    [[nodiscard]] virtual bool in_proportion() = 0;

    /// The row of a quantity with `searched`. The search at each place is made once.
    [[nodiscard]] const Row& searched(const AskedValue& asked);

private:
    std::map<std::tuple<QuantityGroup, contact::Edge, std::size_t>, std::vector<Row>> searched_;
};

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
