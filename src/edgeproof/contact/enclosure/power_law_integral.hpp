// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <optional>

namespace edgeproof::contact {

/// I_m(q), the integral of s^m/sqrt(s^2 - q^2) over q < s < 1, for m >= 0 and 0 <= q < 1,
/// q = |x|/a: the integral in the pressure of a power law (moore-hills EQ12; docs/pressure.md,
/// "Closed form: power laws"). Dimensionless. An enclosure by sums of positive terms, each with a
/// proved remainder.
class PowerLawIntegral {
public:
    /// `enclosed_m` encloses m at the greatest precision that will be used.
    PowerLawIntegral(const Exact& m, const Ball& enclosed_m);

    /// I_m(q). `y` is 1 - q^2, an argument of its own so that it keeps its digits near the edge.
    ///
    /// Not finite for m = 0 if q may be 0, and where more than some millions of terms would be
    /// needed (m beyond about 1e10).
    [[nodiscard]] Ball operator()(const Ball& q, const Ball& y) const;

private:
    /// n of I_n.
    struct Exponent {
        Ball n;
        std::optional<Rational> exact; ///< if it is the quotient of small integers
    };
    [[nodiscard]] static Ball edge_sum(const Exponent& of, const Ball& q, const Ball& y,
                                       const Ball& root);
    [[nodiscard]] Ball apex_power(const Ball& q) const;
    [[nodiscard]] Ball apex_sum(const Ball& q) const;
    /// I_n for the remaining n, 0 <= n < 2.
    [[nodiscard]] Ball rest(const Ball& q, const Ball& y, const Ball& root) const;
    [[nodiscard]] Ball few_by_parts(const Ball& q, const Ball& y, const Ball& root) const;
    [[nodiscard]] Ball by_parts(const Ball& q, const Ball& y, const Ball& root) const;

    Exponent whole_; ///< m
    double about_m_;
    long steps_; ///< the number of steps by 2 from m down to 0 <= n < 2
    Exponent left_;
    std::optional<long> whole_left_; ///< 0 or 1, if n is an integer
    Ball apex_factor_;               ///< the factor of q^n in I_n (apex_power)
    Ball most_;                      ///< the greatest argument for which a series is used
};

} // namespace edgeproof::contact
