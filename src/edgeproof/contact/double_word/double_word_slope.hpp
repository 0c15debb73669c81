// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/double_word/double_word_field.hpp"
#include "edgeproof/contact/law/logarithmic_pressure.hpp"
#include "edgeproof/precision/double_word/logarithm.hpp"

#include <limits>
#include <vector>

namespace edgeproof::contact {

/// p of a piecewise linear slope: the formula of law/logarithmic_pressure.hpp.
struct DoubleWordSlope {
    struct Knot {
        std::size_t index; ///< in the profile
        DoubleWordMark at;
        Mark<DoubleWord> mark;
        bool corner;
        DoubleWord jump; ///< of g'
        DoubleWord drop; ///< of g''
    };
    std::vector<Knot> knots; ///< those that count
    DoubleWord arc;
    DoubleWord width; ///< a + b
    DoubleWord factor;
    const LogarithmTable* table;

    /// (v - x) G where v - x is all but 0: G <= ln(1 + 4 D/|v - x|), and r ln(1 + 4 D/r) grows with
    /// r; D < 2^100.
    static DoubleWord moment_beside(const DoubleWord& offset) {
        const double r = std::fabs(offset.high) + std::fabs(offset.low) + offset.radius;
        return {0, 0, 400 * std::fmax(r, 0x1p-400)};
    }

    struct Green {
        DoubleWord value;
        DoubleWord moment;
    };
    static constexpr double smallest_excess = 0x1p-520;

    /// What logarithmic_sum asks of a slope.
    [[nodiscard]] bool has_corner(std::size_t i) const { return knots[i].corner; }
    [[nodiscard]] const DoubleWord& jump(std::size_t i) const { return knots[i].jump; }
    [[nodiscard]] const DoubleWord& rate_drop(std::size_t i) const { return knots[i].drop; }

    [[nodiscard]] DoubleWord logarithm(const DoubleWord& y) const {
        if (!double_word::well_known(y) || !(y.high > smallest_excess)) [[unlikely]] {
            return double_word::about_zero(y); // ln(1 + y) <= y
        }
        return log1p(y, *table);
    }
    /// `offset`: v - x, well known.
    [[nodiscard]] Green green(const Knot& knot, const DoubleWord& offset, const DoubleWordPlace& x,
                              const DoubleWord& w_x) const {
        const DoubleWord excess =
            green_excess(knot.mark, x.right, x.left, w_x, offset.high > 0 ? 1 : -1);
        const DoubleWord G = logarithm(excess / (width * abs(offset)));
        return {G, offset * G};
    }

    /// At a place of the contact, which is u from the edge that the knots are counted from.
    /// Infinite exactly on a corner.
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
                    return Green{double_word::unknown(), moment_beside(offset)};
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
