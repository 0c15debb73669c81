// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/double_word/double_word_slope.hpp"

#include <cstddef>

namespace edgeproof::contact {

/// p - p* of a piecewise linear slope in its stick zone, computed without the difference of the
/// two: the sum over the knots with G - G* in place of G, where G - G* = ln(1 + t) and t has no
/// cancellation (docs/double-words.md, lemma 9). The result is accurate even if the stick zone is
/// almost the whole contact. On a corner, where p and p* are infinite, it is the limit.
struct DoubleWordSlip {
    DoubleWord right; ///< a - a*
    DoubleWord left;  ///< b - b*
    DoubleWord arc;   ///< A - A*: the arc of the contact minus that of the stick zone

    /// Returns p - p* (stress).
    /// @param whole the slope over the contact
    /// @param stick the slope over the stick zone
    /// @param X the place in the contact, distinct from its edges (length)
    /// @param x the place in the stick zone, distinct from its edges (length)
    /// @param edge,u edge of the contact and the distance from it (length)
    [[nodiscard]] DoubleWord difference(const DoubleWordSlope& whole, const DoubleWordSlope& stick,
                                        const DoubleWordPlace& X, const DoubleWordPlace& x,
                                        Edge edge, const DoubleWord& u) const {
        const DoubleWord w_X = sqrt(X.right * X.left);
        const DoubleWord w_x = sqrt(x.right * x.left);
        const DoubleWord both = right * left;
        // w - w* = (d_r l* + d_l r* + d_r d_l)/(w + w*) (docs/double-words.md, lemma 9)
        const DoubleWord roots = (right * x.left + left * x.right + both) / (w_X + w_x);
        const DoubleWord common = both * stick.width;
        const DoubleWord widths = whole.width * stick.width;
        std::size_t next = 0;
        const DoubleWord sum = logarithmic_sum(
            whole, whole.knots.size(), stick.arc * roots + arc * w_X,
            [](std::size_t) { return true; },
            [&](std::size_t i) {
                const DoubleWordSlope::Knot& knot = whole.knots[i];
                const DoubleWord offset = knot.at.offset(edge, u);
                if (next == stick.knots.size() || stick.knots[next].index != knot.index) {
                    return whole.green(knot, offset, X, w_X);
                }
                const Mark<DoubleWord>& V = knot.mark;
                const Mark<DoubleWord>& v = stick.knots[next++].mark;
                // The next three are delta = alpha - alpha* = beta - beta*, alpha + beta*, and
                // sqrt(alpha beta) + sqrt(alpha* beta*) (docs/double-words.md, lemma 9).
                const DoubleWord gain =
                    (right * x.left * v.left + left * x.right * v.right + common) / widths;
                const DoubleWord mean =
                    V.right * X.left / whole.width + x.right * v.left / stick.width;
                const DoubleWord root = V.w * w_X / whole.width + v.w * w_x / stick.width;
                // Y*
                DoubleWord inner =
                    green_excess(v, x.right, x.left, w_x, offset.high > 0 ? 1 : -1) / stick.width;
                if (!double_word::well_known(offset)) {
                    inner.radius += 2 * double_word::most(offset); // the side of v is unknown
                }
                // t = (Y - Y*)/(|v - x| + Y*)
                const DoubleWord t = scaled(gain + gain * mean / root, 2) / (abs(offset) + inner);
                const DoubleWord K = whole.logarithm(t);
                return DoubleWordSlope::Green{K, offset * K};
            });
        return sum * whole.factor;
    }
};

} // namespace edgeproof::contact
