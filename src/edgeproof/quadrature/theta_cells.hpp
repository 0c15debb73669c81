// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/magnitude.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace edgeproof::quadrature {

/// The Gauss-Legendre rule of n nodes over -1 < x < 1, enclosed (Arb's roots:
/// `johansson-mezzarobba2018`). Only nodes x >= 0 are stored, from the outermost inwards; the rule
/// is symmetric.
struct GaussLegendreBalls {
    std::vector<Ball> x;
    std::vector<Ball> weight;
};

/// The rule at a working precision of `bits`, n >= 1. A table is built at its first use in a
/// thread, which keeps the most recent ones.
[[nodiscard]] std::shared_ptr<const GaussLegendreBalls> gauss_legendre_balls(std::size_t n,
                                                                             long bits);

/// A part of a piece of g' inside the contact: s = c + d cos t, with t from `from` to `to`; or,
/// near a knot that is a branch point of g', s = knot + side t^root (docs/curved-slopes.md, "What
/// is integrated").
struct ThetaSpan {
    std::size_t piece;
    Ball from;
    Ball to;
    std::size_t formula = 0; ///< the formula of g' on it: in s, or in t if there is a root
    long root = 0;           ///< 0: s = c + d cos t
    int side = 1;            ///< 1: right of the knot; -1: left of it
    Ball knot = {};

    /// s and |dtheta/dt| over a box of t. The latter is not finite where it may not be holomorphic,
    /// which matters only for a box that is not real.
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
    /// Bounds all functions on a box and proves that they are holomorphic on it, if it is not real;
    /// false if there is no proof.
    virtual bool bound(const ThetaPlace& at, std::vector<Magnitude>& most) const = 0;
    /// The values at a real point.
    virtual void value(const ThetaPlace& at, std::vector<Ball>& f) const = 0;
};

/// The required accuracy: |error_k| scale_k <= tolerance on every cell.
struct ThetaGoal {
    Magnitude tolerance;
    std::vector<Magnitude> scale;
    std::size_t nodes = 32;
    int depth = 60; ///< the largest number of halvings of a span
};

/// The enclosed integrals over the spans, by the Gauss-Legendre rule on cells
/// (docs/curved-slopes.md, "Intervals and disks"). Cells are halved until the rule's error, bounded
/// on an ellipse about the cell, is small; a cell that is too small to
/// matter contributes its length times the bound. Not finite if the depth is not enough. `centre`
/// is c, `half_length` is d (lengths); theta is dimensionless.
[[nodiscard]] std::vector<Ball> integrate_cells(const ThetaIntegrand& f,
                                                const std::vector<ThetaSpan>& spans,
                                                const Ball& centre, const Ball& half_length,
                                                const ThetaGoal& goal, long bits);

} // namespace edgeproof::quadrature
