// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <utility>

namespace edgeproof::contact {

using formula::Exact;
using formula::Expr;

/// An edge of the contact -b < x < a. Distances u run inwards from it: u = a - x or u = b + x.
enum class Edge { right, left };

[[nodiscard]] constexpr Edge opposite(Edge edge) {
    return edge == Edge::right ? Edge::left : Edge::right;
}
/// The index of an edge in arrays that hold one entry for each edge.
[[nodiscard]] constexpr std::size_t index_of(Edge edge) { return edge == Edge::right ? 0 : 1; }

/// The load: the right edge a (length), or the normal force P per unit length; for an axisymmetric
/// contact the radius a, the total force P, or the approach delta (length).
struct Load {
    enum class Kind { right_edge, force, approach };
    Kind kind = Kind::right_edge;
    Exact value;
    [[nodiscard]] static Load right_edge(Exact a) { return {Kind::right_edge, std::move(a)}; }
    [[nodiscard]] static Load force(Exact P) { return {Kind::force, std::move(P)}; }
    [[nodiscard]] static Load approach(Exact delta) { return {Kind::approach, std::move(delta)}; }
};

/// The part of the contact that is examined, as fractions of its length a + b from the edge. For a
/// symmetric contact from the edge to the middle, `to` is 1/2.
struct ExtentRange {
    Exact from = Exact::of(Rational(0));
    Exact to = Exact::of(Rational(1));
};

} // namespace edgeproof::contact
