// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/precision/error.hpp"

namespace edgeproof::contact {

/// A place inside the contact, given by its distances from both edges (lengths; docs/mechanics.md,
/// "The contact"), so that the distance from the nearer edge keeps all its digits.
template <class T> struct Point {
    T right; ///< a - x
    T left;  ///< x + b
    T x;
};

/// The point at the distance u from an edge (lengths). Throws DomainError unless 0 < u < a + b.
template <class T> [[nodiscard]] Point<T> point_at(const Extent<T>& e, Edge edge, const T& u) {
    const T other = e.length() - u;
    if (!(u > T(0)) || !(other > T(0))) {
        throw DomainError("a point lies outside the contact");
    }
    return edge == Edge::right ? Point<T>{u, other, T(e.a - u)} : Point<T>{other, u, T(u - e.b)};
}

} // namespace edgeproof::contact
