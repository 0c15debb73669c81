// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/design/error_family.hpp"

#include <optional>
#include <vector>

namespace edgeproof::contact {

/// A contact on a piecewise linear slope whose knots, slopes and edges are balls or jets: the
/// kernels of contact/law/kernels.hpp, over these types.
template <class T> struct LinearContact {
    struct Piece {
        T at_origin;
        T rate;
    };
    struct Mark {
        T right; ///< a - v
        T left;  ///< v + b
        T y;     ///< v - (a - b)/2
        T w;     ///< sqrt((a - v)(v + b))
        T h;     ///< 2 atan sqrt((a - v)/(v + b))
        bool outside = false;
    };
    std::vector<T> knots;
    std::vector<Piece> pieces;
    std::vector<T> jumps;
    std::vector<bool> corner;
    std::size_t origin = 0;
    T modulus;
    long bits = 64;

    [[nodiscard]] T constant(long k) const { return T(Ball(k, bits)); }
    [[nodiscard]] Mark mark(const T& a, const T& b, const T& v) const;
    [[nodiscard]] Mark right_end(const T& a, const T& b) const;
    [[nodiscard]] Mark left_end(const T& a, const T& b) const;
    /// Positive where the left edge lies further out (eqn:Consistency).
    [[nodiscard]] T imbalance(const T& a, const T& b) const;
    /// Its derivative by b.
    [[nodiscard]] T imbalance_rate(const T& a, const T& b) const;
    [[nodiscard]] T force(const T& a, const T& b) const;
    /// dP/da along the family of contacts.
    [[nodiscard]] T force_rate(const T& a, const T& b) const;
    /// The integral of g'' over the angle h.
    [[nodiscard]] T arc(const T& a, const T& b) const;

private:
    template <class AtKnot, class Between>
    [[nodiscard]] T over_measure(const T& a, const T& b, const AtKnot& at_knot,
                                 const Between& between) const;
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
