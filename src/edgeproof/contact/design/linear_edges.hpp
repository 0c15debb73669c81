// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/design/linear_contact.hpp"

#include <optional>

namespace edgeproof::contact {

/// The edges of a contact over a box of parameters.
template <class T> struct LinearEdges {
    T a;
    T b;
};

/// Enclosed by interval Newton, which shows that for each parameter of the box an edge lies in the
/// ball and is the only one there. Nothing where the box is too wide, or an edge may lie on a knot.
/// `start`: edges under a greater load, from which Newton's method is begun.
[[nodiscard]] std::optional<LinearEdges<Ball>>
solve_edges(const LinearContact<Ball>& contact, const LinearContact<Ball>& middle, bool symmetric,
            const std::optional<Ball>& a, const std::optional<Ball>& P,
            const LinearEdges<Ball>* start = nullptr);
/// With the derivatives that the implicit function theorem gives, about edges that are enclosed.
[[nodiscard]] LinearEdges<Jet> differentiated_edges(const LinearContact<Jet>& contact,
                                                    const LinearEdges<Ball>& edges, bool symmetric,
                                                    const std::optional<Jet>& a,
                                                    const std::optional<Jet>& P);

} // namespace edgeproof::contact
