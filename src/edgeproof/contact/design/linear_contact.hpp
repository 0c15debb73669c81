// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/design/error_family.hpp"
#include "edgeproof/contact/law/linear_measure.hpp"

#include <optional>
#include <vector>

namespace edgeproof::contact {

/// A contact on a piecewise linear slope whose knots, slopes and edges are balls or jets. The
/// integrals are those of contact/law over these types. `a`, `b`: the distances of the edges from
/// the origin. A result is not finite if an edge may lie on a knot.
template <class T> struct LinearContact {
    LinearSlope<T> slope;
    T modulus; ///< E*
    long bits = 64;

    [[nodiscard]] T constant(long k) const { return T(Ball(k, bits)); }
    /// Positive if the left edge must lie further out (moore-hills EQ20).
    [[nodiscard]] T imbalance(const T& a, const T& b) const;
    /// The derivative of the imbalance with respect to b.
    [[nodiscard]] T imbalance_rate(const T& a, const T& b) const;
    /// The normal force P per unit length (moore-hills EQ22).
    [[nodiscard]] T force(const T& a, const T& b) const;
    /// dP/da along the family of contacts.
    [[nodiscard]] T force_rate(const T& a, const T& b) const;
    /// The integral of g'' over the angle h (1/length).
    [[nodiscard]] T arc(const T& a, const T& b) const;

private:
    template <class Kernel> [[nodiscard]] T over_measure(const Extent<T>& e) const;
    [[nodiscard]] std::vector<Mark<T>> marks(const Extent<T>& e) const;
};

template <class T>
[[nodiscard]] LinearContact<T> linear_contact(const ParametricSlope& slope,
                                              const formula::Expr& contact_modulus,
                                              const ParameterValues<T>& value);

extern template struct LinearContact<Ball>;
extern template struct LinearContact<Jet>;

/// The edges of a contact over a box of parameters.
template <class T> struct LinearEdges {
    T a;
    T b;
};

/// Encloses the edges by interval Newton, which proves that for each parameter of the box an edge
/// lies in the ball and is the only one there. Returns nothing if the box is too wide, or if an
/// edge may lie on a knot. `start`: edges under a greater load, from which Newton's method starts.
[[nodiscard]] std::optional<LinearEdges<Ball>>
solve_edges(const LinearContact<Ball>& contact, const LinearContact<Ball>& middle, bool symmetric,
            const std::optional<Ball>& a, const std::optional<Ball>& P,
            const LinearEdges<Ball>* start = nullptr);
/// Adds the derivatives, by the implicit function theorem, to edges that are enclosed.
[[nodiscard]] LinearEdges<Jet> differentiated_edges(const LinearContact<Jet>& contact,
                                                    const LinearEdges<Ball>& edges, bool symmetric,
                                                    const std::optional<Jet>& a,
                                                    const std::optional<Jet>& P);

} // namespace edgeproof::contact
