// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/double_word/double_word_field.hpp"
#include "edgeproof/contact/law/logarithmic_pressure.hpp"
#include "edgeproof/precision/double_word/logarithm.hpp"

#include <limits>
#include <vector>

namespace edgeproof::contact {

/// p of a piecewise linear slope by the formula of law/logarithmic_pressure.hpp (docs/pressure.md,
/// "Closed form: piecewise linear slopes").
struct DoubleWordSlope {
    struct Knot {
        std::size_t index; ///< in the profile
        DoubleWordMark at;
        Mark<DoubleWord> mark;
        bool corner;
        DoubleWord jump; ///< of g'
        DoubleWord drop; ///< of g''
    };
    std::vector<Knot> knots; ///< those inside the contact where g' jumps or bends
    DoubleWord arc;
    DoubleWord width; ///< a + b
    DoubleWord factor;
    const LogarithmTable* table;

    /// (v - x) G where v - x is nearly 0: G <= ln(1 + 4 D/|v - x|), and r ln(1 + 4 D/r) increases
    /// with r, D < 2^100 (docs/double-words.md, lemma 6).
    static DoubleWord moment_near_knot(const DoubleWord& offset) {
        const double r = std::fabs(offset.high) + std::fabs(offset.low) + offset.radius;
        return {0, 0, 400 * std::fmax(r, 0x1p-400)};
    }

    struct Green {
        DoubleWord value;  ///< G
        DoubleWord moment; ///< (v - x) G
    };
    static constexpr double smallest_excess = 0x1p-520;

    /// The members that logarithmic_sum requires of a slope.
    [[nodiscard]] bool has_corner(std::size_t i) const { return knots[i].corner; }
    [[nodiscard]] const DoubleWord& jump(std::size_t i) const { return knots[i].jump; }
    [[nodiscard]] const DoubleWord& rate_drop(std::size_t i) const { return knots[i].drop; }

    /// Returns ln(1 + y).
    [[nodiscard]] DoubleWord logarithm(const DoubleWord& y) const {
        if (!double_word::well_known(y) || !(y.high > smallest_excess)) [[unlikely]] {
            return double_word::about_zero(y); // ln(1 + y) <= y
        }
        return log1p(y, *table);
    }
    /// Returns G(x, v) of a knot. `offset`: v - x, not zero within its radius.
    [[nodiscard]] Green green(const Knot& knot, const DoubleWord& offset, const DoubleWordPlace& x,
                              const DoubleWord& w_x) const {
        const DoubleWord excess =
            green_excess(knot.mark, x.right, x.left, w_x, offset.high > 0 ? 1 : -1);
        const DoubleWord G = logarithm(excess / (width * abs(offset)));
        return {G, offset * G};
    }

    /// Returns p (stress) at a place of the contact; infinite exactly on a corner.
    /// @param x distances from the edges of the contact (length)
    /// @param edge,u edge from which the distances of the knots are measured, and the distance
    /// from it
    [[nodiscard]] DoubleWord pressure(const DoubleWordPlace& x, Edge edge,
                                      const DoubleWord& u) const {
        if (!x.inside()) {
            return double_word::unknown();
        }
        const DoubleWord w_x = x.root(x.right * x.left);
        bool on_corner = false;
        const DoubleWord sum = logarithmic_sum(
            *this, knots.size(), arc * w_x, [](std::size_t) { return true; },
            [&](std::size_t i) {
                const Knot& knot = knots[i];
                const DoubleWord offset = knot.at.offset(edge, u);
                if (!double_word::well_known(offset)) {
                    on_corner =
                        on_corner || (knot.corner && offset.high == 0 && offset.radius == 0);
                    return Green{double_word::unknown(), moment_near_knot(offset)};
                }
                return green(knot, offset, x, w_x);
            });
        if (on_corner) {
            return {std::numeric_limits<double>::infinity(), 0, 0};
        }
        return sum * factor;
    }
};

} // namespace edgeproof::contact
