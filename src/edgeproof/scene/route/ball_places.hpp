// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/route/ball_refinement.hpp"
#include "edgeproof/scene/route/row.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace edgeproof::scene {

/// The proved positions of the edges and the points of a scene. Keeps references to all three
/// arguments.
class BallPlaces {
public:
    BallPlaces(BallRefinement& balls, const Scene& scene, const Plan& plan);

    /// a + b. Null if no number of bits isolates the edges.
    [[nodiscard]] const Ball* length() const { return length_ ? &*length_ : nullptr; }
    /// The distance of an edge from the origin, if it is known to be a rational number.
    [[nodiscard]] std::optional<Rational> known(contact::Edge edge) const;
    /// Throws DomainError for a point outside the contact, and for a place given by the edges that
    /// many bits do not separate from a corner.
    void refuse_outside(contact::Edge edge, const Distance& u);
    /// The coordinate x of the point u, which is inside the contact, if it is known to be a
    /// rational number.
    [[nodiscard]] std::optional<Rational> known_x(contact::Edge edge, const Distance& u) const;
    /// The bits of a ball around a known place. Such a value is printed from its exact form, so
    /// that a ball of any width suffices.
    [[nodiscard]] long bits() const;

private:
    void refuse_outside_by_edges(contact::Edge edge, const Distance& u);
    /// If x is a number, exact algebra decides.
    void refuse_corner_at(const Distance& u) const;
    /// Stores the position of an edge, if it is a known rational number.
    void know(contact::Edge edge);

    BallRefinement& balls_;
    const Scene& scene_;
    const Plan& plan_;
    std::optional<Ball> length_;
    std::optional<Rational> known_length_;
    std::map<contact::Edge, Rational> known_;
};

/// Returns the extents to which n terms stay within the scene's tolerance, proved by the signs of
/// the error between the crossings; nothing if the budget does not decide.
[[nodiscard]] std::optional<std::vector<Row>> enclosed_extent(BallRefinement& balls,
                                                              const Scene& scene, const Plan& plan,
                                                              contact::Edge edge, std::size_t n);

} // namespace edgeproof::scene
