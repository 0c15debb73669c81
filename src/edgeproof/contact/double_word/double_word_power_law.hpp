// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/double_word/double_word_field.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/precision/double_word/logarithm.hpp"
#include "edgeproof/precision/double_word/piecewise_series.hpp"

#include <cstdint>
#include <vector>

namespace edgeproof::contact {

/// p of a power law whose exponent m is a multiple of 1/2, m <= 64: P'(a)/pi times I_m(|x|/a)
/// (docs/pressure.md), from m I_m = sqrt(y) + (m - 1) q^2 I_(m-2) upwards, in which all is
/// positive. At its bottom I_0 is a logarithm, I_1 = sqrt(y), and I_(1/2), I_(3/2) are power
/// series: about the edge, and about the apex with a power of q.
class DoubleWordPowerLaw {
public:
    [[nodiscard]] static bool has(const formula::Exact& m);
    /// Of the contact of such a law, the apex counted from the edges of `whole`.
    DoubleWordPowerLaw(const formula::Exact& m, const BallContact& contact,
                       const BallContact& whole);

    /// At a place of the contact, which is u from the edge that the apex is counted from.
    [[nodiscard]] DoubleWord pressure(const DoubleWordPlace& x, Edge edge,
                                      const DoubleWord& u) const {
        if (!x.inside()) {
            return double_word::unknown();
        }
        const DoubleWord y = x.right * x.left * inverse_ * inverse_;
        const DoubleWord root = x.root(y);
        const DoubleWord q = abs(apex_.offset(edge, u)) * inverse_;
        const DoubleWord square = q * q;
        DoubleWord I = lowest(y, root, q, square);
        for (const Step& step : steps_) {
            I = step.inverse * root + step.ratio * square * I;
        }
        return I * factor_;
    }

    [[nodiscard]] const DoubleWord& factor() const { return factor_; }
    /// All other numbers of the contact.
    [[nodiscard]] std::vector<DoubleWord> constants() const {
        return {apex_.inset.first, apex_.outset.first, inverse_};
    }

private:
    /// 0 <= n <= 3/2 of the recurrence's bottom.
    enum class Lowest : std::uint8_t { zero, half, one, three_halves };
    struct Step {
        DoubleWord inverse; ///< 1/m
        DoubleWord ratio;   ///< (m - 1)/m
    };
    struct Series {
        explicit Series(const Rational& n);
        PiecewiseSeries edge; ///< I_n/sqrt(y) in y
        PiecewiseSeries apex; ///< I_n less the power of q, in q^2
        DoubleWord power;     ///< its factor
        static const Series& of(Lowest n);
    };

    [[nodiscard]] DoubleWord lowest(const DoubleWord& y, const DoubleWord& root,
                                    const DoubleWord& q, const DoubleWord& square) const {
        constexpr double farthest = 0x1p500; // of the logarithm
        if (n_ == Lowest::one) {
            return root;
        }
        const bool at_apex = q.high == 0 && q.radius == 0;
        if (n_ == Lowest::zero && at_apex) {
            return {}; // the next step takes q^2 I_0, which is 0
        }
        if (n_ == Lowest::zero) {
            const DoubleWord excess = (root + y / (q + DoubleWord{1, 0, 0})) / q;
            return double_word::well_known(excess) && excess.high < farthest &&
                           excess.high > 1 / farthest
                       ? log1p(excess, *table_)
                       : double_word::about_zero(excess); // ln(1 + y) <= y
        }
        if (y.high <= 0.5) {
            return root * series_->edge(y);
        }
        if (at_apex) {
            return series_->apex(square);
        }
        const DoubleWord half_power = sqrt(q);
        return series_->apex(square) +
               series_->power * (n_ == Lowest::half ? half_power : q * half_power);
    }

    DoubleWordMark apex_;
    DoubleWord inverse_; ///< 1/a
    DoubleWord factor_;
    Lowest n_ = Lowest::one;
    std::vector<Step> steps_;
    const Series* series_ = nullptr;
    const LogarithmTable* table_ = &LogarithmTable::get();
};

} // namespace edgeproof::contact
