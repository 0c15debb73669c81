// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/double_word/double_word_pressure.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/contact/slip/ball_slip.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <variant>

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

/// q, correctly rounded to binary64, in double words like the pressure: under full stick
/// (law/shear.hpp), similar to p (Q and P increase together), or in partial slip, f (p - p*)
/// (slip/ball_slip.hpp). On a corner of the stick zone, where p and p* are infinite, it is the
/// limit. Undecided values are left to balls. The object is immutable: many threads may
/// use it.
class DoubleWordShear {
public:
    /// `load`: Q (force/length) and the bulk tension (stress).
    [[nodiscard]] static DoubleWordShear full_stick(const BallContact& contact,
                                                    const ShearLoad<Ball>& load);
    /// `ratio`: Q/P.
    [[nodiscard]] static DoubleWordShear similar(DoubleWordPressure pressure, const Ball& ratio);
    /// `stick`: the stick zone (length); `traction`: f in the direction of Q.
    [[nodiscard]] static DoubleWordShear partial_slip(const Profile& profile,
                                                      const BallContact& contact,
                                                      const BallZone& stick, const Ball& traction);

    /// Returns q (stress) at the distance `u` from an edge (length); see DoubleWordPressure::at.
    [[nodiscard]] DoubleWord at(Edge edge, const DoubleWord& u) const {
        return in_range_ && in_double_words(u) ? kernel_(*this, edge, u) : double_word::unknown();
    }
    /// Returns the binary64 nearest to q at `u`; nothing where that is undecided.
    [[nodiscard]] std::optional<double> nearest(Edge edge, double u) const {
        return nearest_binary64(at(edge, {u, 0, 0}));
    }

    /// `at` without its checks.
    [[nodiscard]] DoubleWord formula(Edge edge, const DoubleWord& u) const;

private:
    /// Returns factor times a p that may be infinite (on a corner).
    static DoubleWord times(const DoubleWord& factor, const DoubleWord& p) {
        return std::isinf(p.high) && double_word::well_known(factor)
                   ? DoubleWord{factor.high * p.high, 0, p.radius}
                   : factor * p;
    }
    struct FullStick {
        PreciseWord length;
        DoubleWord Q_over_pi;
        DoubleWord tension; ///< sigma_0/8

        /// eqn:Shear_Adhered, where 2x + b - a is the difference of the distances from the edges.
        [[nodiscard]] DoubleWord at(Edge edge, const DoubleWord& u) const {
            const DoubleWordPlace x(length, edge, u);
            return x.inside() ? (Q_over_pi + tension * (x.left - x.right)) / sqrt(x.right * x.left)
                              : double_word::unknown();
        }
    };
    struct Similar {
        DoubleWordPressure pressure;
        DoubleWord ratio;

        /// q = (Q/P) p (docs/partial-slip.md, "P and Q in proportion").
        [[nodiscard]] DoubleWord at(Edge edge, const DoubleWord& u) const {
            return times(ratio, pressure.formula(edge, u));
        }
    };
    struct Slip {
        DoubleWordPressure pressure;
        DoubleWordPressure stick; ///< p*
        DoubleWord friction;
        DoubleWordMark right; ///< of the edge of the stick zone
        DoubleWordMark left;
        DoubleWordSlip zones;

        /// q = f (p - p*) (docs/partial-slip.md; docs/double-words.md, lemmas 9 to 11).
        [[nodiscard]] DoubleWord at(Edge edge, const DoubleWord& u) const {
            DoubleWordPlace x(right, left, edge, u);
            if (!x.known()) { // on the edge of the stick zone, or too close to it to be separated
                x.move_inside();
                const DoubleWord inner =
                    x.inside() ? double_word::about_zero(stick.formula(x, edge, u)) : DoubleWord{};
                return friction * (pressure.formula(edge, u) - inner);
            }
            if (!x.inside()) {
                return times(friction, pressure.formula(edge, u));
            }
            if (pressure.slope() == nullptr) {
                return friction * (pressure.formula(edge, u) - stick.formula(x, edge, u));
            }
            return friction * zones.difference(*pressure.slope(), *stick.slope(),
                                               {pressure.length(), edge, u}, x, edge, u);
        }
    };
    using Form = std::variant<FullStick, Similar, Slip>;

    /// `in_range`: the numbers of the contact are in the range of the bounds.
    DoubleWordShear(Form form, bool in_range);

    Form form_;
    bool in_range_;
    DoubleWordKernel<DoubleWordShear>::Function kernel_;
};

} // namespace edgeproof::contact
