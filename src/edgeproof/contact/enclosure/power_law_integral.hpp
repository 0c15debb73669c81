// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/elementary/ratio_series.hpp"

#include <optional>

namespace edgeproof::contact {

/// I_m(q), the integral of s^m/sqrt(s^2 - q^2) over q < s < 1, for m >= 0 and 0 <= q < 1: what the
/// pressure of a power law is made of (moore-hills.tex eqn:MossakovskiiPressure), q = |x|/a. An
/// enclosure for every m, the largest included: sums of positive terms, each with a proved
/// remainder.
class PowerLawIntegral {
public:
    /// `enclosed_m` holds m, to as many bits as will be asked for.
    PowerLawIntegral(const formula::Exact& m, const Ball& enclosed_m);

    /// I_m(q). `y` is 1 - q^2, given beside q so that it keeps its digits near the edge.
    ///
    /// Not finite for m = 0 where q may be 0, and where more than some millions of terms would be
    /// needed (m beyond about 1e10).
    [[nodiscard]] Ball operator()(const Ball& q, const Ball& y) const;

private:
    /// n of I_n, and what its sums have of n alone.
    struct Exponent {
        Exponent(Ball enclosed, std::optional<Rational> exactly);
        Ball n;
        std::optional<Rational> exact;
        /// n = p/q, where that is made of small numbers.
        struct Words {
            long p;
            long q;
        };
        std::optional<Words> words;
        std::optional<RatioSeries> by_edge;
        /// For n < 2.
        std::optional<RatioSeries> by_apex;
        /// No quotient has a large denominator.
        bool few_words = false;
    };
    [[nodiscard]] static Ball edge_sum(const Exponent& of, const Ball& q, const Ball& y,
                                       const Ball& root);
    [[nodiscard]] Ball apex_power(const Ball& q) const;
    [[nodiscard]] Ball apex_sum(const Ball& q) const;
    /// I_n of the n that is left, 0 <= n < 2.
    [[nodiscard]] Ball rest(const Ball& q, const Ball& y, const Ball& root) const;
    [[nodiscard]] Ball few_by_parts(const Ball& q, const Ball& y, const Ball& root) const;
    [[nodiscard]] Ball by_parts(const Ball& q, const Ball& y, const Ball& root) const;

    Exponent whole_; ///< m
    double about_m_;
    long steps_; ///< how many times m goes down by 2 to 0 <= n < 2
    Exponent left_;
    std::optional<long> whole_left_; ///< 0 or 1, where n is that
    Ball apex_factor_;               ///< of q^n in I_n
    Ball most_;                      ///< of what a series converges in
};

} // namespace edgeproof::contact
