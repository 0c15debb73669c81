// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/magnitude.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof::quadrature {

/// A piece of g' as far as the contact reaches, or a part of it: s = c + d cos t, t from `from` to
/// `to`; or beside a knot that is a branch point of g', s = knot + side t^root.
struct ThetaSpan {
    std::size_t piece;
    Ball from;
    Ball to;
    std::size_t formula = 0; ///< of g' on it: in s, or in t where there is a root
    long root = 0;           ///< 0: s = c + d cos t
    int side = 1;            ///< 1: right of the knot; -1: left of it
    Ball knot = {};

    /// s and dtheta/dt, up to its sign, over a box of t; the latter is not finite where it may not
    /// be holomorphic, which matters where the box is not real.
    void map(acb_t s, acb_t rate, const acb_t t, const Ball& centre, const Ball& half_length,
             long bits) const;
};

/// A box of a span, or a point.
struct ThetaPlace {
    const ThetaSpan& span;
    const acb_struct* t;
    const acb_struct* s;
};

/// Functions of s that are integrated over theta together.
class ThetaIntegrand {
public:
    virtual ~ThetaIntegrand() = default;
    [[nodiscard]] virtual std::size_t count() const = 0;
    /// What none of them exceeds on a box, and that they are holomorphic on it where it is not
    /// real; false where that is not shown.
    virtual bool bound(const ThetaPlace& at, std::vector<Magnitude>& most) const = 0;
    /// At a point, which is real.
    virtual void value(const ThetaPlace& at, std::vector<Ball>& f) const = 0;
};

/// How far an integral is driven: |error_k| scale_k <= tolerance on every cell.
struct ThetaGoal {
    Magnitude tolerance;
    std::vector<Magnitude> scale;
    std::size_t nodes = 32;
    int depth = 60; ///< halvings of a span, at most
};

/// The integrals over the spans, enclosed: by the Gauss-Legendre rule on cells that are halved
/// until its error, bounded on an ellipse about the cell (bernstein.hpp), is small; a cell too
/// small to matter counts by its length. Not finite where the depth does not suffice.
[[nodiscard]] std::vector<Ball> integrate_cells(const ThetaIntegrand& f,
                                                const std::vector<ThetaSpan>& spans,
                                                const Ball& centre, const Ball& half_length,
                                                const ThetaGoal& goal, long bits);

} // namespace edgeproof::quadrature
