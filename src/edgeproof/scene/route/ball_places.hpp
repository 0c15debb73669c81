// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/route/ball_refinement.hpp"
#include "edgeproof/scene/route/value_route.hpp"

#include <map>
#include <optional>

namespace edgeproof::scene {

/// Where the edges and the points of a scene are, proved. Keeps references to all three.
class BallPlaces {
public:
    BallPlaces(BallRefinement& balls, const Scene& scene, const Plan& plan);

    /// a + b. Null where no number of bits isolates the edges.
    [[nodiscard]] const Ball* length() const { return length_ ? &*length_ : nullptr; }
    /// The distance of an edge from the origin, if that is known to be a rational number.
    [[nodiscard]] std::optional<Rational> known(contact::Edge edge) const;
    /// Throws DomainError for a point beyond the contact, and for a place by the edges that is on a
    /// corner, as far as many bits tell.
    void refuse_outside(contact::Edge edge, const Distance& u);
    /// x of the point u, which is not outside. Nothing where no number of bits encloses it.
    [[nodiscard]] std::optional<BallRefinement::Found> x(contact::Edge edge, const Distance& u);

private:
    void refuse_outside_by_edges(contact::Edge edge, const Distance& u);
    /// Where x is a number, exact algebra tells.
    void refuse_corner_at(const Distance& u) const;
    /// Keeps where an edge is, if that is a rational number, and known.
    void know(contact::Edge edge);

    BallRefinement& balls_;
    const Scene& scene_;
    const Plan& plan_;
    std::optional<Ball> length_;
    std::optional<Rational> known_length_;
    std::map<contact::Edge, Rational> known_;
};

} // namespace edgeproof::scene
