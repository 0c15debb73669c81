// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/magnitude.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof::quadrature {

/// A piece of g' as far as the contact reaches: s = c + d cos theta, theta from `from` to `to`.
struct ThetaSpan {
    std::size_t piece;
    Ball from;
    Ball to;
};

/// Functions of s that are integrated over theta together.
class ThetaIntegrand {
public:
    virtual ~ThetaIntegrand() = default;
    [[nodiscard]] virtual std::size_t count() const = 0;
    /// What none of them exceeds on a box of s, and that they are holomorphic on it where it is not
    /// real; false where that is not shown.
    virtual bool bound(std::size_t piece, const acb_t s, std::vector<Magnitude>& most) const = 0;
    virtual void value(std::size_t piece, const Ball& s, std::vector<Ball>& f) const = 0;
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
