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
/// (docs/pressure.md, "Closed form: power laws"). The recurrence m I_m = sqrt(y) + (m - 1) q^2
/// I_(m-2) is applied upwards, where all terms are positive. It begins with I_0, a logarithm, with
/// I_1 = sqrt(y), or with I_(1/2) or I_(3/2), which are power series about the edge, or about the
/// apex with a power of q.
class DoubleWordPowerLaw {
public:
    /// True if there is such a formula for the exponent `m`.
    [[nodiscard]] static bool has(const formula::Exact& m);
    /// The contact, or zone, of such a law.
    /// @param m exponent
    /// @param contact the contact or zone in balls
    /// @param whole the contact from whose edges the distance of the apex is measured
    DoubleWordPowerLaw(const formula::Exact& m, const BallContact& contact,
                       const BallContact& whole);

    /// Returns p (stress) at a place of the contact.
    /// @param x distances from the edges of `contact` (length)
    /// @param edge,u edge of `whole` and the distance from it (length)
    [[nodiscard]] DoubleWord pressure(const DoubleWordPlace& x, Edge edge,
                                      const DoubleWord& u) const {
        if (!x.inside()) {
            return double_word::unknown();
        }
        // y = 1 - q^2 = u (D - u)/a^2 (docs/pressure.md, "Closed form: power laws")
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
    /// n, the exponent at which the recurrence begins.
    enum class Lowest : std::uint8_t { zero, half, one, three_halves };
    struct Step {
        DoubleWord inverse; ///< 1/m
        DoubleWord ratio;   ///< (m - 1)/m
    };
    struct Series {
        explicit Series(const Rational& n);
        PiecewiseSeries edge; ///< I_n/sqrt(y) in y
        PiecewiseSeries apex; ///< I_n without the power of q, in q^2
        DoubleWord power;     ///< factor of the power of q
        static const Series& of(Lowest n);
    };

    /// Returns I_n (docs/pressure.md, "Closed form: power laws").
    [[nodiscard]] DoubleWord lowest(const DoubleWord& y, const DoubleWord& root,
                                    const DoubleWord& q, const DoubleWord& square) const {
        constexpr double farthest = 0x1p500; // largest argument of the logarithm
        if (n_ == Lowest::one) {
            return root;
        }
        const bool at_apex = q.high == 0 && q.radius == 0;
        if (n_ == Lowest::zero && at_apex) {
            return {}; // the next step takes q^2 I_0, which is 0
        }
        if (n_ == Lowest::zero) {
            // I_0 = arcosh(1/q) = ln((1 + sqrt(y))/q)
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
